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
from sketchkit.backends.cpu.triangles import I64, Triangles, fused


class _Run(NamedTuple):
    """The samples of one plane of the frame that some spans cover.

    Attributes
    ----------
    plane : int
    counts : (m,) int64
        How many samples each span covers.
    along : (k,) int64
        Each sample's place in its span.
    address : (k,) int64
        In a window's (samples, rows, columns).
    """

    plane: int
    counts: I64
    along: I64
    address: I64


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
    if pipeline.depth_test:
        held = surface.window.part_of(surface.frame.depths).copy()
        return _find_last(spans, triangles, surface, held)
    return _find_last(spans, triangles, surface, None)


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
                passing = _depths(some, run, triangles, surface) <= held.reshape(-1)[address]
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
            ranked = _depths(some, run, triangles, surface) | rank
            np.minimum.at(least.reshape(-1), run.address, ranked)
    held[...] = least | NO_TRIANGLE
    return NO_TRIANGLE - 1 - (least & NO_TRIANGLE)


def _runs(spans: Spans, surface: Surface) -> Iterator[_Run]:
    """Yield what the spans cover, a plane of samples after the other."""
    window = surface.window
    rows, columns = window.bottom - window.top, window.right - window.left
    for plane, (left, right) in enumerate(zip(spans.left, spans.right, strict=True)):
        counts = right - left
        along = ramps(counts)
        start = (plane * rows + spans.row - window.top) * columns + left - window.left
        yield _Run(plane, counts, along, np.repeat(start, counts) + along)


def _depths(spans: Spans, run: _Run, triangles: Triangles, surface: Surface) -> I64:
    """Return the depths of samples, (k,), as the frame holds them."""
    place_x, place_y = surface.frame.grid.places[run.plane]
    x = np.repeat(spans.left[run.plane] + place_x, run.counts) + run.along
    y = np.repeat(spans.row + place_y, run.counts)
    origin, per_x, per_y = (
        np.repeat(plane[0, spans.triangle], run.counts) for plane in triangles.depth_planes
    )
    return packed_depths(fused(per_y, y, fused(per_x, x, origin)))
