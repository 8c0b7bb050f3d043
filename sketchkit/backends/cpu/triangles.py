"""Set-up: triangles on the frame, their corners on an exact grid and their values as planes.

The arithmetic is Mesa's: what is fused, and at which corner a triangle begins. The planes of thin
triangles depend on it visibly.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import floor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.frames import SUBPIXELS, Frame, Window
from sketchkit.draw.vertex import F32

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]
Numbers = NDArray[np.floating] | NDArray[np.integer]


class Planes(NamedTuple):
    """Values that change evenly over a triangle: a row a value, a column a triangle.

    Attributes
    ----------
    origin : (c, n) float32
        At place (0, 0) of the frame.
    per_x, per_y : (c, n) float32
        The change from one pixel to the next.
    """

    origin: F32
    per_x: F32
    per_y: F32

    def at(self, triangle: I64, x: Numbers, y: Numbers) -> F32:
        """Return the values of triangles at places in the frame, (c, k)."""
        origin, per_x, per_y = (plane.take(triangle, axis=1) for plane in self)
        return fused(per_y, y, fused(per_x, x, origin))


@dataclass
class Triangles:
    """Triangles on a frame, in the order in which they are drawn.

    Attributes
    ----------
    grid_x, grid_y : (3, n) float64, 1/256 px
        The corners, rounded to whole numbers.
    x, y : (3, n) float32, pixels
        The corners before that; the planes go through these.
    depths : (3, n) float32
        0 (near) to 1, at the corners.
    reciprocal_w : (3, n) float32
    varyings : (3, k, n) float32
    is_clockwise : (n,) bool
        Whether the corners, as they were drawn, run clockwise if rows count downwards.
    """

    grid_x: F64
    grid_y: F64
    x: F32
    y: F32
    depths: F32
    reciprocal_w: F32
    varyings: F32
    is_clockwise: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.is_clockwise)

    @cached_property
    def depth_planes(self) -> Planes:
        """Return depth, one row."""
        return self.planes(self.depths[:, None])

    def within(self, window: Window) -> Window:
        """Return the part of a window that the triangles reach."""
        if not len(self):
            return Window(0, 0, 0, 0)
        left, top = self.grid_x.min() / SUBPIXELS, self.grid_y.min() / SUBPIXELS
        right, bottom = self.grid_x.max() / SUBPIXELS, self.grid_y.max() / SUBPIXELS
        return window.meet(floor(left), floor(top), floor(right) + 1, floor(bottom) + 1)

    def planes(self, values: F32) -> Planes:
        """Return the planes through values at the corners, (3, c, n)."""
        x, y = self.x, self.y
        from_second_x, from_second_y = x[0] - x[1], y[0] - y[1]
        to_third_x, to_third_y = x[2] - x[0], y[2] - y[0]
        area = from_second_x * to_third_y - from_second_y * to_third_x
        per_area = 1 / area
        from_second, to_third = values[0] - values[1], values[2] - values[0]
        per_x = from_second * (to_third_y * per_area) - to_third * (from_second_y * per_area)
        per_y = to_third * (from_second_x * per_area) - from_second * (to_third_x * per_area)
        return Planes(values[0] - (per_x * x[0] + per_y * y[0]), per_x, per_y)


def set_up(corners: F32, frame: Frame) -> Triangles:
    """Return clipped triangles, (n, 3, 4 + k), on a frame; those without area are left out.

    Clip space is the frame's own here: its +y is where rows count to.
    """
    columns = np.ascontiguousarray(corners.transpose(2, 1, 0))  # (4 + k, 3, n)
    reciprocal_w = 1 / columns[3]
    half_size = np.array([frame.width / 2, frame.height / 2, 0.5], np.float32)[:, None, None]
    x, y, depths = fused(columns[:3] * reciprocal_w, half_size, half_size)
    x, y = x - np.float32(frame.grid.shift), y - np.float32(frame.grid.shift)
    grid_x, grid_y = _to_grid(x), _to_grid(y)
    area = (grid_x[1] - grid_x[0]) * (grid_y[2] - grid_y[0])
    area -= (grid_x[2] - grid_x[0]) * (grid_y[1] - grid_y[0])
    kept = np.flatnonzero(np.abs(area) > 0)
    is_clockwise: NDArray[np.bool_] = area[kept] > 0
    first = np.where(is_clockwise, 1, 0)  # anticlockwise from there on
    order = np.stack([first, 1 - first, np.full_like(first, 2)]), kept
    return Triangles(
        grid_x[order],
        grid_y[order],
        x[order],
        y[order],
        depths[order],
        reciprocal_w[order],
        columns[4:, *order].transpose(1, 0, 2),
        is_clockwise,
    )


def _to_grid(places: F32) -> F64:
    """Return places, pixels, in whole 1/256 px.

    + 0.0 leaves no -0.0: at horizontal edges the sign of a zero decides (see raster).
    """
    grid: F64 = np.rint(places * np.float32(SUBPIXELS)).astype(np.float64) + 0.0
    return grid


def fused(a: F32, b: Numbers, c: F32) -> F32:
    """Return a * b + c, rounded once: the product of two float32 is exact in float64."""
    total: F32 = (a * np.asarray(b, np.float64) + c).astype(np.float32)
    return total
