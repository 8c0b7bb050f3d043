"""What of a difference no renderer can be blamed for.

Two renderers, or drivers, draw the same edge with other mixtures of the two colours beside it, move
it by less than a pixel, and round colours otherwise. So each pixel is matched with the best that
can be mixed of the other picture's pixels around it, both ways: a line that one picture has and
the other has not is found from the one that has it. What is left is the *residue*.

That alone would let a picture pass that has moved by a pixel as a whole, with all of its text and
lines. Renderers do not do so: their edges move one way here and the other way there. So a whole
picture's movement is measured first, and if there is one, nothing is forgiven but rounding.

An object among others that is a pixel off, a line that is twice as thick, a surface whose colour is
slightly another: all of these have a match, and are found by the mean of their surroundings, which
renderers keep. They are not alike, but slight: see `slight`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, maximum_filter, minimum_filter, uniform_filter

U8 = NDArray[np.uint8]
I16 = NDArray[np.int16]

RADIUS = 1  # px: how far around a match is looked for
ROUNDING = 2  # of 255: by so much colours of lights and of mixtures differ between renderers
# What lies by less than a quarter of the contrast around outside of a mixture is one too: edges are
# made of four samples, and another renderer may have one more of them inside.
MIXTURE_SHARE = 4
# Lines of one pixel are no mixture of anything: where one renderer has a black pixel, another has
# two grey ones. So what has kept its mean is matched too, within an eighth of the contrast.
MEAN_SHARE = 8
STRIP = 256  # rows at once: memory is bounded

# An edge that has moved by a pixel changes the mean of a window by its contrast over the window's
# width; where one renderer has it a little further than the other, that evens out along it.
# Measured on 165 scenes: with their samples elsewhere 2 are found to differ slightly, from OpenGL
# to the CPU none; a line of 2 pixels instead of 1, and circles and spheres a pixel off, all are.
WINDOW = 5  # px
FARTHEST_EDGE = 0.7  # px

STEPS = (-1.0, -0.5, 0.0, 0.5, 1.0)  # px: movements of a whole picture that are tried
# A movement is believed when it explains this much of the difference. Measured: a pixel leaves a
# third at most, half a pixel (which the mean of two imitates) two thirds; pictures with their
# samples elsewhere, or without smoothing, are never better explained by a movement than without.
LEFT_BY_MOVEMENT = 0.75
ENOUGH_PIXELS = 200_000


def residue(submitted: U8, expected: U8) -> U8:
    """Return by how much each pixel differs from its best match, channel by channel.

    Parameters
    ----------
    submitted, expected : (h, w, 3) uint8, of one size

    Returns
    -------
    (h, w, 3) uint8
    """
    remaining = np.zeros_like(expected)
    for rows, around, inside in _strips(len(expected)):
        one, other = submitted[around], expected[around]
        if np.array_equal(one, other):
            continue
        remaining[rows] = _unmatched(one, other)[inside]
    return remaining


def difference(submitted: U8, expected: U8) -> U8:
    """Return by how much each pixel differs, channel by channel, rounding aside: (h, w, 3)."""
    remaining = np.maximum(submitted, expected) - np.minimum(submitted, expected)
    remaining[remaining <= ROUNDING] = 0
    return remaining


def left_over(submitted: U8, expected: U8) -> U8:
    """Return what counts: the residue, or of a picture that has moved as a whole the difference."""
    remaining = residue(submitted, expected)
    if movement(submitted, expected) == (0.0, 0.0):
        return remaining
    return difference(submitted, expected)


def slight(submitted: U8, expected: U8) -> U8:
    """Return by how much pixels differ where the mean around them does, channel by channel.

    Returns
    -------
    (h, w, 3) uint8
        Of a moved edge also the pixels beside it.
    """
    found = np.zeros_like(expected)
    differs = difference(submitted, expected).any(axis=2)
    for place in find_objects(differs.astype(np.int8)):
        for top in range(place[0].start, place[0].stop, STRIP):
            rows = slice(top, min(top + STRIP, place[0].stop))
            inner, around = _widened(rows, place[1], expected.shape)
            found[inner] = _displaced(submitted[around], expected[around])[
                tuple(
                    slice(one.start - other.start, one.stop - other.start)
                    for one, other in zip(inner, around, strict=True)
                )
            ]
    return found


def _widened(
    rows: slice, columns: slice, shape: tuple[int, ...]
) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Return a part of a picture and its neighbours, and that with all its windows."""

    def wider(part: slice, length: int, by: int) -> slice:
        return slice(max(part.start - by, 0), min(part.stop + by, length))

    inner = wider(rows, shape[0], 1), wider(columns, shape[1], 1)
    return inner, (wider(inner[0], shape[0], WINDOW), wider(inner[1], shape[1], WINDOW))


