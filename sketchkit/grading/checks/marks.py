"""From a measure to marks: the curve that an assignment states, and the sentence that states it.

A measure is a distance: 0 is perfect, and 1 is as far as the assignment tolerates. Where a check
counts parts that are right, its measure is the share of parts that are not.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise

from sketchkit.grading.assignment.table import Table

SLACK = 1e-9  # of sums of shares: three thirds are a whole
ALL_OR_NOTHING = "all or nothing"


class Measure(Enum):
    """What a curve of marks is a curve over; the values are what 1 stands for, in words."""

    DISTANCE = "the tolerance"
    EXCESS = "the limit"
    SHARE = "what is right"


@dataclass(frozen=True)
class MarkCurve:
    """The share of a check's marks for a distance.

    Attributes
    ----------
    points : tuple of (distance, share)
        Distances rise, shares fall; lines between. Two of one distance are a step, whose upper
        end holds there.
    words : str
        The curve as a student reads it, without a final stop.
    """

    points: tuple[tuple[float, float], ...]
    words: str

    def score(self, distance: float) -> float:
        """Return the share of the marks, 0 to 1; none for what is no number."""
        if math.isnan(distance):
            return 0.0
        if distance <= self.points[0][0] + SLACK:
            return self.points[0][1]
        for (near, upper), (far, lower) in pairwise(self.points):
            if near < distance <= far + SLACK:
                part = min((distance - near) / (far - near), 1.0) if far > near else 1.0
                return upper + part * (lower - upper)
        return self.points[-1][1]


def falling_to(none_at: float, measure: Measure = Measure.DISTANCE) -> MarkCurve:
    """Return the curve that gives all marks within the tolerance, and none from a multiple on."""
    words = f"all within {measure.value}, none from {none_at:g} times it on, and evenly between"
    return MarkCurve(((1.0, 1.0), (none_at, 0.0)), words)


def step(measure: Measure = Measure.DISTANCE) -> MarkCurve:
    """Return the curve that gives all marks within the tolerance, and none beyond it."""
    return MarkCurve(((1.0, 1.0), (1.0, 0.0)), f"all within {measure.value}, none beyond it")


BY_SHARE = MarkCurve(((0.0, 1.0), (1.0, 0.0)), "in proportion to what is right")
WHOLE = MarkCurve(((0.0, 1.0), (0.0, 0.0)), "all if everything is right, and none otherwise")


def read_curve(table: Table, measure: Measure, none_at: float = 4.0) -> MarkCurve:
    """Return the curve that a check states with `curve` or `none_at`."""
    is_share = measure is Measure.SHARE
    if not is_share and "none_at" in table:
        if "curve" in table:
            raise table.error("none_at and curve say the same: write one of them.", "none_at")
        return falling_to(table.number("none_at", none_at, above=1), measure)
    match table.value("curve"):
        case None:
            return BY_SHARE if is_share else falling_to(none_at, measure)
        case str(name) if name == ALL_OR_NOTHING:
            return WHOLE if is_share else step(measure)
        case list(points):
            return _drawn_curve(table, points, measure)
        case _:
            raise table.error(
                f'curve is "{ALL_OR_NOTHING}" or a list of points.', "curve", _example(measure)
            )


def _drawn_curve(table: Table, points: Sequence[object], measure: Measure) -> MarkCurve:
    pairs = tuple(_pair(table, point, measure) for point in points)
    if len(pairs) < 2:
        raise table.error("curve has two points at least.", "curve", _example(measure))
    if any(nearer[0] > farther[0] for nearer, farther in pairwise(pairs)):
        raise table.error("The first numbers of curve's points rise.", "curve", _example(measure))
    directed = _from_shares(pairs) if measure is Measure.SHARE else pairs
    if any(nearer[1] < farther[1] for nearer, farther in pairwise(directed)):
        raise table.error(
            "A curve gives no more marks for what is worse.", "curve", _example(measure)
        )
    if directed[0][1] != 1:
        raise table.error("A curve gives all marks, 1, for the best.", "curve", _example(measure))
    return MarkCurve(directed, _described(pairs, measure))


def _pair(table: Table, point: object, measure: Measure) -> tuple[float, float]:
    if not isinstance(point, list) or len(point) != 2:
        raise table.error("Each point of curve has two numbers.", "curve", _example(measure))
    place, share = (table.as_number(number, "curve", least=0) for number in point)
    if share > 1 or (measure is Measure.SHARE and place > 1):
        raise table.error(
            "In curve, 1 stands for all: no share is larger.", "curve", _example(measure)
        )
    return place, share


def _from_shares(pairs: Sequence[tuple[float, float]]) -> tuple[tuple[float, float], ...]:
    """Return points over the share that is right as points over the share that is not."""
    return tuple((1 - place, share) for place, share in reversed(pairs))


def _described(pairs: Sequence[tuple[float, float]], measure: Measure) -> str:
    stops = (f"{share:.0%} at {_place(place, measure)}" for place, share in pairs)
    return f"{', '.join(stops)}, and evenly between"


def _place(place: float, measure: Measure) -> str:
    if measure is Measure.SHARE:
        return f"{place:.0%} right"
    return measure.value if place == 1 else f"{place:g} times {measure.value}"


def _example(measure: Measure) -> str:
    if measure is Measure.SHARE:
        return "Write curve = [[0.5, 0], [0.9, 1.0]]: half of it right, no marks; 90 % right, all."
    return f"Write curve = [[1, 1.0], [2, 0.5], [4, 0]]: twice {measure.value}, half the marks."
