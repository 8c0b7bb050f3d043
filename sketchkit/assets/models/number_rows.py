"""Rows of numbers in a text file: read all at once, and wrong ones told by their line."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np

from sketchkit.assets.models.data import F32, broken, said
from sketchkit.core.errors import SketchError


class NumberRows:
    """Rows of `width` numbers, as they were written."""

    def __init__(self, width: int) -> None:
        self.width = width
        self.words: list[bytes] = []
        self.lines: list[int] = []

    def __len__(self) -> int:
        return len(self.lines)

    def add(self, path: Path, line: int, words: list[bytes]) -> None:
        """Take the row in a line; what follows the numbers does not count.

        Raises
        ------
        SketchError
            If there are too few.
        """
        if len(words) < self.width:
            problem = f"there have to be {self.width} numbers"
            raise broken(path, f"line {line}", problem, got=str(len(words)))
        self.words += words if len(words) == self.width else words[: self.width]
        self.lines.append(line)

    def array(self, path: Path) -> F32:
        """Return the rows as (n, width) float32.

        Raises
        ------
        SketchError
            If something is no number, or too large for 32 bits.
        """
        try:
            values = single(map(float, self.words))
        except ValueError:
            values = single(float(word) if is_number(word) else np.nan for word in self.words)
        wrong = np.flatnonzero(~np.isfinite(values))
        if len(wrong):
            line = self.lines[int(wrong[0]) // self.width]
            raise not_a_number(path, line, self.words[int(wrong[0])])
        return values.reshape(-1, self.width)


def not_a_number(path: Path, line: int, word: bytes) -> SketchError:
    """Return the error for a word where a number has to be."""
    hint = "Decimals have a point, not a comma." if b"," in word else None
    problem = f"{said(word)[:40]!r} is no number that can be drawn"
    return broken(path, f"line {line}", problem, hint=hint)


def single(numbers: Iterable[float]) -> F32:
    """Return numbers as float32; too large ones become infinite."""
    with np.errstate(over="ignore"):
        return np.array(list(numbers), np.float64).astype(np.float32)


def is_number(word: str | bytes) -> bool:
    """Return whether a word can be read as a number."""
    try:
        float(word)
    except ValueError:
        return False
    return True
