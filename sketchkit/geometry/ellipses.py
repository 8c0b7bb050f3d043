"""Ellipses and arcs: what `ellipseMode()` makes of four numbers, and the corners of an arc."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import CENTER, CHORD, CORNER, CORNERS, OPEN, PIE
from sketchkit.geometry.circles import COSINES, HALF_DEGREES, SINES

F32 = NDArray[np.float32]


class Boxes(NamedTuple):
    """Bounding boxes: their top left corners and sizes, (n,) float32 each."""

    x: F32
    y: F32
    width: F32
    height: F32


def ellipse_boxes(mode: int, numbers: F32) -> Boxes:
    """Return the bounding boxes of ellipses.

    Parameters
    ----------
    mode : CORNER, CORNERS, CENTER or RADIUS
    numbers : (n, 4) float32
        As the sketch gave them.
    """
    a, b, c, d = numbers.T
    if mode == CORNER:
        return Boxes(a, b, c, d)
    if mode == CORNERS:
        return Boxes(a, b, c - a, d - b)
    if mode == CENTER:
        return Boxes(a - c / 2, b - d / 2, c, d)
    return Boxes(a - c, b - d, 2 * c, 2 * d)


def upright(boxes: Boxes) -> Boxes:
    """Return the boxes with sizes that are not negative."""
    return Boxes(
        np.minimum(boxes.x, boxes.x + boxes.width),
        np.minimum(boxes.y, boxes.y + boxes.height),
        np.abs(boxes.width),
        np.abs(boxes.height),
    )


class Arc(NamedTuple):
    """An arc of the unit circle.

    Attributes
    ----------
    hub : (x, y)
        Where the triangles of the fill meet: the centre, or the middle of the flat side.
    x, y : (k,) float32
        Corners along the arc.
    is_full : bool
        Whether the arc is a whole turn, so that its outline closes without the hub.
    """

    hub: tuple[float, float]
    x: F32
    y: F32
    is_full: bool


def wrap_angles(start: float, stop: float) -> tuple[float, float] | None:
    """Return the angles with start at 0 or above and at most one turn between; None for no arc."""
    if not (math.isfinite(start) and math.isfinite(stop) and stop > start):
        return None
    turns = math.ceil(max(0.0, -start) / math.tau)
    start, stop = start + turns * math.tau, stop + turns * math.tau
    return start, min(stop, start + math.tau)


def unit_arc(start: float, stop: float, mode: int, sides: int) -> Arc:
    """Return the corners of an arc.

    Parameters
    ----------
    start, stop : float, radians
        From `wrap_angles`; clockwise on the screen from the x axis.
    mode : 0, OPEN, CHORD or PIE
    sides : int
        How many sides a whole ellipse of its size would have.
    """
    first = int(0.5 + start / math.tau * HALF_DEGREES)
    last = int(0.5 + stop / math.tau * HALF_DEGREES)
    length = min(max(last - first, 0), HALF_DEGREES)
    is_full = length == HALF_DEGREES
    if is_full and mode == CHORD:  # the first and the last corner must not coincide
        length -= 1
        last -= 1
    step = max(1, HALF_DEGREES // sides)
    along = np.append(np.arange(0, length, step), length)
    entry = (first + along) % HALF_DEGREES
    first, last = first % HALF_DEGREES, last % HALF_DEGREES
    hub = (0.0, 0.0)
    if mode in (CHORD, OPEN):
        hub = (
            float(COSINES[first] + COSINES[last]) / 2,
            float(SINES[first] + SINES[last]) / 2,
        )
    return Arc(hub, COSINES[entry], SINES[entry], is_full)


def arc_outline_passes_hub(mode: int) -> bool:
    """Return whether the outline of an arc runs through its hub."""
    return mode in (CHORD, PIE)
