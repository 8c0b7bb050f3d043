"""How much two pictures of one size differ, in numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.images.flip import flip
from sketchkit.grading.images.matching import difference, left_over, slight, without_match
from sketchkit.grading.images.regions import Region, largest_region

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]

HIGH = 99  # the percentile: a hundredth of the picture may be as different as it likes
# By more than this of 255 a pixel differs. Measured: renderers with their samples elsewhere stay
# below it but for single pixels; an object whose colour is off by 12 is found.
VISIBLE = 8
FAINT = 5  # the same where the mean around a pixel differs, too


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
    slight : Region or None
        The largest one whose edges lie a little elsewhere, or whose colour is a little another.
    is_strict : bool
        Whether the others were measured without a match.
    """

    remaining: U8
    errors: F32
    mean: float
    high: float
    region: Region | None
    slight: Region | None
    is_strict: bool = False


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
        slight=_slight_region(submitted, expected, remaining),
    )


def _slight_region(submitted: U8, expected: U8, remaining: U8) -> Region | None:
    """Return the largest region with pixels that differ slightly: those alone are its pixels."""
    differs = difference(submitted, expected).max(axis=2) > FAINT
    differs &= remaining.max(axis=2) <= VISIBLE
    found = largest_region(slight(submitted, expected).max(axis=2) > FAINT)
    if found is None:
        return None
    left, top, width, height = found.box
    pixels = found.pixels & differs[top : top + height, left : left + width]
    return found._replace(size=int(pixels.sum()), pixels=pixels) if pixels.any() else None


def strictly(submitted: U8, expected: U8, found: Measure) -> Measure:
    """Return a measure in which what is slight counts, as nothing else does."""
    return found._replace(
        remaining=difference(submitted, expected),
        errors=flip(expected, submitted),
        region=found.slight,
        is_strict=True,
    )


def amount(remaining: U8) -> Amount:
    """Return how much is left without a match."""
    worst = remaining.max(axis=2)
    return Amount(float(worst.mean()), float((worst <= VISIBLE).mean()))
