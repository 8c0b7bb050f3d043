from sketchkit.api.events import MouseEvent
from sketchkit.core.constants import CENTER, LEFT, RIGHT
from sketchkit.runtime.mouse import Mouse


def actions(events: list[MouseEvent]) -> list[int]:
    return [event.action for event in events]


def test_button_that_comes_up_in_its_place_is_a_click() -> None:
    mouse = Mouse()
    mouse.move(10, 10)
    mouse.press(0)

    assert actions(mouse.release(0)) == [MouseEvent.RELEASE, MouseEvent.CLICK]


def test_button_that_comes_up_elsewhere_is_none() -> None:
    mouse = Mouse()
    mouse.press(0)
    moved = mouse.move(30, 5)

    assert actions(moved) == [MouseEvent.DRAG]
    assert moved[0].button == LEFT
    assert actions(mouse.release(0)) == [MouseEvent.RELEASE]


def test_clicks_in_a_row_are_counted() -> None:
    mouse = Mouse()
    counts = []
    for millis in (0, 200, 5000):
        mouse.press(0, 0, millis)
        counts.append(mouse.release(0, 0, millis)[-1].count)

    assert counts == [1, 2, 1]


def test_buttons_are_processings() -> None:
    buttons = [Mouse().press(number)[0].button for number in (0, 1, 2)]

    assert buttons == [LEFT, RIGHT, CENTER]
    assert Mouse().press(7) == []


def test_movement_within_a_pixel_is_none() -> None:
    mouse = Mouse()
    mouse.move(10.2, 10)

    assert mouse.move(10.7, 10.3) == []


def test_wheel_counts_downwards_and_adds_small_steps_up() -> None:
    mouse = Mouse()

    assert [event.count for event in mouse.scroll(-2)] == [2]
    assert mouse.scroll(0.5) == []
    assert [event.count for event in mouse.scroll(0.5)] == [-1]
