import json
from collections.abc import Sequence

import pytest

from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.inputs import Live, Recorded, Replayed
from sketchkit.runtime.keys import Keys
from sketchkit.runtime.mouse import Mouse
from sketchkit.runtime.replay import replay_of

SHIFT, CONTROL = 1, 2  # GLFW's numbers
A, KEYPAD_5, ENTER, UP, F5 = 65, 325, 257, 265, 294


def keyed(code: int, text: str = "", held: int = 0) -> Sequence[AnyEvent]:
    """Return what happens in a window when a key goes down and up."""
    keys = Keys()
    events = [*keys.press(code, held), *(keys.character(text) if text else keys.settle())]
    return [*events, *keys.release(code, held)]


def clicked(held: int = 0) -> Sequence[AnyEvent]:
    mouse = Mouse()
    return [*mouse.move(30, 40, 0, held), *mouse.press(1, held), *mouse.release(1, held)]


@pytest.mark.parametrize(
    "happened",
    [
        pytest.param(keyed(A, "a"), id="letter"),
        pytest.param(keyed(A, "A", SHIFT), id="capital letter"),
        pytest.param(keyed(A, "q"), id="another layout"),
        pytest.param(keyed(A, "\u00e9"), id="a letter beyond ASCII"),
        pytest.param(keyed(A, held=CONTROL), id="with Control"),
        pytest.param(keyed(KEYPAD_5, "5"), id="number pad"),
        pytest.param(keyed(32, " "), id="space"),
        pytest.param(keyed(ENTER), id="enter"),
        pytest.param(keyed(UP), id="arrow"),
        pytest.param(keyed(F5), id="function key"),
        pytest.param(clicked(SHIFT), id="click"),
        pytest.param(Mouse().scroll(-2), id="wheel"),
        pytest.param(Mouse().cross_edge(is_inside=True), id="pointer comes"),
        pytest.param([WindowEvent("windowResized", (30, 20))], id="new size"),
        pytest.param([WindowEvent("focusLost")], id="keys go elsewhere"),
    ],
)
def test_what_is_recorded_is_what_the_file_replays(happened: Sequence[AnyEvent]) -> None:
    recorded = Recorded()

    seen = [event for one in happened for event in recorded.take(one, 1)]

    assert seen == list(happened)
    assert list(replay_of(json.loads(recorded.text())).at(1)) == seen


def test_recording_begins_anew_with_the_sketch() -> None:
    recorded = Recorded()
    recorded.take(WindowEvent("focusLost"), 5)

    recorded.begin()

    assert json.loads(recorded.text()) == {"events": []}


def test_replayed_file_is_heard_and_the_user_is_not() -> None:
    inputs = Replayed(replay_of([{"frame": 2, "wheel": 1}]))

    assert [len(inputs.at(frame)) for frame in (1, 2, 3)] == [0, 1, 0]
    assert not inputs.take(WindowEvent("focusLost"), 1)


def test_live_events_are_handed_on() -> None:
    event = WindowEvent("focusLost")

    assert list(Live().take(event, 1)) == [event]
