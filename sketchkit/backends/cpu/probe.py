"""The probe: what of a draw lands in one pixel, fragment by fragment.

It goes through the same stages as the executor, with the same arithmetic, but keeps each fragment
beside the triangle that it comes from, instead of blending them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.clipping import clip_triangles
from sketchkit.backends.cpu.frames import Frame, SampleGrid, Window, packed_depths, window_of
from sketchkit.backends.cpu.raster import rasterize
from sketchkit.backends.cpu.shading import Sampled, Shading
from sketchkit.backends.cpu.triangles import Triangles, set_up
from sketchkit.backends.cpu.vertices import LIT, TEXTURED, Range, assemble
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import F32, U8, VertexBlock

Mask = NDArray[np.bool_]
I64 = NDArray[np.int64]


class Fragment(NamedTuple):
    """What a triangle has in a pixel.

    Attributes
    ----------
    triangle : int
        Which of the block's, counted from its first index.
    is_covered : (samples,) bool
    is_clipped : bool
        Whether a clip keeps it from being drawn.
    color : (4,) uint8
    depths : (samples,) int64
        As `Frame.depths` has them.
    uv : (u, v) or None
        The place on the texture.
    is_discarded : bool
        Whether a shader of the sketch's own draws nothing there.
    """

    triangle: int
    is_covered: Mask
    is_clipped: bool
    color: U8
    depths: I64
    uv: tuple[float, float] | None
    is_discarded: bool = False


def probe(
    pipeline: Pipeline,
    block: VertexBlock,
    drawn: Range,
    place: tuple[int, int],
    texture: Sampled | None,
) -> list[Fragment]:
    """Return what a draw has in a pixel, in the order in which it is drawn.

    Parameters
    ----------
    pipeline : Pipeline
        Its target says how large the canvas is, and which way up.
    place : (x, y)
        Of the pixel, from the top left of the picture.
    texture : Sampled or None
        What covers the triangles.
    """
    target = pipeline.target
    column, row = place[0], place[1] if target.top_row_first else target.height - 1 - place[1]
    with np.errstate(all="ignore"):
        corners = clip_triangles(_numbered(assemble(block, pipeline, drawn), pipeline))
        frame = Frame(Target(target.width, target.height, target.samples, target.top_row_first))
        triangles = set_up(corners, frame)
        around = Window(0, 0, target.width, target.height).meet(
            column - 1, row - 1, column + 2, row + 2
        )
        near = _near(triangles, around)
        if not len(near):
            return []
        numbers = near.varyings[0, _number_column(pipeline)].astype(np.int64) + drawn.first // 3
        shading = Shading(near, pipeline, frame.grid.centre, texture)
        turned = target.top_row_first
        clip = window_of(target, pipeline.clip).meet(*around)
        covered = _covered(near, around, frame.grid, (column, row), turned=turned)
        kept = (
            covered
            if clip == around
            else _covered(near, clip, frame.grid, (column, row), turned=turned)
        )
        return [
            _fragment(
                shading, own, (column, row), frame, kept.get(own, mask), own not in kept
            )._replace(triangle=int(numbers[own]))
            for own, mask in sorted(covered.items())
        ]


def _number_column(pipeline: Pipeline) -> int:
    """Return which of what is interpolated is the triangle's number: before u and v."""
    return 8 if pipeline.program in LIT else 4


def _numbered(corners: F32, pipeline: Pipeline) -> F32:
    """Return corners with the number of their triangle among what is interpolated."""
    at = 4 + _number_column(pipeline)
    numbers = np.arange(len(corners), dtype=np.float32)[:, None, None]
    column = np.broadcast_to(numbers, (len(corners), 3, 1))
    return np.concatenate([corners[..., :at], column, corners[..., at:]], axis=2)


def _near(triangles: Triangles, window: Window) -> Triangles:
    """Return the triangles whose bounds meet a window."""
    x, y = triangles.x, triangles.y
    meets = (x.max(axis=0) >= window.left - 1) & (x.min(axis=0) <= window.right + 1)
    meets &= (y.max(axis=0) >= window.top - 1) & (y.min(axis=0) <= window.bottom + 1)
    at = np.flatnonzero(meets)
    return Triangles(
        triangles.grid_x[:, at],
        triangles.grid_y[:, at],
        triangles.x[:, at],
        triangles.y[:, at],
        triangles.depths[:, at],
        triangles.reciprocal_w[:, at],
        triangles.varyings[..., at],
        triangles.is_clockwise[at],
    )


def _covered(
    triangles: Triangles, window: Window, grid: SampleGrid, place: tuple[int, int], *, turned: bool
) -> dict[int, Mask]:
    """Return which samples of a pixel each triangle covers; those that cover none are left out."""
    if window.is_empty:
        return {}
    column, row = place
    found = {}
    for spans in rasterize(triangles, slice(0, len(triangles)), window, grid, turned=turned):
        for at in np.flatnonzero(spans.row == row):
            mask = (spans.left[:, at] <= column) & (column < spans.right[:, at])
            if mask.any():
                found[int(spans.triangle[at])] = mask
    return found


def _fragment(
    shading: Shading,
    triangle: int,
    place: tuple[int, int],
    frame: Frame,
    is_covered: Mask,
    is_clipped: bool,
) -> Fragment:
    column, row = place
    own, x, y = np.array([triangle]), np.array([column]), np.array([row])
    triangles = shading.triangles
    depths = [
        triangles.depth_planes.at(own, x + place_x, y + place_y)[0, 0]
        for place_x, place_y in frame.grid.places
    ]
    uv = shading.uvs(own, x, y)[:, 0].tolist() if shading.is_textured else None
    return Fragment(
        triangle,
        is_covered,
        is_clipped,
        shading.colors(own, x, y)[0],
        packed_depths(np.array(depths, np.float32)),
        None if uv is None else (uv[0], uv[1]),
    )


__all__ = ["TEXTURED", "Fragment", "Range", "probe"]
