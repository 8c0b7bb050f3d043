"""JSON that somebody else wrote: what is missing or of a wrong kind is told by its place."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from sketchkit.assets.models.data import broken
from sketchkit.core.errors import SketchError

LARGEST = 1e38  # near the end of 32 bits


class JsonPlace:
    """A value within a JSON document, and how one gets there: `meshes[0].primitives[1]`."""

    def __init__(self, path: Path, trail: str, value: object) -> None:
        self.path = path
        self.trail = trail
        self.value = value

    @classmethod
    def parsed(cls, path: Path, text: bytes) -> JsonPlace:
        """Return the whole of a document.

        Raises
        ------
        SketchError
            If it is no JSON, or no object.
        """
        try:
            value = json.loads(text)
        except json.JSONDecodeError as problem:
            where = f"line {problem.lineno}, column {problem.colno}"
            raise broken(path, where, f"this is no JSON: {problem.msg}") from None
        except (UnicodeDecodeError, RecursionError, ValueError):  # the last: digits without end
            raise SketchError(f"{path} is no JSON that can be read.") from None
        document = cls(path, "", value)
        if not isinstance(value, dict):
            raise document.wrong("an object in braces")
        return document

    def wrong(self, wanted: str) -> SketchError:
        """Return the error for a value that is not what the format has here."""
        shown = json.dumps(self.value)
        got = "nothing" if self.value is None else shown[:40] + "…" * (len(shown) > 40)
        return broken(self.path, self.trail or "line 1", f"there has to be {wanted}", got=got)

    def __contains__(self, key: str) -> bool:
        return isinstance(self.value, dict) and key in self.value

    def __getitem__(self, key: str) -> JsonPlace:
        """Return the value of a key; one that is missing is None."""
        if not isinstance(self.value, dict):
            raise self.wrong("an object in braces")
        trail = f"{self.trail}.{key}" if self.trail else key
        return JsonPlace(self.path, trail, self.value.get(key))

    def __iter__(self) -> Iterator[JsonPlace]:
        """Yield the values of a list; one that is missing has none."""
        if self.value is None:
            return
        if not isinstance(self.value, list):
            raise self.wrong("a list")
        for number, value in enumerate(self.value):
            yield JsonPlace(self.path, f"{self.trail}[{number}]", value)

    def whole(self, default: int | None = None) -> int:
        """Return a whole number from 0 on."""
        value = default if self.value is None else self.value
        if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 2**53:
            raise self.wrong("a whole number, 0 or more")
        return value

    def text(self, default: str | None = None) -> str:
        """Return a text."""
        value = default if self.value is None else self.value
        if not isinstance(value, str):
            raise self.wrong("a text")
        return value

    def numbers(self, default: tuple[float, ...]) -> tuple[float, ...]:
        """Return as many numbers as the default has."""
        if self.value is None:
            return default
        found = tuple(place._number() for place in self)
        if len(found) != len(default):
            raise self.wrong(f"a list of {len(default)} numbers")
        return found

    def _number(self) -> float:
        value = self.value
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.wrong("a number")
        if not abs(value) < LARGEST:  # so is no number, too
            raise self.wrong("a number that can be drawn")
        return float(value)

    def of(self, things: list[JsonPlace], noun: str) -> JsonPlace:
        """Return the one of a list that this number names."""
        number = self.whole()
        if number >= len(things):
            raise self.wrong(f"a number below {len(things)}, for there are so many {noun}")
        return things[number]
