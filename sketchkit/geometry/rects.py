"""Rectangles: what `rectMode()` makes of four numbers."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import CENTER, CORNER, CORNERS

F32 = NDArray[np.float32]


def rect_edges(mode: int, numbers: F32) -> tuple[F32, F32, F32, F32]:
    """Return left, top, right and bottom, (n,) each, with left <= right and top <= bottom.

    Parameters
    ----------
    mode : CORNER, CORNERS, CENTER or RADIUS
    numbers : (n, 4) float32
        As the sketch gave them.
    """
    a, b, c, d = numbers.T
    if mode == CORNER:
        left, top, right, bottom = a, b, a + c, b + d
    elif mode == CORNERS:
        left, top, right, bottom = a, b, c, d
    else:
        half_width, half_height = (c / 2, d / 2) if mode == CENTER else (c, d)
        left, right = a - half_width, a + half_width
        top, bottom = b - half_height, b + half_height
    return (
        np.minimum(left, right),
        np.minimum(top, bottom),
        np.maximum(left, right),
        np.maximum(top, bottom),
    )


def rect_corners(mode: int, numbers: F32) -> tuple[F32, F32]:
    """Return x and y of the corners, (n, 4) each: clockwise from the top left."""
    left, top, right, bottom = rect_edges(mode, numbers)
    return (
        np.stack([left, right, right, left], axis=1),
        np.stack([top, top, bottom, bottom], axis=1),
    )
