"""Reach: whether a draw's triangles come onto the picture at all, and if not, what keeps them off.

The stages are the executor's; where it only leaves a triangle out, this says why.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import numpy as np

from sketchkit.backends.cpu.clipping import SIDES, clip_triangles
from sketchkit.backends.cpu.frames import Frame, Window, window_of
from sketchkit.backends.cpu.raster import rasterize
from sketchkit.backends.cpu.triangles import Triangles, set_up
from sketchkit.backends.cpu.vertices import Range, assemble
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import F32, VertexBlock

MOST_PLACES = 5  # pixels that are named of what does reach the picture


class Obstacle(Enum):
    """What keeps triangles off a picture."""

    NO_NUMBER = "no number"
    BEHIND = "behind the camera"
    TOO_NEAR = "nearer than the near plane"
    TOO_FAR = "farther than the far plane"
    LEFT = "left of the picture"
    RIGHT = "right of the picture"
    ABOVE = "above the picture"
    BELOW = "below the picture"
    OUTSIDE = "outside of what the camera sees"
    FLAT = "without area on the picture"
    SMALL = "between the samples"
    CLIPPED = "outside of the clip"


@dataclass(frozen=True)
class Reach:
    """How far a draw gets.

    Attributes
    ----------
    obstacle : Obstacle or None
        None if some of it is drawn.
    bounds : (left, top, right, bottom) or None, pixels
        What it spans, from the top left of the picture; None where that cannot be said.
    places : list of (x, y)
        Pixels that it covers, from the top left of the picture.
    """

    obstacle: Obstacle | None
    bounds: tuple[float, float, float, float] | None = None
    places: list[tuple[int, int]] = field(default_factory=list)


def reach(pipeline: Pipeline, block: VertexBlock, drawn: Range) -> Reach:
    """Return how far the triangles of a draw get."""
    with np.errstate(all="ignore"):
        corners = assemble(block, pipeline, drawn)
        sound = corners[np.isfinite(corners[..., :4]).all(axis=(1, 2))]
        if not len(sound):
            return Reach(Obstacle.NO_NUMBER)
        bounds = _bounds(sound, pipeline.target)
        if obstacle := _outside(sound, pipeline.target):
            return Reach(obstacle, bounds)
        in_view = clip_triangles(sound)
        if not len(in_view):
            return Reach(Obstacle.OUTSIDE, bounds)
        size = pipeline.target
        frame = Frame(Target(size.width, size.height, size.samples, size.top_row_first))
        triangles = set_up(in_view, frame)
        if not len(triangles):
            return Reach(Obstacle.FLAT, bounds)
        places = _places(triangles, window_of(size, pipeline.clip), frame, size)
        if places:
            return Reach(None, bounds, places)
        everywhere = Window(0, 0, size.width, size.height)
        if pipeline.clip is not None and _places(triangles, everywhere, frame, size):
            return Reach(Obstacle.CLIPPED, bounds)
        return Reach(Obstacle.SMALL, bounds)


def _bounds(corners: F32, target: Target) -> tuple[float, float, float, float] | None:
    """Return what corners span on the picture; None if some are not before the camera."""
    x, y, _, w = (corners[..., column] for column in range(4))
    if not (w > 0).all():
        return None
    across, down = (x / w + 1) * target.width / 2, (y / w + 1) * target.height / 2
    if not target.top_row_first:
        down = target.height - down
    return float(across.min()), float(down.min()), float(across.max()), float(down.max())


def _outside(corners: F32, target: Target) -> Obstacle | None:
    """Return the side of the view that all corners are beyond."""
    x, y, z, w = (corners[..., column] for column in range(4))
    if (w <= 0).all():
        return Obstacle.BEHIND
    vertical = (Obstacle.BELOW, Obstacle.ABOVE)
    if not target.top_row_first:
        vertical = vertical[1], vertical[0]
    names = (Obstacle.RIGHT, Obstacle.LEFT, *vertical, Obstacle.TOO_NEAR, Obstacle.TOO_FAR)
    beyond = {
        name: bool((x * side[0] + y * side[1] + z * side[2] + w * side[3] < 0).all())
        for side, name in zip(SIDES, names, strict=True)
    }
    # Depth first: what is too near lies beside the picture only because it is.
    order = (*names[4:], *names[:4])
    return next((name for name in order if beyond[name]), None)


def _places(
    triangles: Triangles, window: Window, frame: Frame, target: Target
) -> list[tuple[int, int]]:
    """Return some of the pixels that triangles cover inside a window."""
    if window.is_empty:
        return []
    found: list[tuple[int, int]] = []
    every = slice(0, len(triangles))
    for spans in rasterize(triangles, every, window, frame.grid, turned=target.top_row_first):
        covered = np.flatnonzero((spans.right > spans.left).any(axis=0))
        if not len(covered):
            continue
        for at in covered[np.linspace(0, len(covered) - 1, MOST_PLACES).astype(int)]:
            sample = int(np.argmax(spans.right[:, at] - spans.left[:, at]))
            column = int(spans.left[sample, at] + spans.right[sample, at]) // 2
            row = int(spans.row[at])
            found.append((column, row if target.top_row_first else target.height - 1 - row))
    distinct = list(dict.fromkeys(found))
    step = max(len(distinct) // MOST_PLACES, 1)
    return distinct[::step][:MOST_PLACES]
