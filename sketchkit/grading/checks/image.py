"""The check `image`: frames look as the reference's do."""

from __future__ import annotations

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.beside import (
    COMBINATIONS,
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
from sketchkit.grading.results import CheckResult


def read(table: Table, _: Check) -> PictureRule:
    """Return how pictures are compared, from the check's table."""
    return PictureRule(
        read_tolerance(table),
        read_curve(table, Measure.DISTANCE),
        table.choice("combine", tuple(COMBINATIONS), "mean"),
    )


def needs(check: Check, _: PictureRule) -> tuple[Run, ...]:
    """Return the run whose frames are looked at."""
    return (picture_run(check.events, check.frames),)


def judge(case: Case, rule: PictureRule) -> CheckResult:
    """Return marks for the frames, against the reference that they resemble most."""
    best = best_of(hold_beside(case, rule, run) for run in case.reference_runs())
    if best is None:
        return result(case.check, 0.0, rule.curve, ("There is no reference to compare with.",))
    return result(case.check, best.score, rule.curve, told(best), shown(best, case))


KIND = Kind(read, needs, judge, lambda _: Basis.PICTURES)
