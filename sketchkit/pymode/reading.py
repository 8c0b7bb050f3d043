"""A file of Python Mode as text: without byte order mark, carriage returns and tabs."""

from __future__ import annotations

import io
import re
import tokenize
from collections.abc import Iterator

TAB = 8  # columns; Python 2 takes a tab for as many spaces as lead to the next multiple

# Strings and comments: a quotation mark in one of them begins no other.
LITERALS = re.compile(
    r'"""(?:\\.|.)*?"""'
    r"|'''(?:\\.|.)*?'''"
    r'|"(?:\\.|[^"\\\n])*"'
    r"|'(?:\\.|[^'\\\n])*'"
    r"|#[^\n]*",
    re.DOTALL,
)


STRAY_SPACES = re.compile(r"\\([ \t]+)(?=\n)")


def text_of(data: bytes) -> str:
    r"""Return a file as Python 3 reads it: lines end in \n, and begin with spaces alone.

    Parameters
    ----------
    data : bytes
        As it is on disk. What is not UTF-8, though no `coding:` line says so, is taken for Latin-1.

    Raises
    ------
    SyntaxError
        If a `coding:` line names an encoding that does not exist.
    """
    encoding, _ = tokenize.detect_encoding(io.BytesIO(_with_one_line(data)).readline)
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    text = re.sub(r"\r\n?", "\n", text.lstrip("\ufeff"))
    return _with_ends_cut(_without_tabs(text))


def _with_one_line(data: bytes) -> bytes:
    """Return the part of a file that says in what it is written, or what says nothing of it."""
    first_lines = b"\n".join(data.splitlines()[:2])
    return first_lines if re.search(rb"coding[:=]|^\xef\xbb\xbf", first_lines) else b""


def _without_tabs(text: str) -> str:
    if "\t" not in text:
        return text
    inside = set(_lines_inside_strings(text))
    lines = text.split("\n")
    return "\n".join(
        line if number in inside else _spaces_first(line) for number, line in enumerate(lines)
    )


def _with_ends_cut(text: str) -> str:
    """Take away spaces behind a backslash at a line's end: Python Mode does not mind them."""
    if not (stray := list(STRAY_SPACES.finditer(text))):
        return text
    literals = [found.span() for found in LITERALS.finditer(text)]
    for found in reversed(stray):
        if not any(first <= found.start() < end for first, end in literals):
            text = text[: found.start(1)] + text[found.end(1) :]
    return text


def _spaces_first(line: str) -> str:
    rest = line.lstrip(" \t")
    return line[: len(line) - len(rest)].expandtabs(TAB) + rest


def _lines_inside_strings(text: str) -> Iterator[int]:
    """Yield the numbers, from 0, of the lines that begin in the middle of a string."""
    for found in LITERALS.finditer(text):
        if "\n" in found.group():
            first = text.count("\n", 0, found.start())
            yield from range(first + 1, first + 1 + found.group().count("\n"))
