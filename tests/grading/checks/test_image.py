from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sketchkit.grading.checks.judge import judge
from sketchkit.grading.evidence import Evidence, RunEvidence
from sketchkit.grading.results import Status
from tests.grading.checks.cases import check_of, judged, picture, pictured

# Of 200 pixels 2 may differ: 4 are twice the tolerance.
PIXELS = 'metric = "pixels"\ntolerance = {share = 0.01}\n'


def shows(folder: Path, **frames: int) -> Evidence:
    """Return a run whose frames have so many black pixels: `shows(folder, f1=4)`."""
    return Evidence({"": pictured(folder, {int(n[1:]): count for n, count in frames.items()})})


@pytest.mark.parametrize(
    ("pixels", "points"),
    [(0, 6), (2, 6), (4, 4), (5, 3), (6, 2), (8, 0), (200, 0)],
)
def test_marks_fall_with_the_distance(tmp_path: Path, pixels: int, points: float) -> None:
    check = check_of("image", PIXELS)

    result = judged(check, shows(tmp_path / "s", f1=pixels), shows(tmp_path / "r", f1=0), tmp_path)

    assert result.points == pytest.approx(points)


def test_marks_and_their_curve_are_in_the_reasons(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, expect="The window is white.")

    result = judged(check, shows(tmp_path / "s", f1=4), shows(tmp_path / "r", f1=0), tmp_path)

    assert result.reasons == (
        "The window is white.",
        "Frame 1: 4 pixels differ, and 2 may.",
        "4 of 6 marks: all within the tolerance, none from 4 times it on, and evenly between.",
    )


def test_full_marks_need_no_reason(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, expect="The window is white.")

    result = judged(check, shows(tmp_path / "s", f1=2), shows(tmp_path / "r", f1=0), tmp_path)

    assert result.reasons == ()
    assert result.comparisons[0].is_alike


@pytest.mark.parametrize(("combine", "score"), [("mean", 0.5), ("best", 1), ("worst", 0)])
def test_frames_are_combined(tmp_path: Path, combine: str, score: float) -> None:
    check = check_of("image", f'{PIXELS}combine = "{combine}"', frames=(1, 2))
    own, theirs = shows(tmp_path / "s", f1=0, f2=99), shows(tmp_path / "r", f1=0, f2=0)

    assert judged(check, own, theirs, tmp_path).score == score


def test_reference_that_is_most_alike_counts(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, references=("white", "black"))
    references = {"white": shows(tmp_path / "w", f1=0), "black": shows(tmp_path / "b", f1=200)}

    result = judge(check, shows(tmp_path / "s", f1=199), references, tmp_path)

    assert result.score == 1


def test_one_reference_counts_for_all_frames(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, frames=(1, 2), references=("white", "black"))
    white, black = shows(tmp_path / "w", f1=0, f2=0), shows(tmp_path / "b", f1=200, f2=200)

    result = judge(
        check, shows(tmp_path / "s", f1=0, f2=200), {"white": white, "black": black}, tmp_path
    )

    assert result.score == 0.5


def test_frames_before_a_mistake_are_judged(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, frames=(1, 30, 40))
    run = pictured(tmp_path / "s", {1: 0}, Status.STOPPED, "sketch.py, line 3: x is not defined.")

    result = judged(check, Evidence({"": run}), shows(tmp_path / "r", f1=0, f30=0, f40=0), tmp_path)

    assert result.score == pytest.approx(1 / 3)
    assert result.points == 2
    assert result.reasons[0] == (
        "It stopped before frame 30: sketch.py, line 3: x is not defined. So it is in 1 more frame."
    )


@pytest.mark.parametrize(
    ("run", "words"),
    [
        (RunEvidence(Status.REFUSED, "The archive is broken."), "no frame 1: The archive is bro"),
        (RunEvidence(Status.CRASHED, "Signal 11."), "It stopped before frame 1: Signal 11."),
        (RunEvidence(Status.GRADED), "There is no frame 1."),
    ],
)
def test_submission_without_frames_is_told_why(
    tmp_path: Path, run: RunEvidence, words: str
) -> None:
    result = judged(
        check_of("image", PIXELS), Evidence({"": run}), shows(tmp_path / "r", f1=0), tmp_path
    )

    assert result.score == 0
    assert words in result.reasons[0]


