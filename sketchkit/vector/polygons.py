"""Shapes of `beginShape()` … `endShape()` to items of a page: curves stay curves."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby, pairwise

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.given_vertices import as_bezier
from sketchkit.draw.recorder import ShapeRun
from sketchkit.draw.rows import Rows
from sketchkit.geometry.shapes import FACE_KINDS, faces
from sketchkit.vector.page import Item, Path, joined, polyline
from sketchkit.vector.pictures import textured_items
from sketchkit.vector.shapes import dot
from sketchkit.vector.views import View

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]

CHANNEL_SHIFTS = np.array([24, 16, 8, 0])


def shape_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield what a shape consists of."""
    shape = rows.recorder.shapes[rows.links[row]]
    if shape.kind == c.POINTS:
        yield from _dots(rows, row, shape, view)
    elif shape.kind in (c.LINES, c.LINE_STRIP, c.LINE_LOOP):
        yield from _lines(rows, row, shape, view)
    elif shape.kind in FACE_KINDS:
        yield from _faces(rows, row, shape, view)
    else:
        yield from _polygon(rows, row, shape, view)


class _Corners:
    """The corners of one shape."""

    def __init__(self, rows: Rows, shape: ShapeRun) -> None:
        table = rows.recorder.corner_array()[shape.first : shape.first + shape.count]
        self.places: F64 = table["place"].astype(np.float64)
        self.fills: I64 = table["fill"]
        self.strokes: I64 = table["stroke"]


def _dots(rows: Rows, row: int, shape: ShapeRun, view: View) -> Iterator[Item | None]:
    if rows.strokes[row] >= 0:
        corners = _Corners(rows, shape)
        for place, color in zip(corners.places, corners.strokes.tolist(), strict=True):
            yield dot(view, place, color, float(rows.weights[row]))


def _lines(rows: Rows, row: int, shape: ShapeRun, view: View) -> Iterator[Item | None]:
    corners = _Corners(rows, shape)
    runs = [np.arange(shape.count)]
    if shape.kind == c.LINES:
        runs = list(np.arange(shape.count // 2 * 2).reshape(-1, 2))
    for run in runs:
        if len(run) > 1:
            path = polyline(corners.places[run], is_closed=shape.kind == c.LINE_LOOP)
            yield view.solid_mark(path, view.ink(NO_COLOR, *_stroke(rows, row, corners, run)))


def _faces(rows: Rows, row: int, shape: ShapeRun, view: View) -> Iterator[Item | None]:
    corners = _Corners(rows, shape)
    every = faces(shape.kind, np.array([0]), np.array([shape.count])).corners
    if shape.texture is None and rows.strokes[row] < 0 and not view.stage.is_3d:
        yield from _joined_faces(every, corners, view)
        return
    for face in every:
        fill = NO_COLOR
        if rows.fills[row] >= 0:
            if shape.texture is None:
                fill = mean_color(corners.fills[face])
            else:
                yield from _textured(rows, row, shape, face, view)
        path = polyline(corners.places[face], is_closed=True)
        yield view.solid_mark(path, view.ink(fill, *_stroke(rows, row, corners, face)))


def _joined_faces(every: I64, corners: _Corners, view: View) -> Iterator[Item | None]:
    """Yield faces of one colour as one path: no seams show between them."""
    colors = [mean_color(corners.fills[face]) for face in every]
    for color, run in groupby(zip(colors, every, strict=True), key=lambda pair: pair[0]):
        path = joined([corners.places[face] for _, face in run])
        yield view.solid_mark(path, view.ink(color, NO_COLOR, 0.0))


def _textured(
    rows: Rows, row: int, shape: ShapeRun, corner: I64, view: View
) -> Iterator[Item | None]:
    """Yield pictures that cover a face, or a whole polygon."""
    corners = _Corners(rows, shape)
    if shape.texture is not None and shape.first_uv is not None:
        uvs = rows.recorder.uv_array()[shape.first_uv + corner].astype(np.float64)
        tint = mean_color(corners.fills[corner])
        yield from textured_items(view, shape.texture, corners.places[corner], uvs, tint)


def _polygon(rows: Rows, row: int, shape: ShapeRun, view: View) -> Iterator[Item | None]:
    corners = _Corners(rows, shape)
    every = np.arange(shape.count)
    path = _contour_path(shape, corners)
    fill = NO_COLOR
    if rows.fills[row] >= 0:
        if shape.texture is None:
            fill = mean_color(corners.fills)
        else:
            yield from _textured(rows, row, shape, every, view)
    yield view.solid_mark(path, view.ink(fill, *_stroke(rows, row, corners, every)))


def _contour_path(shape: ShapeRun, corners: _Corners) -> Path:
    """Return all contours; of corners that are steps of a curve, the curve."""
    curves = {run.first: run for run in shape.curves}
    letters, points = [], []
    for first, last in pairwise((0, *shape.contours, shape.count)):
        corner = first
        while corner < last:
            run = curves.get(corner)
            if run is None or corner == first:
                letters.append("M" if corner == first else "L")
                points.append(corners.places[corner : corner + 1])
                corner += 1
            else:
                letters.append("C")
                points.append(as_bezier(run)[1:])
                corner += run.count
        letters.append("Z" * shape.is_closed)
    return Path("".join(letters), np.vstack(points))


def _stroke(rows: Rows, row: int, corners: _Corners, at: I64) -> tuple[int, float]:
    """Return colour and weight of the stroke along some corners."""
    if rows.strokes[row] < 0:
        return NO_COLOR, 0.0
    return mean_color(corners.strokes[at]), float(rows.weights[row])


def mean_color(colors: I64) -> int:
    """Return the mean of packed colours: a path has one colour."""
    colors = np.maximum(colors, 0)
    if (colors == colors[0]).all():
        return int(colors[0])
    channels = (colors[:, None] >> CHANNEL_SHIFTS & 255).mean(axis=0).round().astype(np.int64)
    return int((channels << CHANNEL_SHIFTS).sum())
