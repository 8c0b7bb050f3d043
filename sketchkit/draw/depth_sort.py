"""`hint(ENABLE_DEPTH_SORT)`: triangles from the farthest to the nearest, so that translucent ones blend.

Newell's algorithm without splitting: sort by the farthest corner, then exchange neighbours that
hide each other the wrong way round.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]

MOST_EXCHANGED = 2000  # triangles; beyond it comparing pairs takes longer than a frame, sort alone
COPLANAR = 1e-9


def depth_order(corners: F64) -> I64:
    """Return the triangles' order, the farthest first, (t,).

    `corners` is (t, 3, 3): x, y and nearness (larger is nearer) on the screen, any scale.
    """
    order = np.argsort(corners[:, :, 2].min(axis=1), kind="stable")
    if len(order) > MOST_EXCHANGED:
        return order
    low, high = corners.min(axis=1), corners.max(axis=1)
    remaining = order.tolist()
    moved: set[int] = set()
    done = []
    while remaining:
        active = _first_to_draw(remaining, corners, low, high, moved)
        remaining.remove(active)
        done.append(active)
    return np.array(done)


def _first_to_draw(
    remaining: list[int], corners: F64, low: F64, high: F64, moved: set[int]
) -> int:
    """Return which of the remaining triangles hides none of the others."""
    active = remaining[0]
    tried = {active}
    position = 1
    while position < len(remaining):
        other = remaining[position]
        if high[active, 2] <= low[other, 2] and other not in moved:
            break  # all that follow are nearer
        apart = (high[active, :2] <= low[other, :2]).any() or (
            low[active, :2] >= high[other, :2]
        ).any()
        if (
            other == active
            or apart
            or _side(corners[other], corners[active], -1) > 0
            or _side(corners[active], corners[other], 1) > 0
            or other in tried
        ):
            position += 1
            continue
        active = other
        tried.add(other)
        moved.add(other)
        position = 0
    return active


def _side(plane: F64, triangle: F64, nearness: int) -> int:
    """Return 1 if a triangle lies on the near (+1) or far (-1) side of another's plane, else 0."""
    normal = np.cross(plane[1] - plane[0], plane[2] - plane[0])
    if normal[2] * nearness < 0:
        normal = -normal
    distances = (triangle - plane[0]) @ normal
    return 1 if (distances >= -COPLANAR).all() else 0
