import json
from pathlib import Path

import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence
from tests.grading.checks.cases import Check, check_of, judged, pictured

PIXELS = 'metric = "pixels"\ntolerance = {share = 0.01}\n'
EVENTS = [{"frame": 3, "move": [4, 5]}, {"frame": 4, "press": "left"}, {"frame": 30, "key": "a"}]


def clicking(folder: Path, frames: tuple[int, ...] = (2, 8)) -> Check:
    """Return a check that replays a click in frame 4."""
    (folder / "events.json").write_text(json.dumps({"events": EVENTS}))
    return check_of("interaction", PIXELS, frames=frames, folder=folder, events="events.json")


def answers(folder: Path, touched: dict[int, int], untouched: dict[int, int]) -> Evidence:
    """Return both runs, by the black pixels of their frames."""
    return Evidence(
        {
            "events.json": pictured(folder / "touched", touched),
            "": pictured(folder / "untouched", untouched),
        }
    )


def test_answer_as_expected_earns_all(tmp_path: Path) -> None:
    reference = answers(tmp_path / "r", {2: 0, 8: 50}, {2: 0, 8: 0})
    own = answers(tmp_path / "s", {2: 0, 8: 50}, {2: 0, 8: 0})

    assert judged(clicking(tmp_path), own, reference, tmp_path).score == 1


def test_no_reaction_earns_nothing_however_little_would_change(tmp_path: Path) -> None:
    reference = answers(tmp_path / "r", {2: 0, 8: 1}, {2: 0, 8: 0})
    own = answers(tmp_path / "s", {2: 0, 8: 0}, {2: 0, 8: 0})

    result = judged(clicking(tmp_path), own, reference, tmp_path)

    assert result.points == 0
    assert result.reasons[0].startswith("Nothing in your sketch reacts to the mouse or the keys")
    assert result.reasons[1] == (
        "In frame 4 the left mouse button is pressed, and the picture should answer to that."
    )


def test_frame_without_an_answer_says_what_happened_before_it(tmp_path: Path) -> None:
    reference = answers(tmp_path / "r", {2: 0, 8: 50, 40: 90}, {2: 0, 8: 0, 40: 0})
    own = answers(tmp_path / "s", {2: 0, 8: 50, 40: 0}, {2: 0, 8: 0, 40: 0})

    result = judged(clicking(tmp_path, (2, 8, 40)), own, reference, tmp_path)

    assert result.score == pytest.approx(2 / 3)
    assert result.reasons[0] == (
        "Frame 40 looks as it should without mouse and keys. In frame 30 the key a is pressed, "
        "and the picture should answer to that."
    )


def test_reference_that_does_not_react_demands_no_reaction(tmp_path: Path) -> None:
    reference = answers(tmp_path / "r", {2: 0, 8: 0}, {2: 0, 8: 0})

    assert judged(clicking(tmp_path), reference, reference, tmp_path).score == 1


def test_both_runs_are_asked_for(tmp_path: Path) -> None:
    check = clicking(tmp_path)

    touched, untouched = KINDS["interaction"].needs(check, check.options)

    assert (touched.events, untouched.events) == ("events.json", "")
    assert touched.frames == (1, 2, 3, 7, 8, 9)
    assert untouched.frames == (2, 8)


def test_input_is_needed() -> None:
    with pytest.raises(AssignmentError, match="needs input"):
        check_of("interaction", PIXELS)


def test_frames_before_all_events_prove_nothing(tmp_path: Path) -> None:
    with pytest.raises(AssignmentError, match=r"Nothing happens in events.json before frame 3"):
        clicking(tmp_path, (1, 2))
