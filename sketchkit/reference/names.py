"""Every public name of Processing's, from `processing_names.csv`."""

from __future__ import annotations

import csv
from functools import cache
from pathlib import Path
from typing import NamedTuple

TABLE = Path(__file__).with_name("processing_names.csv")
COLUMNS = ("owner", "name", "kind", "tier", "category")


class Name(NamedTuple):
    """A name of Processing's.

    Attributes
    ----------
    owner : str
        The class that it belongs to; empty for what a sketch sees by itself.
    name : str
    kind : str
        class, constant, function, handler, keyword, method or variable.
    tier : int
        1: in Processing's reference, or used by coursework; 2: used by other sketches; 3: all else.
    category : str
        Where the reference has it.
    """

    owner: str
    name: str
    kind: str
    tier: int
    category: str

    @property
    def written(self) -> str:
        """The name as sketches write it: `rect()`, `PVector.mag()`, `CENTER`."""
        brackets = "()" if self.kind in ("function", "method", "handler") else ""
        return f"{self.owner}.{self.name}{brackets}" if self.owner else f"{self.name}{brackets}"


@cache
def every_name() -> tuple[Name, ...]:
    """Return all of them, in the order of the table."""
    with TABLE.open(encoding="utf-8") as file:
        return tuple(
            Name(row["owner"], row["name"], row["kind"], int(row["tier"]), row["category"])
            for row in csv.DictReader(file)
        )


@cache
def names_by_owner() -> dict[str, frozenset[str]]:
    """Return the names of each class; those of "" are what a sketch sees by itself."""
    owners = {entry.owner for entry in every_name()}
    return {
        owner: frozenset(entry.name for entry in every_name() if entry.owner == owner)
        for owner in owners
    }
