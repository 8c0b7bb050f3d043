"""`hint(ENABLE_DEPTH_SORT)`: triangles from far to near, so that translucent ones blend rightly.

Newell's algorithm without splitting, in Processing's own order of steps: where triangles cross,
no order is right, and the steps decide which one shows.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

F32 = NDArray[np.float32]
I64 = NDArray[np.int64]

MOST_COMPARED = 2000  # triangles; beyond it comparing pairs takes longer than a frame: sort alone
NEGLIGIBLE = 0.1  # of the farthest corner's distance to a plane: nearer ones count as on it


def depth_order(corners: F32) -> I64:
    """Return the triangles' order, the farthest first, (t,).

    `corners` is (t, 3, 3): x, y and nearness (larger is nearer), as on the screen.
    """
    low, high = corners.min(axis=1), corners.max(axis=1)
    order = _sorted_by(low[:, 2].tolist())
    if len(order) > MOST_COMPARED:
        return np.array(order)
    moved: set[int] = set()
    for position in range(len(order)):
        _place(position, order, corners, low, high, moved)
    return np.array(order)


def _sorted_by(keys: list[float]) -> list[int]:
    """Return indices by rising key: a quicksort whose order of equal keys is Processing's."""
    order = list(range(len(keys)))
    ranges = [(0, len(keys) - 1)]
    while ranges:
        left, right = ranges.pop()
        middle = (left + right) // 2
        order[left], order[middle] = order[middle], order[left]
        pivot, k = keys[order[left]], left
        for i in range(left + 1, right + 1):
            if keys[order[i]] < pivot:
                k += 1
                order[k], order[i] = order[i], order[k]
        order[left], order[k] = order[k], order[left]
        if k + 1 < right:
            ranges.append((k + 1, right))
        if left < k - 1:
            ranges.append((left, k - 1))
    return order


def _place(
    position: int, order: list[int], corners: F32, low: F32, high: F32, moved: set[int]
) -> None:
    """Bring a triangle to `position` that hides none of those after it."""
    tried: set[int] = set()
    other = position + 1
    while other < len(order):
        active, test = order[position], order[other]
        if high[active, 2] <= low[test, 2] and test not in moved:
            return  # those that follow are all nearer
        apart = (high[active, :2] <= low[test, :2]) | (low[active, :2] >= high[test, :2])
        if (
            apart.any()
            or _is_beside(corners[test], corners[active], -1)
            or _is_beside(corners[active], corners[test], 1)
            or test in tried
        ):
            other += 1
            continue
        tried.add(active)
        moved.add(test)
        order.insert(position, order.pop(other))
        other = position + 1


def _is_beside(plane: F32, triangle: F32, nearness: int) -> bool:
    """Return whether a triangle lies on the near (+1) or far (-1) side of another's plane.

    For triangles in one plane rounding decides, so the steps are Processing's, in single precision.
    """
    first = plane[0]
    (ax, ay, az), (bx, by, bz) = plane[1] - first, plane[2] - first
    normal = np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], np.float32)
    square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]
    if not square:
        return True
    normal = normal * (np.float32(1) / np.sqrt(square))
    level = _dot(normal, first)
    distances = _dot(normal, triangle.T) - level
    toward = _dot(normal, first + np.array([0, 0, 100 * nearness], np.float32)) - level
    sizes = np.abs(distances)
    distances[sizes < sizes.max() * np.float32(NEGLIGIBLE)] = 0
    return bool((distances * toward >= 0).all())


def _dot(normal: F32, points: F32) -> F32:
    products: F32 = normal[0] * points[0] + normal[1] * points[1] + normal[2] * points[2]
    return products
