import pytest

from sketchkit.api.events import KeyEvent
from sketchkit.core.constants import BACKSPACE, CODED, CONTROL, DELETE, ENTER, LEFT
from sketchkit.runtime.keys import Keys

A, ONE, QUOTE, KEYPAD_5 = 65, 49, 39, 325  # GLFW's numbers


def brief(events: list[KeyEvent]) -> list[tuple[int, str, int]]:
    return [(event.action, event.key, event.keyCode) for event in events]


@pytest.mark.parametrize(
    ("code", "character", "key_code"),
    [
        pytest.param(A, "a", 65, id="a small letter has the capital's number"),
        pytest.param(A, "q", 81, id="the layout says which letter it is"),
        pytest.param(ONE, "1", 49, id="digit"),
        pytest.param(QUOTE, "'", 222, id="Java's number of a sign"),
        pytest.param(KEYPAD_5, "5", 101, id="number pad"),
        pytest.param(A, "\u00e9", 65, id="a letter beyond ASCII"),
    ],
)
def test_press_waits_for_its_character(code: int, character: str, key_code: int) -> None:
    keys = Keys()

    waiting = keys.press(code, 0)
    events = keys.character(character)

    assert waiting == []
    assert brief(events) == [
        (KeyEvent.PRESS, character, key_code),
        (KeyEvent.TYPE, character, 0),
    ]


def test_release_remembers_the_character() -> None:
    keys = Keys()
    keys.press(A, 1)
    keys.character("A")

    assert brief(keys.release(A, 0)) == [(KeyEvent.RELEASE, "A", 65)]


@pytest.mark.parametrize(
    ("code", "key", "key_code"),
    [
        pytest.param(263, CODED, LEFT, id="arrow"),
        pytest.param(341, CODED, CONTROL, id="control"),
        pytest.param(290, CODED, 112, id="F1"),
        pytest.param(257, ENTER, 10, id="enter"),
        pytest.param(261, DELETE, 127, id="delete"),
    ],
)
def test_keys_that_need_no_layout_come_at_once(code: int, key: str, key_code: int) -> None:
    assert brief(Keys().press(code, 0))[0] == (KeyEvent.PRESS, key, key_code)


@pytest.mark.parametrize(("code", "typed"), [(257, [ENTER]), (259, [BACKSPACE]), (263, [])])
def test_enter_and_backspace_type_and_arrows_do_not(code: int, typed: list[str]) -> None:
    events = Keys().press(code, 0)

    assert [event.key for event in events if event.action == KeyEvent.TYPE] == typed


def test_control_and_a_letter_is_a_control_character() -> None:
    keys = Keys()
    keys.press(A, 2)

    assert brief(keys.settle()) == [(KeyEvent.PRESS, "\x01", 65), (KeyEvent.TYPE, "\x01", 0)]


def test_two_presses_in_a_row_keep_their_order() -> None:
    keys = Keys()
    keys.press(A, 0)

    events = keys.press(263, 0)

    assert brief(events) == [(KeyEvent.PRESS, "a", 65), (KeyEvent.PRESS, CODED, LEFT)]


def test_modifiers_are_processings() -> None:
    (event,) = Keys().press(263, 1 | 4)

    assert event.isShiftDown()
    assert event.isAltDown()
    assert not event.isControlDown()
