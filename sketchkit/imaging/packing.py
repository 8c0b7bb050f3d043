"""Pictures as bytes, and the same as colours packed in ints."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
U32 = NDArray[np.uint32]


def to_argb(data: U8) -> U32:
    """Return bytes RGBA, (..., 4), as colours packed 0xAARRGGBB."""
    red, green, blue, alpha = np.moveaxis(data.astype(np.uint32), -1, 0)
    packed: U32 = alpha << 24 | red << 16 | green << 8 | blue
    return packed


def to_rgba(colors: U32) -> U8:
    """Return packed colours as bytes RGBA, one more dimension of 4."""
    parts = [colors >> 16, colors >> 8, colors, colors >> 24]
    return np.stack(parts, axis=-1).astype(np.uint8)
