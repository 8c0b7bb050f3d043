"""Flatness: whether a picture shows anything at all."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

ALIKE = 2  # of 255: colours that differ by no more look the same


def is_flat(pixels: NDArray[np.uint8]) -> bool:
    """Return whether a picture, (h, w, 3 or 4), looks like a single colour; alpha is left out."""
    first = pixels[0, 0, :3].astype(np.int16)
    few = pixels[:: max(pixels.shape[0] // 8, 1), :: max(pixels.shape[1] // 8, 1), :3]
    if np.abs(few.astype(np.int16) - first).max() > ALIKE:
        return False
    return bool((np.ptp(pixels[..., :3], axis=(0, 1)) <= ALIKE).all())
