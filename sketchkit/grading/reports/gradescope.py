"""A submission's results as Gradescope reads them.

Its form: https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format. All texts
are declared to be "text", so that nothing that a submission has printed is taken for HTML,
Markdown or colours.
"""

from __future__ import annotations

from collections.abc import Mapping

from sketchkit.grading.reports.figures import is_deterministic_in_words, is_full, plain
from sketchkit.grading.results import CheckResult, Status, StudentResult
from sketchkit.grading.texts import visible, visible_line


def gradescope(student: StudentResult, record: Mapping[str, str]) -> dict[str, object]:
    """Return what Gradescope's `results.json` holds.

    Gradescope has no way to say that there are no marks yet: a submission that the grader failed
    at gets 0, and `output` says why.
    """
    return {
        "score": round(student.points, 4),
        "output": visible("\n\n".join(_paragraphs(student))),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "stdout_visibility": "hidden",
        "tests": [
            _test(check, str(number)) for number, check in enumerate(student.checks, start=1)
        ],
        "extra_data": {
            "status": student.status.value,
            "deterministic": student.is_deterministic,
            "sandbox": visible_line(student.sandbox),
            "record": {visible_line(name): visible_line(text) for name, text in record.items()},
        },
    }


def _test(check: CheckResult, number: str) -> dict[str, object]:
    reasons = [*check.reasons]
    for comparison in check.comparisons:
        if comparison.reason and comparison.reason not in reasons:
            reasons.append(f"{comparison.label}: {comparison.reason}")
    return {
        "name": visible_line(check.name),
        "number": number,
        "score": round(check.points, 4),
        "max_score": round(check.out_of, 4),
        "status": "passed" if is_full(check) else "failed",
        "output": visible("\n".join(reasons)),
        "output_format": "text",
        "name_format": "text",
        "visibility": "visible",
    }


def _paragraphs(student: StudentResult) -> list[str]:
    """Return what is said of a whole submission."""
    words = [f"{plain(student.points)} of {plain(student.out_of)} marks."]
    if student.status is not Status.GRADED:
        words.append(f"This sketch: {student.status.value}. {student.explanation}".strip())
    elif student.explanation:
        words.append(student.explanation)
    if student.is_deterministic is not None:
        words.append(f"Draws the same in every run: {is_deterministic_in_words(student)}.")
    words.extend(student.remarks)
    if student.console:
        words.append(f"It printed:\n{student.console}")
    if student.sandbox:
        words.append(f"Sandbox: {student.sandbox}.")
    return words
