"""The kinds of `beginShape()`: which vertices make the faces, and the normals of faces without any.

Many shapes are worked on at once: their vertices lie one shape after the other, and a face is a
row of indices into all of them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I64 = NDArray[np.int64]

SAME = 1.2e-7  # Processing takes coordinates that are closer than float32's epsilon for equal
TRIANGLE = np.array([(0, 1, 2)])
QUAD = np.array([(0, 1, 2), (2, 3, 0)])
FACE_KINDS = (c.TRIANGLES, c.TRIANGLE_STRIP, c.TRIANGLE_FAN, c.QUADS, c.QUAD_STRIP)
STRIP_QUAD = np.array([(0, 1, 3), (1, 2, 3)])


class Faces(NamedTuple):
    """Faces of the same number of corners.

    Attributes
    ----------
    corners : (m, k) int64
        Indices of vertices; also the closed outline of each face.
    shapes : (m,) int64
        Which shape each face belongs to.
    triangles : (t, 3) int64
        How a face is split, in indices of its own corners.
    normal_corners : list of (corner, corner, corner)
        The triangles, in corners of a face, whose normals the vertices take, later ones winning.
    """

    corners: I64
    shapes: I64
    triangles: I64
    normal_corners: list[tuple[int, int, int]]


def ragged_ranges(counts: I64) -> tuple[I64, I64]:
    """Return 0 .. count-1 for each count, end to end, and which count each belongs to."""
    owner = np.repeat(np.arange(len(counts)), counts)
    starts = np.cumsum(counts) - counts
    return np.arange(len(owner)) - starts[owner], owner


def faces(kind: int, firsts: I64, counts: I64) -> Faces:
    """Return the faces of shapes of one kind; vertices left over make none.

    Parameters
    ----------
    kind : TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN, QUADS or QUAD_STRIP
    firsts, counts : (s,) int64
        First vertex and number of vertices of each shape.
    """
    match kind:
        case c.TRIANGLES:
            i, shapes = ragged_ranges(counts // 3)
            local, split, normals = 3 * i[:, None] + np.arange(3), TRIANGLE, [(0, 1, 2)]
        case c.TRIANGLE_FAN:
            i, shapes = ragged_ranges(np.maximum(counts - 2, 0))
            local = np.stack([np.zeros_like(i), i + 1, i + 2], axis=1)
            split, normals = TRIANGLE, [(0, 1, 2)]
        case c.TRIANGLE_STRIP:
            i, shapes = ragged_ranges(np.maximum(counts - 2, 0))
            middle = i + 1
            side = np.where(middle % 2 == 0, -1, 1)
            local = np.stack([middle, middle + side, middle - side], axis=1)
            split, normals = TRIANGLE, [(2, 0, 1)]
        case c.QUADS:
            i, shapes = ragged_ranges(counts // 4)
            local, split = 4 * i[:, None] + np.arange(4), QUAD
            normals = [(0, 1, 2), (2, 3, 0)]
        case _:
            i, shapes = ragged_ranges(np.maximum(counts // 2 - 1, 0))
            local, split = 2 * i[:, None] + np.array([0, 1, 3, 2]), STRIP_QUAD
            normals = [(0, 1, 3), (3, 1, 2)]
    return Faces(firsts[shapes][:, None] + local, shapes, split, normals)


def triangle_normals(a: F32, b: F32, c: F32) -> F32:
    """Return the unit normal of triangles, (m, 3), toward the viewer if clockwise on the screen.

    `a`, `b`, `c` are (m, 3). A triangle without area has the normal (0, 0, 0).
    """
    normals = np.cross(c - b, a - b)
    lengths = np.sqrt((normals * normals).sum(axis=1, keepdims=True))
    unit: F32 = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    return unit


def vertex_normals(positions: F32, faces: Faces) -> F32:
    """Return a normal for each vertex: that of the last triangle it is part of.

    `positions` is (v, 3); vertices of no face get (0, 0, 1).
    """
    normals = np.zeros_like(positions)
    normals[:, 2] = 1
    corners = faces.corners[:, np.array(faces.normal_corners)].reshape(-1, 3)
    if len(corners):
        a, b, c = positions[corners[:, 0]], positions[corners[:, 1]], positions[corners[:, 2]]
        # With an index that occurs twice NumPy keeps the last value, as Processing does.
        normals[corners.ravel()] = triangle_normals(a, b, c).repeat(3, axis=0)
    return normals


def is_aligned(x: F32, y: F32, *, triangles: bool) -> NDArray[np.bool_]:
    """Return which faces have their edges along the axes (a triangle: two of its edges), (m,).

    `x`, `y` are (m, k), one row for each face.
    """
    dx, dy = x - np.roll(x, -1, axis=1), y - np.roll(y, -1, axis=1)
    flat = (np.abs(dx) < SAME) | (np.abs(dy) < SAME)
    if triangles:
        return np.asarray(flat.sum(axis=1) >= 2)
    return np.asarray(flat[:, :3].all(axis=1))
