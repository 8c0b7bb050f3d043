"""Recorded calls to items of a page: each as the shape that it names."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.constants import CHORD, PIE, ROUND
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.recorder import Kind
from sketchkit.draw.rows import Rows
from sketchkit.geometry import ellipses
from sketchkit.geometry.rects import rect_edges
from sketchkit.vector.page import Ellipse, Item, Outline, Path, Rect, polyline
from sketchkit.vector.views import View

F64 = NDArray[np.float64]

QUARTER_TURN = np.pi / 2
SAME_ANGLE = 1e-6  # radians: angles are recorded in 32 bits


def point_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield a disc, or a square, as wide as the stroke."""
    yield dot(view, rows.numbers[row, :3].astype(np.float64), *_stroke(rows, row))


def dot(view: View, place: F64, color: int, weight: float) -> Item | None:
    """Return a point of `point()` at a place, (3,)."""
    size = weight
    if view.stage.is_3d:  # it faces the viewer
        seen = view.on_page(place[None])
        if seen is None:
            return None
        place, size = seen[0], weight * view.scale
        view = view.flat()
    x, y = place[:2].tolist()
    outline: Outline = Rect(x - size / 2, y - size / 2, size, size)
    if view.style.stroke_cap == ROUND:
        outline = Ellipse(x, y, size / 2, size / 2)
    return view.mark(outline, view.ink(color, NO_COLOR, 0.0))


def line_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield a line; it has no fill."""
    ends = rows.numbers[row, :6].reshape(2, 3).astype(np.float64)
    ink = view.ink(NO_COLOR, *_stroke(rows, row))
    yield view.solid_mark(polyline(ends, is_closed=False), ink)


def triangle_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield a triangle."""
    yield _painted(rows, row, view, _corners(rows, row, 3))


def quad_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield a shape of four corners."""
    yield _painted(rows, row, view, _corners(rows, row, 4))


def rect_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield a rectangle."""
    edges = rect_edges(view.style.rect_mode, rows.numbers[row : row + 1, :4])
    left, top, right, bottom = (float(edge[0]) for edge in edges)
    yield _painted(rows, row, view, Rect(left, top, right - left, bottom - top))


def ellipse_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield an ellipse."""
    x, y, half_width, half_height = _ellipse(rows, row, view)
    yield _painted(rows, row, view, Ellipse(x, y, abs(half_width), abs(half_height)))


def arc_items(rows: Rows, row: int, view: View) -> Iterator[Item | None]:
    """Yield an arc: its fill and its outline may differ."""
    start, stop, number = rows.numbers[row, 4:7].tolist()
    x, y, half_width, half_height = _ellipse(rows, row, view)
    arc = unit_arc(start, stop)
    is_full = stop - start >= 2 * np.pi - SAME_ANGLE
    mode = int(number)
    hub = np.zeros((1, 2))
    pie = Path("M" + "L" + arc.letters[1:] + "Z", np.vstack([hub, arc.points]))
    fill = pie if mode in (0, PIE) else Path(arc.letters + "Z", arc.points)
    outline = (
        pie if mode == PIE else Path(arc.letters + "Z" * (mode == CHORD or is_full), arc.points)
    )
    color, weight = _stroke(rows, row)
    for path, ink in (
        (fill, view.ink(int(rows.fills[row]), NO_COLOR, 0.0)),
        (outline, view.ink(NO_COLOR, color, weight)),
    ):
        placed = Path(path.letters, path.points * (half_width, half_height) + (x, y))
        yield view.mark(placed, ink)


def unit_arc(start: float, stop: float) -> Path:
    """Return a part of the unit circle, as cubic curves of at most a quarter turn."""
    count = max(1, int(np.ceil((stop - start) / QUARTER_TURN - SAME_ANGLE)))
    angles = np.linspace(start, stop, count + 1)
    step = (stop - start) / count
    reach = 4 / 3 * np.tan(step / 4)  # of the control points, along the tangents
    places = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    tangents = np.stack([-np.sin(angles), np.cos(angles)], axis=1) * reach
    curves = np.stack(
        [places[:-1] + tangents[:-1], places[1:] - tangents[1:], places[1:]], axis=1
    ).reshape(-1, 2)
    return Path("M" + "C" * count, np.vstack([places[:1], curves]))


def _painted(rows: Rows, row: int, view: View, outline: Outline) -> Item | None:
    """Return an outline in the colours of its row."""
    return view.mark(outline, view.ink(int(rows.fills[row]), *_stroke(rows, row)))


def _stroke(rows: Rows, row: int) -> tuple[int, float]:
    return int(rows.strokes[row]), float(rows.weights[row])


def _corners(rows: Rows, row: int, count: int) -> Path:
    points = rows.numbers[row, : 2 * count].reshape(count, 2).astype(np.float64)
    return polyline(points, is_closed=True)


def _ellipse(rows: Rows, row: int, view: View) -> Ellipse:
    """Return the ellipse of a row; its sizes may be negative, which turns an arc over."""
    boxes = ellipses.ellipse_boxes(view.style.ellipse_mode, rows.numbers[row : row + 1, :4])
    x, y, width, height = (float(column[0]) for column in boxes)
    return Ellipse(x + width / 2, y + height / 2, width / 2, height / 2)


ITEMS: dict[int, Callable[[Rows, int, View], Iterator[Item | None]]] = {
    Kind.POINT: point_items,
    Kind.LINE: line_items,
    Kind.TRIANGLE: triangle_items,
    Kind.QUAD: quad_items,
    Kind.RECT: rect_items,
    Kind.ELLIPSE: ellipse_items,
    Kind.ARC: arc_items,
}
