"""FloatDict and DoubleDict: numbers with fractions, found by their keys."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan

from sketchkit.api.data.dicts.number_dict import NumberDict
from sketchkit.api.data.faults import fraction
from sketchkit.api.data.lists.float_list import quotient
from sketchkit.api.data.lists.number_list import parts_of
from sketchkit.data.java_numbers import double_text, float_text, read_float


class FloatDict(NumberDict[float]):
    """Numbers that are found by their keys.

    Parameters
    ----------
    keys : optional
        A dictionary, a list of pairs, or a list of keys with a list of values behind it.
    values : list, optional
        The numbers of the keys.

    Examples
    --------
    >>> prices = FloatDict()
    >>> prices.set("tea", 2.5)
    >>> prices["coffee"] = 3
    >>> println(prices)
    FloatDict size=2 { "tea": 2.5, "coffee": 3.0 }
    >>> prices.maxKey(), prices.get("milk", 0)
    ('coffee', 0)
    """

    def __init__(self, keys: object = None, values: Iterable[object] | None = None) -> None:
        super().__init__(keys, values)

    def _read(self, item: object) -> float:
        if item is None:
            return nan
        if isinstance(item, str):
            number = read_float(item)
            return nan if number is None else number
        return fraction(type(self).__name__, item)

    def _taken(self, name: str, value: object, key: str) -> float:
        return fraction(name, value, place=key)

    def _text(self, value: float) -> str:
        return float_text(value)

    def _quotient(self, value: float, amount: float) -> float:
        return quotient(value, amount)

    def sumDouble(self) -> float:
        """Return all numbers added up."""
        return self.sum()

    def getPercent(self) -> FloatDict:
        """Return what part of the sum each number is, from 0 to 1."""
        return FloatDict(self.keys(), parts_of(self.values()))

    def _at(self, name: str, place: int) -> float:
        return nan if place < 0 else self.value(place)

    def _sort(self, *, by_key: bool, is_reversed: bool) -> None:
        super()._sort(by_key=by_key, is_reversed=is_reversed)
        if not by_key:  # what is no number (NaN) comes last in either direction
            self._replace(sorted(self._values.items(), key=lambda entry: entry[1] != entry[1]))

    def _rank(self, value: float) -> float:
        return 0.0 if value != value else value


class DoubleDict(FloatDict):
    """Numbers that are found by their keys, printed with all of their digits.

    Parameters
    ----------
    keys, values : optional
        As those of `FloatDict`.

    Examples
    --------
    >>> println(DoubleDict({"third": 1 / 3}))
    DoubleDict size=1 { "third": 0.3333333333333333 }
    """

    def _text(self, value: float) -> str:
        return double_text(value)
