"""Marks and other numbers, as reports write them."""

from __future__ import annotations

import math

from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult


def plain(number: float) -> str:
    """Return a number with at most two decimals: "7.5", "3", "0.33"."""
    if not math.isfinite(number):
        return "no number"
    return f"{round(number, 2) + 0.0:.2f}".rstrip("0").rstrip(".")


def has_marks(student: StudentResult) -> bool:
    """Return whether its marks mean something: not if the grader itself has failed."""
    return student.status is not Status.FAILED


def is_full(check: CheckResult) -> bool:
    """Return whether a check cost no marks."""
    return check.score >= 1 and check.points >= check.out_of


def check_names(result: ClassResult) -> tuple[str, ...]:
    """Return the names of all checks, in the order in which they are met first.

    Not every submission has all: one that was refused may have none.
    """
    checks = (check for student in result.students for check in student.checks)
    return tuple(dict.fromkeys(check.name for check in checks))


def check_of(student: StudentResult, name: str) -> CheckResult | None:
    """Return a submission's check of a name, or None if it has none."""
    return next((check for check in student.checks if check.name == name), None)


def is_deterministic_in_words(student: StudentResult) -> str:
    """Return "yes", "no" or "not tried"."""
    return {True: "yes", False: "no", None: "not tried"}[student.is_deterministic]
