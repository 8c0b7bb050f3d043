"""Changes to a text at places that its syntax tree names."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, order=True)
class Edit:
    """A part of a line that becomes something else: lines from 1, columns in characters from 0."""

    line: int
    column: int
    old: str
    new: str


def apply(text: str, edits: Iterable[Edit]) -> str:
    """Return a text with some edits made; none may overlap another."""
    lines = text.split("\n")
    for edit in sorted(edits, reverse=True):
        line = lines[edit.line - 1]
        end = edit.column + len(edit.old)
        assert line[edit.column : end] == edit.old
        lines[edit.line - 1] = line[: edit.column] + edit.new + line[end:]
    return "\n".join(lines)


class Tokens:
    """The words and signs of a text, by place."""

    def __init__(self, text: str) -> None:
        readline = io.StringIO(text).readline
        self._lines = text.split("\n")
        self._tokens = [
            token
            for token in tokenize.generate_tokens(readline)
            if token.type in (tokenize.OP, tokenize.NAME)
        ]

    def between(
        self, before: ast.expr, after: ast.expr, signs: Sequence[str]
    ) -> tuple[int, int] | None:
        """Return line and column of the first of some signs between two expressions."""
        start = before.end_lineno or 0, self._column(before.end_lineno, before.end_col_offset)
        end = after.lineno, self._column(after.lineno, after.col_offset)
        for token in self._tokens:
            if start <= token.start < end and token.string in signs:
                return token.start
        return None

    def name_after(self, line: int, word: str, name: str) -> tuple[int, int] | None:
        """Return where a name stands behind a word, as `f` behind `def`, from a line on."""
        for token, following in zip(self._tokens, self._tokens[1:], strict=False):
            if token.start[0] >= line and (token.string, following.string) == (word, name):
                return following.start
        return None

    def _column(self, line: int | None, offset: int | None) -> int:
        """Return a place in characters; Python's tree counts bytes."""
        text = self._lines[(line or 1) - 1]
        return len(text.encode()[: offset or 0].decode(errors="ignore"))
