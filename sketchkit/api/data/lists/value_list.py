"""What all of Processing's lists can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from os import PathLike
from typing import Generic, Protocol, Self, TypeVar, overload

from sketchkit.api.chance import chance
from sketchkit.api.data.faults import PlaceError, no_place, whole
from sketchkit.api.data.saving import save_text

T = TypeVar("T")


class Writes(Protocol):
    """What a list can be written to: a `PrintWriter`, or one of Python's own files."""

    def write(self, text: str, /) -> object:
        """Write a text."""
        ...


class ValueList(ABC, Generic[T]):
    """Values in a row, all of one kind.

    Like Python's own lists they can be looped over, measured with `len()`, asked with `in`, and
    their values read and changed as `values[0]`.
    """

    _blank: T  # what stands in places that were never set

    def __init__(self, *items: object) -> None:
        first = items[0] if len(items) == 1 else None
        if isinstance(first, Iterable) and not isinstance(first, str | bytes):
            items = tuple(first)
        elif isinstance(first, int) and not isinstance(first, bool):
            items = ()  # how many values there will be: here nobody needs to know
        self._values: list[T] = [self._read(item) for item in items]

    @abstractmethod
    def _read(self, item: object) -> T:
        """Return what an item of a list of anything means here."""

    @abstractmethod
    def _taken(self, name: str, value: object) -> T:
        """Return a value that a function was given, or raise what is wrong with it."""

    @abstractmethod
    def _text(self, value: T) -> str:
        """Return a value as it is printed."""

    def _quoted(self, value: T) -> str:
        """Return a value as JSON has it."""
        return self._text(value)

    def size(self) -> int:
        """Return how many values there are."""
        return len(self._values)

    def resize(self, length: int) -> None:
        """Have so many values: cut off the last ones, or add blank ones."""
        self._values[length:] = [self._blank] * (length - len(self._values))

    def clear(self) -> None:
        """Remove all values."""
        self._values.clear()

    def get(self, index: int) -> T:
        """Return the value at a place, counted from 0."""
        return self._values[self._place("get", index)]

    def set(self, index: int, what: T) -> None:
        """Set the value at a place; a list that is too short grows."""
        place = whole("set", index)
        if place < 0:
            raise no_place("set", index, self._values)
        value = self._taken("set", what)
        if place >= len(self._values):
            self.resize(place + 1)
        self._values[place] = value

    def push(self, value: T) -> None:
        """Add a value at the end."""
        self._values.append(self._taken("push", value))

    def pop(self) -> T:
        """Remove the last value, and return it."""
        if not self._values:
            raise no_place("pop", "", self._values)
        return self._values.pop()

    def append(self, value: T | Iterable[T]) -> None:
        """Add a value at the end, or all values of a list."""
        if isinstance(value, Iterable) and not isinstance(value, str | bytes):
            self._values += [self._taken("append", item) for item in value]
        else:
            self._values.append(self._taken("append", value))

    def appendUnique(self, value: T) -> None:
        """Add a value at the end, unless it is there already."""
        if not self.hasValue(value):
            self._values.append(self._taken("appendUnique", value))

    def insert(self, index: int, value: T | Iterable[T]) -> None:
        """Put a value, or all values of a list, before the one at a place."""
        place = whole("insert", index)
        if not 0 <= place <= len(self._values):
            raise no_place("insert", index, range(len(self._values) + 1), "place")
        is_list = isinstance(value, Iterable) and not isinstance(value, str | bytes)
        items: Iterable[object] = value if is_list else [value]  # type: ignore[assignment] # as told
        self._values[place:place] = [self._taken("insert", item) for item in items]

    def remove(self, index: int) -> T:
        """Remove the value at a place, and return it."""
        return self._values.pop(self._place("remove", index))

    def removeValue(self, value: T) -> int:
        """Remove a value where it is first, and return where that was; -1 if it is not there."""
        place = self.index(value)
        if place >= 0:
            del self._values[place]
        return place

    def removeValues(self, value: T) -> int:
        """Remove a value wherever it is, and return how often that was."""
        count = len(self._values)
        self._values = [v for v in self._values if not _is_same(v, value)]
        return count - len(self._values)

    def replaceValue(self, value: T, newValue: T) -> bool:
        """Replace a value where it is first; return whether it is there."""
        place = self.index(value)
        if place >= 0:
            self._values[place] = self._taken("replaceValue", newValue)
        return place >= 0

    def replaceValues(self, value: T, newValue: T) -> bool:
        """Replace a value wherever it is; return whether it is there."""
        new = self._taken("replaceValues", newValue)
        is_there = self.hasValue(value)
        self._values = [new if _is_same(v, value) else v for v in self._values]
        return is_there

    def index(self, what: T) -> int:
        """Return where a value is first, or -1."""
        return next((p for p, v in enumerate(self._values) if _is_same(v, what)), -1)

    def hasValue(self, value: T) -> bool:
        """Return whether a value is there."""
        return self.index(value) >= 0

    def reverse(self) -> None:
        """Turn the order around."""
        self._values.reverse()

    @abstractmethod
    def sort(self) -> None:
        """Sort the values, the smallest first."""

    @abstractmethod
    def sortReverse(self) -> None:
        """Sort the values, the largest first."""

    def shuffle(self, sketch: object = None) -> None:
        """Mix the values, with the sketch's random numbers: `randomSeed()` makes it the same."""
        for last in range(len(self._values) - 1, 0, -1):
            other = int(chance().below(last + 1))
            values = self._values
            values[last], values[other] = values[other], values[last]

    def choice(self) -> T:
        """Return one of the values by chance; `randomSeed()` makes it the same."""
        return self._values[self._any_place("choice")]

    def removeChoice(self) -> T:
        """Remove one of the values by chance, and return it."""
        return self._values.pop(self._any_place("removeChoice"))

    def copy(self) -> Self:
        """Return another list of the same values."""
        return type(self)(self._values)

    def getSubset(self, start: int, num: int | None = None) -> Self:
        """Return a list of `num` values from a place on; of all that follow if it is left out."""
        first, count = whole("getSubset", start), len(self._values)
        end = count if num is None else first + whole("getSubset", num)
        if not 0 <= first <= end <= count:
            raise PlaceError(
                f"getSubset() reaches beyond the list, which has {count} values.",
                got=f"getSubset({start})" if num is None else f"getSubset({start}, {num})",
            )
        return type(self)(self._values[first:end])

    def values(self) -> list[T]:
        """Return the values in a list of Python's."""
        return list(self._values)

    toArray = values
    array = values

    def iterator(self) -> Iterator[T]:
        """Return what `next()` takes the values of, one after the other."""
        return iter(self)

    def join(self, separator: str) -> str:
        """Return the values as one text, with a separator between them."""
        return str(separator).join(map(self._text, self._values))

    def print(self) -> None:
        """Print the values, each on its line with its place."""
        for place, value in enumerate(self._values):
            print(f"[{place}] {self._text(value)}")

    def save(self, file: str | PathLike[str]) -> None:
        """Write a file with a value in each line."""
        save_text("save", file, self._lines())

    def write(self, writer: Writes) -> None:
        """Write a value in each line to what `createWriter()` has made."""
        writer.write(self._lines())

    def toJSON(self) -> str:
        """Return the list as JSON."""
        return f"[ {', '.join(map(self._quoted, self._values))} ]"

    def _lines(self) -> str:
        return "".join(f"{self._text(value)}\n" for value in self._values)

    def _place(self, name: str, index: object) -> int:
        place = whole(name, index)
        if not 0 <= place < len(self._values):
            raise no_place(name, index, self._values)
        return place

    def _any_place(self, name: str) -> int:
        if not self._values:
            raise no_place(name, "", self._values)
        return int(chance().below(len(self._values)))

    def __len__(self) -> int:
        return len(self._values)

    def __iter__(self) -> Iterator[T]:
        return iter(self._values)

    def __contains__(self, value: object) -> bool:
        return any(_is_same(v, value) for v in self._values)

    @overload
    def __getitem__(self, place: int) -> T: ...
    @overload
    def __getitem__(self, place: slice) -> list[T]: ...
    def __getitem__(self, place: int | slice) -> T | list[T]:
        try:
            return self._values[place]
        except IndexError:
            raise no_place("get", place, self._values) from None

    def __setitem__(self, place: int, value: T) -> None:
        try:
            self._values[place] = self._taken("set", value)
        except IndexError:
            raise no_place("get", place, self._values) from None

    def __delitem__(self, place: int | slice) -> None:
        del self._values[place]

    def __eq__(self, other: object) -> bool:
        if isinstance(other, ValueList | list | tuple):
            return self._values == list(other)
        return NotImplemented

    __hash__ = None  # type: ignore[assignment] # it can change, as a list

    def __repr__(self) -> str:
        return f"{type(self).__name__} size={len(self._values)} {self.toJSON()}"


def _is_same(a: object, b: object) -> bool:
    """Return whether two values are equal; what is no number (NaN) is equal to its like."""
    return bool(a == b or (a != a and b != b))
