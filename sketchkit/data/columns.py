"""A column of a table: values of one kind, and how they are read and written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum
from math import nan
from typing import TypeVar

from sketchkit.data.java_numbers import double_text, float_text, read_float, read_int, read_whole

Cell = str | int | float | None
N = TypeVar("N", int, float)


class ColumnKind(IntEnum):
    """What a column holds; numbers are Processing's."""

    STRING = 0
    INT = 1
    LONG = 2
    FLOAT = 3
    DOUBLE = 4
    CATEGORY = 5  # one of few texts, which are numbered as they come


WHOLE = (ColumnKind.INT, ColumnKind.LONG)
FRACTIONAL = (ColumnKind.FLOAT, ColumnKind.DOUBLE)
BLANK: dict[ColumnKind, Cell] = {  # what a cell holds that was never set
    ColumnKind.STRING: None,
    ColumnKind.INT: 0,
    ColumnKind.LONG: 0,
    ColumnKind.FLOAT: 0.0,
    ColumnKind.DOUBLE: 0.0,
    ColumnKind.CATEGORY: 0,
}


@dataclass
class Missing:
    """What stands for a cell that is missing, or whose text is no number.

    Cells with the text `text` count as missing, too.
    """

    text: str | None = None
    whole: int = 0
    long: int = 0
    fraction: float = nan
    double: float = nan


@dataclass
class Column:
    """A column.

    Attributes
    ----------
    cells : list
        Text or None; numbers; or for categories their numbers, -1 for none.
    kind : ColumnKind
        What it holds.
    title : str or None
        Its title.
    categories : list of str or None
        The texts that are numbered.
    """

    cells: list[Cell] = field(default_factory=list)
    kind: ColumnKind = ColumnKind.STRING
    title: str | None = None
    categories: list[str | None] = field(default_factory=list)

    def resize(self, count: int) -> None:
        """Have so many cells; new ones are blank."""
        self.cells[count:] = [BLANK[self.kind]] * (count - len(self.cells))

    def text(self, row: int, missing: Missing) -> str | None:
        """Return a cell as text."""
        cell = self.cells[row]
        if self.kind is ColumnKind.CATEGORY:
            return self._category(int(cell or 0), missing)
        if self.kind in FRACTIONAL and isinstance(cell, float):
            if cell != cell:
                return None
            return float_text(cell) if self.kind is ColumnKind.FLOAT else double_text(cell)
        return None if cell is None else str(cell)

    def whole(self, row: int, missing: Missing) -> int:
        """Return a cell as a whole number: what stands before the point, or what is missing."""
        if self.kind in (*WHOLE, ColumnKind.CATEGORY):
            return int(self.cells[row] or 0)
        number = _number(read_int, self.text(row, missing), missing)
        return missing.whole if number is None else int(number)

    def long(self, row: int, missing: Missing) -> int:
        """Return a cell as a whole number of any size."""
        if self.kind in (*WHOLE, ColumnKind.CATEGORY):
            return int(self.cells[row] or 0)
        number = _number(read_whole, self.text(row, missing), missing)
        return missing.long if number is None else int(number)

    def fraction(self, row: int, missing: Missing, otherwise: float) -> float:
        """Return a cell as a number, or another if it is none."""
        cell = self.cells[row]
        if self.kind in FRACTIONAL and isinstance(cell, float):
            return cell
        number = _number(read_float, self.text(row, missing), missing)
        return otherwise if number is None else float(number)

    def put(self, row: int, value: object, missing: Missing) -> None:
        """Set a cell to what a text, or a value as text, means in a column of this kind."""
        text = None if value is None else value if isinstance(value, str) else _plain_text(value)
        self.cells[row] = self._read(text, missing)

    def convert(self, kind: ColumnKind, missing: Missing) -> None:
        """Hold another kind of values from now on; what cannot be read becomes missing."""
        texts = [self.text(row, missing) for row in range(len(self.cells))]
        self.kind = kind
        self.categories = []
        self.cells = [self._read(text, missing) for text in texts]

    def _read(self, text: str | None, missing: Missing) -> Cell:
        match self.kind:
            case ColumnKind.STRING:
                return text
            case ColumnKind.INT:
                number = None if text is None else read_int(text)
                return missing.whole if number is None else number
            case ColumnKind.LONG:
                number = None if text is None else read_whole(text)
                return missing.long if number is None else number
            case ColumnKind.CATEGORY:
                return self._number_of(text, missing)
        fraction = None if text is None else read_float(text)
        otherwise = missing.fraction if self.kind is ColumnKind.FLOAT else missing.double
        return otherwise if fraction is None else fraction

    def _number_of(self, text: str | None, missing: Missing) -> int:
        if text is None or text == missing.text:
            return -1
        if text not in self.categories:
            self.categories.append(text)
        return self.categories.index(text)

    def _category(self, number: int, missing: Missing) -> str | None:
        return self.categories[number] if 0 <= number < len(self.categories) else missing.text


def _plain_text(value: object) -> str:
    return float_text(value) if isinstance(value, float) else str(value)


def _number(read: Callable[[str], N | None], text: str | None, missing: Missing) -> N | None:
    """Return what a text is read as; None if it is missing, or cannot be read."""
    return None if text is None or text == missing.text else read(text)
