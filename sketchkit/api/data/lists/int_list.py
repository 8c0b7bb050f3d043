"""IntList and LongList: whole numbers in a row."""

from __future__ import annotations

from typing import Self

from sketchkit.api.data.faults import whole
from sketchkit.api.data.lists.float_list import FloatList
from sketchkit.api.data.lists.number_list import NumberList, parts_of
from sketchkit.core.errors import SketchError
from sketchkit.data.java_numbers import read_int


class IntList(NumberList[int]):
    """Whole numbers in a row.

    Parameters
    ----------
    *items
        The numbers, or one list of them. Text is read, and 0 if it is no number.

    Notes
    -----
    `IntList(10)` is empty: in Processing the number says how much room there is. Fractions are
    cut off. There is no largest number, as for Python's own.

    Examples
    --------
    >>> scores = IntList()
    >>> scores.append(30)
    >>> scores.append([10, 20])
    >>> scores.sort()
    >>> println(scores)
    IntList size=3 [ 10, 20, 30 ]
    >>> scores.sum(), scores[0], 20 in scores
    (60, 10, True)
    """

    _blank = 0

    @classmethod
    def fromRange(cls, start: int, stop: int | None = None) -> Self:
        """Return the numbers from `start` up to `stop`, without it; from 0 if there is only one."""
        first, end = (0, start) if stop is None else (start, stop)
        return cls(range(whole("fromRange", first), whole("fromRange", end)))

    def _read(self, item: object) -> int:
        if item is None:
            return 0
        if isinstance(item, str):
            return read_int(item.strip()) or 0
        return whole(type(self).__name__, item)

    def _taken(self, name: str, value: object) -> int:
        return whole(name, value)

    def _text(self, value: int) -> str:
        return str(value)

    def _quotient(self, value: int, amount: int) -> int:
        return whole_quotient(value, amount)

    def increment(self, index: int) -> None:
        """Add 1 to the number at a place; a list that is too short grows."""
        place = whole("increment", index)
        if place >= len(self._values):
            self.resize(place + 1)
        self.add(place, 1)

    def getPercent(self) -> FloatList:
        """Return what part of the sum each number is, from 0 to 1."""
        return FloatList(parts_of(self._values))

    def sumLong(self) -> int:
        """Return all numbers added up."""
        return self.sum()


class LongList(IntList):
    """Whole numbers in a row, as `IntList`.

    Parameters
    ----------
    *items
        As those of `IntList`.

    Examples
    --------
    >>> println(LongList([12345678901]))
    LongList size=1 [ 12345678901 ]
    """


def whole_quotient(value: int, amount: int) -> int:
    """Return a whole number divided by another, cut off towards 0.

    Raises
    ------
    SketchError
        If it is divided by 0.

    Examples
    --------
    >>> whole_quotient(-7, 2)
    -3
    """
    if not amount:
        raise SketchError("div() cannot divide a whole number by 0.")
    result = abs(value) // abs(amount)
    return result if (value < 0) == (amount < 0) else -result
