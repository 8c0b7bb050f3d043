"""Filters that look at each pixel, or at its four neighbours: all of `filter()` but the blur.

They return a new picture, and leave alpha as it is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
I32 = NDArray[np.int32]
LUMINANCE = np.array((77, 151, 28), np.int32)  # of 256: how bright red, green and blue look


def gray(data: U8) -> U8:
    """Return a picture without its colours."""
    return _recolored(data, (_luminances(data) >> 8)[..., None])


def inverted(data: U8) -> U8:
    """Return the negative."""
    return _recolored(data, 255 - data[..., :3])


def opaque(data: U8) -> U8:
    """Return a picture without its transparency."""
    result = data.copy()
    result[..., 3] = 255
    return result


def threshold(data: U8, level: float) -> U8:
    """Return black and white: white where the largest part of a colour reaches `level`, 0..1."""
    limit = int(np.float32(level) * np.float32(255))
    is_white = data[..., :3].max(axis=2, keepdims=True) >= limit
    return _recolored(data, np.where(is_white, 255, 0))


def posterized(data: U8, levels: int) -> U8:
    """Return a picture in which each part of a colour has `levels` values, 2..255."""
    steps = np.arange(256) * levels >> 8
    return _recolored(data, (steps * 255 // (levels - 1)).astype(np.uint8)[data[..., :3]])


def dilated(data: U8) -> U8:
    """Return a picture in which each pixel is the lightest of itself and its four neighbours."""
    return _spread(data, _luminances(data))


def eroded(data: U8) -> U8:
    """Return a picture in which each pixel is the darkest of itself and its four neighbours."""
    return _spread(data, -_luminances(data))


def _recolored(data: U8, colors: NDArray[np.integer]) -> U8:
    """Return other colours, (h, w, 3) or (h, w, 1), with the alphas of a picture."""
    result = np.empty_like(data)
    result[..., :3] = colors
    result[..., 3] = data[..., 3]
    return result


def _luminances(data: U8) -> I32:
    """Return how bright each pixel looks, 256 times."""
    brightness: I32 = data[..., :3].astype(np.int32) @ LUMINANCE
    return brightness


def _spread(data: U8, ranks: I32) -> U8:
    """Return, for each pixel, the highest in rank; of equals itself, left, right, up, down."""
    result, best = data.copy(), ranks.copy()
    for here, neighbour in NEIGHBOURS:
        is_higher = ranks[neighbour] > best[here]
        best[here] = np.where(is_higher, ranks[neighbour], best[here])
        result[here] = np.where(is_higher[..., None], data[neighbour], result[here])
    return result


ALL, LATER, EARLIER = slice(None), slice(1, None), slice(None, -1)
NEIGHBOURS = (  # the pixels that have one, and where it is
    ((ALL, LATER), (ALL, EARLIER)),  # left
    ((ALL, EARLIER), (ALL, LATER)),  # right
    ((LATER, ALL), (EARLIER, ALL)),  # up
    ((EARLIER, ALL), (LATER, ALL)),  # down
)
