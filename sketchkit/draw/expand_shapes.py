"""`beginShape()` … `endShape()` to pieces: all shapes of a kind at once, polygons one by one."""

from __future__ import annotations

from collections import defaultdict
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.draw.added_corners import main_sources, mix_colors
from sketchkit.draw.outlines import Dots, Outlines, add_dots, add_outlines, has_joints
from sketchkit.draw.pieces import Expansion, Fills
from sketchkit.draw.recorder import ShapeRun
from sketchkit.draw.rows import Rows
from sketchkit.geometry.polygons import interpolate, tessellate
from sketchkit.geometry.primitives import normal_givers
from sketchkit.geometry.shapes import (
    FACE_KINDS,
    TRIANGLE,
    Faces,
    faces,
    is_aligned,
    ragged_ranges,
    vertex_normals,
)

F32 = NDArray[np.float32]
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]


class Corners:
    """All corners of the recorder, as columns."""

    def __init__(self, rows: Rows) -> None:
        table = rows.recorder.corner_array()
        self.recorder = rows.recorder
        self.weight_scale = rows.weight_scale
        self.places: F32 = table["place"]
        self.attributes = table["attributes"].astype(np.int64)
        self.fills = np.maximum(table["fill"], 0)
        self.strokes = np.maximum(table["stroke"], 0)

    @cached_property
    def normals(self) -> F32:
        """The normal that the sketch gave last before each corner, (v, 3)."""
        if self.recorder.normals is not None:
            return self.recorder.normals
        table = np.array([entry.normal for entry in self.recorder.attributes], np.float32)
        normals: F32 = table[self.attributes]
        return normals

    @cached_property
    def weights(self) -> F32:
        """The stroke's weight in force at each corner, (v,)."""
        table = np.array([entry.weight for entry in self.recorder.attributes], np.float32)
        weights: F32 = table[self.attributes] * self.weight_scale
        return weights

    @cached_property
    def uvs(self) -> F32:
        """Texture coordinates of each corner, (v, 2); zeros where there are none."""
        uvs = np.zeros((len(self.places), 2), np.float32)
        given = self.recorder.uv_array()
        for shape in self.recorder.shapes:
            if shape.first_uv is not None:
                own = given[shape.first_uv : shape.first_uv + shape.count]
                uvs[shape.first : shape.first + shape.count] = own
        return uvs


def expand_shapes(rows: Rows, at: I64, out: Expansion) -> None:
    """Add the pieces of shapes, `at` being their rows."""
    corners = Corners(rows)
    by_kind: dict[int, list[int]] = defaultdict(list)
    for row in at.tolist():
        by_kind[_shape(rows, row).kind].append(row)
    for kind, mine in by_kind.items():
        own = np.array(mine)
        if kind == c.POINTS:
            _expand_dots(rows, corners, own, out)
        elif kind in (c.LINES, c.LINE_STRIP, c.LINE_LOOP):
            _expand_lines(rows, corners, own, kind, out)
        elif kind in FACE_KINDS:
            _expand_faces(rows, corners, own, kind, out)
        else:
            _expand_polygons(rows, corners, own, out)


def _shape(rows: Rows, row: int) -> ShapeRun:
    shape: ShapeRun = rows.recorder.shapes[rows.links[row]]
    return shape


def _runs(rows: Rows, at: I64) -> tuple[I64, I64]:
    """Return first corner and number of corners of each shape."""
    shapes = [_shape(rows, row) for row in at]
    return np.array([s.first for s in shapes]), np.array([s.count for s in shapes])


def _expand_dots(rows: Rows, corners: Corners, at: I64, out: Expansion) -> None:
    at = at[rows.strokes[at] >= 0]
    if not len(at):
        return
    firsts, counts = _runs(rows, at)
    local, owner = ragged_ranges(counts)
    index = firsts[owner] + local
    x, y, z = corners.places[index].T
    owners = at[owner]
    dots = Dots(owners, x, y, z, corners.strokes[index], rows.weights[owners], index)
    add_dots(rows, dots, out)


