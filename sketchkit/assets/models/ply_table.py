"""A table of a PLY file: its columns by their names."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.models.data import F32, I64, broken
from sketchkit.assets.models.ply_header import Element
from sketchkit.core.errors import SketchError

Numbers = NDArray[np.generic]


@dataclass(slots=True)
class Table:
    """The rows of an element.

    Attributes
    ----------
    count : int
    scalars : dict
        Of a property that is one number: a number for each row.
    lists : dict
        Of a property that is a list: the lengths, and all lists joined.
    rows : list of int, optional
        The line of each row, in a file of text.
    """

    count: int = 0
    scalars: dict[str, Numbers] = field(default_factory=dict)
    lists: dict[str, tuple[I64, Numbers]] = field(default_factory=dict)
    rows: list[int] = field(default_factory=list)

    def columns(self, names: tuple[str, ...]) -> F32 | None:
        """Return numbers side by side, (n, k) float32, or None if one of them is missing."""
        if not all(name in self.scalars for name in names):
            return None
        with np.errstate(over="ignore"):
            return np.stack([self.scalars[name].astype(np.float32) for name in names], axis=1)

    def where(self, noun: str, row: int) -> str:
        """Return the place of a row, in words."""
        return f"line {self.rows[row]}" if self.rows else f"{noun} {row + 1}"


def ends_early(path: Path, where: str, element: Element, rows: int) -> SketchError:
    """Return the error for a file that has only so many rows of an element."""
    return broken(
        path,
        where,
        f"the file ends after {rows} of {element.count} rows of {element.name!r}",
        hint="It was not copied whole.",
    )
