"""Textures: an image and its smaller copies, and the colour between their texels.

Filtered three times linearly, as Processing asks OpenGL: between columns, between rows, and between
the two copies whose texels are nearest to the size of a pixel. In whole numbers with 8-bit weights,
as Mesa does, and with its short cut for the logarithm.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.triangles import fused
from sketchkit.draw.resources import Pixels, Wrap
from sketchkit.draw.vertex import F32, U8

I32 = NDArray[np.int32]
I64 = NDArray[np.int64]

WEIGHT_BITS = 8
ONE = 1 << WEIGHT_BITS  # the weight 1
HALF = ONE // 2


class Texture:
    """An image made ready to be sampled.

    Attributes
    ----------
    version : int
        The image's, when it was copied.
    is_opaque : bool
        Whether alpha is 255 everywhere.
    """

    def __init__(self, pixels: Pixels) -> None:
        self.version = pixels.version
        self.is_opaque: bool = bool((pixels.data[..., 3] == 255).all())
        levels = [np.ascontiguousarray(pixels.data)]
        while pixels.mipmaps and max(levels[-1].shape[:2]) > 1:
            levels.append(_halve(levels[-1]))
        self._texels = np.concatenate([level.reshape(-1, 4).T for level in levels], axis=1)
        self._heights = np.array([level.shape[0] for level in levels])
        self._widths = np.array([level.shape[1] for level in levels])
        sizes = self._heights * self._widths
        self._starts = np.cumsum(sizes) - sizes

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows of the image."""
        return int(self._widths[0]), int(self._heights[0])

    def sample(self, uv: F32, texels_squared: F32, wrap: Wrap) -> U8:
        """Return colours, (4, k), at places in the image, (2, k), 0..1 from its top left.

        `texels_squared`, (k,), is the square of how many of the image's texels a pixel spans.
        """
        detail = np.clip(_half_log2(texels_squared), 0, len(self._starts) - 1)
        level = detail.astype(np.int64)
        weight = ((detail - level) * ONE).astype(np.int32)
        colors = self._between_texels(uv, level, wrap)
        blurred = np.flatnonzero(weight)
        if len(blurred):
            smaller = self._between_texels(uv[:, blurred], level[blurred] + 1, wrap)
            colors[:, blurred] = _lerp(colors[:, blurred], smaller, weight[blurred])
        return colors.astype(np.uint8)

    def _between_texels(self, uv: F32, level: I64, wrap: Wrap) -> I32:
        """Return colours of one copy of the image for each place, (4, k)."""
        start, width = self._starts[level], self._widths[level]
        left, right, weight_x = _neighbours(uv[0], width, wrap)
        above, below, weight_y = _neighbours(uv[1], self._heights[level], wrap)
        upper, lower = (
            _lerp(self._at(address + left), self._at(address + right), weight_x)
            for address in (start + above * width, start + below * width)
        )
        return _lerp(upper, lower, weight_y)

    def _at(self, address: I64) -> I32:
        return self._texels.take(address, axis=1).astype(np.int32)


def _neighbours(places: F32, length: I64, wrap: Wrap) -> tuple[I64, I64, I32]:
    """Return the texels before and after places 0..1 in a row, and the weight of the latter."""
    fixed = np.rint(places * length.astype(np.float32) * np.float32(ONE)).astype(np.int64) - HALF
    before, weight = fixed >> WEIGHT_BITS, (fixed & (ONE - 1)).astype(np.int32)
    if wrap is Wrap.REPEAT:
        return before % length, (before + 1) % length, weight
    last = length - 1
    return np.clip(before, 0, last), np.clip(before + 1, 0, last), weight


def _lerp(a: I32, b: I32, weight: I32) -> I32:
    return a + (((b - a) * weight + HALF) >> WEIGHT_BITS)


def _half_log2(squares: F32) -> F32:
    """Return about half the logarithm: right at the powers of two, straight in between."""
    mantissa, exponent = np.frexp(np.maximum(squares, np.float32(1)))
    half: F32 = np.float32(0.5) * (exponent - 2 + 2 * mantissa)
    return half


def _halve(level: U8) -> U8:
    """Return the next smaller copy: means of 2x2, or what is between if a side is odd."""
    height, width = level.shape[:2]
    half_width, half_height = max(width // 2, 1), max(height // 2, 1)
    u, v = _centres(half_width, half_height), _centres(half_height, half_width)
    uv = np.stack(np.meshgrid(u, v)).reshape(2, -1)
    alone = Texture(Pixels(level, mipmaps=False))
    halved = alone.sample(uv, np.zeros(uv.shape[1], np.float32), Wrap.CLAMP)
    return halved.T.reshape(half_height, half_width, 4)


def _centres(count: int, other: int) -> F32:
    """Return the centres of `count` pixels, 0..1, as a rectangle `other` pixels high has them."""
    step = np.float32(other) * (np.float32(1) / (np.float32(count) * np.float32(other)))
    return fused(np.full(count, step), np.arange(count), np.full(count, step / 2))
