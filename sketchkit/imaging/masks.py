"""Pictures as masks: how bright they are becomes alpha."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
WEIGHTS = np.array((0.2126, 0.7152, 0.0722), np.float32)  # of red, green and blue


def luminances(mask: U8) -> U8:
    """Return how bright each pixel of a mask is, (h, w): what a canvas takes as its alpha."""
    brightness: U8 = (mask[..., :3].astype(np.float32) @ WEIGHTS + 0.5).astype(np.uint8)
    return brightness
