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
from operator import itemgetter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from sketchkit.grading.images.matching import difference, left_over, movement, residue
from sketchkit.grading.images.measuring import Amount, Measure, amount
from sketchkit.grading.images.shifts import shift, shifted
from sketchkit.grading.images.transformations import Transformation, both, colors, places
from sketchkit.grading.images.words import direction, percent
from sketchkit.imaging.flatness import is_flat

U8 = NDArray[np.uint8]

# Of the difference, and of the pixels that differ: more than that, and it is no explanation.
LEFT_AT_MOST = 0.2
DIFFERING_AT_MOST = 0.3
NEARER = 0.75  # of the difference without a match, where with one little is left of it
WORTH_A_TRY = 0.6  # of the difference of small versions, which are looked at first
WORTH_A_TRY_IN_PAIRS = 0.5  # of that: there are many pairs, and one that is meant fits well
MOST_PAIRS = 2
SMALL = 96  # px
ABOUT_EQUAL = 0.02  # of the difference: then what is simpler is meant


class Explanation(NamedTuple):
    """Why: a short name, and a sentence with what was measured."""

    name: str
    sentence: str


class Trial(NamedTuple):
    """What may have been meant.

    `opening` and `ending` are a sentence: "Turned upside down, your picture is", "the expected
    one". `picture` makes what the expected picture would be. Where all of it lies elsewhere
    (`is_elsewhere`) edges were drawn anew, not only moved: that is forgiven.
    """

    name: str
    opening: str
    ending: str
    picture: Callable[[], U8]
    is_elsewhere: bool = False


class Among(NamedTuple):
    """What an explanation is looked for among.

    Attributes
    ----------
    alternatives : mapping of str to (h, w, 3) uint8
        The reference drawn otherwise: "frame 29", "lights off".
    name : str
        The expected picture's: "frame 30", or "".
    only : str or None
        The one explanation that is tried; None for all.
    """

    alternatives: Mapping[str, U8]
    name: str = ""
    only: str | None = None


def explain(submitted: U8, expected: U8, found: Measure, among: Among) -> Explanation | None:
    """Return what explains a difference, or None.

    Parameters
    ----------
    submitted, expected : (h, w, 3) uint8, of one size
    found : Measure
        Of these two.
    among : Among
    """
    before = amount(found.remaining)
    if before.weight == 0:
        return None
    # What was measured without a match must be explained without one.
    is_strict = found.is_strict or movement(submitted, expected) != (0.0, 0.0)
    left = difference if is_strict else left_over
    best: tuple[Trial, Amount] | None = None
    for trial in _trials(submitted, expected, found, among):
        if among.only not in (None, trial.name):
            continue
        picture = np.ascontiguousarray(trial.picture())
        after = amount((residue if trial.is_elsewhere else left)(submitted, picture))
        if not _explains(before, after) or (
            trial.is_elsewhere and not _is_nearer(submitted, picture, expected)
        ):
            continue
        if best is None or after.weight < best[1].weight - ABOUT_EQUAL * before.weight:
            best = trial, after
    return _said(best[0], before, best[1]) if best else None


def _explains(before: Amount, after: Amount) -> bool:
    return (
        after.weight <= LEFT_AT_MOST * before.weight
        and 1 - after.agreement <= DIFFERING_AT_MOST * (1 - before.agreement)
    )


def _is_nearer(submitted: U8, picture: U8, expected: U8) -> bool:
    """Return whether a picture is more like the submitted one than the expected picture is."""
    before, after = (_distance(submitted, other) for other in (expected, picture))
    return after <= NEARER * before


def _trials(submitted: U8, expected: U8, found: Measure, among: Among) -> Iterator[Trial]:
    for key, picture in among.alternatives.items():
        # Of a picture on which nothing is drawn, what is drawn on another one is no frame.
        is_empty = is_flat(picture) and not is_flat(submitted)
        if picture.shape == submitted.shape and not is_empty:
            yield _alternative(key, picture, among.name)
    # Of one colour, anything can be made.
    if is_flat(submitted) or is_flat(expected):
        return
    yield from _likely_transformations(submitted, expected)
    box = found.region.box if found.region else (0, 0, *submitted.shape[1::-1])
    right, down = shift(submitted, expected, box)
    if right or down:
        yield _movement(expected, right, down)


def _likely_transformations(submitted: U8, expected: U8) -> Iterator[Trial]:
    """Yield those that already make small versions of the pictures more alike.

    Two at once, one of places and one of colours, are tried where none alone does.
    """
    small, small_expected = _shrunk(submitted), _shrunk(expected)
    limit = WORTH_A_TRY * _distance(small, small_expected)
    pairs: list[tuple[float, Trial]] = []
    for place in (None, *places(expected)):
        moved = expected if place is None else np.ascontiguousarray(place.change(expected))
        small_moved = small_expected if place is None else place.change(small_expected)
        if place is not None and _distance(small, small_moved) <= limit:
            yield _trial(place, expected, is_elsewhere=True)
        for paint in colors(submitted, moved):
            distance = _distance(small, paint.change(small_moved))
            if place is None and distance <= limit:
                yield _trial(paint, expected)
            elif place is not None and distance <= WORTH_A_TRY_IN_PAIRS * limit:
                pairs.append((distance, _trial(both(place, paint), expected, is_elsewhere=True)))
    yield from (trial for _, trial in sorted(pairs, key=itemgetter(0))[:MOST_PAIRS])


def _trial(candidate: Transformation, expected: U8, *, is_elsewhere: bool = False) -> Trial:
    name, opening, ending, change = candidate
    return Trial(name, opening, ending, partial(change, expected), is_elsewhere)


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
        is_elsewhere=True,
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