def _expand_lines(rows: Rows, corners: Corners, at: I64, kind: int, out: Expansion) -> None:
    at = at[rows.strokes[at] >= 0]
    if kind == c.LINES and len(at):
        firsts, counts = _runs(rows, at)
        local, owner = ragged_ranges(counts // 2)
        index = firsts[owner][:, None] + 2 * local[:, None] + np.arange(2)
        _add_polylines(rows, corners, index, at[owner], out, is_closed=False)
        return
    for row in at:
        shape = _shape(rows, row)
        if shape.count >= 2:
            index = shape.first + np.arange(shape.count)[None]
            closed = kind == c.LINE_LOOP and shape.count > 2
            _add_polylines(rows, corners, index, np.array([row]), out, is_closed=closed)


def _add_polylines(
    rows: Rows, corners: Corners, index: I64, owners: I64, out: Expansion, *, is_closed: bool
) -> None:
    """Stroke lines through the corners `index`, (n, k), of the rows `owners`, (n,)."""
    stroked = rows.strokes[owners] >= 0
    if not stroked.any():
        return
    index, owners = index[stroked], owners[stroked]
    x, y, z = (corners.places[index][..., axis] for axis in range(3))
    weights = corners.weights[index]
    if (weights == weights[:, :1]).all():
        weights = weights[:, :1]
    own_weights = rows.weights[owners][:, None]  # those at the end of the shape
    weights = np.where(_takes_last_weight(rows, owners)[:, None], own_weights, weights)
    colors = corners.strokes[index]
    add_outlines(rows, Outlines(owners, x, y, z, colors, weights, is_closed, index), out)


def _takes_last_weight(rows: Rows, owners: I64) -> Bool:
    """Return whose outlines are as wide as the last `strokeWeight()` said: 2D ones with joins."""
    found: Bool = ~rows.is_3d[rows.states[owners]] & has_joints(rows, owners)
    return found


def _expand_faces(rows: Rows, corners: Corners, at: I64, kind: int, out: Expansion) -> None:
    firsts, counts = _runs(rows, at)
    found = faces(kind, firsts, counts)
    if not len(found.corners):
        return
    owners = at[found.shapes]
    shapes = [_shape(rows, row) for row in at]
    normals = _normals(corners, found, shapes) if rows.is_lit else None
    snap = _snap(rows, corners, found, owners)
    filled = rows.fills[owners] >= 0
    textured = np.array([shape.texture is not None for shape in shapes])[found.shapes]
    for wants_texture in (False, True):
        mine = filled & (textured == wants_texture)
        if not mine.any():
            continue
        index = found.corners[mine]
        fills = _fills(rows, corners, owners[mine], index, found.triangles)
        fills.normals = None if normals is None else normals[index]
        fills.snap = None if snap is None else snap[mine]
        if wants_texture or rows.wants_uvs:
            fills.uvs = corners.uvs[index]
        if wants_texture:
            fills.ambient = rows.fills[owners[mine]][:, None]  # the colours are the tint
            textures = [shape.texture for shape in shapes]
            fills.textures = [textures[i] for i in found.shapes[mine]]
        out.fills.append(fills)
    _add_polylines(rows, corners, found.corners, owners, out, is_closed=True)


def _normals(corners: Corners, found: Faces, shapes: list[ShapeRun]) -> F32:
    """Return normals of all corners, (v, 3): the sketch's, or those of the faces."""
    given = np.array([shape.has_normals for shape in shapes])[found.shapes]
    if given.all():
        return corners.normals
    without = found._replace(corners=found.corners[~given])
    made = vertex_normals(corners.places, without)
    if given.any():
        kept = found.corners[given]
        made[kept] = corners.normals[kept]
    return made


def _snap(rows: Rows, corners: Corners, found: Faces, owners: I64) -> NDArray[np.bool_] | None:
    """Return which faces are moved to whole pixels: those of shapes all of whose faces fit."""
    may = rows.can_snap[rows.states[owners]]
    if not may.any():
        return None
    places = corners.places[found.corners]
    is_triangle = found.corners.shape[1] == len(TRIANGLE[0])
    fits: NDArray[np.bool_] = is_aligned(places[..., 0], places[..., 1], triangles=is_triangle)
    if not fits.all():
        fits = ~np.isin(owners, owners[~fits])
    snap: NDArray[np.bool_] = may & fits
    return snap


def _fills(rows: Rows, corners: Corners, owners: I64, index: I64, triangles: I64) -> Fills:
    """Return pieces whose corners are those at `index`, (n, k)."""
    places = corners.places[index]
    return Fills(
        owners,
        places[..., 0],
        places[..., 1],
        places[..., 2],
        triangles,
        corners.fills[index],
        attributes=corners.attributes[index],
        sources=index,
    )


def _expand_polygons(rows: Rows, corners: Corners, at: I64, out: Expansion) -> None:
    lines: dict[tuple[int, bool], list[tuple[int, I64]]] = defaultdict(list)
    for row in at.tolist():
        shape = _shape(rows, row)
        if rows.fills[row] >= 0:
            _fill_polygon(rows, corners, row, shape, out)
        if rows.strokes[row] >= 0:
            for index in _contours(corners, shape):
                closed = shape.is_closed and len(index) > 2
                lines[len(index), closed].append((row, index))
    for (_, closed), group in lines.items():
        owners = np.array([row for row, _ in group])
        index = np.stack([index for _, index in group])
        _add_polylines(rows, corners, index, owners, out, is_closed=closed)


def _contours(corners: Corners, shape: ShapeRun) -> list[I64]:
    """Return the corners of each contour; of corners that repeat, the first."""
    bounds = [0, *shape.contours, shape.count]
    contours = []
    for first, last in pairwise(bounds):
        index = np.arange(shape.first + first, shape.first + last)
        places = corners.places[index]
        moved = np.ones(len(index), np.bool_)
        moved[1:] = (places[1:] != places[:-1]).any(axis=1)
        if shape.is_closed and len(index) > 1 and (places[0] == places[-1]).all():
            moved[-1] = False
        if moved.sum() > 1:
            contours.append(index[moved])
    return contours


def _fill_polygon(rows: Rows, corners: Corners, row: int, shape: ShapeRun, out: Expansion) -> None:
    """Fill one polygon; corners that arise where outlines cross blend those of their edges."""
    bounds = [0, *shape.contours, shape.count]
    lengths = [last - first for first, last in pairwise(bounds)]
    run = slice(shape.first, shape.first + shape.count)
    points = corners.places[run].astype(np.float64)
    found = tessellate(points, lengths)
    if not len(found.triangles):
        return
    index = shape.first + main_sources(found, shape.count)[found.triangles]
    fills = _fills(rows, corners, np.full(len(found.triangles), row), index, TRIANGLE)
    places = interpolate(found, points)[found.triangles].astype(np.float32)
    fills.x, fills.y, fills.z = places[..., 0], places[..., 1], places[..., 2]
    fills.colors = mix_colors(found, corners.fills[run])[found.triangles]
    if shape.has_normals:
        normals = interpolate(found, corners.normals[run].astype(np.float64))
        fills.normals = normals[found.triangles].astype(np.float32)
    elif rows.is_lit and np.ptp(points[:, 2]):  # one normal will do for a flat polygon
        fills.normal_givers = normal_givers(points, lengths)
    if shape.texture is not None:
        fills.textures = [shape.texture] * len(found.triangles)
        fills.ambient = np.full((1, 1), rows.fills[row])
    if shape.texture is not None or rows.wants_uvs:
        uvs = interpolate(found, corners.uvs[run].astype(np.float64))
        fills.uvs = uvs[found.triangles].astype(np.float32)
    out.fills.append(fills)
