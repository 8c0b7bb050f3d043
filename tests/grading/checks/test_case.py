import pytest

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.checks.case import first_of, missing_frame, result
from sketchkit.grading.checks.marks import BY_SHARE
from sketchkit.grading.evidence import RunEvidence
from sketchkit.grading.results import Status


@pytest.mark.parametrize(
    ("score", "points"), [(1, 1), (0.9999, 0.99), (1 / 3, 0.33), (0.29, 0.29), (0, 0)]
)
def test_marks_are_hundredths_rounded_down(score: float, points: float) -> None:
    check = Check("A", "1-a", "trace", 1, None)

    assert result(check, score, BY_SHARE).points == points


def test_reasons_are_said_once() -> None:
    check = Check("A", "1-a", "trace", 1, None)

    assert result(check, 1, BY_SHARE, ["It is late.", "", "It is late."]).reasons == (
        "It is late.",
    )


def test_first_line_of_an_explanation_is_enough_for_a_frame() -> None:
    run = RunEvidence(Status.STOPPED, "a.py, line 2: size is not called.\n\n    2 | siez(1)\n")

    assert missing_frame(run, 3) == "It stopped before frame 3: a.py, line 2: size is not called."


def test_repetitions_are_counted() -> None:
    assert first_of(["One."]) == "One."
    assert first_of(["One.", "Two.", "Three."]) == "One. So it is in 2 more frames."
