import json
from pathlib import Path

import pytest

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.events_file import read_events


def written(folder: Path, content: object) -> Path:
    path = folder / "events.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    return path


@pytest.mark.parametrize(
    ("event", "words"),
    [
        ({"move": [4, 5]}, "the mouse moves to 4, 5"),
        ({"press": "left", "at": [1, 2]}, "the left mouse button is pressed"),
        ({"release": "right"}, "the right mouse button is released"),
        ({"click": "center"}, "the center mouse button is clicked"),
        ({"drag": [[1, 2], [8, 9]]}, "the mouse is dragged to 8, 9"),
        ({"wheel": 2}, "the wheel is turned"),
        ({"key": "a"}, "the key a is pressed"),
        ({"keyDown": "UP"}, "the key UP is pressed"),
        ({"keyUp": "UP"}, "the key UP is released"),
        ({"type": "hello"}, "'hello' is typed"),
        ({"resize": [300, 200]}, "the window becomes 300 x 200"),
        ({"enter": True}, "the mouse enters or leaves the window"),
    ],
)
def test_event_in_words(tmp_path: Path, event: dict[str, object], words: str) -> None:
    path = written(tmp_path, {"events": [{"frame": 3, **event}]})

    (happening,) = read_events(path, "events.json")

    assert (happening.frame, happening.words) == (3, words)


def test_events_are_in_the_order_of_their_frames(tmp_path: Path) -> None:
    path = written(tmp_path, [{"frame": 9, "key": "b"}, {"frame": 3, "key": "a"}])

    assert [happening.frame for happening in read_events(path, "events.json")] == [3, 9]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("{", "Line 1 is not JSON."),
        ({"event": []}, "Has no list of events."),
        ({"events": []}, "Nothing happens in it."),
        ({"events": [{"frame": 1, "pres": "left"}]}, "Event 1: "),
    ],
)
def test_file_that_is_no_list_of_events_is_refused(
    tmp_path: Path, content: object, words: str
) -> None:
    with pytest.raises(AssignmentError) as refused:
        read_events(written(tmp_path, content), "input/events.json")

    assert str(refused.value).startswith(f"input/events.json: {words}")
    assert refused.value.hint
