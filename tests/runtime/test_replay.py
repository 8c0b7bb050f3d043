from __future__ import annotations

import json
from pathlib import Path
from textwrap import dedent

import pytest

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.backends.listing import ListingBackend
from sketchkit.core.constants import CODED, ENTER, LEFT, RIGHT, UP
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.replay import EventsError, Replay, read_replay, replay_of
from tests.runtime.sketches import written

ACTIONS = {
    MouseEvent.PRESS: "press",
    MouseEvent.RELEASE: "release",
    MouseEvent.CLICK: "click",
    MouseEvent.DRAG: "drag",
    MouseEvent.MOVE: "move",
    MouseEvent.ENTER: "enter",
    MouseEvent.EXIT: "exit",
    MouseEvent.WHEEL: "wheel",
}


def mouse(*entries: dict[str, object]) -> list[tuple[int, str, int, int, int]]:
    """Return frame, action, x, y and button (or notches) of each event of the mouse."""
    replay = replay_of({"events": list(entries)})
    return [
        (frame, ACTIONS[e.action], e.x, e.y, e.count if e.action == e.WHEEL else e.button)
        for frame, events in sorted(replay.events.items())
        for e in events
        if isinstance(e, MouseEvent)
    ]


def keys(*entries: dict[str, object]) -> list[tuple[int, int, str, int]]:
    """Return frame, action, key and keyCode of each event of the keyboard."""
    replay = replay_of({"events": list(entries)})
    return [
        (frame, e.action, e.key, e.keyCode)
        for frame, events in sorted(replay.events.items())
        for e in events
        if isinstance(e, KeyEvent)
    ]


def run(folder: Path, text: str, replay: Replay, frames: int) -> list[str]:
    """Run a sketch; return what it has written to its list `seen`."""
    sketch = written(folder, dedent(text) + "\ndef dispose():\n    saveStrings('seen.txt', seen)\n")
    launch = Launch(sketch, lambda *_: None, replay=replay)
    list(render(launch, [frames], ListingBackend()))
    return (folder / "seen.txt").read_text().split("\n")[:-1]


def test_click_presses_and_releases_where_it_says() -> None:
    assert mouse({"frame": 2, "click": "left", "at": [10, 20]}) == [
        (2, "move", 10, 20, 0),
        (2, "press", 10, 20, LEFT),
        (2, "release", 10, 20, LEFT),
        (2, "click", 10, 20, LEFT),
    ]


def test_pointer_that_moves_with_a_button_held_drags() -> None:
    assert mouse(
        {"frame": 1, "press": "right"},
        {"frame": 2, "move": [9, 9]},
        {"frame": 3, "release": "right"},
    ) == [(1, "press", 0, 0, RIGHT), (2, "drag", 9, 9, RIGHT), (3, "release", 9, 9, RIGHT)]


def test_drag_moves_evenly_and_lets_go_in_its_last_frame() -> None:
    events = mouse({"frame": 5, "drag": [[0, 0], [8, 4]], "frames": 2})

    assert events == [
        (5, "press", 0, 0, LEFT),
        (6, "drag", 4, 2, LEFT),
        (7, "drag", 8, 4, LEFT),
        (7, "release", 8, 4, LEFT),
    ]


def test_entries_are_taken_in_the_order_of_their_frames() -> None:
    assert mouse({"frame": 9, "wheel": -3}, {"frame": 1, "enter": True}) == [
        (1, "enter", 0, 0, 0),
        (9, "wheel", 0, 0, -3),
    ]


def test_key_is_pressed_typed_and_released() -> None:
    assert keys({"frame": 3, "key": "a"}) == [
        (3, KeyEvent.PRESS, "a", ord("A")),
        (3, KeyEvent.TYPE, "a", 0),
        (3, KeyEvent.RELEASE, "a", ord("A")),
    ]


def test_keys_without_a_character_are_coded() -> None:
    assert keys({"frame": 1, "keyDown": "UP"}, {"frame": 4, "keyUp": "UP"}) == [
        (1, KeyEvent.PRESS, CODED, UP),
        (4, KeyEvent.RELEASE, CODED, UP),
    ]


def test_text_is_typed_character_by_character() -> None:
    pressed = [key for _, action, key, _ in keys({"frame": 1, "type": "Ab\n"}) if action == 1]

    assert pressed == ["A", "b", ENTER]


def test_keys_held_meanwhile_are_modifiers() -> None:
    replay = replay_of({"events": [{"frame": 1, "press": "left", "with": ["SHIFT", "CTRL"]}]})

    (event,) = replay.at(1)
    assert isinstance(event, MouseEvent)
    assert (event.isShiftDown(), event.isControlDown(), event.isAltDown()) == (True, True, False)


