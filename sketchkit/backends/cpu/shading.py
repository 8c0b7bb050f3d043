"""The fragment stage: the colour of a triangle at a pixel.

Colours are evaluated once a pixel, at its centre, even if that lies outside of the triangle and
only other samples of the pixel inside. Interpolation is perspective-correct: what changes evenly
over the screen is a value divided by w, and 1 / w.
"""

from __future__ import annotations

from functools import cached_property
from typing import Protocol

import numpy as np

from sketchkit.backends.cpu.frames import bounded
from sketchkit.backends.cpu.lighting import unit_colors
from sketchkit.backends.cpu.triangles import I64, Numbers, Planes, Triangles
from sketchkit.backends.cpu.vertices import LIT
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Wrap
from sketchkit.draw.vertex import F32, U8

OPAQUE = 255


class Sampled(Protocol):
    """What covers triangles: a texture, or what stands for one (see `Texture`)."""

    @property
    def is_opaque(self) -> bool:
        """Whether alpha is 255 everywhere."""
        ...

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows."""
        ...

    def sample(self, uv: F32, texels_squared: F32, wrap: Wrap) -> U8:
        """Return colours, (4, k), at places, (2, k)."""
        ...


class Shading:
    """Colours of the triangles of one draw.

    Attributes
    ----------
    triangles : Triangles
    is_opaque : (n,) bool
        Which triangles hide what is behind them, if blended by their alpha.
    """

    def __init__(
        self, triangles: Triangles, pipeline: Pipeline, centre: float, texture: Sampled | None
    ) -> None:
        self.triangles = triangles
        self._centre = centre
        self._texture = texture
        self._wrap = pipeline.wrap
        self._corners = _corner_colors(triangles, pipeline)
        self._is_flat = (self._corners == self._corners[0]).all(axis=(0, 1))
        self._flat_colors = as_rows(quantize(self._corners[0]))
        self.is_opaque = (quantize(self._corners[:, 3]) == OPAQUE).all(axis=0)
        if texture is not None:
            self.is_opaque &= texture.is_opaque

    @property
    def is_textured(self) -> bool:
        """Whether something covers them."""
        return self._texture is not None

    def colors(self, triangle: I64, column: I64, row: I64) -> U8:
        """Return the colours of triangles at pixels of the frame, (k, 4)."""
        if self._texture is None and self._is_flat.all():
            return self._flat_colors.view(np.uint32)[triangle].view(np.uint8)
        if self._is_flat.all():
            colors = self._corners[0].take(triangle, axis=1)
        else:
            x, y = column + self._centre, row + self._centre
            colors = self._interpolate(self._color_planes, triangle, x, y)
        if self._texture is not None:
            colors *= unit_colors(self._texels(self._texture, triangle, column, row))
        return as_rows(quantize(colors))

    def uvs(self, triangle: I64, column: I64, row: I64) -> F32:
        """Return the places on the texture that triangles show at pixels of the frame, (2, k)."""
        x, y = column + self._centre, row + self._centre
        return self._interpolate(self._uv_planes, triangle, x, y)

    def _texels(self, texture: Sampled, triangle: I64, column: I64, row: I64) -> U8:
        """Return the colours of the texture, (4, k).

        How far the texture moves from one pixel to the next is looked up for blocks of 2x2 pixels
        that begin at even ones: graphics hardware shades such blocks together.
        """

        def uv_at(x: I64, y: I64) -> F32:
            x_centre, y_centre = x + self._centre, y + self._centre
            return self._interpolate(self._uv_planes, triangle, x_centre, y_centre)

        left, top = column & ~1, row & ~1
        corner = uv_at(left, top)
        size = np.array(texture.size, np.float32)[:, None]
        along_x, along_y = (
            ((uv_at(x, y) - corner) * size) ** 2 for x, y in ((left + 1, top), (left, top + 1))
        )
        texels_squared = np.maximum(along_x[0] + along_x[1], along_y[0] + along_y[1])
        return texture.sample(uv_at(column, row), texels_squared, self._wrap)

    def _interpolate(self, planes: Planes, triangle: I64, x: Numbers, y: Numbers) -> F32:
        """Return values, of which planes have what is divided by w, at places in the frame."""
        values = planes.at(triangle, x, y)
        values *= 1 / self._reciprocal_w_planes.at(triangle, x, y)
        return values

    @cached_property
    def _reciprocal_w_planes(self) -> Planes:
        return self.triangles.planes(self.triangles.reciprocal_w[:, None])

    @cached_property
    def _color_planes(self) -> Planes:
        return self.triangles.planes(self._corners * self.triangles.reciprocal_w[:, None])

    @cached_property
    def _uv_planes(self) -> Planes:
        uvs = self.triangles.varyings[:, -2:]
        return self.triangles.planes(uvs * self.triangles.reciprocal_w[:, None])


def quantize(colors: F32) -> U8:
    """Return colours 0..1 as 0..255."""
    whole: U8 = np.rint(bounded(colors) * np.float32(255)).astype(np.uint8)
    return whole


def as_rows(channels: U8) -> U8:
    """Return colours, (4, k), a row each."""
    return np.ascontiguousarray(channels.T)


def _corner_colors(triangles: Triangles, pipeline: Pipeline) -> F32:
    """Return the colours at the corners, (3, 4, n), of the side that is seen.

    Clockwise on the picture is the front; some targets have the picture upside down.
    """
    front = triangles.varyings[:, :4]
    if pipeline.program not in LIT:
        return front
    is_front = triangles.is_clockwise == pipeline.target.top_row_first
    return np.where(is_front, front, triangles.varyings[:, 4:8])