@pytest.mark.parametrize("metric", [PIXELS, ""], ids=["pixels", "flip"])
def test_other_size_is_told_in_words(tmp_path: Path, metric: str) -> None:
    run = RunEvidence(Status.GRADED, frames={1: picture(tmp_path / "1.png", 9, (30, 40))})

    result = judged(
        check_of("image", metric), Evidence({"": run}), shows(tmp_path / "r", f1=0), tmp_path
    )

    assert result.score == 0
    assert "Your picture is 30 x 40 pixels; 20 x 10 is expected." in result.reasons[0]


def test_file_that_is_no_picture_is_told(tmp_path: Path) -> None:
    (tmp_path / "1.png").write_text("no picture")
    run = RunEvidence(Status.GRADED, frames={1: tmp_path / "1.png"})

    result = judged(
        check_of("image", PIXELS), Evidence({"": run}), shows(tmp_path / "r", f1=0), tmp_path
    )

    assert result.reasons[0] == "1.png is no picture that can be read."


def test_heat_map_is_written_for_what_differs(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, frames=(1, 2))
    own, theirs = shows(tmp_path / "s", f1=0, f2=50), shows(tmp_path / "r", f1=0, f2=0)

    alike, unlike = judged(check, own, theirs, tmp_path / "out").comparisons

    assert alike.difference is None
    assert unlike.difference == tmp_path / "out" / "1-image-0002-difference.png"
    with Image.open(unlike.difference) as heat:
        assert np.count_nonzero(np.asarray(heat)[..., 0]) == 50
    assert (unlike.submitted, unlike.expected) == (
        tmp_path / "s" / "2.png",
        tmp_path / "r" / "2.png",
    )


def test_eye_sees_black_for_white(tmp_path: Path) -> None:
    check = check_of("image")

    same = judged(check, shows(tmp_path / "s", f1=0), shows(tmp_path / "r", f1=0), tmp_path)
    other = judged(check, shows(tmp_path / "t", f1=200), shows(tmp_path / "r", f1=0), tmp_path)

    assert (same.score, other.score) == (1, 0)
    assert other.comparisons[0].flip_mean > 0.9


def test_other_frame_of_the_reference_is_recognised(tmp_path: Path) -> None:
    check = check_of("image", frames=(3,))
    size = (60, 60)
    reference = RunEvidence(
        Status.GRADED,
        frames={n: picture(tmp_path / f"r{n}.png", 600 * n, size) for n in (1, 2, 3, 4)},
    )
    own = RunEvidence(Status.GRADED, frames={3: picture(tmp_path / "s.png", 2400, size)})

    result = judged(check, Evidence({"": own}), Evidence({"": reference}), tmp_path)

    assert result.reasons[0] == "Frame 3: This is frame 4, not frame 3."


def test_reference_drawn_otherwise_is_recognised(tmp_path: Path) -> None:
    size = (60, 60)
    dark = picture(tmp_path / "dark.png", 2400, size)
    reference = RunEvidence(
        Status.GRADED,
        frames={1: picture(tmp_path / "r.png", 600, size)},
        variants={"lights off": {1: dark}},
    )
    own = RunEvidence(Status.GRADED, frames={1: picture(tmp_path / "s.png", 2400, size)})

    result = judged(check_of("image"), Evidence({"": own}), Evidence({"": reference}), tmp_path)

    assert "without lights" in result.reasons[0]


def test_many_reasons_are_cut_short(tmp_path: Path) -> None:
    check = check_of("image", PIXELS, frames=tuple(range(1, 11)))
    own = Evidence({"": pictured(tmp_path / "s", {n: 20 + n for n in range(1, 11)})})
    theirs = Evidence({"": pictured(tmp_path / "r", dict.fromkeys(range(1, 11), 0))})

    result = judged(check, own, theirs, tmp_path)

    assert result.reasons[3] == "7 more frames differ."
    assert len(result.comparisons) == 6
    assert result.comparisons[-1].label == "frame 10"


def test_missing_reference_is_told(tmp_path: Path) -> None:
    check = check_of("image", PIXELS)

    without = judge(check, shows(tmp_path / "s", f1=0), {}, tmp_path)
    empty = judged(check, shows(tmp_path / "s", f1=0), shows(tmp_path / "r", f2=0), tmp_path)

    assert without.reasons[0] == "There is no reference to compare with."
    assert empty.reasons[0] == "The reference has no frame 1."
