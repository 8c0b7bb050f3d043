"""By how many frames an animation is early or late: found on small pictures, which is quick."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.beside import counterpart
from sketchkit.grading.checks.pictures import U8, PictureError, read_small

MOST_SHIFT = 120  # two seconds: more is another animation
SMALL = 160  # px wide
GAIN = 0.9  # a shift has to leave less than this of the difference that there is without


def read_shift(table: Table, usual: int) -> int:
    """Return by how many frames a submission may be early or late, from a check's table."""
    shift = table.whole("shift", usual)
    if shift > MOST_SHIFT:
        raise table.error(f"shift is at most {MOST_SHIFT} frames, not {shift}.", "shift")
    return shift


def likely_shift(
    submitted: dict[int, Path], expected: dict[int, Path], frames: Sequence[int], most: int
) -> int:
    """Return the shift within `most` at which the frames differ least; 0 unless one is better.

    Positive: the submission shows each picture later than the reference.
    """
    if most == 0:
        return 0
    moved = {counterpart(number, by) for number in frames for by in range(-most, most + 1)}
    own = {number: _small(path) for number, path in submitted.items() if number in moved}
    theirs = {number: _small(expected[number]) for number in frames if number in expected}
    return best_shift(partial(_difference, own, theirs, frames), most)


def best_shift(difference: Callable[[int], float], most: int) -> int:
    """Return the shift of the least difference; of equal ones the smallest."""
    without = difference(0)
    best, least = 0, without * GAIN
    for size in range(1, most + 1):
        for shift in (size, -size):
            if (found := difference(shift)) < least:
                best, least = shift, found
    return best


def _difference(
    own: dict[int, U8 | None], theirs: dict[int, U8 | None], frames: Sequence[int], shift: int
) -> float:
    """Return the mean difference of the frames that have a counterpart."""
    pairs = [
        (theirs.get(number), own.get(moved))
        for number in frames
        if (moved := counterpart(number, shift)) is not None
    ]
    if not pairs:
        return math.inf
    return float(np.mean([_distance(expected, found) for expected, found in pairs]))


def _distance(one: U8 | None, other: U8 | None) -> float:
    """Return the mean difference of two pictures, 0 to 255; the most for what cannot be compared.

    The most, and not infinity: a frame that a late animation lacks at its end is one among many.
    """
    if one is None or other is None or one.shape != other.shape:
        return 255.0
    return float(np.abs(one.astype(np.int16) - other).mean())


def _small(path: Path) -> U8 | None:
    try:
        return read_small(path, SMALL)
    except PictureError:
        return None
