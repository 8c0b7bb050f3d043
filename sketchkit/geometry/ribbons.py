"""Strokes of P3D: which corners make the screen-facing strips of a polyline.

Where the corners lie on the screen is known only after projection: each has a place, the place of
the other end of its segment, and a side. Processing's strokes have no caps, and every joint is a
bevel: two triangles from the joint to the neighbouring corners of the segments that meet.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

I64 = NDArray[np.int64]


class Ribbon(NamedTuple):
    """The strips of a polyline, in indices of its points.

    Attributes
    ----------
    points, others : (v,) int64
        Where each corner lies, and the other end of its segment (itself for the middle of a joint).
    sides : (v,) float32
        +1 or -1 across the segment as seen from `points` to `others`; 0 for the middle of a joint.
    triangles : (t, 3) int64
    """

    points: I64
    others: I64
    sides: NDArray[np.float32]
    triangles: I64


@cache
def ribbon(point_count: int, *, is_closed: bool, is_joined: bool) -> Ribbon:
    """Return the strips of a polyline.

    Parameters
    ----------
    point_count : int
        At least 2.
    is_closed : bool
        Whether a segment leads back to the first point.
    is_joined : bool
        Whether joints are bevelled; thin strokes are not.
    """
    corners: list[tuple[int, int, int]] = []
    triangles: list[tuple[int, int, int]] = []
    for begin in range(point_count - (not is_closed)):
        end = (begin + 1) % point_count
        a = len(corners)
        corners += [(begin, end, 1), (begin, end, -1), (end, begin, -1), (end, begin, 1)]
        triangles += [(a, a + 1, a + 2), (a + 2, a + 1, a + 3)]
        if is_joined and begin > 0:
            previous = a - (5 if begin > 1 else 4)
            corners.append((begin, begin, 0))
            triangles += [(a + 4, previous + 2, a), (a + 4, previous + 3, a + 1)]
    if is_closed and is_joined:
        last = len(corners) - 5
        corners.append((0, 0, 0))
        middle = len(corners) - 1
        triangles += [(middle, last + 2, 0), (middle, 1, last + 3)]
    points, others, sides = np.array(corners).T
    return Ribbon(points, others, sides.astype(np.float32), np.array(triangles))
