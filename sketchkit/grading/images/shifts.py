"""How far a whole picture has moved, up to a few pixels."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.images.words import Box

U8 = NDArray[np.uint8]
I16 = NDArray[np.int16]
F32 = NDArray[np.float32]

FARTHEST = 8  # px
WINDOW = 256  # px: enough of the picture to see how it has moved
HALVES = (-0.5, 0.0, 0.5)


def shift(submitted: U8, expected: U8, box: Box) -> tuple[float, float]:
    """Return the movement, right and down, that explains a difference best.

    Parameters
    ----------
    submitted, expected : (h, w, 3) uint8
    box : left, top, width, height
        Around where they differ.

    Returns
    -------
    tuple of two multiples of 0.5
    """
    one, other = (_window(picture, box) for picture in (submitted, expected))
    most = min(FARTHEST, (min(one.shape) - 1) // 3)
    if most < 1:  # too small to tell
        return 0.0, 0.0
    whole = range(-most, most + 1)
    coarse = _best(one, other, [(float(x), float(y)) for x, y in product(whole, whole)], most)
    fine = [(coarse[0] + x, coarse[1] + y) for x, y in product(HALVES, HALVES)]
    return _best(one, other, [(x, y) for x, y in fine if max(abs(x), abs(y)) <= most], most)


def shifted(picture: U8, right: float, down: float) -> U8:
    """Return a picture moved; the border is repeated where nothing came from.

    Half a pixel is the mean of two.
    """
    for axis, step in ((1, right), (0, down)):
        length = picture.shape[axis]
        first, second = (
            picture.take(np.clip(np.arange(length) - whole, 0, length - 1), axis)
            for whole in (math.floor(step), math.ceil(step))
        )
        picture = _mean(first, second) if step % 1 else first
    return picture


def _mean(one: U8, other: U8) -> U8:
    mean: U8 = ((one.astype(np.uint16) + other) // 2).astype(np.uint8)
    return mean


def _best(
    one: I16, other: I16, steps: list[tuple[float, float]], margin: int
) -> tuple[float, float]:
    """Return the movement of the least difference; of equal ones, the shortest."""
    steps = sorted(steps, key=lambda step: abs(step[0]) + abs(step[1]))
    inside = one[margin:-margin, margin:-margin]
    errors = [
        np.abs(inside - _inside_of_moved(other, *step, margin)).mean(dtype=np.float64)
        for step in steps
    ]
    return steps[int(np.argmin(errors))]


def _inside_of_moved(plane: I16, right: float, down: float, margin: int) -> I16 | F32:
    """Return a plane without its margin, after a movement that is no longer than that."""
    height, width = plane.shape
    parts = [
        plane[margin - y : height - margin - y, margin - x : width - margin - x]
        for y in {math.floor(down), math.ceil(down)}
        for x in {math.floor(right), math.ceil(right)}
    ]
    if len(parts) == 1:
        return parts[0]
    mean: F32 = np.mean(parts, axis=0, dtype=np.float32)
    return mean


def _window(picture: U8, box: Box) -> I16:
    """Return the brightness of the part around a box's middle."""
    left, top, width, height = box
    row = _start(top + height // 2, picture.shape[0])
    column = _start(left + width // 2, picture.shape[1])
    part = picture[row : row + WINDOW, column : column + WINDOW]
    brightness: I16 = part.sum(axis=2, dtype=np.int16)
    return brightness


def _start(middle: int, length: int) -> int:
    return min(max(middle - WINDOW // 2, 0), max(length - WINDOW, 0))
