"""FloatList and DoubleList: numbers with fractions in a row."""

from __future__ import annotations

from math import copysign, inf, nan

from sketchkit.api.data.faults import fraction
from sketchkit.api.data.lists.number_list import NumberList, parts_of
from sketchkit.data.java_numbers import double_text, float_text, read_float


class FloatList(NumberList[float]):
    """Numbers in a row.

    Parameters
    ----------
    *items
        The numbers, or one list of them. Text is read, and NaN if it is no number.

    Notes
    -----
    The numbers keep all of their digits; printed they have as many as Processing's floats.

    Examples
    --------
    >>> sizes = FloatList(1.5, 0.1)
    >>> sizes.append(3)
    >>> sizes.sort()
    >>> println(sizes)
    FloatList size=3 [ 0.1, 1.5, 3.0 ]
    >>> sizes.max(), sizes[0], len(sizes)
    (3.0, 0.1, 3)
    """

    _blank = 0.0

    def _read(self, item: object) -> float:
        if item is None:
            return nan
        if isinstance(item, str):
            number = read_float(item)
            return nan if number is None else number
        return fraction(type(self).__name__, item)

    def _taken(self, name: str, value: object) -> float:
        return fraction(name, value)

    def _text(self, value: float) -> str:
        return float_text(value)

    def _quotient(self, value: float, amount: float) -> float:
        return quotient(value, amount)

    def sum(self) -> float:
        """Return all numbers added up."""
        return sum(self._values, 0.0)

    def sumDouble(self) -> float:
        """Return all numbers added up."""
        return self.sum()

    def getPercent(self) -> FloatList:
        """Return what part of the sum each number is, from 0 to 1."""
        return FloatList(parts_of(self._values))

    def random(self) -> float:
        """Return one of the numbers by chance; `randomSeed()` makes it the same."""
        return self.choice()

    def print(self) -> None:
        """Print the numbers, each on its line with its place."""
        for place, value in enumerate(self._values):
            print(f"[{place}] {value:f}" if value == value else f"[{place}] NaN")


class DoubleList(FloatList):
    """Numbers in a row, printed with all of their digits.

    Parameters
    ----------
    *items
        As those of `FloatList`.

    Examples
    --------
    >>> println(DoubleList([0.1, 1 / 3]))
    DoubleList size=2 [ 0.1, 0.3333333333333333 ]
    """

    def _text(self, value: float) -> str:
        return double_text(value)


def quotient(value: float, amount: float) -> float:
    """Return a number divided by another, which may be 0: infinity, or NaN, as in Java."""
    if amount:
        return value / amount
    return copysign(inf, value) * copysign(1, amount) if value and value == value else nan
