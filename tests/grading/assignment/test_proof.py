import math
from dataclasses import replace
from pathlib import Path

from sketchkit.grading.assignment.proof import free_marks, prove, unlike_evidence
from sketchkit.grading.evidence import Evidence, RunEvidence, Trace
from sketchkit.grading.results import CheckResult, Comparison, Curve, Status, StudentResult

BOX = CheckResult("A box", "image", 1.0, 4.0, 4.0)
MOTION = CheckResult(
    "It moves", "motion", 1.0, 2.0, 2.0, curves=(Curve("x", (1,), (math.nan,), (0.0,), (1.0,)),)
)
NOTHING = (replace(BOX, score=0.0, points=0.0), replace(MOTION, score=0.0, points=0.0))
REFERENCE = StudentResult("reference", "reference", Status.GRADED, checks=(BOX, MOTION))
EMPTY = StudentResult("empty", "empty", Status.GRADED, checks=NOTHING)


def test_assignment_that_is_proven_leaves_nothing_to_say() -> None:
    assert prove(REFERENCE, REFERENCE, EMPTY) == []


def test_places_of_pictures_may_differ() -> None:
    def with_picture(name: str) -> StudentResult:
        comparison = Comparison("frame 1", submitted=Path(name))
        box = replace(BOX, comparisons=(comparison,))
        return replace(REFERENCE, checks=(box, MOTION))

    assert prove(with_picture("a.png"), with_picture("b.png"), EMPTY) == []


def test_reference_that_loses_marks_is_told_why() -> None:
    worse = replace(BOX, score=0.5, points=2.0, reasons=("It is too dark.",))
    reference = replace(REFERENCE, checks=(worse, MOTION))

    assert prove(reference, reference, EMPTY) == [
        "The reference reference gets 2 of 4 marks in 'A box': It is too dark."
    ]


def test_reference_that_stops_is_told() -> None:
    reference = replace(REFERENCE, status=Status.STOPPED, explanation="It divides by 0.")

    assert prove(reference, reference, EMPTY) == [
        "The reference reference was not judged to its end: It divides by 0."
    ]


def test_reference_that_draws_differently_is_told() -> None:
    (said,) = prove(replace(REFERENCE, is_deterministic=False), REFERENCE, EMPTY)

    assert said.startswith("The reference reference draws something else at each run")


def test_second_judgement_that_differs_is_told() -> None:
    other = replace(REFERENCE, checks=(replace(BOX, reasons=("It is late.",)), MOTION))
    stopped = replace(REFERENCE, status=Status.CRASHED)

    assert prove(REFERENCE, other, EMPTY) == [
        "The reference reference was judged otherwise the second time: A box."
    ]
    assert prove(REFERENCE, stopped, EMPTY) == [
        "The reference reference ended differently the second time: crashed."
    ]


def test_marks_for_nothing_are_told() -> None:
    generous = replace(EMPTY, checks=(replace(BOX, score=0.25, points=1.0), NOTHING[1]))

    (said,) = prove(REFERENCE, REFERENCE, generous)

    assert said.startswith("A sketch that does nothing gets 1 of 4 marks in 'A box': ask")


def test_marks_for_next_to_nothing_are_told() -> None:
    generous = replace(EMPTY, checks=(replace(BOX, score=0.25, points=1.0), NOTHING[1]))

    (said,) = free_marks(generous, "A sketch that only clears its picture")

    assert said.startswith("A sketch that only clears its picture gets 1 of 4 marks in 'A box'")


def shown(folder: Path, picture: bytes, x: float = 1.0, box: int = 1) -> Evidence:
    """Return a run of one frame, whose picture is these bytes."""
    folder.mkdir()
    (folder / "1.png").write_bytes(picture)
    traces = {1: Trace({"box": box})}
    frames = {1: folder / "1.png"}
    values = {"x": (x, math.nan)}
    return Evidence({"": RunEvidence(Status.GRADED, frames=frames, traces=traces, values=values)})


def test_equal_runs_are_alike(tmp_path: Path) -> None:
    assert unlike_evidence(shown(tmp_path / "a", b"same"), shown(tmp_path / "b", b"same")) == []


def test_every_difference_of_two_runs_is_told(tmp_path: Path) -> None:
    one, other = shown(tmp_path / "a", b"same"), shown(tmp_path / "b", b"other", 2.0, 3)

    assert unlike_evidence(one, other) == [
        "Frame 1 is another picture at each run.",
        "In frame 1 something else is drawn at each run.",
        "x has other values at each run.",
    ]


def test_run_that_is_missing_is_told(tmp_path: Path) -> None:
    (said,) = unlike_evidence(shown(tmp_path / "a", b""), Evidence())

    assert said == "One of both runs lacks the run without mouse and keys."
