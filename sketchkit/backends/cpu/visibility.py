"""Which triangle shows at each sample, where triangles hide what is behind them.

Two ways: the last one drawn (painter's order), or the nearest one (z-buffer), the later one of two
that are equally near.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from sketchkit.backends.cpu.frames import NO_TRIANGLE, Surface, packed_depths
from sketchkit.backends.cpu.raster import Spans, ramps
from sketchkit.backends.cpu.shading import Shading
from sketchkit.backends.cpu.triangles import F64, I64, Triangles


class _Run(NamedTuple):
    """The samples of one plane of the frame that some spans cover.

    Attributes
    ----------
    counts : (m,) int64
        How many each span covers.
    address : (k,) int64
        In a window's (samples, rows, columns).
    x, y : (k,) and (m,) float64
        Where the samples lie in the frame, pixels.
    """

    counts: I64
    address: I64
    x: F64
    y: F64


def draw_visible(spans: Iterator[Spans], shading: Shading, surface: Surface) -> None:
    """Give samples the colours of the triangles that show there."""
    shown = _find_shown(spans, shading.triangles, surface)
    window = surface.window
    colors = window.part_of(surface.frame.colors.view(np.uint32)[..., 0])
    for plane, triangle in enumerate(shown):
        is_shown = triangle >= 0
        if plane:  # most samples show what the first one of their pixel does
            is_same = is_shown & (triangle == shown[0])
            np.copyto(colors[plane], colors[0], where=is_same)
            is_shown &= ~is_same
        pixel = np.flatnonzero(is_shown)
        row, column = np.divmod(pixel, is_shown.shape[1])
        seen = shading.colors(triangle.reshape(-1)[pixel], column + window.left, row + window.top)
        colors[plane, row, column] = seen.view(np.uint32)[:, 0]


def _find_shown(spans: Iterator[Spans], triangles: Triangles, surface: Surface) -> I64:
    """Return the triangle that shows at each sample of the window, or -1.

    The shape is (samples, rows, columns).
    """
    pipeline = surface.pipeline
    if pipeline.depth_test and pipeline.depth_write:
        return _find_nearest(spans, triangles, surface)
    held = surface.window.part_of(surface.frame.depths) if pipeline.depth_test else None
    return _find_last(spans, triangles, surface, held)


def _find_last(
    spans: Iterator[Spans], triangles: Triangles, surface: Surface, held: I64 | None
) -> I64:
    """Return the last triangle at each sample, of those not behind `held` if that is given."""
    window = surface.window
    shown = np.full(window.part_of(surface.frame.colors).shape[:3], -1)
    for some in spans:
        for run in _runs(some, surface):
            address, triangle = run.address, np.repeat(some.triangle, run.counts)
            if held is not None:
                passing = _depths(some, run, triangles) <= held.reshape(-1)[address]
                address, triangle = address[passing], triangle[passing]
            shown.reshape(-1)[address] = triangle
    return shown


def _find_nearest(spans: Iterator[Spans], triangles: Triangles, surface: Surface) -> I64:
    """Return the nearest triangle at each sample that is not behind what the frame holds.

    The frame then holds the depths of those triangles. One number tells both who is nearer and,
    of the equally near, who comes later (see `Frame.depths`); so the least number wins, in
    whatever order.
    """
    held = surface.window.part_of(surface.frame.depths)
    least = held.copy()
    for some in spans:
        for run in _runs(some, surface):
            rank = np.repeat(NO_TRIANGLE - 1 - some.triangle, run.counts)
            np.minimum.at(least.reshape(-1), run.address, _depths(some, run, triangles) | rank)
    held[...] = least | NO_TRIANGLE
    return NO_TRIANGLE - 1 - (least & NO_TRIANGLE)


def _runs(spans: Spans, surface: Surface) -> Iterator[_Run]:
    """Yield what the spans cover, a plane of samples after the other."""
    window, grid = surface.window, surface.frame.grid
    rows, columns = window.bottom - window.top, window.right - window.left
    for plane, (place_x, place_y) in enumerate(grid.places):
        left = spans.left[plane]
        counts = spans.right[plane] - left
        start = (plane * rows + spans.row - window.top) * columns + left - window.left
        along = ramps(counts)
        yield _Run(
            counts,
            address=np.repeat(start, counts) + along,
            x=np.repeat(left + place_x, counts) + along,
            y=spans.row + place_y,
        )


def _depths(spans: Spans, run: _Run, triangles: Triangles) -> I64:
    """Return depths of samples, (k,), times 2**32 as the frame holds them."""
    planes = triangles.depth_planes
    origin, per_x, per_y = (
        np.repeat(column[spans.triangle, 0].astype(np.float64), run.counts) for column in planes
    )
    z = (per_x * run.x + origin).astype(np.float32)
    z = (per_y * np.repeat(run.y, run.counts) + z).astype(np.float32)
    return packed_depths(z)
