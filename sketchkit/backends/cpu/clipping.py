"""Clipping: triangles cut at the six sides of the view volume, before the division by w.

Sutherland and Hodgman's method, a side after the other, for all triangles at once. In the order
and with the arithmetic of Mesa, for the corners that a cut adds are rounded to 1/256 px later.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.vertex import F32

I64 = NDArray[np.int64]
Mask = NDArray[np.bool_]

# Distance inside a side is side @ clip: right, left, top, bottom, near, far.
SIDES: F32 = np.array(
    [[-1, 0, 0, 1], [1, 0, 0, 1], [0, -1, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [0, 0, -1, 1]],
    np.float32,
)
MOST_CORNERS = 3 + len(SIDES)  # each side cuts off a corner and leaves two


def clip_triangles(corners: F32) -> F32:
    """Return what of triangles is in view, in their order.

    `corners` is (n, 3, 4 + k): clip space, and what else is interpolated. A triangle that a side
    cuts becomes a fan of up to seven.
    """
    outside = np.stack([_distance(corners, side) < 0 for side in SIDES], axis=2)
    crossed: Mask = np.any(outside, axis=1)  # (n, sides)
    is_sound = np.isfinite(corners[..., :4]).all(axis=(1, 2))
    if not np.any(crossed) and np.all(is_sound):
        return corners
    in_part = is_sound & ~np.any(np.all(outside, axis=1), axis=1)
    is_cut = np.any(crossed, axis=1)
    whole, cut = np.flatnonzero(in_part & ~is_cut), np.flatnonzero(in_part & is_cut)
    pieces, owners = _fans(*_cut_polygons(corners[cut], crossed[cut]))
    order = np.argsort(np.concatenate([whole, cut[owners]]), kind="stable")
    in_view: F32 = np.concatenate([corners[whole], pieces])[order]
    return in_view


def _distance(corners: F32, side: F32) -> F32:
    """Return how far corners are inside a side, in clip space."""
    x, y, z, w = side
    distance: F32 = (
        corners[..., 0] * x + corners[..., 1] * y + corners[..., 2] * z + corners[..., 3] * w
    )
    return distance


def _cut_polygons(triangles: F32, crossed: Mask) -> tuple[F32, I64]:
    """Return the polygons that are left, (n, 9, 4 + k), and the number of corners of each."""
    polygons = np.zeros((len(triangles), MOST_CORNERS, triangles.shape[2]), np.float32)
    polygons[:, :3] = triangles
    counts = np.full(len(triangles), 3)
    for side, is_crossed in zip(SIDES, crossed.T, strict=True):
        rows = np.flatnonzero(is_crossed & (counts > 0))
        polygons[rows], counts[rows] = _cut(polygons[rows], counts[rows], side)
    return polygons, counts


def _cut(polygons: F32, counts: I64, side: F32) -> tuple[F32, I64]:
    """Return polygons cut at one side, and their new numbers of corners."""
    slots = np.arange(MOST_CORNERS)
    following = np.where(slots + 1 < counts[:, None], slots + 1, 0)
    here, there = polygons, np.take_along_axis(polygons, following[:, :, None], axis=1)
    distance_here, distance_there = _distance(here, side), _distance(there, side)
    is_used = slots < counts[:, None]
    is_kept = is_used & (distance_here >= 0)
    is_crossing = is_used & ((distance_here >= 0) != (distance_there >= 0))
    crossings = _crossings(here, there, distance_here, distance_there)
    # Corner, crossing, corner, crossing ...: what is in use moves to the front.
    shape = len(polygons), 2 * MOST_CORNERS
    mixed = np.stack([here, crossings], axis=2).reshape(*shape, polygons.shape[2])
    used = np.stack([is_kept, is_crossing], axis=2).reshape(shape)
    to_front = np.argsort(~used, axis=1, kind="stable")[:, :MOST_CORNERS, None]
    return np.take_along_axis(mixed, to_front, axis=1), used.sum(axis=1)


def _crossings(here: F32, there: F32, distance_here: F32, distance_there: F32) -> F32:
    """Return where the edges from here to there meet the side.

    Reckoned from the outer end: so two triangles that share an edge are cut at the same place,
    though they run through it in opposite directions.
    """
    is_leaving = (distance_there < 0)[:, :, None]
    outer, inner = np.where(is_leaving, there, here), np.where(is_leaving, here, there)
    distance_outer = np.minimum(distance_here, distance_there)
    distance_inner = np.maximum(distance_here, distance_there)
    span = distance_outer - distance_inner
    t = (distance_outer / np.where(span == 0, 1, span))[:, :, None]
    crossings: F32 = outer + t * (inner - outer)
    return crossings


def _fans(polygons: F32, counts: I64) -> tuple[F32, I64]:
    """Return the triangles of convex polygons, polygon after polygon, and whose each is."""
    last = np.arange(2, MOST_CORNERS)
    owners, which = np.nonzero(last < counts[:, None])
    corner = last[which]
    fans = np.stack(
        [polygons[owners, corner - 1], polygons[owners, corner], polygons[owners, 0]], axis=1
    )
    return fans, owners
