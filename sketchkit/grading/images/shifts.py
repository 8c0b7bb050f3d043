"""How far a whole picture has moved, up to a few pixels."""

from __future__ import annotations

from itertools import product
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.images.words import Box

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]
Value = TypeVar("Value", np.uint8, np.int16, np.float32)

FARTHEST = 8  # px
WINDOW = 384  # px: enough of the picture to see how it has moved
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
    most = min(FARTHEST, (min(one.shape) - 2) // 3)
    if most < 1:
        return 0.0, 0.0
    whole = range(-most, most + 1)
    coarse = _best(one, other, [(float(x), float(y)) for x, y in product(whole, whole)])
    fine = [(coarse[0] + x, coarse[1] + y) for x, y in product(HALVES, HALVES)]
    return _best(one, other, [(x, y) for x, y in fine if max(abs(x), abs(y)) <= most])


def shifted(picture: NDArray[Value], right: float, down: float) -> NDArray[Value]:
    """Return a picture moved; the border is repeated where nothing came from.

    Half a pixel is the mean of two.
    """
    for axis, step in ((1, right), (0, down)):
        if step == 0:
            continue
        length = picture.shape[axis]
        first, second = (
            picture.take(np.clip(np.arange(length) - int(whole), 0, length - 1), axis)
            for whole in (np.floor(step), np.ceil(step))
        )
        if step % 1:
            first = ((first.astype(np.float32) + second) / 2).astype(picture.dtype)
        picture = first
    return picture


def _best(one: F32, other: F32, steps: list[tuple[float, float]]) -> tuple[float, float]:
    """Return the movement of the least difference; of equal ones, the shortest."""
    steps = sorted(steps, key=lambda step: abs(step[0]) + abs(step[1]))
    margin = FARTHEST if min(one.shape) > 3 * FARTHEST else (min(one.shape) - 1) // 3
    inside = np.s_[margin : one.shape[0] - margin, margin : one.shape[1] - margin]
    errors = [np.abs(one - shifted(other, *step))[inside].mean() for step in steps]
    return steps[int(np.argmin(errors))]


def _window(picture: U8, box: Box) -> F32:
    """Return the brightness of the part around a box's middle."""
    left, top, width, height = box
    row = _start(top + height // 2, picture.shape[0])
    column = _start(left + width // 2, picture.shape[1])
    part = picture[row : row + WINDOW, column : column + WINDOW]
    brightness: F32 = part.sum(axis=2, dtype=np.float32)
    return brightness


def _start(middle: int, length: int) -> int:
    return min(max(middle - WINDOW // 2, 0), max(length - WINDOW, 0))
