"""GLSL cut into tokens: nothing is lost, so that the pieces put together are the text again."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from enum import Enum, auto
from typing import NamedTuple


class Kind(Enum):
    """What a token is."""

    NEWLINE = auto()
    SPACE = auto()  # a backslash that joins two lines, too
    COMMENT = auto()
    NAME = auto()  # keywords, too
    NUMBER = auto()
    SYMBOL = auto()  # one character, whatever it is


class Token(NamedTuple):
    """A piece of a shader.

    Attributes
    ----------
    kind : Kind
    text : str
    line : int
        Where it begins, from 1.
    directive : str
        Of a preprocessor line: `define`, `ifdef`, ..., also in what follows on it; else empty.
    column : int
        Where it begins in its line, from 0.
    """

    kind: Kind
    text: str
    line: int
    directive: str = ""
    column: int = 0

    @property
    def is_code(self) -> bool:
        """Whether it is anything but white space and comments."""
        return self.kind in (Kind.NAME, Kind.NUMBER, Kind.SYMBOL)


_PATTERN = re.compile(
    r"""(?P<NEWLINE>\r\n|\n|\r)
      | (?P<SPACE>(?:[^\S\n\r]|\\(?:\r\n|\n|\r))+)
      | (?P<COMMENT>//[^\n\r]*|/\*.*?(?:\*/|\Z))
      | (?P<NAME>[A-Za-z_][A-Za-z_0-9]*)
      | (?P<NUMBER>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?[A-Za-z_0-9]*)
      | (?P<SYMBOL>.)
    """,
    re.VERBOSE | re.DOTALL,
)
_LINE_END = re.compile(r"\r\n|\n|\r")
_DIRECTIVE_NAME = re.compile(r"\s*([a-z]*)")


def tokenize(source: str) -> list[Token]:
    """Return the tokens of a text; any text has some."""
    tokens, line, start, directive, at_start = [], 1, 0, "", True
    for found in _PATTERN.finditer(source):
        kind, text = Kind[found.lastgroup or "SYMBOL"], found[0]
        if kind is Kind.NEWLINE:
            directive, at_start = "", True
        elif text == "#" and at_start:
            name = _DIRECTIVE_NAME.match(source, found.end())
            directive = (name and name[1]) or "#"
        at_start = at_start and kind in (Kind.NEWLINE, Kind.SPACE, Kind.COMMENT)
        tokens.append(Token(kind, text, line, directive, found.start() - start))
        for end in _LINE_END.finditer(text):
            line, start = line + 1, found.start() + end.end()
    return tokens


def text_of(tokens: Iterable[Token]) -> str:
    """Return the text that tokens are made of."""
    return "".join(token.text for token in tokens)


def code_of(tokens: Iterable[Token]) -> list[Token]:
    """Return what the compiler itself sees: no space, no comments, no preprocessor lines."""
    return [token for token in tokens if token.is_code and not token.directive]


def next_code(tokens: Sequence[Token], place: int) -> str:
    """Return the text of the next token that is no space or comment; at the end none."""
    token = tokens[place]
    for later in tokens[place + 1 :]:
        if later.directive != token.directive:
            if token.directive:  # it is at the end of its preprocessor line
                return ""
            continue
        if later.is_code:
            return later.text
    return ""


def directives(tokens: Iterable[Token]) -> Iterator[list[Token]]:
    """Yield each preprocessor line: what of it is code, after the `#`."""
    held: list[Token] = []
    for token in tokens:
        if held and not token.directive:
            yield held
            held = []
        if token.directive and token.is_code and not (token.text == "#" and not held):
            held.append(token)
    if held:
        yield held
