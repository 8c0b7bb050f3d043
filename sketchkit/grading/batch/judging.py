"""Judging one submission: its runs, its checks, its result."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.digest import digest_of
from sketchkit.grading.assignment.plan import runs
from sketchkit.grading.batch.references import add_data
from sketchkit.grading.batch.renders import Material, Setting, sha, show
from sketchkit.grading.batch.workplace import Workplace
from sketchkit.grading.checks.judge import judge
from sketchkit.grading.evidence import Evidence, RunEvidence
from sketchkit.grading.intake.submission import Submission
from sketchkit.grading.results import CheckResult, Comparison, Status, StudentResult

# What is told of a submission with several runs: the worst that befell any.
BY_GRAVITY = (
    Status.FAILED,
    Status.REFUSED,
    Status.OVER_LIMIT,
    Status.CRASHED,
    Status.STOPPED,
    Status.GRADED,
)
MOST_CONSOLE = 64 * 1024  # characters


@dataclass(frozen=True)
class Task:
    """One submission, and all that is needed to judge it.

    Attributes
    ----------
    submission : Submission
    references : dict of str to Evidence
    setting : Setting
    """

    submission: Submission
    references: Mapping[str, Evidence]
    setting: Setting


Judged = tuple[Task, StudentResult]


def judge_submission(task: Task) -> StudentResult:
    """Run a submission and judge it.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    submission, setting = task.submission, task.setting
    if submission.refusal:
        return unjudged(task, Status.REFUSED, submission.refusal)
    evidence = show(_material(task), runs(setting.assignment), setting).evidence
    pictures = setting.workplace.differences / submission.slug
    checks = tuple(
        _placed(judge(check, evidence, task.references, pictures / check.slug), setting.workplace)
        for check in setting.assignment.checks
    )
    worst = min(evidence.runs.values(), key=lambda run: BY_GRAVITY.index(run.status))
    return StudentResult(
        submission.name,
        submission.slug,
        worst.status,
        worst.explanation,
        checks,
        console=_joined(run.console for run in evidence.runs.values())[:MOST_CONSOLE],
        remarks=tuple(
            dict.fromkeys(text for run in evidence.runs.values() for text in run.remarks)
        ),
        is_deterministic=_is_deterministic(evidence.runs.values()),
        thumbnail=_thumbnail(evidence, setting.workplace),
        sandbox=setting.level.in_words,
    )


def judge_safely(task: Task) -> StudentResult:
    """Judge a submission; what goes wrong in the grader is told in its result."""
    try:
        return judge_submission(task)
    except Exception as problem:  # one submission must not end a batch, whatever it brings about
        explanation = f"The grader failed on it: {type(problem).__name__}: {problem}"
        return unjudged(task, Status.FAILED, explanation[:2000])


def unjudged(task: Task, status: Status, explanation: str) -> StudentResult:
    """Return the result of a submission of which nothing could be run."""
    checks = tuple(
        CheckResult(check.name, check.kind, 0.0, 0.0, check.points, (explanation,))
        for check in task.setting.assignment.checks
    )
    submission = task.submission
    level = task.setting.level.in_words
    return StudentResult(
        submission.name, submission.slug, status, explanation, checks, sandbox=level
    )


def _material(task: Task) -> Material:
    """Return a submission with the assignment's data beside its sketch."""
    submission, assignment = task.submission, task.setting.assignment
    assert submission.folder is not None
    assert submission.sketch is not None
    folder = submission.folder / submission.sketch.parent
    add_data(assignment, folder)
    digest = sha([submission.digest, submission.sketch.as_posix(), _data_digest(assignment)])
    return Material(folder, submission.sketch.name, digest)


def _data_digest(assignment: Assignment) -> str:
    return digest_of(assignment.data, ["."]) if assignment.data is not None else ""


def _placed(result: CheckResult, workplace: Workplace) -> CheckResult:
    """Return a result whose pictures are seen from the folder of results."""
    return replace(result, comparisons=tuple(_seen(one, workplace) for one in result.comparisons))


def _seen(comparison: Comparison, workplace: Workplace) -> Comparison:
    return replace(
        comparison,
        submitted=workplace.relative(comparison.submitted),
        expected=workplace.relative(comparison.expected),
        difference=workplace.relative(comparison.difference),
    )


def _joined(texts: Iterable[str]) -> str:
    """Return what all runs have printed; what is the same in each stands there once."""
    return "\n".join(dict.fromkeys(text for text in texts if text))


def _is_deterministic(evidence: Iterable[RunEvidence]) -> bool | None:
    known = [run.is_deterministic for run in evidence if run.is_deterministic is not None]
    return all(known) if known else None


def _thumbnail(evidence: Evidence, workplace: Workplace) -> Path | None:
    """Return the last picture of the first run that has any."""
    for run in evidence.runs.values():
        if run.frames:
            return workplace.relative(run.frames[max(run.frames)])
    return None
