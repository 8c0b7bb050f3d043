from pathlib import Path

import pytest

from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.checks.shift import best_shift
from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import Status
from tests.grading.checks.cases import check_of, judged, pictured

PIXELS = 'metric = "pixels"\ntolerance = {share = 0.01}\n'
LAST = 20


def growing(folder: Path, late: int = 0, frames: int = LAST) -> Evidence:
    """Return an animation whose frame n has 8 n black pixels, or shows that some frames late."""
    return Evidence({"": pictured(folder, {n: 8 * max(n - late, 0) for n in range(1, frames + 1)})})


@pytest.mark.parametrize(
    ("late", "words"), [(3, "3 frames late"), (-2, "2 frames early"), (1, "1 frame late")]
)
def test_constant_shift_costs_nothing(tmp_path: Path, late: int, words: str) -> None:
    check = check_of("sequence", f"{PIXELS}shift = 3", frames=(4, 8, 12))

    result = judged(check, growing(tmp_path / "s", late), growing(tmp_path / "r"), tmp_path)

    assert result.score == 1
    assert words in result.reasons[0]


def test_shift_beyond_what_is_tolerated_costs(tmp_path: Path) -> None:
    check = check_of("sequence", f"{PIXELS}shift = 2", frames=(4, 8, 12))

    result = judged(check, growing(tmp_path / "s", 3), growing(tmp_path / "r"), tmp_path)

    assert result.score == 0
    assert "costs no marks" not in " ".join(result.reasons)


def test_animation_in_time_is_not_called_late(tmp_path: Path) -> None:
    check = check_of("sequence", PIXELS, frames=(4, 8, 12))

    result = judged(check, growing(tmp_path / "s"), growing(tmp_path / "r"), tmp_path)

    assert (result.score, result.reasons) == (1, ())


def test_frames_before_the_first_do_not_count(tmp_path: Path) -> None:
    check = check_of("sequence", PIXELS, frames=(1, 2, 6))

    result = judged(check, growing(tmp_path / "s", -3), growing(tmp_path / "r"), tmp_path)

    assert result.score == 1
    assert [comparison.label for comparison in result.comparisons] == ["frame 6, yours 3"]


def test_score_is_the_mean_of_the_frames(tmp_path: Path) -> None:
    check = check_of("sequence", PIXELS, frames=(4, 8, 12, 16))
    run = pictured(tmp_path / "s", {4: 32, 8: 64, 12: 96}, Status.STOPPED, "It divides by 0.")

    result = judged(check, Evidence({"": run}), growing(tmp_path / "r"), tmp_path)

    assert result.score == 0.75
    assert result.reasons[0] == "It stopped before frame 16: It divides by 0."


def test_still_picture_is_no_animation(tmp_path: Path) -> None:
    check = check_of("sequence", PIXELS, frames=(4, 8, 12, 16))
    still = Evidence({"": pictured(tmp_path / "s", dict.fromkeys(range(1, 21), 32))})

    result = judged(check, still, growing(tmp_path / "r"), tmp_path)

    assert result.score == 0.25


def test_plan_has_frames_beyond_the_ends() -> None:
    check = check_of("sequence", "shift = 2", frames=(1, 10))

    (run,) = KINDS["sequence"].needs(check, check.options)

    assert run.frames == (1, 2, 3, 8, 9, 10, 11, 12)
    assert run.last_frame == 12
    assert run.varied == (1, 10)


@pytest.mark.parametrize(
    ("differences", "shift"),
    [
        ({0: 10, 1: 5, -1: 5}, 1),
        ({0: 10, 1: 9.5, -1: 9.6}, 0),
        ({0: 10, 1: 5, -1: 4, 2: 3}, 2),
        ({0: 0, 1: 0, -1: 0}, 0),
        ({0: 10, -2: 1}, -2),
    ],
)
def test_shift_has_to_be_worth_it(differences: dict[int, float], shift: int) -> None:
    assert best_shift(lambda by: differences.get(by, 100), 2) == shift
