"""Fill polygons: turn the rings of a `beginShape()` polygon into triangles.

Which triangles shows as soon as vertices have colours of their own, so they are those of the GLU
tessellator, which Processing uses: `sweep` parts a polygon into monotone regions, and each of
these is worked off here from the right.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.geometry.predicates import Place, side
from sketchkit.geometry.sweep import Blend, Corner, Ring, Sweep

F64 = NDArray[np.float64]
U32 = NDArray[np.uint32]
I32 = NDArray[np.int32]

Point = list[float]  # x, y, z
Triangle = tuple[int, int, int]  # indices of points, counter-clockwise in the plane of the sweep

FARTHEST = 3.4e38  # float32 ends here, and so does Processing's plane


class Winding(Enum):
    """How often an outline must go round a place for that to be inside."""

    NONZERO = "nonzero"
    EVEN_ODD = "even-odd"

    def is_inside(self, number: int) -> bool:
        """Return whether places with this winding number are inside."""
        return number != 0 if self is Winding.NONZERO else number % 2 != 0


class Tessellation(NamedTuple):
    """The triangles of a polygon.

    Attributes
    ----------
    triangles : (m, 3) uint32
        Indices into the given points, followed by the new ones. The triangles do not overlap and go
        round like the outline does, or its greater part. Three points in line may make one, too.
    sources : (k, 4) int32
        Of which points each new one is a mixture; -1 for none. A new point may have new points
        before it as its sources. New points arise where edges cross, and where points coincide.
    weights : (k, 4) float64
        The shares of the sources in position, colour and all else; 0 for none.
    """

    triangles: U32
    sources: I32
    weights: F64


def tessellate(
    points: F64, ring_lengths: Sequence[int], winding: Winding = Winding.NONZERO
) -> Tessellation:
    """Cut a polygon into triangles, the same as Processing does.

    Parameters
    ----------
    points : (n, 3) float64
        The rings one after the other, in a plane of any tilt. The triangles depend on where x
        points: give the numbers of the sketch, before its matrix, and rounded to float32.
    ring_lengths : sequence of int
        How many points each ring has. The last point of a ring is joined to its first, and may
        repeat it.
    winding : Winding
        The fill rule.

    Returns
    -------
    Tessellation
        Without triangles if the points have no area, or are not finite.

    Notes
    -----
    A ring wound against the one around it is a hole; one wound alike is not, when non-zero.

    Examples
    --------
    >>> square = np.array([(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0)], float)
    >>> tessellate(square, [4]).triangles.tolist()
    [[3, 1, 2], [3, 0, 1]]
    """
    rings = project(points, ring_lengths)
    triangles: list[Triangle] = []
    corners = _convex_corners(rings[0]) if len(rings) == 1 else None
    if corners is not None:
        fill_monotone(corners, triangles)
        return _result(triangles, [])
    sweep = Sweep(rings, len(points), winding.is_inside)
    sweep.run()
    for corners in sweep.regions:
        fill_monotone(corners, triangles)
    return _result(triangles, sweep.blends)


def interpolate(tessellation: Tessellation, values: F64) -> F64:
    """Return values of the given points and the new ones, (n + k, c), from those of the given.

    Parameters
    ----------
    tessellation : Tessellation
        Of n points, with k new ones.
    values : (n, c) float64
        One row per point: place, colour, whatever varies along the polygon.
    """
    count = len(values)
    rows = np.concatenate([values, np.zeros((len(tessellation.sources), values.shape[1]))])
    # One by one, since a new point may be a mixture of new ones. There are few.
    for row, (sources, weights) in enumerate(zip(*tessellation[1:], strict=True), count):
        rows[row] = weights @ rows[sources]
    return rows


def _result(triangles: list[Triangle], blends: list[Blend]) -> Tessellation:
    sources = np.full((len(blends), 4), -1, np.int32)
    # GLU hands the weights over in single precision, which shows: white becomes 254 at times.
    weights = np.zeros((len(blends), 4), np.float32)
    for row, (points, shares) in enumerate(blends):
        sources[row, : len(points)] = points
        weights[row, : len(points)] = shares
    corners = np.array(triangles, np.uint32).reshape(-1, 3)
    return Tessellation(corners, sources, weights.astype(np.float64))


def project(given: F64, ring_lengths: Sequence[int]) -> list[Ring]:
    """Return the rings in the plane of the sweep, mirrored if they would go round clockwise.

    This plane is the one of two axes that the polygon faces most. GLU neither turns nor scales
    what it projects, so the triangles of a tilted polygon are those of its shadow.
    There are no rings if the points, (n, 3), are too few, or not finite.
    """
    if len(given) < 3 or not np.abs(given).max() < FARTHEST:
        return []
    points: list[Point] = given.tolist()
    bounds = [0, *accumulate(length for length in ring_lengths if length)]
    is_flat = len({z for _, _, z in points}) == 1
    normal = (0.0, 0.0, 1.0) if is_flat else _normal(points, bounds)
    axis = max(range(3), key=lambda i: abs(normal[i]))
    s_axis, t_axis = (axis + 1) % 3, (axis + 2) % 3
    places = [(point[s_axis], point[t_axis]) for point in points]
    area = sum(_doubled_area(places[start:end]) for start, end in pairwise(bounds))
    if area == 0 and is_flat:
        normal = _normal(points, bounds)
    if area < 0 or (area == 0 and normal[axis] <= 0):
        places = [(s, -t) for s, t in places]
    indexed = list(zip(places, range(len(places)), strict=True))
    return [indexed[start:end] for start, end in pairwise(bounds)]


def _doubled_area(places: list[Place]) -> float:
    area = 0.0
    previous_s, previous_t = places[-1]
    for s, t in places:
        area += (previous_s - s) * (previous_t + t)
        previous_s, previous_t = s, t
    return area


def _normal(points: list[Point], bounds: list[int]) -> tuple[float, float, float]:
    """Return the normal of a large triangle: the first in GLU's order of the points."""
    points = [
        point
        for start, end in pairwise(bounds)
        for point in points[start + 1 : end] + points[start : start + 1]
    ]
    columns = list(zip(*points, strict=True))
    spans = [max(column) - min(column) for column in columns]
    column = columns[spans.index(max(spans))]
    low, high = points[column.index(min(column))], points[column.index(max(column))]
    x, y, z = low[0] - high[0], low[1] - high[1], low[2] - high[2]
    largest, normal = 0.0, (0.0, 0.0, 1.0)
    for point in points:
        u, v, w = point[0] - high[0], point[1] - high[1], point[2] - high[2]
        a, b, c = y * w - z * v, z * u - x * w, x * v - y * u
        size = a * a + b * b + c * c
        if size > largest:
            largest, normal = size, (a, b, c)
    return normal


