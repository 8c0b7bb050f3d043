"""A table of `assignment.toml` as it is read: each value checked, mistakes told with their line."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sketchkit.core.errors import either, nearest
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.lines import line_of

FILE_NAME = "assignment.toml"


@dataclass(frozen=True)
class Document:
    """The text that tables are read from, and the assignment's folder."""

    text: str
    folder: Path


class Table:
    """One table: it remembers what has been asked for, so that the rest can be refused.

    Parameters
    ----------
    content : mapping
    document : Document
    path : sequence
        Where it stands in the file: `("checks", 0)`.
    noun : str
        What it is, with its article: "an image check".
    """

    def __init__(
        self,
        content: Mapping[str, object],
        document: Document,
        path: Sequence[str | int] = (),
        noun: str = "an assignment",
    ) -> None:
        self.document = document
        self.noun = noun
        self._content = content
        self._path = tuple(path)
        self._known: set[str] = set()

    def __contains__(self, key: str) -> bool:
        self._known.add(key)
        return key in self._content

    @property
    def subject(self) -> str:
        """What it is, to begin a sentence with: "An image check"."""
        return self.noun[0].upper() + self.noun[1:]

    def value(self, key: str) -> object:
        """Return what stands for a key; None if nothing does (TOML itself has no None)."""
        self._known.add(key)
        return self._content.get(key)

    def required(self, key: str, example: str) -> object:
        """Return what stands for a key, which has to be there; `example` shows how to write it."""
        value = self.value(key)
        if value is not None:
            return value
        others = [other for other in self._content if other not in self._known]
        if (slip := nearest(key, others)) is not None:
            raise self.unknown(slip, key)
        raise self.error(f"{self.subject} needs {key}.", hint=f"Write {example}.")

    def text(self, key: str, default: str | None = None, *, example: str = "") -> str:
        """Return a text; it has to be there if there is no default."""
        value = self.required(key, example) if default is None else self.value(key)
        if value is None:
            assert default is not None
            return default
        if not isinstance(value, str):
            raise self.error(f"{key} is a text, not {shown(value)}.", key, f'Write {key} = "...".')
        return value

    def choice(self, key: str, choices: Sequence[str], default: str) -> str:
        """Return one of several texts."""
        value = self.text(key, default)
        if value in choices:
            return value
        slip = nearest(value, choices)
        raise self.error(
            f"{key} is {either(repr(choice) for choice in choices)}, not {value!r}.",
            key,
            f"Do you mean {slip!r}?" if slip else None,
        )

    def number(
        self, key: str, default: float, *, least: float = -math.inf, above: float = -math.inf
    ) -> float:
        """Return a number of at least `least` and above `above`."""
        value = self.value(key)
        return default if value is None else self.as_number(value, key, least=least, above=above)

    def as_number(
        self, value: object, key: str, *, least: float = -math.inf, above: float = -math.inf
    ) -> float:
        """Return a value of a key as a number, or refuse it."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(f"{key} is a number, not {shown(value)}.", key)
        if not math.isfinite(value):
            raise self.error(f"{key} is a number, not {value}.", key)
        if value <= above:
            raise self.error(f"{key} is more than {above:g}, not {value:g}.", key)
        if value < least:
            raise self.error(f"{key} is at least {least:g}, not {value:g}.", key)
        return float(value)

    def whole(self, key: str, default: int, *, least: int = 0) -> int:
        """Return a whole number."""
        value = self.number(key, default, least=least)
        if value != int(value):
            raise self.error(f"{key} is a whole number, not {value:g}.", key)
        return int(value)

    def texts(self, key: str) -> tuple[str, ...]:
        """Return one text, or the texts of a list."""
        value = self.value(key)
        items = [] if value is None else value if isinstance(value, list) else [value]
        if not all(isinstance(item, str) for item in items):
            raise self.error(f'{key} is a text or a list of texts: ["a", "b"].', key)
        return tuple(items)

    def table(self, key: str, noun: str) -> Table | None:
        """Return a table within this one; None if there is none."""
        value = self.value(key)
        if value is None:
            return None
        if not isinstance(value, Mapping):
            raise self.error(
                f"{key} is a table, not {shown(value)}.", key, f"Write {key} = {{ name = value }}."
            )
        return Table(value, self.document, (*self._path, key), noun)

    def entries(self) -> dict[str, object]:
        """Return all keys and values, for tables whose keys are free."""
        self._known.update(self._content)
        return dict(self._content)

    def finish(self, also: Sequence[str] = ()) -> None:
        """Refuse what nobody has asked for, and what is not among some other keys."""
        self._known.update(also)
        for key in self._content:
            if key not in self._known:
                raise self.unknown(key, nearest(key, sorted(self._known)))

    def unknown(self, key: str, known: str | None) -> AssignmentError:
        """Return the error for a key that means nothing here."""
        hint = f"Do you mean {known}?" if known else f"Its keys are {_listed(self._known)}."
        return self.error(f"{key} is no key of {self.noun}.", key, hint)

    def error(
        self, problem: str, key: str | None = None, hint: str | None = None
    ) -> AssignmentError:
        """Return an error about a key of this table, or about all of it."""
        path = self._path if key is None else (*self._path, key)
        line = line_of(self.document.text, path)
        return AssignmentError(problem, file=FILE_NAME, line=line, hint=hint)


def shown(value: object) -> str:
    """Return a value as the file has it, shortened.

    Examples
    --------
    >>> shown("a"), shown(True), shown([1, 2])
    ("'a'", 'true', 'a list')
    """
    match value:
        case bool():
            return str(value).lower()
        case Mapping():
            return "a table"
        case list():
            return "a list"
        case str():
            return repr(value if len(value) <= 40 else f"{value[:37]}...")
        case _:
            return str(value)


def _listed(names: set[str]) -> str:
    *others, last = sorted(names)
    return f"{', '.join(others)} and {last}" if others else last
