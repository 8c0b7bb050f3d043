"""FLIP: how different two pictures look to somebody who flips between them, pixel by pixel.

Colours are compared after the blur that an eye gives them at a distance, and where edges or points
come or go the difference counts more. 0 is equal, 1 is as different as can be.

Source: P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild,
"FLIP: A Difference Evaluator for Alternating Images", HPG 2020. Equations and constants are theirs.
"""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import correlate1d

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]
F64 = NDArray[np.float64]

PIXELS_PER_DEGREE = 67  # a 4K screen of 0.7 m, seen from 0.7 m: what FLIP's authors assume

# How finely an eye sees light, red against green, blue against yellow: sums of Gaussians, each a
# weight and a width (the paper's a and b), in degrees.
ACHROMATIC = ((1.0, 0.0047),)
RED_GREEN = ((1.0, 0.0053),)
BLUE_YELLOW = ((34.1, 0.04), (13.5, 0.025))
FEATURE_WIDTH = 0.082  # degrees: the width of the edges and points that are looked for

COLOR_EXPONENT = 0.7
FEATURE_EXPONENT = 0.5
KNEE = 0.4, 0.95  # up to 0.4 of the largest colour difference is spread over 0..0.95

TO_XYZ = np.array(  # from linear sRGB
    [
        [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
        [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
        [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
    ]
)
WHITE = TO_XYZ.sum(axis=1)
# XYZ over white, and from there to light, red-green and blue-yellow (without their offsets).
TO_OPPONENT = np.array([[0, 116, 0], [500, -500, 0], [0, 200, -200]]) @ (TO_XYZ / WHITE[:, None])

TILE = 256  # px: memory is bounded, and what a step needs stays in the processor's cache


def flip(expected: U8, submitted: U8) -> F32:
    """Return the difference of two pictures at each pixel.

    Parameters
    ----------
    expected, submitted : (h, w, 3) uint8, sRGB, of one size

    Returns
    -------
    (h, w) float32, 0..1
    """
    height, width, _ = expected.shape
    errors = np.zeros((height, width), np.float32)
    for top in range(0, height, TILE):
        for left in range(0, width, TILE):
            _fill_tile(errors, expected, submitted, top, left)
    return errors


def _fill_tile(errors: F32, expected: U8, submitted: U8, top: int, left: int) -> None:
    """Compute a tile with as much around it as the filters reach; equal ones stay 0."""
    reach = _kernels().reach
    first_row, first_column = max(top - reach, 0), max(left - reach, 0)
    around = np.s_[first_row : top + TILE + reach, first_column : left + TILE + reach]
    one, other = expected[around], submitted[around]
    if np.array_equal(one, other):
        return
    inside = np.s_[
        top - first_row : top - first_row + TILE, left - first_column : left - first_column + TILE
    ]
    errors[top : top + TILE, left : left + TILE] = _errors(one, other)[inside]


def _errors(expected: U8, submitted: U8) -> F32:
    one, other = _opponent(expected), _opponent(submitted)
    colors = _color_errors(_seen(one), _seen(other))
    features = _feature_errors(one[0], other[0])
    raised: F32 = colors ** (1 - features)
    return raised


def _opponent(picture: U8) -> F32:
    """Return light (Y, 0..116), red-green and blue-yellow, (3, h, w)."""
    linear = _LINEAR[picture.transpose(2, 0, 1).reshape(3, -1)]
    planes = TO_OPPONENT.astype(np.float32) @ linear
    opponent: F32 = planes.reshape(3, *picture.shape[:2])
    return opponent


def _seen(opponent: F32) -> F32:
    """Return what is seen at a distance, as CIELAB with Hunt's adjustment, (3, h, w)."""
    blurred = np.empty_like(opponent)
    for plane, kernels, result in zip(opponent, _kernels().blurs, blurred, strict=True):
        result[:] = sum(_separable(plane, kernel, kernel) for kernel in kernels)
    shape = blurred.shape
    linear = _FROM_OPPONENT @ blurred.reshape(3, -1)
    np.clip(linear, 0, 1, out=linear)
    x, y, z = _lab_curve(_TO_RELATIVE_XYZ @ linear).reshape(shape)
    return _hunt(116 * y - 16, 500 * (x - y), 200 * (y - z))


def _hunt(lightness: F32, a: F32, b: F32) -> F32:
    """Return CIELAB with colours that count less where it is dark."""
    return np.stack([lightness, np.float32(0.01) * lightness * a, np.float32(0.01) * lightness * b])


def _lab_curve(ratio: F32) -> F32:
    """Return CIELAB's cube root, which is a straight line near black."""
    delta = 6 / 29
    line = ratio * np.float32(1 / (3 * delta**2)) + np.float32(4 / 29)
    curve: F32 = np.where(ratio > delta**3, np.cbrt(ratio), line)
    return curve


def _color_errors(one: F32, other: F32) -> F32:
    difference = one - other
    hyab = np.abs(difference[0]) + np.hypot(difference[1], difference[2])
    powered = hyab**COLOR_EXPONENT
    most = _largest_color_error()
    share, height = KNEE
    knee = share * most
    below = powered * (height / knee)
    above = height + (powered - knee) * ((1 - height) / (most - knee))
    errors: F32 = np.clip(np.where(powered < knee, below, above), 0, 1)
    return errors


@cache
def _largest_color_error() -> float:
    """Return the difference of green and blue, the largest there is."""
    colors = np.eye(3, dtype=np.float32)[:, 1:]  # (3, 2) linear
    x, y, z = _lab_curve(_TO_RELATIVE_XYZ @ colors)
    green, blue = _hunt(116 * y - 16, 500 * (x - y), 200 * (y - z)).T.astype(np.float64)
    hyab = abs(green[0] - blue[0]) + math.hypot(*(green[1:] - blue[1:]))
    return float(hyab**COLOR_EXPONENT)


def _feature_errors(one: F32, other: F32) -> F32:
    """Return how much edges and points differ, (h, w), of two planes of light, 0..116."""
    edges_one, points_one = _features(one)
    edges_other, points_other = _features(other)
    largest = np.maximum(np.abs(edges_one - edges_other), np.abs(points_one - points_other))
    # Light is divided here instead of before the filters, which are linear.
    scaled = largest * np.float32(1 / (116 * math.sqrt(2)))
    errors: F32 = np.minimum(scaled**FEATURE_EXPONENT, 1)
    return errors


def _features(light: F32) -> tuple[F32, F32]:
    """Return the strength of edges and of points."""
    kernels = _kernels()
    strengths = []
    for kernel in (kernels.edge, kernels.point):
        across = _separable(light, kernels.feature_blur, kernel)
        down = _separable(light, kernel, kernels.feature_blur)
        strengths.append(np.hypot(across, down))
    return strengths[0], strengths[1]


def _separable(plane: F32, down: F64, across: F64) -> F32:
    """Return a plane filtered with two kernels, one after the other; the border is repeated."""
    rows = correlate1d(plane, across, axis=1, mode="nearest")
    filtered: F32 = correlate1d(rows, down, axis=0, mode="nearest")
    return filtered


class _Kernels(NamedTuple):
    """One-dimensional kernels; an image is filtered with two of them.

    `blurs` are for light, red-green and blue-yellow: each the kernels whose results are added.
    """

    blurs: tuple[tuple[F64, ...], ...]
    feature_blur: F64
    edge: F64
    point: F64
    reach: int


@cache
def _kernels() -> _Kernels:
    widest = max(width for _, width in (*ACHROMATIC, *RED_GREEN, *BLUE_YELLOW))
    radius = math.ceil(3 * math.sqrt(widest / (2 * math.pi**2)) * PIXELS_PER_DEGREE)
    deviation = FEATURE_WIDTH * PIXELS_PER_DEGREE / 2
    feature_radius = math.ceil(3 * deviation)
    place = np.arange(-feature_radius, feature_radius + 1, dtype=np.float64)
    bell = np.exp(-(place**2) / (2 * deviation**2))
    return _Kernels(
        blurs=tuple(_blur(parts, radius) for parts in (ACHROMATIC, RED_GREEN, BLUE_YELLOW)),
        feature_blur=bell / bell.sum(),
        edge=_balanced(-place * bell),
        point=_balanced((place**2 / deviation**2 - 1) * bell),
        reach=max(radius, feature_radius),
    )


def _blur(parts: tuple[tuple[float, float], ...], radius: int) -> tuple[F64, ...]:
    """Return kernels that, each taken both ways and then added, are a sum of Gaussians.

    Together they have the sum 1, and the ends of narrow ones that add nothing are cut off.
    """
    place = np.arange(-radius, radius + 1) / PIXELS_PER_DEGREE
    kernels = []
    for weight, width in parts:
        bell = np.exp(-(math.pi**2) * place**2 / width)
        kernels.append(bell * math.sqrt(weight * math.sqrt(math.pi / width)))
    total = sum(kernel.sum() ** 2 for kernel in kernels)
    return tuple(_trimmed(kernel / math.sqrt(total)) for kernel in kernels)


def _trimmed(kernel: F64) -> F64:
    counts = np.flatnonzero(kernel > 1e-7 * kernel.max())
    trimmed: F64 = kernel[counts[0] : counts[-1] + 1]
    return trimmed


def _balanced(kernel: F64) -> F64:
    """Return a kernel whose positive numbers have the sum 1, and its negative ones -1."""
    positive, negative = np.maximum(kernel, 0), np.minimum(kernel, 0)
    balanced: F64 = positive / positive.sum() - negative / negative.sum()
    return balanced


def _linear() -> F32:
    """Return what each of sRGB's 256 values is in linear light."""
    value = np.arange(256) / 255
    return np.where(value > 0.04045, ((value + 0.055) / 1.055) ** 2.4, value / 12.92).astype("f4")


_LINEAR = _linear()
_TO_RELATIVE_XYZ = (TO_XYZ / WHITE[:, None]).astype(np.float32)
_FROM_OPPONENT = np.linalg.inv(TO_OPPONENT).astype(np.float32)
