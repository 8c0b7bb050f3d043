"""The order into which Processing sorts texts and the rows of tables.

Equal ones do not keep their order there: it is a quicksort. What stands where can be seen in a
sketch, so the same steps are done here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


def sort_in_place(values: list[T], key: Callable[[T], object], *, reverse: bool = False) -> None:
    """Sort a list by what `key` makes of its values, equal ones as Processing leaves them.

    Examples
    --------
    >>> words = ["banana", "Apple", "cherry", "apple"]
    >>> sort_in_place(words, str.lower)
    >>> words
    ['apple', 'Apple', 'banana', 'cherry']
    """
    keys = [key(value) for value in values]

    def is_before(a: int, b: int) -> bool:
        first, second = (b, a) if reverse else (a, b)
        return bool(keys[first] < keys[second])  # type: ignore[operator] # keys of one kind

    def swap(a: int, b: int) -> None:
        keys[a], keys[b] = keys[b], keys[a]
        values[a], values[b] = values[b], values[a]

    ranges = [(0, len(values) - 1)]
    while ranges:
        first, last = ranges.pop()
        if first < last:
            middle = _partition(first, last, is_before, swap)
            ranges += [(first, middle - 1), (middle + 1, last)]


def _partition(
    first: int,
    last: int,
    is_before: Callable[[int, int], bool],
    swap: Callable[[int, int], None],
) -> int:
    """Bring a range in order about the value in its middle; return where that one then is."""
    swap((first + last) // 2, last)  # it waits at the end
    low, high = first - 1, last
    while True:
        low += 1
        while is_before(low, last):
            low += 1
        high -= 1
        while high > 0 and is_before(last, high):
            high -= 1
        if low >= high:
            break
        swap(low, high)
    swap(low, last)
    return low
