import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.evidence import Evidence, RunEvidence, Trace
from sketchkit.grading.results import Status
from tests.grading.checks.cases import check_of, judged, traced


def drawing(draw_calls: int, vertices: int = 100, seconds: float = 1.0) -> Evidence:
    """Return a run of one frame that gives so much to do."""
    trace = Trace({"rect": 1}, draw_calls=draw_calls, vertices=vertices)
    return Evidence({"": RunEvidence(Status.GRADED, traces={1: trace}, seconds=seconds)})


@pytest.mark.parametrize(
    ("text", "draw_calls", "vertices", "score"),
    [
        ('draw_calls = "<= 20"', 20, 100, 1),
        ('draw_calls = "<= 20"', 30, 100, 0.5),
        ('draw_calls = "<= 20"', 40, 100, 0),
        ('draw_calls = "<= 20"\nnone_at = 3', 40, 100, 0.5),
        ('draw_calls = "<= 20"\ncurve = "all or nothing"', 21, 100, 0),
        ('draw_calls = "<= 20"\nvertices = "<= 50"', 10, 100, 0.5),
        ('vertices = "200..300"', 1, 100, 0),
        ('vertices = "150..300"', 1, 100, 0.5),
        ('vertices = ">= 100"', 1, 100, 1),
    ],
)
def test_marks_beyond_a_limit(text: str, draw_calls: int, vertices: int, score: float) -> None:
    result = judged(check_of("performance", text), drawing(draw_calls, vertices))

    assert result.score == pytest.approx(score)


def test_reason_says_how_much() -> None:
    result = judged(check_of("performance", 'draw_calls = "<= 20"'), drawing(1030))

    assert result.reasons == (
        "Draw calls in frame 1: 1,030. Expected: at most 20.",
        "0 of 6 marks: all within the limit, none from 2 times it on, and evenly between.",
    )


def test_drawing_nothing_is_not_fast() -> None:
    result = judged(check_of("performance", 'draw_calls = "<= 20"'), drawing(0, 0))

    assert result.score == 0
    assert result.reasons[0] == "Nothing is drawn in frame 1."


@pytest.mark.parametrize(("vertices", "score"), [(50, 1), (100, 1), (150, 0.5), (200, 0)])
def test_no_more_than_the_reference(vertices: int, score: float) -> None:
    check = check_of("performance", 'vertices = "as in the reference"')

    assert judged(check, drawing(1, vertices), drawing(1, 100)).score == score


def test_frames_are_judged_one_by_one() -> None:
    check = check_of("performance", 'draw_calls = "<= 2"', frames=(1, 2, 3))
    few, many = Trace(draw_calls=1, vertices=3), Trace(draw_calls=9, vertices=3)

    result = judged(check, traced(f1=few, f2=many))

    assert result.score == pytest.approx(1 / 3)
    assert result.reasons[0].startswith("Draw calls in frame 2: 9. Expected: at most 2.")


@pytest.mark.parametrize(("seconds", "score"), [(4, 1), (6, 0.75), (8, 0.5), (60, 0.5)])
def test_time_is_one_part(seconds: float, score: float) -> None:
    check = check_of("performance", 'draw_calls = "<= 2"\ntime = 4')

    assert judged(check, drawing(1, seconds=seconds)).score == pytest.approx(score)


def test_time_is_told() -> None:
    check = check_of("performance", 'draw_calls = "<= 2"\ntime = 4')

    result = judged(check, drawing(1, seconds=5.25))

    assert result.reasons[0] == "It takes 5.2 s of computing; 4 s are allowed."


def test_empty_sketch_earns_nothing_for_being_quick() -> None:
    check = check_of("performance", 'draw_calls = "<= 2"\ntime = 4')

    assert judged(check, drawing(0, 0, seconds=0.1)).score == 0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "needs draw_calls or vertices"),
        ("time = 5", "Time differs between computers: it never counts alone"),
        ("draw_calls = 1\ntime = 0.1", "time is at least 1"),
        ("draw_calls = 'few'", "draw_calls is a number of things"),
    ],
)
def test_limit_that_cannot_be_is_refused(text: str, words: str) -> None:
    with pytest.raises(AssignmentError, match=words):
        check_of("performance", text)
