"""The blur of `filter(BLUR, radius)`: rows first, then columns, each cut to whole numbers.

Pixels are weighted (r - distance)**2, those outside of the picture not at all. That is two
parabolas, whose second differences are constant but for three places; so the weighted sums are
running sums of running sums, and take the same time for any radius.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
U32 = NDArray[np.uint32]
REACH = np.float32(3.5)  # pixels, of a radius of 1
MOST = 248  # pixels


def blurred(data: U8, radius: float) -> U8:
    """Return a blurred picture, (h, w, n) of any n parts.

    In a small picture the radius is smaller than asked for, and 0 is none.
    """
    height, width, _ = data.shape
    pixels = reach(radius, width, height)
    rows = _smoothed(data.transpose(1, 0, 2), pixels)
    return _smoothed(rows.transpose(1, 0, 2), pixels).astype(np.uint8)


def reach(radius: float, width: int, height: int) -> int:
    """Return how far the blur of a picture goes: 1 more than the last pixel that counts."""
    most = np.float32(min(width, height)) / np.float32(2) / REACH
    return min(max(int(min(np.float32(radius), most) * REACH), 1), MOST)


def _smoothed(values: NDArray[np.integer], reach: int) -> U32:
    """Return the weighted means along the first axis."""
    sums = _weighted_sums(values.astype(np.uint32), reach)
    weights = _weighted_sums(np.ones((len(values), 1, 1), np.uint32), reach)
    return sums // weights


def _weighted_sums(values: U32, reach: int) -> U32:
    """Return the sums of what is less than `reach` away, weighted (reach - distance)**2.

    Overflow on the way does no harm: what counts are the last 32 bits.
    """
    count = len(values)
    padded = np.zeros((count + 3 * reach, *values.shape[1:]), np.uint32)
    padded[2 * reach : 2 * reach + count] = values
    # Entry i is for the place i - reach: from there on sums are not 0.
    size = count + reach - 1
    before, middle, after = (padded[start : start + size] for start in (0, reach, 2 * reach))
    running = np.cumsum(padded, axis=0, dtype=np.uint32)
    within = running[2 * reach - 1 : 2 * reach - 1 + size] - running[:size]
    differences = 2 * within - np.uint32(4 * reach) * middle + before + after
    slopes = np.cumsum(differences, axis=0, dtype=np.uint32)
    sums = np.cumsum(slopes, axis=0, dtype=np.uint32)
    return sums[reach - 1 : reach - 1 + count]
