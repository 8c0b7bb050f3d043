"""How much two pictures of one size differ, in numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.images.flip import flip
from sketchkit.grading.images.matching import left_over, without_match
from sketchkit.grading.images.regions import Region, largest_region

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]

HIGH = 99  # the percentile: a hundredth of the picture may be as different as it likes
# By more than this of 255 a pixel differs. Measured: renderers with their samples elsewhere stay
# below it but for single pixels; an object whose colour is off by 12 is found.
VISIBLE = 8


class Measure(NamedTuple):
    """What was measured, after the best match.

    Attributes
    ----------
    remaining : (h, w, 3) uint8
        What has no match, see `matching`.
    errors : (h, w) float32
        FLIP of that.
    mean, high : float
        Of `errors`: mean and `HIGH` percentile.
    region : Region or None
    """

    remaining: U8
    errors: F32
    mean: float
    high: float
    region: Region | None


class Amount(NamedTuple):
    """A difference in short: `weight` is its mean, 0..255; `agreement` a share of the pixels."""

    weight: float
    agreement: float


def measure(submitted: U8, expected: U8) -> Measure:
    """Measure a picture, (h, w, 3), against another of its size."""
    remaining = left_over(submitted, expected)
    errors = flip(expected, without_match(submitted, expected, remaining))
    return Measure(
        remaining,
        errors,
        mean=float(errors.mean(dtype=np.float64)),
        high=float(np.percentile(errors, HIGH)),
        region=largest_region(remaining.max(axis=2) > VISIBLE),
    )


def amount(remaining: U8) -> Amount:
    """Return how much is left without a match."""
    worst = remaining.max(axis=2)
    return Amount(float(worst.mean()), float((worst <= VISIBLE).mean()))
