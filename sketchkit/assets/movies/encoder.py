"""What all kinds of films have in common, and what a frame changes of the one before."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.errors import SketchError

U8 = NDArray[np.uint8]


class MovieError(SketchError):
    """A film cannot be written."""


class Encoder(Protocol):
    """Writes a film into an open file. It is made with the file, (width, height) and the rate."""

    def add(self, pixels: U8) -> None:
        """Take the next frame, (h, w, 3)."""
        ...

    def finish(self) -> str | None:
        """Write what is missing; return what the user should know, if there is anything."""
        ...

    def close(self) -> None:
        """Let go of what it holds, finished or not. The film's file is not its own."""
        ...


class Change(NamedTuple):
    """The smallest rectangle in which a frame differs from the one before.

    Attributes
    ----------
    frame : int
        From which frame on it is shown, counted from 0.
    x, y : int
        Its left and top edge.
    pixels : (h, w, ...) array
        What is in it now.
    """

    frame: int
    x: int
    y: int
    pixels: U8


class Changes:
    """Finds what changes from frame to frame.

    Parameters
    ----------
    grid : int, pixels
        Left and top edges are multiples of it.
    """

    def __init__(self, grid: int = 1) -> None:
        self._grid = grid
        self._last: U8 | None = None

    def next(self, frame: int, pixels: U8) -> Change | None:
        """Return what a frame changes, or None if it is the same picture."""
        last, self._last = self._last, pixels
        if last is None:
            return Change(frame, 0, 0, pixels)
        differs = pixels != last
        if differs.ndim == 3:
            differs = differs.any(axis=2)
        rows = np.flatnonzero(differs.any(axis=1))
        if not len(rows):
            return None
        top, bottom = int(rows[0]) // self._grid * self._grid, int(rows[-1]) + 1
        columns = np.flatnonzero(differs[top:bottom].any(axis=0))
        left, right = int(columns[0]) // self._grid * self._grid, int(columns[-1]) + 1
        return Change(frame, left, top, pixels[top:bottom, left:right])
