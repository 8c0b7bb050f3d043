"""Drawing that depends on what is there already: translucent colours, other blend modes.

A pixel's fragments must be blended in the order in which they are drawn, those of different pixels
need not wait for each other. So the fragments are dealt into layers: the first of every pixel, the
second of every pixel, and so on; each layer is blended at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.blending import blend
from sketchkit.backends.cpu.frames import NO_TRIANGLE, Frame, Surface, packed_depths
from sketchkit.backends.cpu.raster import Spans, ramps
from sketchkit.backends.cpu.shading import Shading
from sketchkit.backends.cpu.triangles import I64, Triangles
from sketchkit.draw.vertex import U8

Mask = NDArray[np.bool_]


class Fragments(NamedTuple):
    """Pixels of triangles, in the order in which they are drawn.

    Attributes
    ----------
    triangle, row, column : (k,) int64
    is_covered : (samples, k) bool
        Which of the pixel's samples are inside.
    """

    triangle: I64
    row: I64
    column: I64
    is_covered: Mask

    def take(self, which: I64) -> Fragments:
        """Return some of the fragments."""
        triangle, row, column, is_covered = self
        return Fragments(triangle[which], row[which], column[which], is_covered[:, which])


def draw_in_layers(spans: Iterator[Spans], shading: Shading, surface: Surface) -> None:
    """Blend triangles into a frame."""
    for some in spans:
        fragments = _fragments(some)
        colors = shading.colors(fragments.triangle, fragments.column, fragments.row)
        for layer in _layers(fragments.row * surface.frame.width + fragments.column):
            _draw_layer(fragments.take(layer), colors[layer], shading.triangles, surface)


def _fragments(spans: Spans) -> Fragments:
    """Return the pixels of which spans cover at least one sample."""
    is_empty = spans.left >= spans.right
    left = np.where(is_empty, np.iinfo(np.int64).max, spans.left).min(axis=0)
    right = np.maximum(np.where(is_empty, 0, spans.right).max(axis=0), left)
    counts = right - left
    column = np.repeat(left, counts) + ramps(counts)
    covered = (np.repeat(spans.left, counts, axis=1) <= column) & (
        column < np.repeat(spans.right, counts, axis=1)
    )
    return Fragments(
        np.repeat(spans.triangle, counts), np.repeat(spans.row, counts), column, covered
    )


def _layers(pixel: I64) -> Iterator[I64]:
    """Yield the fragments of each layer, given the pixel of each fragment."""
    if not len(pixel):
        return
    keyed = np.sort(pixel << 32 | np.arange(len(pixel)))  # by pixel, then in drawing order
    by_pixel = keyed & 0xFFFFFFFF
    starts = np.flatnonzero(np.diff(keyed >> 32, prepend=-1))
    counts = np.diff(starts, append=len(keyed))
    starts = starts[np.argsort(-counts, kind="stable")]
    reaching = np.cumsum(np.bincount(counts)[::-1])[::-1]  # how many pixels have that many
    for layer in range(counts.max()):
        yield by_pixel[starts[: reaching[layer + 1]] + layer]


def _draw_layer(fragments: Fragments, colors: U8, triangles: Triangles, surface: Surface) -> None:
    """Blend fragments of different pixels."""
    frame, pipeline = surface.frame, surface.pipeline
    is_shown = fragments.is_covered
    if pipeline.depth_test:
        is_shown = _test_depths(fragments, triangles, frame, is_written=pipeline.depth_write)
    # Four bytes at once: a colour is one number to whoever only moves it.
    held = frame.colors.view(np.uint32).reshape(frame.samples, -1)
    address = fragments.row * frame.width + fragments.column
    there = held.take(address, axis=1)
    blended = blend(pipeline.blend, colors, there[..., None].view(np.uint8))
    held[:, address] = np.where(is_shown, blended.view(np.uint32)[..., 0], there)


def _test_depths(
    fragments: Fragments, triangles: Triangles, frame: Frame, *, is_written: bool
) -> Mask:
    """Return which samples are not behind what the frame holds, (samples, k)."""
    x, y = fragments.column, fragments.row
    z = [
        triangles.depth_planes.at(fragments.triangle, x + place_x, y + place_y)[0]
        for place_x, place_y in frame.grid.places
    ]
    depths = packed_depths(np.stack(z))
    held = frame.depths[:, y, x]
    is_shown: Mask = fragments.is_covered & (depths <= held)
    if is_written:
        frame.depths[:, y, x] = np.where(is_shown, depths | NO_TRIANGLE, held)
    return is_shown
