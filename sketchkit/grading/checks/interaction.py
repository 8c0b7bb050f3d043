"""The check `interaction`: mouse and keys are replayed, and frames look as the reference's then do.

A sketch that draws the same with and without them gets no marks, however little of the picture
would have changed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.events_file import Happening, read_events
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.beside import Attempt, PictureRule, picture_run, shown, told
from sketchkit.grading.checks.case import NOT_RUN, Basis, Case, Kind, result
from sketchkit.grading.checks.metrics import compare
from sketchkit.grading.checks.pictures import PictureError, read_picture, size_of
from sketchkit.grading.checks.sequence import best_attempt, lateness, read_rule
from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import CheckResult

USUAL_SHIFT = 1
WITHOUT_EVENTS = ""
NO_REACTION = (
    "Nothing in your sketch reacts to the mouse or the keys: with them and without it draws the "
    "same."
)


@dataclass(frozen=True)
class InteractionRule:
    """How frames are compared, and what happens in the file of events."""

    pictures: PictureRule
    happenings: tuple[Happening, ...]


def read(table: Table, check: Check) -> InteractionRule:
    """Return the check's own values, from its table and from the file of events."""
    if not check.events:
        raise table.error(f"{table.subject} needs input.", hint='Write input = "events.json".')
    happenings = read_events(table.document.folder / check.events, check.events)
    if happenings[0].frame > check.frames[-1]:
        raise table.error(
            f"Nothing happens in {check.events} before frame {happenings[0].frame}, and the last "
            f"frame that is looked at is {check.frames[-1]}.",
            "frames" if "frames" in table else None,
        )
    return InteractionRule(read_rule(table, USUAL_SHIFT), happenings)


def needs(check: Check, rule: InteractionRule) -> tuple[Run, ...]:
    """Return the run with the events, and the one without them."""
    without = Run(WITHOUT_EVENTS, check.frames, last_frame=check.frames[-1])
    return picture_run(check.events, check.frames, rule.pictures.shift), without


def judge(case: Case, rule: InteractionRule) -> CheckResult:
    """Return the mean of the frames' marks; none if nothing reacts."""
    curve = rule.pictures.curve
    best = best_attempt(case, rule.pictures)
    if best is None:
        return result(case.check, 0.0, curve, ("There is no reference to compare with.",))
    if _is_idle(case, case.submission) and not all(
        _is_idle(case, case.references[name]) for name in case.references
    ):
        reasons = [NO_REACTION, _expected(case, rule)]
        return result(case.check, 0.0, curve, reasons, shown(best, case))
    reasons = [*lateness(best, case), *_unmoved(best, case, rule), *told(best)]
    return result(case.check, best.score, curve, reasons, shown(best, case))


def _is_idle(case: Case, evidence: Evidence) -> bool:
    """Return whether the frames that there are look the same with and without the events."""
    with_events = evidence.runs.get(case.check.events, NOT_RUN).frames
    without = evidence.runs.get(WITHOUT_EVENTS, NOT_RUN).frames
    numbers = [n for n in case.check.frames if n in with_events and n in without]
    try:
        return bool(numbers) and all(
            size_of(with_events[n]) == size_of(without[n])
            and np.array_equal(read_picture(with_events[n]), read_picture(without[n]))
            for n in numbers
        )
    except PictureError:
        return False


def _unmoved(attempt: Attempt, case: Case, rule: InteractionRule) -> Iterator[str]:
    """Yield a sentence on the first frame that looks as if nothing had happened, if one does."""
    for sighting in attempt.sightings:
        submitted = sighting.comparison.submitted
        if sighting.verdict is None or sighting.verdict.is_alike or submitted is None:
            continue
        if _looks_untouched(case, rule, sighting.number):
            yield (
                f"Frame {sighting.number} looks as it should without mouse and keys. "
                + _expected(case, rule, sighting.number)
            )
            return


def _looks_untouched(case: Case, rule: InteractionRule, number: int) -> bool:
    submitted = case.run.frames.get(number)
    for evidence in case.references.values():
        expected = evidence.runs.get(WITHOUT_EVENTS, NOT_RUN).frames.get(number)
        if submitted is None or expected is None:
            continue
        try:
            pictures = read_picture(submitted), read_picture(expected)
        except PictureError:
            continue
        if compare(*pictures, rule.pictures.tolerance).is_alike:
            return True
    return False


def _expected(case: Case, rule: InteractionRule, number: int | None = None) -> str:
    """Return what happens in the events before a frame, as what the sketch should have answered."""
    last = case.check.frames[-1] if number is None else number
    before = [happening for happening in rule.happenings if happening.frame <= last]
    if not before:
        return ""
    # A press says more than the way there, and than the release after it.
    telling = [one for one in before if not re.search("moves to|is released", one.words)]
    happening = (telling or before)[-1]
    return f"In frame {happening.frame} {happening.words}, and the picture should answer to that."


KIND = Kind(read, needs, judge, lambda _: Basis.PICTURES)
