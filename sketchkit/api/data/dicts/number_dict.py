"""What dictionaries of numbers can do besides."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from sketchkit.api.data.dicts.value_dict import ValueDict
from sketchkit.api.data.faults import no_place

N = TypeVar("N", int, float)


class NumberDict(ValueDict[N]):
    """Numbers that are found by their keys."""

    def get(self, key: str, alternate: N | None = None) -> N:
        """Return the number of a key; without such a key another, or an error if none is given."""
        if alternate is None:
            self._check(key)
            return self._values[key]
        return self._values.get(key, alternate)

    def add(self, key: str, amount: N) -> None:
        """Add to the number of a key; a new key begins with the amount."""
        number = self._taken("add", amount, key)
        if key in self._values:
            number += self._values[key]
        self._values[self._key("add", key)] = number

    def sub(self, key: str, amount: N) -> None:
        """Subtract from the number of a key; a new key begins with minus the amount."""
        self.add(key, -self._taken("sub", amount, key))

    def mult(self, key: str, amount: N) -> None:
        """Multiply the number of a key; nothing happens if there is no such key."""
        if key in self._values:
            self._values[key] *= self._taken("mult", amount, key)

    def div(self, key: str, amount: N) -> None:
        """Divide the number of a key; nothing happens if there is no such key."""
        if key in self._values:
            number = self._taken("div", amount, key)
            self._values[key] = self._quotient(self._values[key], number)

    def _quotient(self, value: N, amount: N) -> N:
        raise NotImplementedError

    def minIndex(self) -> int:
        """Return the place of the smallest number, or -1."""
        return self._extreme(min)

    def maxIndex(self) -> int:
        """Return the place of the largest number, or -1."""
        return self._extreme(max)

    def minKey(self) -> str | None:
        """Return the key of the smallest number, or None."""
        place = self.minIndex()
        return None if place < 0 else self.key(place)

    def maxKey(self) -> str | None:
        """Return the key of the largest number, or None."""
        place = self.maxIndex()
        return None if place < 0 else self.key(place)

    def minValue(self) -> N:
        """Return the smallest number."""
        return self._at("minValue", self.minIndex())

    def maxValue(self) -> N:
        """Return the largest number."""
        return self._at("maxValue", self.maxIndex())

    def sum(self) -> N:
        """Return all numbers added up."""
        return sum(self._values.values())

    def _rank(self, value: N) -> N:
        return value

    def _at(self, name: str, place: int) -> N:
        if place < 0:
            raise no_place(name, "", (), "number")
        return self.value(place)

    def _extreme(self, choose: Callable[..., int]) -> int:
        values = self.values()
        places = [place for place, value in enumerate(values) if value == value]
        return choose(places, key=values.__getitem__) if places else -1
