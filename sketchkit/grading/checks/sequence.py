"""The check `sequence`: an animation looks as the reference's does, be it early or late."""

from __future__ import annotations

from collections.abc import Iterator

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.beside import (
    Attempt,
    PictureRule,
    best_of,
    hold_beside,
    picture_run,
    shown,
    told,
)
from sketchkit.grading.checks.case import Basis, Case, Kind, result
from sketchkit.grading.checks.marks import Measure, read_curve
from sketchkit.grading.checks.metrics import read_tolerance
from sketchkit.grading.checks.shift import likely_shift, read_shift
from sketchkit.grading.results import CheckResult

USUAL_SHIFT = 3


def read(table: Table, _: Check) -> PictureRule:
    """Return how pictures are compared, from the check's table."""
    return read_rule(table, USUAL_SHIFT)


def read_rule(table: Table, usual_shift: int) -> PictureRule:
    """Return how pictures are compared, with a shift that the table may state."""
    return PictureRule(
        read_tolerance(table),
        read_curve(table, Measure.DISTANCE),
        shift=read_shift(table, usual_shift),
    )


def needs(check: Check, rule: PictureRule) -> tuple[Run, ...]:
    """Return the run whose frames are looked at, some before and after them too."""
    return (picture_run(check.events, check.frames, rule.shift),)


def judge(case: Case, rule: PictureRule) -> CheckResult:
    """Return the mean of the frames' marks, at the shift that gives the most."""
    best = best_attempt(case, rule)
    if best is None:
        return result(case.check, 0.0, rule.curve, ("There is no reference to compare with.",))
    reasons = [*lateness(best, case), *told(best)]
    return result(case.check, best.score, rule.curve, reasons, shown(best, case))


def best_attempt(case: Case, rule: PictureRule) -> Attempt | None:
    """Return the fairest comparison, over references and shifts; None without a reference."""
    return best_of(_attempts(case, rule))


def _attempts(case: Case, rule: PictureRule) -> Iterator[Attempt | None]:
    for run in case.reference_runs():
        shift = likely_shift(case.run.frames, run.frames, case.check.frames, rule.shift)
        attempt = hold_beside(case, rule, run, shift)
        yield attempt
        # Small pictures may have misled: without a shift there may be more marks.
        if shift and (attempt is None or attempt.score < 1):
            yield hold_beside(case, rule, run)


def lateness(attempt: Attempt, case: Case) -> list[str]:
    """Return a sentence on the shift, if there is one, and what it does to the marks."""
    if attempt.shift == 0 or attempt.score == 0:
        return []
    frames = f"{abs(attempt.shift)} frame{'s' if abs(attempt.shift) > 1 else ''}"
    when = "late" if attempt.shift > 0 else "early"
    first = case.check.frames[0]
    moved = max(first + attempt.shift, 1)
    return [
        f"Your animation is {frames} {when}, which costs no marks here: what belongs to frame "
        f"{moved - attempt.shift} is in your frame {moved}."
    ]


KIND = Kind(read, needs, judge, lambda _: Basis.PICTURES)
