"""A case: one check, what the submission has shown, what the references show; and the verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Generic, TypeVar

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.assignment.table import Table
from sketchkit.grading.checks.marks import MarkCurve
from sketchkit.grading.evidence import Evidence, RunEvidence
from sketchkit.grading.results import CheckResult, Comparison, Curve, Status

O = TypeVar("O")  # noqa: E741 # options: what a kind reads of its own
NOT_RUN = RunEvidence(Status.FAILED, "it was not run")


class Basis(Enum):
    """What a check needs of a reference."""

    NOTHING = "nothing"  # the assignment itself says what is expected
    PICTURES = "pictures"  # a folder of frames will do
    SKETCH = "a sketch"


@dataclass(frozen=True)
class Case:
    """What a judge looks at.

    Attributes
    ----------
    check : Check
    submission : Evidence
    references : dict of str to Evidence
        Those that the check accepts.
    pictures : Path
        The folder where heat maps are written.
    """

    check: Check
    submission: Evidence
    references: Mapping[str, Evidence]
    pictures: Path

    @property
    def run(self) -> RunEvidence:
        """The submission's run with the check's events."""
        return self.submission.runs.get(self.check.events, NOT_RUN)

    def reference_runs(self) -> list[RunEvidence]:
        """Return each accepted reference's run with the check's events."""
        return [
            self.references[name].runs.get(self.check.events, NOT_RUN)
            for name in self.check.references
            if name in self.references
        ]


@dataclass(frozen=True)
class Kind(Generic[O]):
    """A kind of check.

    Attributes
    ----------
    read : callable
        Returns the kind's own options, `(table, check)`: the check has all but these already.
    needs : callable
        Returns what has to be run for a check, `(check, options)`.
    judge : callable
        Returns the result, `(case, options)`.
    basis : callable
        Returns what the options need of a reference.
    has_frames : bool
        Whether it looks at frames; one that does not takes no events either.
    """

    read: Callable[[Table, Check], O]
    needs: Callable[[Check, O], tuple[Run, ...]]
    judge: Callable[[Case, O], CheckResult]
    basis: Callable[[O], Basis]
    has_frames: bool = True


def result(  # what a result is made of
    check: Check,
    score: float,
    curve: MarkCurve,
    reasons: Iterable[str] = (),
    comparisons: Iterable[Comparison] = (),
    curves: Iterable[Curve] = (),
) -> CheckResult:
    """Return a result: marks in hundredths, rounded down, and how they came about."""
    points = check.points if score == 1 else math.floor(score * check.points * 100 + 1e-6) / 100
    said = [*reasons]
    if score < 1:
        said = [check.expect, *said, f"{points:g} of {check.points:g} marks: {curve.words}."]
    return CheckResult(
        check.name,
        check.kind,
        score,
        points,
        check.points,
        tuple(dict.fromkeys(filter(None, said))),
        tuple(comparisons),
        tuple(curves),
    )


def missing_frame(run: RunEvidence, number: int) -> str:
    """Return why there is nothing of a frame, in a sentence."""
    why = run.explanation.strip().partition("\n")[0].rstrip(".")  # the rest is told elsewhere
    if not why:
        return f"There is no frame {number}."
    if run.status in (Status.REFUSED, Status.FAILED):
        return f"There is no frame {number}: {why}."
    return f"It stopped before frame {number}: {why}."


def missing_trace(run: RunEvidence, number: int) -> str:
    """Return why nothing is known of what a frame draws, in a sentence."""
    if run.status is Status.GRADED:
        return f"Nothing is drawn in frame {number}: there is no draw(), or noLoop() has ended it."
    return missing_frame(run, number)


def first_of(sentences: Sequence[str]) -> str:
    """Return the first of sentences that say the same of one frame each, and how many follow."""
    more = len(sentences) - 1
    if not more:
        return sentences[0]
    return f"{sentences[0]} So it is in {more} more frame{'s' if more > 1 else ''}."
