"""Strokes and points of P3D: strips and fans that face the viewer, made in clip space."""

from __future__ import annotations

import numpy as np

from sketchkit.backends.cpu.projection import project
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.vertex import F32


def widen_lines(positions: F32, directions: F32, pipeline: Pipeline) -> F32:
    """Return the corners of strokes in clip space, (n, 4).

    A corner lies half the weight to the side of the line to the segment's other end, as seen on
    the screen. The middle of a join has no direction, and stays where it is.
    """
    scale = np.array(pipeline.line_scale, np.float32)
    here = project(positions * scale, pipeline.projection)
    there = project((positions + directions[:, :3]) * scale, pipeline.projection)
    # On the screen it is there.xy / there.w - here.xy / here.w; multiplied by both w it is the
    # same direction, and needs no division by what may be 0.
    along = (there[:, :2] * here[:, 3:] - here[:, :2] * there[:, 3:]) * _size(pipeline)
    squares = along[:, 0] * along[:, 0] + along[:, 1] * along[:, 1]
    along *= (np.float32(1) / np.sqrt(np.where(squares > 0, squares, 1)))[:, None]
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) * directions[:, 3:]
    return _offset(here, across, pipeline)


def widen_points(positions: F32, offsets: F32, pipeline: Pipeline) -> F32:
    """Return the corners of points in clip space, (n, 4): each its offset from its centre."""
    return _offset(project(positions, pipeline.projection), offsets, pipeline)


def _offset(clip: F32, offsets: F32, pipeline: Pipeline) -> F32:
    """Return clip-space places moved by offsets, (n, 2), in pixels or in eye space."""
    if pipeline.stroke_perspective:
        matrix = np.array(pipeline.projection, np.float32).reshape(4, 4)
        clip[:, :2] += offsets * (matrix[:2, 0] - matrix[:2, 1])  # of the length (1, -1)
    else:
        clip[:, :2] += offsets * (clip[:, 3:] / (np.float32(0.5) * _size(pipeline)))
    return clip


def _size(pipeline: Pipeline) -> F32:
    return np.array([pipeline.target.across, pipeline.target.down], np.float32)
