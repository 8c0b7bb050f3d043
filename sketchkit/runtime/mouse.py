"""From the pointer over a window to Processing's mouse events: clicks, drags, the wheel."""

from __future__ import annotations

from sketchkit.api.events import MouseEvent
from sketchkit.core.constants import CENTER, LEFT, RIGHT
from sketchkit.runtime.keys import modifiers_of

BUTTONS = {0: LEFT, 1: RIGHT, 2: CENTER}  # GLFW's numbers
CLICK_DISTANCE = 3  # px: a hand is never quite still
DOUBLE_CLICK_MS = 500
NEVER_MS = -DOUBLE_CLICK_MS


class Mouse:
    """Joins movements and buttons into events. Places are in the sketch's own pixels."""

    def __init__(self) -> None:
        self._x = self._y = 0
        self._modifiers = 0
        self._held: list[int] = []  # buttons, the last one pressed at the end
        self._pressed_at = (0, 0)
        self._has_dragged = False
        self._clicks = 0
        self._clicked: tuple[int, int] = 0, NEVER_MS  # the button of the last click, and when
        self._wheel = 0.0  # what is left of touchpads' small steps

    def move(self, x: float, y: float, millis: int = 0, modifiers: int = 0) -> list[MouseEvent]:
        """Take the pointer's new place."""
        self._modifiers = modifiers_of(modifiers)
        place = int(x // 1), int(y // 1)
        if place == (self._x, self._y):
            return []
        self._x, self._y = place
        if not self._held:
            return [self._event(MouseEvent.MOVE, 0, 0, millis)]
        if not self._is_near_press():
            self._has_dragged = True
        return [self._event(MouseEvent.DRAG, self._held[-1], 1, millis)]

    def press(self, number: int, modifiers: int = 0, millis: int = 0) -> list[MouseEvent]:
        """Take a button that went down."""
        button = BUTTONS.get(number)
        if button is None:
            return []
        self._modifiers = modifiers_of(modifiers)
        last, clicked_ms = self._clicked
        is_soon = millis - clicked_ms < DOUBLE_CLICK_MS
        is_again = last == button and is_soon and self._is_near_press()
        self._clicks = self._clicks + 1 if is_again else 1
        self._held.append(button)
        self._pressed_at, self._has_dragged = (self._x, self._y), False
        return [self._event(MouseEvent.PRESS, button, self._clicks, millis)]

    def release(self, number: int, modifiers: int = 0, millis: int = 0) -> list[MouseEvent]:
        """Take a button that came up."""
        button = BUTTONS.get(number)
        if button is None or button not in self._held:
            return []
        self._modifiers = modifiers_of(modifiers)
        self._held.remove(button)
        events = [self._event(MouseEvent.RELEASE, button, self._clicks, millis)]
        if not self._has_dragged:
            self._clicked = button, millis
            events.append(self._event(MouseEvent.CLICK, button, self._clicks, millis))
        return events

    def scroll(self, notches: float, millis: int = 0, modifiers: int = 0) -> list[MouseEvent]:
        """Take a turn of the wheel, positive away from the user.

        Of a touchpad's small steps, each that fills a notch is an event.
        """
        self._modifiers = modifiers_of(modifiers)
        self._wheel -= notches
        whole = int(self._wheel)
        if whole == 0:
            return []
        self._wheel -= whole
        return [self._event(MouseEvent.WHEEL, 0, whole, millis)]

    def cross_edge(self, is_inside: bool, millis: int = 0, modifiers: int = 0) -> list[MouseEvent]:
        """Take that the pointer has come over the window, or left it."""
        self._modifiers = modifiers_of(modifiers)
        action = MouseEvent.ENTER if is_inside else MouseEvent.EXIT
        return [self._event(action, 0, 0, millis)]

    def _is_near_press(self) -> bool:
        x, y = self._pressed_at
        return max(abs(self._x - x), abs(self._y - y)) <= CLICK_DISTANCE

    def _event(self, action: int, button: int, count: int, millis: int) -> MouseEvent:
        return MouseEvent(action, self._modifiers, millis, self._x, self._y, button, count)
