"""Box and sphere of unit size, corner by corner as Processing builds them."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.geometry.circles import COSINES, HALF_DEGREES, SINES

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I64 = NDArray[np.int64]


class Solid(NamedTuple):
    """A solid around the origin.

    Attributes
    ----------
    positions, normals : (k, 3) float32
    uvs : (k, 2) float32
        Each face of the box shows the whole texture; the sphere is wrapped in it once.
    triangles : (t, 3) int64
        Clockwise as seen from outside, y down.
    outlines : (m, j) int64
        Corners of each line that `stroke()` draws, in order.
    is_closed : bool
        Whether each outline returns to its first corner.
    reach : float
        How far its corners are from the origin at most, along each axis.
    """

    positions: F32
    normals: F32
    uvs: F32
    triangles: I64
    outlines: I64
    is_closed: bool
    reach: float


# Back, front, right, left, top, bottom: four corners each, in units of half the size.
_BOX_CORNERS = np.array(
    [
        [(-1, -1, -1), (-1, 1, -1), (1, 1, -1), (1, -1, -1)],
        [(-1, 1, 1), (-1, -1, 1), (1, -1, 1), (1, 1, 1)],
        [(1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1)],
        [(-1, 1, -1), (-1, -1, -1), (-1, -1, 1), (-1, 1, 1)],
        [(1, -1, -1), (1, -1, 1), (-1, -1, 1), (-1, -1, -1)],
        [(-1, 1, -1), (-1, 1, 1), (1, 1, 1), (1, 1, -1)],
    ],
    np.float32,
)
_BOX_NORMALS = np.array(
    [(0, 0, -1), (0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, -1, 0), (0, 1, 0)], np.float32
)
_UPRIGHT = [(0, 0), (0, 1), (1, 1), (1, 0)]
_TURNED = [(1, 1), (1, 0), (0, 0), (0, 1)]
_BOX_UVS = np.array([_UPRIGHT, _TURNED, _UPRIGHT, _TURNED, _TURNED, _UPRIGHT], np.float32)
QUAD_TRIANGLES = np.array([(0, 1, 2), (2, 3, 0)])


@cache
def unit_box() -> Solid:
    """Return the box whose sides are 1 long."""
    faces = np.arange(24).reshape(6, 4)
    return Solid(
        _BOX_CORNERS.reshape(24, 3) / 2,
        _BOX_NORMALS.repeat(4, axis=0),
        _BOX_UVS.reshape(24, 2),
        (faces[:, :1, None] + QUAD_TRIANGLES).reshape(12, 3),
        faces,
        is_closed=True,
        reach=0.5,
    )


@cache
def unit_sphere(around: int, along: int) -> Solid:
    """Return the sphere of radius 1.

    Parameters
    ----------
    around : int
        Steps around the y axis, at least 3.
    along : int
        Steps from pole to pole, at least 2.
    """
    positions, uvs = _sphere_corners(around, along)
    triangles, edges = _sphere_faces(around, along)
    return Solid(positions, positions, uvs, triangles, edges, is_closed=False, reach=1.0)


def _sphere_corners(around: int, along: int) -> tuple[F32, F32]:
    """Return positions and texture coordinates, from the +y pole to the -y pole.

    The poles are repeated for each step around, a row in between closes with its first corner, so
    that every corner has a u of its own.
    """
    entry = (np.arange(around, dtype=np.float32) * np.float32(HALF_DEGREES / around)).astype(int)
    ring_x, ring_z = COSINES[entry], SINES[entry]
    u = (1 - np.arange(around + 1) / around).astype(np.float32)
    # Single precision and an added-up step, as in Processing: they decide which entry is taken.
    step = np.add.accumulate(np.full(along, HALF_DEGREES / 2 / along, np.float32)).astype(int)
    positions, uvs = [], []
    for row in range(along + 1):
        v = np.float32(1 - row / along)
        if row in (0, along):
            pole = np.array([(0, 1 if row == 0 else -1, 0)], np.float32)
            positions.append(pole.repeat(around, axis=0))
            uvs.append(np.stack([u[:-1], np.full(around, v)], axis=1))
            continue
        radius, y = SINES[step[row - 1]], COSINES[step[row - 1]]
        ring = np.stack([ring_x * radius, np.full(around, y), ring_z * radius], axis=1)
        positions.append(np.concatenate([ring, ring[:1]]))
        uvs.append(np.stack([u, np.full(around + 1, v)], axis=1))
    return np.concatenate(positions).astype(np.float32), np.concatenate(uvs).astype(np.float32)


def _sphere_faces(around: int, along: int) -> tuple[I64, I64]:
    """Return triangles and edges, in Processing's order."""
    triangles: list[tuple[int, int, int]] = []
    edges: list[tuple[int, int]] = []
    for i in range(around):  # the cap at +y
        pole, corner = i, around + i
        triangles.append((corner, pole, corner + 1))
        edges += [(pole, corner), (corner, corner + 1)]
    row = around
    for _ in range(2, along):
        below, row = row, row + around + 1
        for i in range(around):
            a, b = below + i, row + i
            triangles += [(b, a, a + 1), (b, a + 1, b + 1)]
            edges += [(a, b), (b, b + 1), (a + 1, b)]
    for i in range(around):  # the cap at -y
        corner, pole = row + i, row + around + 1 + i
        triangles.append((pole, corner, corner + 1))
        edges.append((corner, pole))
    return np.array(triangles), np.array(edges)
