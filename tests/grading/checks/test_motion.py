import math

import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.checks.case import Basis
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence, RunEvidence
from sketchkit.grading.results import Status
from tests.grading.checks.cases import check_of, judged, moved

TEN = tuple(range(1, 11))
STEPS = tuple(10.0 * n for n in TEN)  # 10 in frame 1, 100 in frame 10: a range of 90


def test_same_motion_earns_all() -> None:
    result = judged(
        check_of("motion", 'values = ["x"]', frames=TEN), moved(x=STEPS), moved(x=STEPS)
    )

    assert (result.score, result.reasons) == (1, ())


@pytest.mark.parametrize(
    ("tolerance", "offset", "score"),
    [
        ("5", 5, 1),
        ("5", 6, 0),
        ("{absolute = 5}", -5, 1),
        ("{relative = 0.1}", 9, 1),
        ("{relative = 0.1}", 9.1, 0),
        ("{absolute = 20, relative = 0.1}", 19, 1),
    ],
)
def test_band_is_as_wide_as_the_tolerance(tolerance: str, offset: float, score: float) -> None:
    check = check_of("motion", f'values = ["x"]\ntolerance = {tolerance}', frames=TEN)
    own = moved(x=tuple(x + offset for x in STEPS))

    assert judged(check, own, moved(x=STEPS)).score == score


@pytest.mark.parametrize(("unit", "turn"), [("radians", 2 * math.pi), ("degrees", 360)])
def test_whole_turns_of_an_angle_make_no_difference(unit: str, turn: float) -> None:
    angles = tuple(0.3 * turn * n for n in TEN)
    text = f'values = ["x"]\ntolerance = 0.01\nangles = "{unit}"'
    check = check_of("motion", text, frames=TEN)
    wrapped = moved(x=tuple(angle % turn for angle in angles))
    opposite = moved(x=tuple(angle + turn / 2 for angle in angles))

    assert judged(check, wrapped, moved(x=angles)).score == 1
    assert judged(check, opposite, moved(x=angles)).score == 0


def test_share_of_frames_within_the_band() -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 1', frames=TEN)
    own = moved(x=(*STEPS[:7], 0.0, 0.0, 0.0))

    result = judged(check, own, moved(x=STEPS))

    assert result.score == pytest.approx(0.7)
    assert result.reasons[0] == (
        "x is outside of its band in 3 of 10 frames. In frame 8 it is 0, and 79 to 81 is expected."
    )


@pytest.mark.parametrize(("late", "words"), [(2, "2 frames late"), (-1, "1 frame early")])
def test_constant_shift_costs_nothing(late: int, words: str) -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 1\nshift = 2', frames=TEN)
    own = moved(x=tuple(10.0 * (n - late) for n in range(1, 13)))

    result = judged(check, own, moved(x=STEPS))

    assert result.score == 1
    assert words in result.reasons[0]


def test_shift_does_not_excuse_a_value_that_stands_still() -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 1\nshift = 2', frames=TEN)

    # Early by two, frames 1 and 2 would be before the first: one of the other eight fits.
    assert judged(check, moved(x=(50.0,) * 12), moved(x=STEPS)).score == pytest.approx(1 / 8)


def test_value_that_does_not_move_may_be_rounded_otherwise() -> None:
    check = check_of("motion", 'values = ["x"]', frames=TEN)

    own = moved(x=(0.1 + 0.2,) * 10)

    assert judged(check, own, moved(x=(0.3,) * 10)).score == 1


def test_several_values_count_alike() -> None:
    check = check_of("motion", 'values = ["x", "y"]\ntolerance = 1', frames=TEN)
    own = moved(x=STEPS, y=(0.0,) * 10)

    result = judged(check, own, moved(x=STEPS, y=STEPS))

    assert result.score == 0.5
    assert [curve.name for curve in result.curves] == ["x", "y"]


@pytest.mark.parametrize(("x", "score"), [(5.0, 1), (0.0, 1), (10.5, 0)])
def test_written_band_needs_no_reference(x: float, score: float) -> None:
    check = check_of("motion", "bands = {x = [[1, 0, 10], [10, 0, 10]]}", frames=TEN)

    assert KINDS["motion"].basis(check.options) is Basis.NOTHING
    assert judged(check, moved(x=(x,) * 10)).score == score