def _convex_corners(ring: Ring) -> list[Corner] | None:
    """Return the corners of a strictly convex ring, sorted by place, or None for another ring.

    Most polygons are convex, and then there is nothing to sweep.
    """
    if len(ring) < 3:
        return None
    corners: list[Corner] = []
    before, (place, index) = ring[-2][0], ring[-1]
    was_upper, turns = place < before, 0
    for after, after_index in ring:
        rise, next_rise = place[1] - before[1], after[1] - place[1]
        if (place[0] - before[0]) * next_rise <= rise * (after[0] - place[0]):
            return None
        is_upper = after < place
        turns += is_upper != was_upper
        corners.append((place, index, is_upper))
        before, place, index, was_upper = place, after, after_index, is_upper
    if turns != 2:
        return None
    corners.sort()
    return corners


def fill_monotone(corners: list[Corner], triangles: list[Triangle]) -> None:
    """Append the triangles of a region whose corners, sorted by place, are on two sides.

    The corners are worked off from the right. `waiting` are those to be joined to others still:
    a first one, and then later ones of one side, which bend inwards. Each triangle but the last
    begins with the edge that parts it from the rest of the region.
    """
    if len(corners) < 3:
        return
    waiting = [corners[-1], corners[-2]]
    for corner in corners[-3:0:-1]:
        if corner[2] == waiting[-1][2]:
            _cut_ears(corner, waiting, triangles)
        else:
            _join_all(corner, waiting, triangles)
            del waiting[:-1]
        waiting.append(corner)
    last = corners[0][1]
    if not waiting[-1][2]:
        waiting.reverse()
    triangles.extend((tip[1], last, base[1]) for base, tip in pairwise(waiting))


def _cut_ears(corner: Corner, waiting: list[Corner], triangles: list[Triangle]) -> None:
    """Join `corner` to the waiting ones of its own side, as far as it sees them."""
    place, index, is_upper = corner
    while len(waiting) > 1:
        tip, base = waiting[-1], waiting[-2]
        bend = side(place, tip[0], base[0])
        if (bend < 0) if is_upper else (bend > 0):
            return
        waiting.pop()
        triangles.append((index, base[1], tip[1]) if is_upper else (base[1], index, tip[1]))


def _join_all(corner: Corner, waiting: list[Corner], triangles: list[Triangle]) -> None:
    """Join `corner` to the waiting ones, which are on the other side."""
    index, is_upper = corner[1], waiting[-1][2]
    for right, left in pairwise(waiting):
        triangles.append((left[1], index, right[1]) if is_upper else (index, left[1], right[1]))