def test_events_are_handled_after_draw_of_their_frame(tmp_path: Path) -> None:
    seen = run(
        tmp_path,
        """
        seen = []
        def setup():
            size(50, 50)
        def draw():
            seen.append(f"draw {frameCount} {mouseX} {mousePressed} {millis()}")
        def mousePressed():
            seen.append(f"pressed {frameCount} {mouseX}")
        """,
        replay_of([{"frame": 2, "press": "left", "at": [30, 10]}, {"frame": 3, "release": "left"}]),
        4,
    )

    assert seen == [
        "draw 1 0 False 0",
        "draw 2 0 False 17",
        "pressed 2 30",
        "draw 3 30 True 33",
        "draw 4 30 False 50",
    ]


def test_sketch_that_does_not_loop_is_woken_by_events(tmp_path: Path) -> None:
    seen = run(
        tmp_path,
        """
        seen = []
        def setup():
            noLoop()
        def draw():
            seen.append(f"draw {frameCount}")
        def keyPressed():
            seen.append(f"key {key} {millis()}")
            redraw()
        """,
        replay_of([{"frame": 10, "key": "x"}]),
        20,
    )

    assert seen == ["draw 1", "key x 150", "draw 2"]


def test_window_that_is_resized_gives_the_sketch_its_new_size(tmp_path: Path) -> None:
    seen = run(
        tmp_path,
        """
        seen = []
        def setup():
            size(50, 50)
        def draw():
            seen.append(f"{width} {height}")
        """,
        replay_of([{"frame": 2, "resize": [70, 60]}]),
        2,
    )

    assert seen == ["50 50", "70 60"]


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ({"frame": 1, "clik": "left"}, "Do you mean click?"),
        ({"frame": 1}, "One of these is wanted: move, press"),
        ({"frame": 1, "key": "a", "wheel": 1}, "One of these is wanted"),
        ({"key": "a"}, '"frame" is a whole number from 1 on.'),
        ({"frame": 0, "key": "a"}, '"frame" is a whole number from 1 on.'),
        ({"frame": True, "key": "a"}, '"frame" is a whole number from 1 on.'),
        ({"frame": 1, "press": "lefft"}, "A button is one of left, right, center."),
        ({"frame": 1, "move": [1]}, "A place is written [x, y]"),
        ({"frame": 1, "key": "UPP"}, "A key is one character, or one of ESC"),
        ({"frame": 1, "drag": [[0, 0]]}, "A drag is written [[x, y], [x, y]]"),
        ({"frame": 1, "drag": [[0, 0], [1, 1]], "frames": 0}, '"frames" is how many'),
        ({"frame": 1, "wheel": 0.5}, '"wheel" is a whole number of notches'),
        ({"frame": 1, "key": "a", "with": ["SHIF"]}, '"with" is a list of SHIFT'),
        ({"frame": 1, "type": 3}, '"type" is a text.'),
        ({"frame": 1, "resize": [0, 5]}, '"resize" is [width, height]'),
        ("a", "An event is written in braces"),
    ],
)
def test_entry_that_cannot_be_understood_is_told_by_its_number(entry: object, said: str) -> None:
    good = {"frame": 1, "key": "a"}

    with pytest.raises(EventsError) as caught:
        replay_of({"events": [good, entry]}, "events.json")

    assert str(caught.value).startswith("events.json, event 2: ")
    assert said in str(caught.value)


def test_content_without_a_list_is_refused() -> None:
    with pytest.raises(EventsError, match="has no list of events"):
        replay_of({"event": []})


def test_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "events.json"
    path.write_text(json.dumps({"events": [{"frame": 7, "exit": True}]}), encoding="utf-8-sig")

    assert list(read_replay(path).events) == [7]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b'{"events": [\n{"frame": 1,}]}', "events.json, line 2 is not JSON."),
        (b"\xff\xfe{", "events.json is not JSON."),
        (b"[" * 100_000, "events.json"),
    ],
    ids=["comma", "encoding", "depth"],
)
def test_file_that_is_no_json_is_told_with_its_line(tmp_path: Path, data: bytes, said: str) -> None:
    path = tmp_path / "events.json"
    path.write_bytes(data)

    with pytest.raises(EventsError) as caught:
        read_replay(path)

    assert said in str(caught.value)


def test_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(EventsError, match="cannot be read"):
        read_replay(tmp_path / "events.json")