def test_written_band_is_straight_between_its_corners() -> None:
    check = check_of("motion", "bands = {x = [[2, 0, 10], [6, 40, 50]]}", frames=TEN)

    (curve,) = judged(check, moved(x=(0.0,) * 10)).curves

    assert curve.frames == (2, 3, 4, 5, 6)
    assert curve.low == (0, 10, 20, 30, 40)
    assert curve.high == (10, 20, 30, 40, 50)


def test_curve_is_what_the_report_draws() -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 5', frames=(2, 4))

    (curve,) = judged(check, moved(x=STEPS), moved(x=STEPS)).curves

    assert (curve.frames, curve.values) == ((2, 4), (20, 40))
    assert curve.low == pytest.approx((15, 35), abs=1e-3)
    assert curve.high == pytest.approx((25, 45), abs=1e-3)


@pytest.mark.parametrize("values", [{}, {"x": (math.nan,) * 10}], ids=["missing", "no number"])
def test_value_that_is_not_there_is_named(values: dict[str, tuple[float, ...]]) -> None:
    check = check_of("motion", 'values = ["x"]', frames=TEN)

    result = judged(check, moved(**values), moved(x=STEPS))

    assert result.score == 0
    assert result.reasons[0].startswith("Your sketch has no number that is called x:")


def test_frames_without_a_number_are_named() -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 1', frames=TEN)
    own = moved(x=(math.nan, math.nan, *STEPS[2:]))

    result = judged(check, own, moved(x=STEPS))

    assert result.score == pytest.approx(0.8)
    assert result.reasons[0] == "x is no number in 2 frames, first in frame 1."


def test_submission_that_stopped_is_judged_as_far_as_it_came() -> None:
    check = check_of("motion", 'values = ["x"]\ntolerance = 1', frames=TEN)
    run = RunEvidence(Status.STOPPED, "It divides by 0.", values={"x": STEPS[:6]})

    result = judged(check, Evidence({"": run}), moved(x=STEPS))

    assert result.score == pytest.approx(0.6)
    assert result.reasons[0] == "It stopped before frame 7: It divides by 0."


def test_submission_that_never_ran_is_told_why() -> None:
    check = check_of("motion", 'values = ["x"]', frames=TEN)
    run = RunEvidence(Status.CRASHED, "Signal 11.")

    result = judged(check, Evidence({"": run}), moved(x=STEPS))

    assert result.score == 0
    assert result.reasons[0] == "It stopped before frame 1: Signal 11."


def test_reference_without_the_value_is_told() -> None:
    check = check_of("motion", 'values = ["x"]', frames=TEN)

    result = judged(check, moved(x=STEPS), moved(y=STEPS))

    assert result.score == 0
    assert result.reasons[0] == "The reference has no number x in these frames: tell your teacher."


def test_plan_watches_beyond_the_last_frame() -> None:
    check = check_of("motion", 'values = ["x", "ball.y"]\nshift = 3', frames=TEN)

    (run,) = KINDS["motion"].needs(check, check.options)

    assert run.watched == ("x", "ball.y")
    assert run.last_frame == 13


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "needs values"),
        ('values = ["ball x"]', "'ball x' is no name of a value"),
        ('values = "x"\ntolerance = -1', "tolerance is at least 0"),
        ('values = "x"\ntolerance = {absolut = 1}', r"Do you mean absolute\?"),
        ('values = "x"\nbands = {y = [[1, 0, 1]]}', "bands has y, which is not among the values"),
        ("bands = {x = 3}", "x needs a list of corners, not 3"),
        ("bands = {x = [[1, 2]]}", "A corner of x has three numbers"),
        ("bands = {x = [[1, 5, 2]]}", "a frame, the lowest and the highest number"),
        ("bands = {x = [[5, 0, 1], [1, 0, 1]]}", "The frames of x rise"),
        ("bands = {x = [[50, 0, 1]]}", "covers none of the frames"),
        ('values = "x"\nshift = 121', "shift is at most 120 frames, not 121"),
        ('values = "x"\nshift = 1.5', "shift is a whole number, not 1.5"),
    ],
)
def test_motion_that_cannot_be_watched_is_refused(text: str, words: str) -> None:
    with pytest.raises(AssignmentError, match=words):
        check_of("motion", text, frames=TEN)
