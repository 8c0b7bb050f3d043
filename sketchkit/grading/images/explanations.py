"""Why a picture differs: what explains the difference is tried, measured and said in words.

What is tried makes, of the expected picture, what it would have become: turned upside down, with
red and blue swapped, another frame. It is said only if little is left between that and the
submitted picture, in comparison with what there was. A transformation that changes nothing (a
symmetrical picture's mirror image) leaves all of it, and is never named.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from sketchkit.grading.images.matching import left_over
from sketchkit.grading.images.measuring import Amount, Measure, amount
from sketchkit.grading.images.shifts import shift, shifted
from sketchkit.grading.images.transformations import candidates
from sketchkit.grading.images.words import direction, percent

U8 = NDArray[np.uint8]

# Of the difference, and of the pixels that differ: more than that, and it is no explanation.
LEFT_AT_MOST = 0.2
DIFFERING_AT_MOST = 0.3
WORTH_A_TRY = 0.6  # of the difference of small versions, which are looked at first
SMALL = 96  # px
ABOUT_EQUAL = 0.02  # of the difference: then what is simpler is meant


class Explanation(NamedTuple):
    """Why: a short name, and a sentence with what was measured."""

    name: str
    sentence: str


class Trial(NamedTuple):
    """What may have been meant.

    `opening` and `ending` are a sentence: "Turned upside down, your picture is", "the expected
    one". `picture` makes what the expected picture would be.
    """

    name: str
    opening: str
    ending: str
    picture: Callable[[], U8]


def explain(
    submitted: U8, expected: U8, found: Measure, alternatives: Mapping[str, U8], name: str
) -> Explanation | None:
    """Return what explains a difference, or None.

    Parameters
    ----------
    submitted, expected : (h, w, 3) uint8, of one size
    found : Measure
        Of these two.
    alternatives : mapping of str to (h, w, 3) uint8
        The reference drawn otherwise: "frame 29", "lights off".
    name : str
        The expected picture's: "frame 30", or "".
    """
    before = amount(found.remaining)
    if before.weight == 0:
        return None
    best: tuple[Trial, Amount] | None = None
    for trial in _trials(submitted, expected, found, alternatives, name):
        after = amount(left_over(submitted, np.ascontiguousarray(trial.picture())))
        if not _explains(before, after):
            continue
        if best is None or after.weight < best[1].weight - ABOUT_EQUAL * before.weight:
            best = trial, after
    return _said(best[0], before, best[1]) if best else None


def _explains(before: Amount, after: Amount) -> bool:
    return (
        after.weight <= LEFT_AT_MOST * before.weight
        and 1 - after.agreement <= DIFFERING_AT_MOST * (1 - before.agreement)
    )


def is_flat(picture: U8) -> bool:
    """Return whether a picture is of one colour, rounding aside."""
    return int(np.ptp(picture.reshape(-1, 3), axis=0).max()) <= 2


def _trials(
    submitted: U8, expected: U8, found: Measure, alternatives: Mapping[str, U8], name: str
) -> Iterator[Trial]:
    for key, picture in alternatives.items():
        if picture.shape == submitted.shape:
            yield _alternative(key, picture, name)
    # Of one colour, anything can be made.
    if is_flat(submitted) or is_flat(expected):
        return
    yield from _likely_transformations(submitted, expected)
    box = found.region.box if found.region else (0, 0, *submitted.shape[1::-1])
    right, down = shift(submitted, expected, box)
    if right or down:
        yield _movement(expected, right, down)


def _likely_transformations(submitted: U8, expected: U8) -> Iterator[Trial]:
    """Yield those that already make small versions of the pictures more alike."""
    small, small_expected = _shrunk(submitted), _shrunk(expected)
    limit = WORTH_A_TRY * _distance(small, small_expected)
    for candidate in candidates(submitted, expected):
        if _distance(small, candidate.change(small_expected)) <= limit:
            name, opening, ending, change = candidate
            yield Trial(name, opening, ending, partial(change, expected))


def _alternative(key: str, picture: U8, name: str) -> Trial:
    if re.fullmatch(r"frame \d+", key):
        ending = f"{key}, not {name or 'the one that is expected'}"
        return Trial(key, "This is", ending, lambda: picture)
    way = f"without {key.removesuffix(' off')}" if key.endswith(" off") else f"with {key}"
    opening = f"It looks as if drawn {way}: so drawn, the expected picture is"
    return Trial(key, opening, "yours", lambda: picture)


def _movement(expected: U8, right: float, down: float) -> Trial:
    is_half = {abs(right), abs(down)} <= {0, 0.5}
    return Trial(
        "half a pixel" if is_half else "moved",
        "Your picture is",
        f"the expected one, moved {direction(right, down)}",
        lambda: shifted(expected, right, down),
    )


def _said(trial: Trial, before: Amount, after: Amount) -> Explanation:
    if after.agreement == 1:
        return Explanation(trial.name, f"{trial.opening} {trial.ending}.")
    nearly = "nearly " if after.agreement < 0.99 else ""
    measured = (
        f"{percent(after.agreement)} of the pixels agree then, {percent(before.agreement)} without"
    )
    return Explanation(trial.name, f"{trial.opening} {nearly}{trial.ending}: {measured}.")


def _shrunk(picture: U8) -> U8:
    height, width, _ = picture.shape
    size = min(width, SMALL), min(height, SMALL)
    # Not BOX, which is one-sided where the scale is no whole number: mirror images would differ.
    return np.asarray(Image.fromarray(picture).resize(size, Image.Resampling.BILINEAR))


def _distance(one: U8, other: U8) -> float:
    return float(np.abs(one.astype(np.int16) - other).mean())
