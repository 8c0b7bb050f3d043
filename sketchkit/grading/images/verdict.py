"""The verdict about a picture: alike or not, how far from it, and why.

Three numbers decide, taken after the best match of `matching`: the mean and a high percentile of
FLIP, and the size of the largest region. Each finds what the others overlook: a faint change
everywhere, many small ones, and one object in a large picture.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from sketchkit.grading.images.explanations import Among, Explanation, explain
from sketchkit.grading.images.heat import flat_heat, heat_map
from sketchkit.grading.images.measuring import Measure, amount, measure, strictly
from sketchkit.grading.images.sizes import explain_size
from sketchkit.grading.images.words import Box, color, percent, place
from sketchkit.imaging.flatness import is_flat

U8 = NDArray[np.uint8]

FARTHEST = 1000.0  # distances end here, so that they stay numbers where nothing is tolerated
# What is slight is not alike, but is no further off than this many times the tolerance: a line that
# is twice as thick is no missing line.
WORST_OF_SLIGHT = 2.0
SHARE_OF_SLIGHT = 1 / 3  # of a region's tolerance: what has moved differs at its edges alone
NO_ALTERNATIVES: Mapping[str, U8] = MappingProxyType({})


@dataclass(frozen=True)
class Tolerance:
    """What pictures that are alike may differ by, after the best match.

    Attributes
    ----------
    mean, high : float
        FLIP's mean and 99th percentile, 0 to 1.
    region : int
        Pixels of the largest connected region. It does not grow with the picture: a small object
        is as visible in a large one.

    Notes
    -----
    Measured on 91 frames of sketches that between them use all of Processing's drawing. With a
    pixel's samples elsewhere, or eight of them, the worst were 0.0002, 0.004 and 2 pixels. Of 212
    objects that were left out nine in ten made 144 pixels or more; three could not be seen.
    """

    mean: float = 0.005
    high: float = 0.05
    region: int = 12

    def __post_init__(self) -> None:
        if not (self.mean >= 0 and self.high >= 0 and self.region >= 0):
            raise ValueError(f"a tolerance is made of numbers from 0 on, not {self}")


@dataclass(frozen=True)
class Verdict:
    """What was found out about a picture.

    Attributes
    ----------
    is_alike : bool
    distance : float
        The worst of the three numbers over its tolerance: up to 1 they are alike. Of the region,
        an area, the square root, so that it grows as the others do. At most 1000.
    flip_mean, flip_high : float
        FLIP's mean and 99th percentile, after the best match; 1 if the sizes differ.
    region : int
        Pixels of the largest region of difference.
    region_box : left, top, width, height, or None
    reason : str
        For its author, whole sentences: what explains the difference, else where it is and how
        large. "" if they are alike.
    explanation : str
        A short name of what explains it: "flipped in y"; "" if nothing does.
    heat : (h, w, 3) uint8
        Where they differ, for a reader; of the expected picture's size.
    """

    is_alike: bool
    distance: float
    flip_mean: float
    flip_high: float
    region: int
    region_box: Box | None
    reason: str
    explanation: str
    heat: U8


def judge(
    submitted: U8,
    expected: U8,
    tolerance: Tolerance = Tolerance(),
    alternatives: Mapping[str, U8] = NO_ALTERNATIVES,
    *,
    name: str = "",
    only: str | None = None,
) -> Verdict:
    """Judge a picture.

    Parameters
    ----------
    submitted, expected : (h, w, 3) uint8
        Of any sizes from 1 x 1 on.
    tolerance : Tolerance, optional
    alternatives : mapping of str to (h, w, 3) uint8, optional
        The expected picture drawn otherwise: "frame 29", "depth test off", "lights off". If one of
        them is what was submitted, the reason says so.
    name : str, optional
        What the expected picture is: "frame 30".
    only : str, optional
        The one explanation that is tried: to try them all takes several times as long. "" for none:
        the reason says where it differs.
    """
    if submitted.shape != expected.shape:
        return _of_other_size(submitted, expected, tolerance)
    height, width, _ = expected.shape
    if np.array_equal(submitted, expected):
        return Verdict(True, 0.0, 0.0, 0.0, 0, None, "", "", flat_heat(height, width, 0))
    found, distance = _weighed(submitted, expected, tolerance)
    reason = Explanation("", "")
    if distance > 1:
        where = Explanation("", _where(submitted, expected, found))
        among = Among(alternatives, name, only)
        reason = where if only == "" else _reason(submitted, expected, found, among)
    return Verdict(
        is_alike=distance <= 1,
        distance=distance,
        flip_mean=found.mean,
        flip_high=found.high,
        region=found.region.size if found.region else 0,
        region_box=found.region.box if found.region else None,
        reason=reason.sentence,
        explanation=reason.name,
        heat=heat_map(found.errors),
    )


def _weighed(submitted: U8, expected: U8, tolerance: Tolerance) -> tuple[Measure, float]:
    """Return what was measured, and how far that is from being alike."""
    found = measure(submitted, expected)
    region = found.region.size if found.region else 0
    distance = _distance(found.mean, found.high, region, tolerance)
    slight = found.slight.size if found.slight else 0
    faint = math.sqrt(_ratio(slight, SHARE_OF_SLIGHT * tolerance.region))
    if faint <= max(distance, 1):
        return found, distance
    faint = max(distance, min(faint, WORST_OF_SLIGHT))
    return (found if distance > 1 else strictly(submitted, expected, found)), faint


def _of_other_size(submitted: U8, expected: U8, tolerance: Tolerance) -> Verdict:
    height, width, _ = expected.shape
    reason = explain_size(submitted, expected)
    return Verdict(
        is_alike=False,
        distance=max(_distance(1, 1, height * width, tolerance), 1.001),
        flip_mean=1.0,
        flip_high=1.0,
        region=height * width,
        region_box=(0, 0, width, height),
        reason=reason.sentence,
        explanation=reason.name,
        heat=flat_heat(height, width, 1),
    )


def _distance(mean: float, high: float, region: int, tolerance: Tolerance) -> float:
    ratios = (
        _ratio(mean, tolerance.mean),
        _ratio(high, tolerance.high),
        math.sqrt(_ratio(region, tolerance.region)),
    )
    return min(max(ratios), FARTHEST)


def _ratio(value: float, most: float) -> float:
    if value <= 0:
        return 0.0
    return value / most if most > 0 else FARTHEST**2


def _reason(submitted: U8, expected: U8, found: Measure, among: Among) -> Explanation:
    explanation = explain(submitted, expected, found, among)
    if is_flat(submitted) and not is_flat(expected):
        only = color(submitted[0, 0])
        flat = f"Your picture is one flat colour, {only}: nothing is to be seen on it."
        if explanation is None:
            return Explanation("one flat colour", flat)
        return Explanation(explanation.name, f"{flat} {explanation.sentence}")
    return explanation or Explanation("", _where(submitted, expected, found))


def _where(submitted: U8, expected: U8, found: Measure) -> str:
    """Return where pictures differ, and how, where nothing explains it."""
    differing = 1 - amount(found.remaining).agreement
    region = found.region
    if region is None:
        differs = (submitted != expected).any(axis=2)
        means = (color(picture[differs].mean(axis=0)) for picture in (submitted, expected))
        colors = "{} on average where {} is expected".format(*means)
        return f"Your picture's colours are a little off, everywhere or in many places: {colors}."
    height, width, _ = expected.shape
    left, top, wide, high = region.box
    inside = np.s_[top : top + high, left : left + wide]
    is_mean = color(submitted[inside][region.pixels].mean(axis=0))
    expected_mean = color(expected[inside][region.pixels].mean(axis=0))
    where = f"A region of {wide} x {high} pixels {place(region.box, width, height)} differs"
    if region.size > height * width / 2:
        where = "Most of the picture differs"
    has_edges = not is_flat(expected[inside][region.pixels][None])
    colors = (
        "an edge lies a little elsewhere, or a line has another width"
        if found.is_strict and has_edges
        else f"it is {is_mean} on average where {expected_mean} is expected"
        if is_mean != expected_mean
        else "its colours are the right ones on average, but elsewhere"
    )
    others = f"With {region.others} smaller ones, " if region.others > 1 else "In all, "
    return f"{where}: {colors}. {others}{percent(differing)} of the pixels differ."
