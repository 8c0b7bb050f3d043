"""What all of Processing's dictionaries can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from typing import Any, Generic, NamedTuple, Self, TypeVar

from sketchkit.api.data.faults import no_name, no_place, whole, wrong_kind
from sketchkit.api.data.lists.value_list import Writes
from sketchkit.api.data.saving import save_text
from sketchkit.api.data.streams import BufferedReader
from sketchkit.core.errors import SketchError
from sketchkit.data.json_writing import quote

V = TypeVar("V")


class Entry(NamedTuple, Generic[V]):
    """A key and its value, `entry.key` and `entry.value`."""

    key: str
    value: V


class ValueDict(ABC, Generic[V]):
    """Values that are found by their keys, which are texts; all of one kind, and in an order.

    Like Python's own dictionaries they can be looped over, measured with `len()`, asked with `in`,
    and their values read and changed as `values["name"]`.
    """

    def __init__(self, keys: object = None, values: Iterable[object] | None = None) -> None:
        self._values: dict[str, V] = {}
        if values is not None:
            pairs = _paired(type(self).__name__, keys, values)
        elif isinstance(keys, BufferedReader):
            lines = (line.split("\t") for line in keys)
            pairs = [(line[0], line[1]) for line in lines if len(line) == 2]
        elif isinstance(keys, Mapping | ValueDict):
            pairs = list(keys.items())
        elif isinstance(keys, Iterable):
            pairs = [(pair[0], pair[1]) for pair in keys]
        else:
            pairs = []  # or how many there will be, which nobody needs to know
        for key, value in pairs:
            self._values[self._key(type(self).__name__, key)] = self._read(value)

    @abstractmethod
    def _read(self, item: object) -> V:
        """Return what a value of any kind means here."""

    @abstractmethod
    def _taken(self, name: str, value: object, key: str) -> V:
        """Return a value that a function was given, or raise what is wrong with it."""

    @abstractmethod
    def _text(self, value: V) -> str:
        """Return a value as it is printed."""

    @abstractmethod
    def _rank(self, value: V) -> Any:  # noqa: ANN401 what Python can compare
        """Return what a value is sorted by."""

    def _quoted(self, value: V) -> str:
        """Return a value as JSON has it."""
        return self._text(value)

    def size(self) -> int:
        """Return how many keys there are."""
        return len(self._values)

    def resize(self, length: int) -> None:
        """Keep the first keys alone."""
        if not 1 <= length <= len(self._values):
            raise no_place("resize", length, range(len(self._values) + 1), "length")
        self._replace(list(self._values.items())[:length])

    def clear(self) -> None:
        """Remove all keys."""
        self._values.clear()

    def get(self, key: str, alternate: V | None = None) -> V | None:
        """Return the value of a key, or another if there is no such key."""
        return self._values.get(key, alternate)

    def set(self, key: str, amount: V) -> None:
        """Set the value of a key; a new one comes last."""
        name = self._key("set", key)
        self._values[name] = self._taken("set", amount, name)

    def hasKey(self, key: str) -> bool:
        """Return whether there is a key."""
        return key in self._values

    def remove(self, key: str) -> V:
        """Remove a key, and return its value."""
        self._check(key)
        return self._values.pop(key)

    def index(self, what: str) -> int:
        """Return the place of a key, or -1."""
        return next((p for p, key in enumerate(self._values) if key == what), -1)

    def key(self, index: int) -> str:
        """Return the key at a place, counted from 0."""
        return list(self._values)[self._place("key", index)]

    def value(self, index: int) -> V:
        """Return the value at a place, counted from 0."""
        return list(self._values.values())[self._place("value", index)]

    def setIndex(self, index: int, key: str, value: V) -> None:
        """Have another key and value at a place."""
        entries = list(self._values.items())
        name = self._key("setIndex", key)
        entries[self._place("setIndex", index)] = (name, self._taken("setIndex", value, name))
        self._replace(entries)

    def removeIndex(self, index: int) -> V:
        """Remove the key at a place, and return its value."""
        return self._values.pop(self.key(self._place("removeIndex", index)))

    def swap(self, a: int, b: int) -> None:
        """Exchange what is at two places."""
        first, second = self._place("swap", a), self._place("swap", b)
        entries = list(self._values.items())
        entries[first], entries[second] = entries[second], entries[first]
        self._replace(entries)

    def keys(self) -> list[str]:
        """Return the keys."""
        return list(self._values)

    keyArray = keys

    def values(self) -> list[V]:
        """Return the values."""
        return list(self._values.values())

    valueArray = values

    def items(self) -> list[tuple[str, V]]:
        """Return the keys with their values, as Python's dictionaries do."""
        return list(self._values.items())

    def entries(self) -> list[Entry[V]]:
        """Return the keys with their values: each has a `key` and a `value`."""
        return [Entry(key, value) for key, value in self._values.items()]

    def keyIterator(self) -> Iterator[str]:
        """Return what `next()` takes the keys of, one after the other."""
        return iter(self.keys())

    def valueIterator(self) -> Iterator[V]:
        """Return what `next()` takes the values of, one after the other."""
        return iter(self.values())

    def entryIterator(self) -> Iterator[Entry[V]]:
        """Return what `next()` takes keys with their values of, one after the other."""
        return iter(self.entries())

    def sortKeys(self) -> None:
        """Sort by the keys; small and capital letters are the same."""
        self._sort(by_key=True, is_reversed=False)

    def sortKeysReverse(self) -> None:
        """Sort by the keys, against the alphabet."""
        self._sort(by_key=True, is_reversed=True)

    def sortValues(self, stable: bool = True) -> None:
        """Sort by the values, the smallest first; equal ones by their keys."""
        self._sort(by_key=False, is_reversed=False)

    def sortValuesReverse(self, stable: bool = True) -> None:
        """Sort by the values, the largest first; equal ones by their keys, the last one first."""
        self._sort(by_key=False, is_reversed=True)

    def copy(self) -> Self:
        """Return another dictionary of the same keys and values."""
        return type(self)(self._values)

    def print(self) -> None:
        """Print each key with its value."""
        for key, value in self._values.items():
            print(key, "=", self._text(value))

    def save(self, file: str | PathLike[str]) -> None:
        """Write a file with a key, a tab and its value in each line."""
        save_text("save", file, self._lines())

    def write(self, writer: Writes) -> None:
        """Write a key, a tab and its value in each line to what `createWriter()` has made."""
        writer.write(self._lines())

    def toJSON(self) -> str:
        """Return the dictionary as JSON."""
        pairs = (f"{quote(key)}: {self._quoted(v)}" for key, v in self._values.items())
        return f"{{ {', '.join(pairs)} }}"

    def _lines(self) -> str:
        return "".join(f"{key}\t{self._text(value)}\n" for key, value in self._values.items())

    def _sort(self, *, by_key: bool, is_reversed: bool) -> None:
        def rank(entry: tuple[str, V]) -> tuple[object, object]:
            name, value = entry[0].lower(), self._rank(entry[1])
            return (name, value) if by_key else (value, name)

        self._replace(sorted(self._values.items(), key=rank, reverse=is_reversed))

    def _replace(self, entries: Iterable[tuple[str, V]]) -> None:
        self._values = dict(entries)

    def _key(self, name: str, key: object) -> str:
        if isinstance(key, str):
            return key
        raise wrong_kind(name, "text as the key", key, f"str({key!r}) makes text of it.")

    def _check(self, key: object) -> None:
        if key not in self._values:
            raise no_name(f"This {type(self).__name__}", "key", key, self._values)

    def _place(self, name: str, index: object) -> int:
        place = whole(name, index)
        if not 0 <= place < len(self._values):
            raise no_place(name, index, self._values, "key")
        return place

    def __len__(self) -> int:
        return len(self._values)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __contains__(self, key: object) -> bool:
        return key in self._values

    def __getitem__(self, key: str) -> V:
        self._check(key)
        return self._values[key]

    def __setitem__(self, key: str, value: V) -> None:
        self.set(key, value)

    def __delitem__(self, key: str) -> None:
        self.remove(key)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, ValueDict | Mapping):
            return self._values == dict(other.items())
        return NotImplemented

    __hash__ = None  # type: ignore[assignment] # it can change, as a dictionary

    def __repr__(self) -> str:
        return f"{type(self).__name__} size={len(self._values)} {self.toJSON()}"


def _paired(name: str, keys: object, values: Iterable[object]) -> list[tuple[object, object]]:
    names, amounts = list(keys) if isinstance(keys, Iterable) else [], list(values)
    if len(names) != len(amounts):
        raise SketchError(
            f"{name}() takes as many keys as values.",
            got=f"{len(names)} keys and {len(amounts)} values",
        )
    return list(zip(names, amounts, strict=True))
