"""Shaders in the dialect of Processing's tutorials, made into core GLSL.

The text is rewritten token by token, so that comments, lines and columns of code mostly stay; what
has to be added is on lines of its own, of which the result keeps count.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from sketchkit.glsl.initializers import with_constructors, with_float_returns
from sketchkit.glsl.naming import Names, choose_names
from sketchkit.glsl.tokens import Kind, Token, text_of, tokenize
from sketchkit.glsl.words import INCLUDED_EXTENSIONS, PRECISIONS

FIRST_WITH_IN_AND_OUT = 150  # sources from here on are modern: they keep their words
FIRST_RELAXED = 420  # that takes `float a[2] = {1, 2}`


@dataclass(frozen=True)
class Modern:
    """A shader that core OpenGL takes.

    Attributes
    ----------
    text : str
    renamed : mapping of str
        Of uniforms and attributes that are called differently in `text`: by the sketch's names.
    lines : tuple of int
        For each line of `text`, the line of the source; what was added counts for what follows.
    """

    text: str
    renamed: Mapping[str, str] = field(default_factory=dict)
    lines: tuple[int, ...] = ()

    def source_line(self, line: int) -> int:
        """Return the line of the source for a line of the text; both count from 1."""
        last = self.lines[-1] if self.lines else 1
        return self.lines[line - 1] if 0 < line <= len(self.lines) else last


def modernize(source: str, stage: str, version: int) -> Modern:
    """Return a shader as core GLSL.

    Parameters
    ----------
    source : str
        As the sketch has it.
    stage : str
        `vertex` or `fragment`.
    version : int
        Of GLSL, 330 or later, for sources that name none, or one older than 1.50.

    Notes
    -----
    The text has `sk_y_sign` (vertex), `sk_height` and `sk_is_turned` (fragment, where it matters)
    as further uniforms, all float. Source: what Processing's PShader takes.
    """
    tokens = tokenize(_plain(source))
    declared = _declared_version(tokens)
    is_legacy = declared is None or declared < FIRST_WITH_IN_AND_OUT
    if is_legacy and version < FIRST_RELAXED:
        tokens = with_float_returns(with_constructors(tokens))
    names = choose_names(tokens, stage, is_legacy=is_legacy)
    tokens = [names.renamed(tokens, place) for place in range(len(tokens))]
    if is_legacy:
        tokens = list(_without_old_lines(tokens, version))
    return _assembled(tokens, names, f"#version {version}" if declared is None else None)


def _plain(source: str) -> str:
    """Return a source with what pasting brings along made harmless."""
    return source.replace("\ufeff", "").replace("\u00a0", " ")


def _declared_version(tokens: list[Token]) -> int | None:
    """Return the version that a source names; those of OpenGL ES count as old."""
    line = [token.text for token in tokens if token.directive == "version" and token.is_code]
    if len(line) < 3 or not line[2].isdigit():
        return None
    return 0 if line[3:] in (["es"], ["compatibility"]) else int(line[2])


def _without_old_lines(tokens: list[Token], version: int) -> Iterator[Token]:
    """Yield tokens without precisions and included extensions, and with the version."""
    defined = _defined_names(tokens)
    in_precision = False
    for place, token in enumerate(tokens):
        text = token.text
        if text == "precision" and not token.directive and text not in defined:
            in_precision = True
        if token.directive == "version" and token.is_code:
            yield token._replace(text=f"#version {version}" if text == "#" else "")
        elif token.directive == "extension" and _is_included(tokens, place):
            yield token._replace(text="")
        elif in_precision and token.is_code and not token.directive:
            in_precision = text != ";"
            yield token._replace(text="")
        elif text in PRECISIONS and text not in defined:
            yield token._replace(text="")
        else:
            yield token


def _defined_names(tokens: list[Token]) -> set[str]:
    return {
        tokens[place + 2].text
        for place, token in enumerate(tokens[:-2])
        if token.directive == "define" and token.text == "define"
    }


def _is_included(tokens: list[Token], place: int) -> bool:
    """Return whether a token is on the line of an extension that core GLSL includes."""
    line = tokens[place].line
    first = place
    while first and tokens[first - 1].line == line:
        first -= 1
    for token in tokens[first:]:
        if token.line != line:
            return False
        if token.text in INCLUDED_EXTENSIONS:
            return True
    return False


def _assembled(tokens: list[Token], names: Names, version_line: str | None) -> Modern:
    """Put the added lines in: the version first, declarations after the last extension."""
    added = [names.header] if names.header else []
    last = _last_line_of_head(tokens)
    if version_line is not None and last == 0:
        added.insert(0, version_line)
        version_line = None
    head = [token for token in tokens if token.line <= last]
    rest = [token for token in tokens if token.line > last]
    begin = [version_line] if version_line is not None else []
    text = "".join(f"{line}\n" for line in begin) + text_of(head)
    if text and not text.endswith(("\n", "\r")):
        text += "\n"
    text += "".join(f"{line}\n" for line in added) + text_of(rest)
    count = len(re.findall(r"\r\n|\n|\r", text_of(tokens))) + 1
    lines = [1] * len(begin) + list(range(1, last + 1)) + [last + 1] * len(added)
    lines += range(last + 1, count + 1)
    if names.footer:
        text, lines = f"{text}\n{names.footer}\n", [*lines, count]
    return Modern(_ascii(text), names.by_sketch, tuple(lines))


def _last_line_of_head(tokens: list[Token]) -> int:
    """Return the last line of a version or extension, with the condition around it; 0: none."""
    last = depth = 0
    is_pending = False
    for token in tokens:
        if token.directive in ("version", "extension") and token.text.strip():
            is_pending = True
        elif token.text == token.directive and token.text in ("if", "ifdef", "ifndef"):
            depth += 1
        elif token.text == token.directive == "endif":
            depth -= 1
        elif token.kind is Kind.NEWLINE and is_pending and depth <= 0:
            last, is_pending = token.line, False
    return last


def _ascii(text: str) -> str:
    """Return a text without the letters that some drivers refuse even in comments."""
    if text.isascii():
        return text
    return "".join(
        token.text if token.is_code else re.sub(r"[^\x00-\x7f]", "?", token.text)
        for token in tokenize(text)
    )
