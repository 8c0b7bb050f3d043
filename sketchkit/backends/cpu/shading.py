"""The fragment stage: the colour of a triangle at a pixel.

Colours are evaluated once a pixel, at its centre, even if that lies outside of the triangle and
only other samples of the pixel inside. Interpolation is perspective-correct: what changes evenly
over the screen is a value divided by w, and 1 / w.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.triangles import F64, I64, Planes, Triangles
from sketchkit.backends.cpu.vertices import LIT
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.vertex import F32, U8

OPAQUE = 255


class Shading:
    """Colours of the triangles of one draw.

    Attributes
    ----------
    triangles : Triangles
    is_opaque : (n,) bool
        Which triangles hide what is behind them, if blended by their alpha.
    """

    def __init__(self, triangles: Triangles, pipeline: Pipeline, centre: float) -> None:
        self.triangles = triangles
        self._centre = centre
        self._corners = _corner_colors(triangles, pipeline)
        self._is_flat = (self._corners == self._corners[0]).all(axis=(0, 2))
        self._flat_colors = quantize(self._corners[0])
        self.is_opaque = (quantize(self._corners[..., 3]) == OPAQUE).all(axis=0)

    def colors(self, triangle: I64, column: I64, row: I64) -> U8:
        """Return the colours of triangles at pixels of the frame, (k, 4)."""
        if self._is_flat.all():
            return self._flat_colors.view(np.uint32)[triangle].view(np.uint8)
        x, y = column + self._centre, row + self._centre
        return quantize(self._interpolate(self._color_planes, triangle, x, y))

    def _interpolate(self, planes: Planes, triangle: I64, x: F64, y: F64) -> F32:
        """Return values, of which planes have what is divided by w, at places in the frame."""
        w = 1 / self._reciprocal_w_planes.at(triangle, x, y)
        values: F32 = planes.at(triangle, x, y) * w
        return values

    @cached_property
    def _reciprocal_w_planes(self) -> Planes:
        return self.triangles.planes(self.triangles.reciprocal_w[..., None])

    @cached_property
    def _color_planes(self) -> Planes:
        return self.triangles.planes(self._corners * self.triangles.reciprocal_w[..., None])


def quantize(colors: F32) -> U8:
    """Return colours 0..1 as 0..255; what is outside becomes the nearest, what is no number 0."""
    bounded = np.minimum(np.fmax(colors, 0), 1)
    return np.rint(bounded * np.float32(255)).astype(np.uint8)


def _corner_colors(triangles: Triangles, pipeline: Pipeline) -> F32:
    """Return the colours at the corners, (3, n, 4), of the side that is seen.

    Clockwise on the picture is the front; some targets have the picture upside down.
    """
    front = triangles.varyings[..., :4]
    if pipeline.program not in LIT:
        return front
    is_front = triangles.is_clockwise == pipeline.target.top_row_first
    return np.where(is_front[:, None], front, triangles.varyings[..., 4:8])
