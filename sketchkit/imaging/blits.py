"""Regions of one picture onto regions of another: `copy()` and `blend()`, as Processing does it.

Sizes may differ: then colours lie between four neighbours. Places in the source are whole numbers
with 15 bits after the point, which go from pixel corner to pixel corner, not from centre to centre.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.imaging.blending import blended

U8 = NDArray[np.uint8]
I32 = NDArray[np.int32]
BITS = 15
ONE = 1 << BITS


class Region(NamedTuple):
    """A part of a picture, in its pixels; it may lie outside."""

    x: int
    y: int
    width: int
    height: int

    @property
    def edges(self) -> tuple[int, int, int, int]:
        """Left, top, right and bottom."""
        return self.x, self.y, self.x + self.width, self.y + self.height


def blit(source: U8, taken: Region, target: U8, placed: Region, mode: int = c.REPLACE) -> None:
    """Blend a part of a picture over a part of another, or of itself."""
    if source is target and _overlap(taken, placed):
        source, taken = part(source, taken), Region(0, 0, taken.width, taken.height)
    across = _span(taken.x, taken.width, source.shape[1], placed.x, placed.width, target.shape[1])
    down = _span(taken.y, taken.height, source.shape[0], placed.y, placed.height, target.shape[0])
    if across is None or down is None:
        return
    covered = target[down.first : down.last, across.first : across.last]
    covered[:] = blended(covered, _sampled(source, across.places, down.places), mode)


def paste(source: U8, target: U8, x: int, y: int) -> None:
    """Copy a picture into another, its top left corner at x, y; what is outside is cut."""
    left, top = max(x, 0), max(y, 0)
    right = min(x + source.shape[1], target.shape[1])
    bottom = min(y + source.shape[0], target.shape[0])
    if left < right and top < bottom:
        target[top:bottom, left:right] = source[top - y : bottom - y, left - x : right - x]


def part(data: U8, region: Region) -> U8:
    """Return a copy of a part; what is outside of the picture is transparent black."""
    cut = np.zeros((max(region.height, 0), max(region.width, 0), 4), np.uint8)
    paste(data, cut, -region.x, -region.y)
    return cut


def _overlap(a: Region, b: Region) -> bool:
    """Return whether two regions have pixels in common, or touch each other."""
    return (
        max(a.x, b.x) <= min(a.x + a.width, b.x + b.width)
        and max(a.y, b.y) <= min(a.y + a.height, b.y + b.height)
    )  # fmt: skip


class _Span(NamedTuple):
    """What is drawn along one axis: from where to where, and the places taken, in ONEs."""

    first: int
    last: int
    places: I32


def _span(x: int, width: int, size: int, to: int, to_width: int, to_size: int) -> _Span | None:
    """Cut both regions, along one axis, to their pictures; None if nothing is left."""
    start, end = max(x, 0), min(x + width, size)
    if end <= start or to_width <= 0 or to >= to_size or to + to_width <= 0:
        return None
    step = int(np.float32(end - start) / np.float32(to_width) * np.float32(ONE))
    # Processing forgets the source's own start if the target begins outside; so do we.
    offset = -to * step if to < 0 else start * ONE
    first, last = max(to, 0), min(to + to_width, to_size)
    return _Span(first, last, offset + step * np.arange(last - first, dtype=np.int32))


def _sampled(source: U8, x_places: I32, y_places: I32) -> U8:
    """Return the colours at places, each mixed of the four pixels that it lies between."""
    left, right, x_part = _neighbours(x_places, source.shape[1])
    above, below, y_part = _neighbours(y_places, source.shape[0])
    if not x_part.any() and not y_part.any():
        return source[above[:, None], left]
    upper: I32 = source[above].astype(np.int32)
    lower: I32 = source[below].astype(np.int32)
    near_x: I32 = (ONE - x_part)[:, None]
    near_y: I32 = (ONE - y_part)[:, None, None]
    upper_left: I32 = near_x * near_y >> BITS  # the four weights are ONE together
    lower_left = near_x - upper_left
    upper_right = near_y - upper_left
    lower_right = ONE - upper_left - lower_left - upper_right
    mixed: I32 = upper_left * upper[:, left] + lower_left * lower[:, left]
    mixed += upper_right * upper[:, right] + lower_right * lower[:, right]
    colors: U8 = (mixed >> BITS).astype(np.uint8)
    return colors


def _neighbours(places: I32, size: int) -> tuple[I32, I32, I32]:
    """Return the pixels before and after places, and how far beyond the first they are."""
    first = np.minimum(places >> BITS, size - 1)
    return first, np.minimum(first + 1, size - 1), places & (ONE - 1)
