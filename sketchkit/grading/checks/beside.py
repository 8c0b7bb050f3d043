"""Frames of a submission held beside those of a reference, one by one, and then all of a check."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from statistics import fmean

from sketchkit.assets.output import picture_bytes, write_file
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.checks.case import Case, first_of, missing_frame
from sketchkit.grading.checks.marks import MarkCurve
from sketchkit.grading.checks.metrics import AnyTolerance, compare
from sketchkit.grading.checks.pictures import PictureError, Pictures, read_picture
from sketchkit.grading.evidence import RunEvidence
from sketchkit.grading.images.verdict import Verdict
from sketchkit.grading.results import Comparison

NEIGHBOURS = (-2, -1, 1, 2)  # frames that a picture of the wrong moment is likely to be of
FIRST_FRAMES = (0, 1)
MOST_TOLD = 3  # reasons of single frames
MOST_SHOWN = 6  # comparisons in a report: those that differ most

COMBINATIONS: dict[str, Callable[[Iterable[float]], float]] = {
    "mean": fmean,
    "best": max,
    "worst": min,
}


@dataclass(frozen=True)
class PictureRule:
    """How a check compares pictures.

    Attributes
    ----------
    tolerance : Tolerance or PixelTolerance
    curve : MarkCurve
        Marks of one frame.
    combine : str
        What several frames' marks become: a key of `COMBINATIONS`.
    shift : int
        By how many frames the submission may be early or late.
    """

    tolerance: AnyTolerance
    curve: MarkCurve
    combine: str = "mean"
    shift: int = 0


@dataclass(frozen=True)
class Sighting:
    """One frame that was compared.

    Attributes
    ----------
    number : int
        Of the reference's frame.
    score, distance : float
    comparison : Comparison
        With absolute paths, and no heat map yet.
    verdict : Verdict or None
        None if there were no two pictures.
    """

    number: int
    score: float
    distance: float
    comparison: Comparison
    verdict: Verdict | None = None


@dataclass(frozen=True)
class Attempt:
    """All frames of a check against one reference, at one shift."""

    score: float
    sightings: tuple[Sighting, ...]
    shift: int = 0

    @property
    def rank(self) -> tuple[float, float, int]:
        """Of attempts the one with the largest is the fairest: most marks, nearest, least shift."""
        near = -fmean(min(sighting.distance, 1000.0) for sighting in self.sightings)
        return self.score, near, -abs(self.shift)


def picture_run(events: str, frames: Sequence[int], shift: int = 0) -> Run:
    """Return what is needed of a run, so that its frames can be compared within a shift."""
    shifted = (counterpart(n, by) for n in frames for by in range(-shift, shift + 1))
    submitted = tuple(sorted({number for number in shifted if number is not None}))
    around = {n + step for n in frames for step in NEIGHBOURS if n + step >= 0}
    also = tuple(sorted((around | {*FIRST_FRAMES}) - {*submitted}))
    last = max(submitted + also)
    return Run(events, submitted, also, varied=tuple(frames), last_frame=last)


def counterpart(number: int, shift: int) -> int | None:
    """Return the submission's frame for a reference's; None if it would be before the first.

    Frame 0 is what setup() drew: it is never late.
    """
    if number == 0:
        return 0
    return number + shift if number + shift >= 1 else None


def hold_beside(
    case: Case, rule: PictureRule, reference: RunEvidence, shift: int = 0
) -> Attempt | None:
    """Return how the submission's frames compare with a reference's; None if no frame is left."""
    pairs = ((number, counterpart(number, shift)) for number in case.check.frames)
    sightings: list[Sighting] = []
    for number, own in pairs:
        if own is not None:
            # Most of the time goes into explaining; more than a few reasons are not told.
            # But what explained the last one is likely to explain all that follow.
            known = [one.verdict for one in sightings if not one.comparison.is_alike]
            last = known[-1] if len(known) >= MOST_TOLD else None
            only = (last.explanation if last else "") if len(known) >= MOST_TOLD else None
            sightings.append(_see(case, rule, reference, (number, own), only))
    if not sightings:
        return None
    score = COMBINATIONS[rule.combine](sighting.score for sighting in sightings)
    return Attempt(score, tuple(sightings), shift)


def shown(attempt: Attempt, case: Case) -> list[Comparison]:
    """Return what a report shows: the frames that differ most, with heat maps, in order.

    Paths are absolute; heat maps are written to the case's folder of pictures.
    """
    worst = sorted(attempt.sightings, key=lambda sighting: (-sighting.distance, sighting.number))
    chosen = sorted(worst[:MOST_SHOWN], key=lambda sighting: sighting.number)
    return [_with_heat(sighting, case) for sighting in chosen]


def told(attempt: Attempt) -> list[str]:
    """Return why frames have lost marks, each reason once; of many, the first few and a count."""
    groups: dict[str, list[str]] = {}
    for sighting in attempt.sightings:
        comparison = sighting.comparison
        if comparison.is_alike:
            continue
        is_missing = comparison.submitted is None
        label = "" if sighting.verdict is None else f"{comparison.label.capitalize()}: "
        sentence = f"{label}{comparison.reason}"
        groups.setdefault("" if is_missing else comparison.reason, []).append(sentence)
    first, rest = [*groups.values()][:MOST_TOLD], [*groups.values()][MOST_TOLD:]
    more = sum(map(len, rest))
    also = [f"{more} more frame{'s differ' if more > 1 else ' differs'}."] if more else []
    return [*map(first_of, first), *also]


def best_of(attempts: Iterable[Attempt | None]) -> Attempt | None:
    """Return the fairest of some attempts; None if there is none."""
    return max(filter(None, attempts), key=lambda attempt: attempt.rank, default=None)


def _see(
    case: Case,
    rule: PictureRule,
    reference: RunEvidence,
    numbers: tuple[int, int],
    only: str | None,
) -> Sighting:
    """Compare a frame of the reference with one of the submission, by their numbers."""
    number, own = numbers
    label = f"frame {number}" if own == number else f"frame {number}, yours {own}"
    submitted, expected = case.run.frames.get(own), reference.frames.get(number)
    comparison = Comparison(label, submitted, expected, is_alike=False)
    if expected is None:
        return _nothing(number, comparison, f"The reference has no frame {number}.")
    if submitted is None:
        return _nothing(number, comparison, missing_frame(case.run, own))
    try:
        verdict = compare(
            read_picture(submitted),
            read_picture(expected),
            rule.tolerance,
            _alternatives(reference, number),
            f"frame {number}",
            only,
        )
    except PictureError as problem:
        return _nothing(number, comparison, str(problem))
    return _seen(rule, number, comparison, verdict)


def _seen(rule: PictureRule, number: int, comparison: Comparison, verdict: Verdict) -> Sighting:
    comparison = replace(
        comparison,
        flip_mean=verdict.flip_mean,
        flip_high=verdict.flip_high,
        region=verdict.region,
        is_alike=verdict.is_alike,
        reason=verdict.reason,
    )
    score = rule.curve.score(verdict.distance)
    return Sighting(number, score, verdict.distance, comparison, verdict)


def _nothing(number: int, comparison: Comparison, reason: str) -> Sighting:
    return Sighting(number, 0.0, math.inf, replace(comparison, reason=reason))


def _alternatives(run: RunEvidence, number: int) -> Pictures:
    """Return other pictures of the reference that a wrong one may resemble, by their names."""
    numbers = sorted({number + step for step in NEIGHBOURS} | {*FIRST_FRAMES} - {number})
    paths = {f"frame {other}": run.frames[other] for other in numbers if other in run.frames}
    for name, frames in run.variants.items():
        if number in frames:
            paths[name] = frames[number]
    return Pictures(paths)


def _with_heat(sighting: Sighting, case: Case) -> Comparison:
    if sighting.verdict is None or sighting.verdict.is_alike:
        return sighting.comparison
    path = case.pictures / f"{case.check.slug}-{sighting.number:04d}-difference.png"
    write_file(path, picture_bytes(sighting.verdict.heat, ".png"))
    return replace(sighting.comparison, difference=path)