def _displaced(one: U8, other: U8) -> U8:
    """Return by how much pixels differ where edges lie elsewhere, or colours are others."""
    size = (WINDOW, WINDOW, 1)
    change = one.astype(np.float32) - other
    mean = np.abs(uniform_filter(change, size, mode="nearest"))
    low, high = np.minimum(one, other), np.maximum(one, other)
    contrast = maximum_filter(high, size).astype(np.float32) - minimum_filter(low, size)
    beyond = np.maximum(mean - ROUNDING, 0) * WINDOW - FARTHEST_EDGE * contrast
    most = maximum_filter(np.abs(change), (3, 3, 1))
    displaced: U8 = np.clip(np.minimum(beyond, most), 0, 255).astype(np.uint8)
    return displaced


def without_match(submitted: U8, expected: U8, remaining: U8) -> U8:
    """Return the submitted picture with what has a match taken out: the residue is left."""
    is_brighter = submitted > expected
    return np.where(is_brighter, expected + remaining, expected - remaining)


def movement(submitted: U8, expected: U8) -> tuple[float, float]:
    """Return how far a picture has moved as a whole, right and down, in pixels.

    Returns
    -------
    tuple of two of -1, -0.5, 0, 0.5, 1
    """
    height, width, _ = expected.shape
    if min(height, width) < 8:  # too small to tell
        return 0.0, 0.0
    stride = -(-height * width // ENOUGH_PIXELS)
    one, *others = (
        _brightness(picture[1 + row : height - 1 + row : stride])
        for picture, row in ((submitted, 0), (expected, -1), (expected, 0), (expected, 1))
    )
    errors = {
        (right, down): _error(one, others, right, down) for right, down in product(STEPS, STEPS)
    }
    best = min(errors, key=errors.__getitem__)
    is_better = errors[best] < LEFT_BY_MOVEMENT * errors[0.0, 0.0]
    return best if is_better else (0.0, 0.0)


def _error(one: I16, others: list[I16], right: float, down: float) -> float:
    """Return how much rows differ from others that have moved.

    `others` are the rows above, the same, and those below. Half a pixel is the mean of two.
    """
    width = one.shape[1]
    moved = [others[1 - y][:, 1 - x : width - 1 - x] for y in _whole(down) for x in _whole(right)]
    mean = moved[0] if len(moved) == 1 else sum(moved) / np.float32(len(moved))
    return float(np.abs(one[:, 1:-1] - mean).mean(dtype=np.float64))


def _whole(step: float) -> set[int]:
    """Return the whole numbers that a multiple of a half lies between, or is."""
    return {math.floor(step), math.ceil(step)}


def _brightness(picture: U8) -> I16:
    total: I16 = picture.sum(axis=2, dtype=np.int16)
    return total


def _unmatched(one: U8, other: U8) -> U8:
    """Return by how much pixels of two pictures differ from their best match in the other."""
    low_one, high_one = _extremes(one)
    low_other, high_other = _extremes(other)
    contrast = np.maximum(high_one - low_one, high_other - low_other)
    unmixed = np.maximum(_outside(one, low_other, high_other), _outside(other, low_one, high_one))
    means = np.abs(_sums(one) - _sums(other)) // 9
    unmatched: U8 = np.minimum(
        _beyond(unmixed, contrast // MIXTURE_SHARE + ROUNDING),
        _beyond(means, contrast // MEAN_SHARE + ROUNDING),
    ).astype(np.uint8)
    return unmatched


def _beyond(distance: NDArray[np.integer], allowance: U8) -> NDArray[np.integer]:
    return np.where(distance > allowance, distance - allowance, 0)


def _outside(picture: U8, low: U8, high: U8) -> U8:
    """Return how far each pixel is from a range; below and above are never both."""
    return (np.maximum(picture, high) - high) + (low - np.minimum(picture, low))


def _extremes(picture: U8) -> tuple[U8, U8]:
    """Return the least and the greatest of each pixel and those around it."""
    low = high = picture
    for axis in (0, 1):
        low, high = _around(np.minimum, low, axis), _around(np.maximum, high, axis)
    return low, high


def _sums(picture: U8) -> I16:
    """Return the sum of each pixel and the eight around it; the border is repeated."""
    padded = np.pad(picture.astype(np.int16), ((1, 1), (1, 1), (0, 0)), mode="edge")
    rows = padded[:-2] + padded[1:-1] + padded[2:]
    sums: I16 = rows[:, :-2] + rows[:, 1:-1] + rows[:, 2:]
    return sums


def _around(extreme: np.ufunc, picture: U8, axis: int) -> U8:
    """Return the least, or the greatest, of each pixel and those within the radius on an axis."""
    result = picture.copy()
    length = picture.shape[axis]
    for step in range(1, RADIUS + 1):
        before, after = [slice(None)] * 3, [slice(None)] * 3
        before[axis], after[axis] = slice(0, length - step), slice(step, length)
        first, second = tuple(before), tuple(after)
        result[first] = extreme(result[first], picture[second])
        result[second] = extreme(result[second], picture[first])
    return result


def _strips(height: int) -> Iterator[tuple[slice, slice, slice]]:
    """Yield rows, these and as much around them as a match reaches, and where they lie in that."""
    for top in range(0, height, STRIP):
        first = max(top - RADIUS, 0)
        bottom = min(top + STRIP, height)
        yield (
            slice(top, bottom),
            slice(first, bottom + RADIUS),
            slice(top - first, bottom - first),
        )
