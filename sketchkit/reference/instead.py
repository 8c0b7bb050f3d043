"""What to write for a name that sketchkit has not: sentences, from `instead.csv`.

The table also has words of Java, of older Pythons and of other languages. In its column of owners
`*` stands for whatever has no such attribute, and `import` for modules; in that of names `*` stands
for each name that the owner has in Processing's table and that has no row of its own.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from sketchkit.reference.names import names_by_owner

TABLE = Path(__file__).with_name("instead.csv")
EVERY = "*"
MODULES = "import"
BY_ITSELF = ""  # the owner of what belongs to no class


def instead_of(name: str, owners: Iterable[str] = (BY_ITSELF,)) -> str | None:
    """Return a whole sentence on what to write, or None.

    Parameters
    ----------
    name : str
        As the sketch wrote it.
    owners : iterable of str
        The classes that it may belong to, the nearest first; `""` for a name that stands alone.
    """
    table = sentences()
    for owner in owners:
        if (owner, name) in table:
            return table[owner, name]
        if (owner, EVERY) in table and name in names_by_owner().get(owner, ()):
            return table[owner, EVERY]
    return None


def instead_of_attribute(name: str, owners: Iterable[str]) -> str | None:
    """Return what to write for an attribute that an object has not: of its own kind, or of any."""
    return instead_of(name, owners) or sentences().get((EVERY, name))


@cache
def sentences() -> dict[tuple[str, str], str]:
    """Return the table, by owner and name."""
    with TABLE.open(encoding="utf-8") as file:
        return {(row["owner"], row["name"]): row["instead"] for row in csv.DictReader(file)}
