"""Rasterisation: which samples of the frame lie inside which triangles.

A triangle crosses a row of samples in one run. Where the run begins and ends follows from its
three edges by a division; so the work is a few operations for each row of a triangle, not for
each pixel of its bounding box. Exact: the edge functions are whole numbers below 2**53.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import floor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.frames import SUBPIXELS, SampleGrid, Window
from sketchkit.backends.cpu.triangles import F64, I64, Triangles

ROWS_AT_ONCE = 1 << 15
PIXELS_AT_ONCE = 1 << 16  # what fits the processor's cache


class Spans(NamedTuple):
    """Runs of samples, one for each row of each triangle, in the order of the triangles.

    Attributes
    ----------
    triangle, row : (m,) int64
    left, right : (samples, m) int64
        Columns of the pixels whose sample is inside; `right` is the first one that is not.
    """

    triangle: I64
    row: I64
    left: I64
    right: I64


class _Edges(NamedTuple):
    """The edges of triangles: a * x + b * y + c > 0 inside, 1/256 px; (3, n) each.

    c ends in a half, so that a place on the grid is never on an edge: it belongs to the triangle
    that has the edge on its left or at its top, as OpenGL has it; or at its bottom, where the
    driver turns the picture over. The edges are sorted by a: the
    first has the inside to its right, the last to its left.
    """

    a: F64
    b: F64
    c: F64


def rasterize(
    triangles: Triangles, part: slice, window: Window, grid: SampleGrid, *, turned: bool
) -> Iterator[Spans]:
    """Yield the spans of some of the triangles inside a window, a few at a time.

    `turned` says whether what lies on a horizontal edge is inside above it, not below.
    """
    x, y = triangles.grid_x[:, part], triangles.grid_y[:, part]
    edges = _edges(x, y, turned=turned)
    places = np.rint(np.array(grid.places) * SUBPIXELS)
    highest, lowest = places[:, 1].max(), places[:, 1].min()
    top = np.maximum(np.ceil((y.min(axis=0) - highest) / SUBPIXELS), _limit(window.top, highest))
    bottom = np.minimum(np.floor((y.max(axis=0) - lowest) / SUBPIXELS) + 1, window.bottom)
    rows = np.where(_meets(x, y, window), np.maximum(bottom - top, 0), 0).astype(np.int64)
    for some in batches(rows, ROWS_AT_ONCE):
        counts = rows[some]
        triangle = np.repeat(np.arange(some.start, some.stop) + part.start, counts)
        row = np.repeat(top[some].astype(np.int64), counts) + ramps(counts)
        left, right = _runs(_Edges(*(e[:, some] for e in edges)), counts, row, places)
        for plane, (place_x, place_y) in enumerate(places):
            np.clip(left[plane], _limit(window.left, place_x), window.right, out=left[plane])
            right[plane, row < _limit(window.top, place_y)] = 0
        np.clip(right, left, window.right, out=right)
        spans = Spans(triangle, row, left.astype(np.int64), right.astype(np.int64))
        for few in batches((spans.right - spans.left).max(axis=0), PIXELS_AT_ONCE):
            yield Spans(*(column[..., few] for column in spans))


def _meets(x: F64, y: F64, window: Window) -> NDArray[np.bool_]:
    """Return which triangles' bounding boxes share a pixel with a window."""
    last_column, last_row = (x.max(axis=0) - 1) // SUBPIXELS, (y.max(axis=0) - 1) // SUBPIXELS
    meets: NDArray[np.bool_] = (last_column >= window.left) & (last_row >= window.top)
    return meets


def _limit(edge: int, place: float) -> int:
    """Return the first column, or row, whose sample is inside a window that begins at `edge`.

    Mesa lets samples pass from half a pixel before the edge on, which with four to a pixel lets
    two of the pixel before pass; Processing's frames made with Mesa show it.
    """
    return max(floor(edge - 0.5 - place / SUBPIXELS) + 1, 0)


def batches(costs: I64, limit: int) -> Iterator[slice]:
    """Yield slices of a sequence that cost about `limit` each, and at least one item."""
    total = np.cumsum(costs)
    first = 0
    while first < len(costs):
        spent = total[first - 1] if first else 0
        last = max(int(np.searchsorted(total, spent + limit, side="right")), first + 1)
        yield slice(first, last)
        first = last


def ramps(counts: I64) -> I64:
    """Return 0, 1, 2 ... anew for each count."""
    ends = np.cumsum(counts)
    return np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - counts, counts)


def _edges(x: F64, y: F64, *, turned: bool) -> _Edges:
    next_x, next_y = np.roll(x, -1, axis=0), np.roll(y, -1, axis=0)
    a, b = next_y - y, x - next_x
    is_inside = (a > 0) | ((a == 0) & ((b < 0) if turned else (b > 0)))
    c = -(a * x + b * y) + np.where(is_inside, 0.5, -0.5)
    order = np.argsort(-a, axis=0)
    return _Edges(*(np.take_along_axis(column, order, axis=0) for column in (a, b, c)))


def _runs(edges: _Edges, counts: I64, row: I64, places: F64) -> tuple[F64, F64]:
    """Return where runs begin and end, (samples, m): whole numbers, or infinite.

    A horizontal edge, a = 0, gives an infinity whose sign says on which side of it the row lies.
    """
    y = row * float(SUBPIXELS)
    crossings = []
    for a, b, c in zip(*edges, strict=True):
        slope, shift = np.repeat(a, counts), np.repeat(b, counts)
        value = np.repeat(c, counts) + shift * y
        at_places = np.stack([value + (slope * px + shift * py) for px, py in places])
        crossings.append(at_places / (slope * -SUBPIXELS))
    first, middle, last = crossings
    is_left = np.repeat(edges.a[1] >= 0, counts)
    left = np.ceil(np.maximum(first, np.where(is_left, middle, -np.inf)))
    right = np.ceil(np.minimum(last, np.where(is_left, np.inf, middle)))
    return left, right
