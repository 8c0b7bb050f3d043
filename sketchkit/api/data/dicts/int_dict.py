"""IntDict and LongDict: whole numbers, found by their keys."""

from __future__ import annotations

from collections.abc import Iterable

from sketchkit.api.data.dicts.float_dict import FloatDict
from sketchkit.api.data.dicts.number_dict import NumberDict
from sketchkit.api.data.faults import whole
from sketchkit.api.data.lists.int_list import whole_quotient
from sketchkit.api.data.lists.number_list import parts_of
from sketchkit.data.java_numbers import read_int


class IntDict(NumberDict[int]):
    """Whole numbers that are found by their keys.

    Parameters
    ----------
    keys : optional
        A dictionary, a list of pairs, or a list of keys with a list of values behind it.
    values : list, optional
        The numbers of the keys.

    Examples
    --------
    >>> counts = IntDict()
    >>> for word in ["a", "rose", "is", "a", "rose"]:
    ...     counts.increment(word)
    >>> counts.sortValuesReverse()
    >>> println(counts)
    IntDict size=3 { "rose": 2, "a": 2, "is": 1 }
    >>> for word in counts:
    ...     println(word, counts[word])
    rose 2
    a 2
    is 1
    """

    def __init__(self, keys: object = None, values: Iterable[object] | None = None) -> None:
        super().__init__(keys, values)

    def _read(self, item: object) -> int:
        if item is None:
            return 0
        if isinstance(item, str):
            return read_int(item) or 0
        return whole(type(self).__name__, item)

    def _taken(self, name: str, value: object, key: str) -> int:
        return whole(name, value, place=key)

    def _text(self, value: int) -> str:
        return str(value)

    def _quotient(self, value: int, amount: int) -> int:
        return whole_quotient(value, amount)

    def increment(self, key: str | IntDict) -> None:
        """Add 1 to the number of a key, or to all keys what another dictionary has for them."""
        if isinstance(key, IntDict):
            for name, amount in key.items():
                self.add(name, amount)
        else:
            self.add(key, 1)

    def getPercent(self) -> FloatDict:
        """Return what part of the sum each number is, from 0 to 1."""
        return FloatDict(self.keys(), parts_of(self.values()))

    def sumLong(self) -> int:
        """Return all numbers added up."""
        return self.sum()


class LongDict(IntDict):
    """Whole numbers that are found by their keys, as `IntDict`.

    Parameters
    ----------
    keys, values : optional
        As those of `IntDict`.

    Examples
    --------
    >>> println(LongDict({"stars": 200000000000}))
    LongDict size=1 { "stars": 200000000000 }
    """
