"""Images at another size, to the pixel as Processing makes them.

`resize()` is left to Java there: bilinear, with colours premultiplied by alpha and weights of 8
bits, and never shrinking to less than half in one go.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.imaging.blits import Region

U8 = NDArray[np.uint8]
I32 = NDArray[np.int32]
ONE = 1 << 32  # places in the source are fixed-point numbers with 32 bits after the point
HALF = 1 << 23  # products and quotients have 24 bits after the point


def resized(data: U8, width: int, height: int) -> U8:
    """Return an image, (h, w, 4) RGBA of straight alpha, at another size."""
    is_opaque = bool((data[..., 3] == 255).all())
    while True:
        rows, columns = _next(data.shape[0], height), _next(data.shape[1], width)
        data = _scaled(data, columns, rows, is_opaque=is_opaque)
        if (columns, rows) == (width, height):
            return data


def nearest(data: U8, taken: Region, width: int, height: int) -> U8:
    """Return a part of an image at another size, each pixel the one that its centre falls on.

    Outside of the image, its edge goes on.
    """
    columns = taken.x + (np.arange(width) + 0.5) * (taken.width / width)
    rows = taken.y + (np.arange(height) + 0.5) * (taken.height / height)
    column = np.clip(np.floor(columns).astype(int), 0, data.shape[1] - 1)
    row = np.clip(np.floor(rows).astype(int), 0, data.shape[0] - 1)
    found: U8 = data[row[:, None], column]
    return found


def _next(size: int, wanted: int) -> int:
    """Return the size of the next step: at least half of what there is."""
    return max(size // 2, wanted) if size > wanted else wanted


def _scaled(data: U8, width: int, height: int, *, is_opaque: bool) -> U8:
    """Return an image scaled in one step."""
    source = data.astype(np.int32)
    if not is_opaque:
        source[..., :3] = _times_alpha(source[..., :3], source[..., 3:])
    left, right, x_weight = _neighbours(data.shape[1], width)
    above, below, y_weight = _neighbours(data.shape[0], height)
    upper = _between(source[above][:, left], source[above][:, right], x_weight[:, None])
    lower = _between(source[below][:, left], source[below][:, right], x_weight[:, None])
    mixed = (_between(upper, lower, y_weight[:, None, None]) + (1 << 15)) >> 16
    if not is_opaque:
        mixed[..., :3] = _over_alpha(mixed[..., :3], mixed[..., 3:])
    return mixed.astype(np.uint8)


def _neighbours(size: int, wanted: int) -> tuple[I32, I32, I32]:
    """Return which two lines of pixels each new one lies between, and its place in 256ths."""
    step = 1 / (wanted / size)
    places = int(0.5 * step * ONE) + int(step * ONE) * np.arange(wanted) - ONE // 2
    whole = places >> 32
    first, second = np.clip(whole, 0, size - 1), np.clip(whole + 1, 0, size - 1)
    return first.astype(np.int32), second.astype(np.int32), ((places >> 24) & 255).astype(np.int32)


def _between(a: I32, b: I32, weight: I32) -> I32:
    """Return 256 times what lies between two values."""
    mixed: I32 = (a << 8) + (b - a) * weight
    return mixed


def _times_alpha(colors: I32, alphas: I32) -> I32:
    """Return colours premultiplied by their alpha, rounded."""
    products = colors * (alphas.astype(np.int64) * 0x10101)  # 2**24 / 255
    return ((products + HALF) >> 24).astype(np.int32)


def _over_alpha(colors: I32, alphas: I32) -> I32:
    """Return premultiplied colours divided by their alpha again, rounded as Java does."""
    divisors = np.maximum(alphas, 1).astype(np.int64)
    quotients = (0xFF000000 + divisors // 2) // divisors
    divided = np.where(colors >= divisors, 255, (colors * quotients + HALF) >> 24)
    return np.where(alphas > 0, divided, 0).astype(np.int32)
