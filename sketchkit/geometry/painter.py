"""The order in which polygons are painted, so that what is near covers what is far.

Where two polygons overlap on the screen, the farther one comes first; where they lie in one plane,
the one that was given first. Polygons that pass through each other have no right order.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]

CORNERS = 4  # of every polygon; those with fewer repeat the last one
MOST_COMPARED = 12_000  # polygons; beyond it they are sorted by their middles alone
PAIRS_AT_ONCE = 50_000
IN_ONE_PLANE = 1e-6  # of nearness, which runs from -1 to 1
MARGIN = 1e-3  # px: polygons that only touch do not overlap
THIN = 1e-3  # px²: polygons seen from the side, lines and points cover nothing


def paint_order(polygons: F64) -> I64:
    """Return the order of convex polygons, the farthest first, (n,).

    `polygons` is (n, 4, 3): x and y in pixels, and nearness (larger is nearer).
    """
    keys = polygons[:, :, 2].mean(axis=1)
    if len(polygons) > MOST_COMPARED:
        return np.argsort(keys, kind="stable")
    behind: list[list[int]] = [[] for _ in polygons]  # what must wait for each
    waits = np.zeros(len(polygons), np.int64)
    for first, second in _overlapping(polygons):
        nearer, is_known = _nearer(polygons[first], polygons[second])
        far = np.where(nearer, second, first)[is_known]
        near = np.where(nearer, first, second)[is_known]
        for a, b in zip(far.tolist(), near.tolist(), strict=True):
            behind[a].append(b)
        waits += np.bincount(near, minlength=len(waits))
    return _in_turn(keys, behind, waits)


def _in_turn(keys: F64, behind: list[list[int]], waits: I64) -> I64:
    """Return an order in which nothing comes before what it waits for, if there is one."""
    every = np.argsort(keys, kind="stable").tolist()
    ranks = np.empty(len(keys), np.int64)
    ranks[every] = np.arange(len(keys))
    ready = [rank for rank, polygon in enumerate(every) if not waits[polygon]]
    is_placed = np.zeros(len(keys), np.bool_)
    order: list[int] = []
    farthest = 0
    while len(order) < len(every):
        if ready:
            polygon = every[heapq.heappop(ready)]
        else:  # they wait for each other in a circle: the farthest goes first
            while is_placed[every[farthest]]:
                farthest += 1
            polygon = every[farthest]
        if is_placed[polygon]:
            continue
        is_placed[polygon] = True
        order.append(polygon)
        for other in behind[polygon]:
            waits[other] -= 1
            if not waits[other] and not is_placed[other]:
                heapq.heappush(ready, int(ranks[other]))
    return np.array(order, np.int64)


def _overlapping(polygons: F64) -> Iterator[tuple[I64, I64]]:
    """Yield pairs, first < second, whose boxes overlap: many at once."""
    low, high = polygons[:, :, :2].min(axis=1), polygons[:, :, :2].max(axis=1)
    count = max(1, PAIRS_AT_ONCE // max(1, len(polygons)))
    for start in range(0, len(polygons), count):
        some = slice(start, start + count)
        apart = (low[some, None] > high[None, start:]) | (high[some, None] < low[None, start:])
        first, second = np.nonzero(~apart.any(axis=2))
        is_pair = first < second
        if is_pair.any():
            yield start + first[is_pair], start + second[is_pair]


def _nearer(a: F64, b: F64) -> tuple[Bool, Bool]:
    """Return for each pair whether `a` is nearer than `b`, and whether they overlap at all."""
    differences = np.concatenate(
        [_above(a, b), -_above(b, a), _where_edges_cross(a, b)], axis=1
    )  # (p, s): of nearness, at places where both are; NaN where they are not
    is_known = ~np.isnan(differences).all(axis=1)
    sizes = np.where(np.isnan(differences), -1.0, np.abs(differences))
    largest = np.take_along_axis(differences, sizes.argmax(axis=1)[:, None], axis=1)[:, 0]
    return largest > IN_ONE_PLANE, is_known


def _above(a: F64, b: F64) -> F64:
    """Return by how much corners and middle of each `a` are nearer than `b` there, (p, 5)."""
    points = np.concatenate([a, a.mean(axis=1, keepdims=True)], axis=1)
    normals, is_wide = _planes(b)
    turn = np.sign(normals[:, 2])
    # Lines and points belong to what they lie on the edge of, polygons that touch do not overlap.
    least = np.where(_planes(a)[1], MARGIN, -MARGIN)
    inside = np.broadcast_to(is_wide[:, None], points.shape[:2]).copy()
    for corner in range(CORNERS):
        begin = b[:, corner]
        edge = b[:, (corner + 1) % CORNERS] - begin
        length = np.hypot(edge[:, 0], edge[:, 1])
        ahead = points - begin[:, None]
        across = edge[:, None, 0] * ahead[..., 1] - edge[:, None, 1] * ahead[..., 0]
        inside &= (across * turn[:, None] >= (least * length)[:, None]) | (length == 0)[:, None]
    ahead = points - b[:, :1]
    slope = -normals[:, :2] / np.where(is_wide, normals[:, 2], 1)[:, None]
    there = b[:, :1, 2] + (ahead[..., :2] * slope[:, None]).sum(axis=2)
    return np.where(inside, points[..., 2] - there, np.nan)


def _planes(polygons: F64) -> tuple[F64, Bool]:
    """Return the normals of polygons, as long as twice their area, and which are not thin."""
    normals = np.cross(polygons[:, 2] - polygons[:, 0], polygons[:, 3] - polygons[:, 1])
    triangles = np.cross(polygons[:, 1] - polygons[:, 0], polygons[:, 2] - polygons[:, 0])
    is_triangle = (polygons[:, 2] == polygons[:, 3]).all(axis=1)
    normals = np.where(is_triangle[:, None], triangles, normals)
    return normals, np.abs(normals[:, 2]) > THIN


def _where_edges_cross(a: F64, b: F64) -> F64:
    """Return by how much `a` is nearer where its edges cross those of `b`, (p, 16)."""
    begin_a, begin_b = a[:, :, None], b[:, None]
    edge_a = np.roll(a, -1, axis=1)[:, :, None] - begin_a
    edge_b = np.roll(b, -1, axis=1)[:, None] - begin_b
    apart = begin_b - begin_a
    across = edge_a[..., 0] * edge_b[..., 1] - edge_a[..., 1] * edge_b[..., 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        s = (apart[..., 0] * edge_b[..., 1] - apart[..., 1] * edge_b[..., 0]) / across
        t = (apart[..., 0] * edge_a[..., 1] - apart[..., 1] * edge_a[..., 0]) / across
        crosses = (s > MARGIN) & (s < 1 - MARGIN) & (t > MARGIN) & (t < 1 - MARGIN)
        difference = begin_a[..., 2] + s * edge_a[..., 2] - begin_b[..., 2] - t * edge_b[..., 2]
    return np.where(crosses, difference, np.nan).reshape(len(a), -1)
