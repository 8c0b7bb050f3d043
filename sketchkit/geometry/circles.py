"""Circles as Processing draws them: polygons with corners at whole multiples of half a degree."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

F32 = NDArray[np.float32]
I64 = NDArray[np.int64]

HALF_DEGREES = 720  # entries of Processing's table of sines
FEWEST_SIDES = 20
MOST_SIDES = 200
PIXELS_PER_SIDE = 10.0

_angles = np.arange(HALF_DEGREES) * (np.pi / 360)
SINES: F32 = np.sin(_angles).astype(np.float32)
COSINES: F32 = np.cos(_angles).astype(np.float32)


def side_count(diagonals: F32) -> I64:
    """Return how many sides a circle gets.

    Parameters
    ----------
    diagonals : (n,) float32, pixels
        Length on the screen of the diagonal of the bounding box, or the weight of a point.
    """
    sides = np.float32(2 * np.pi) * diagonals / np.float32(PIXELS_PER_SIDE)
    counts: I64 = np.clip(np.nan_to_num(sides), FEWEST_SIDES, MOST_SIDES).astype(np.int64)
    return counts


@cache
def unit_circle(sides: int) -> tuple[F32, F32]:
    """Return cosines and sines of the corners of a polygon in the unit circle, (sides,) each."""
    # Processing adds up the step in single precision and cuts off: where 720 / sides is no whole
    # number, the sum decides which entry of the table is taken.
    step = np.float32(HALF_DEGREES) / np.float32(sides)
    steps = np.full(sides, step, np.float32)
    steps[0] = 0
    entry = np.add.accumulate(steps).astype(np.int64) % HALF_DEGREES
    return COSINES[entry], SINES[entry]


@cache
def fan(corners: int, *, closed: bool) -> I64:
    """Return the triangles from corner 0 to each pair of neighbours among the other corners.

    Returns
    -------
    (t, 3) int64
        `closed` adds the triangle from the last corner back to corner 1.
    """
    second = np.arange(1, corners if closed else corners - 1)
    third = second + 1
    if closed:
        third[-1] = 1
    return np.stack([np.zeros_like(second), second, third], axis=1)
