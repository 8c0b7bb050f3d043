"""What lists of numbers can do besides."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from sketchkit.api.data.faults import no_place
from sketchkit.api.data.lists.value_list import ValueList

N = TypeVar("N", int, float)


class NumberList(ValueList[N]):
    """Numbers in a row."""

    def add(self, index: int, amount: N) -> None:
        """Add to the number at a place."""
        place = self._place("add", index)
        self._values[place] += self._taken("add", amount)

    def sub(self, index: int, amount: N) -> None:
        """Subtract from the number at a place."""
        place = self._place("sub", index)
        self._values[place] -= self._taken("sub", amount)

    def mult(self, index: int, amount: N) -> None:
        """Multiply the number at a place."""
        place = self._place("mult", index)
        self._values[place] *= self._taken("mult", amount)

    def div(self, index: int, amount: N) -> None:
        """Divide the number at a place."""
        place = self._place("div", index)
        self._values[place] = self._quotient(self._values[place], self._taken("div", amount))

    def _quotient(self, value: N, amount: N) -> N:
        raise NotImplementedError

    def min(self) -> N:
        """Return the smallest number."""
        place = self.minIndex()
        return self._values[max(place, 0)]

    def max(self) -> N:
        """Return the largest number."""
        place = self.maxIndex()
        return self._values[max(place, 0)]

    def minIndex(self) -> int:
        """Return where the smallest number is first."""
        return self._extreme("min", min)

    def maxIndex(self) -> int:
        """Return where the largest number is first."""
        return self._extreme("max", max)

    def sum(self) -> N:
        """Return all numbers added up."""
        return sum(self._values)

    def sort(self) -> None:
        """Sort the numbers, the smallest first. What is no number (NaN) comes last."""
        self._values.sort(key=_smallest_first)

    def sortReverse(self) -> None:
        """Sort the numbers, the largest first. What is no number (NaN) comes last."""
        self._values.sort(key=_largest_first)

    def _extreme(self, name: str, choose: Callable[..., int]) -> int:
        if not self._values:
            raise no_place(name, "", self._values)
        places = [place for place, value in enumerate(self._values) if value == value]
        return choose(places, key=self._values.__getitem__) if places else -1


def parts_of(values: list[N]) -> list[float]:
    """Return what part of their sum each of some numbers is."""
    total = sum(values)
    return [value / total if total else float("nan") for value in values]


def _smallest_first(value: float) -> tuple[bool, float]:
    return value != value, value


def _largest_first(value: float) -> tuple[bool, float]:
    return value != value, -value
