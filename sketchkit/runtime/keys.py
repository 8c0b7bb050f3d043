"""From the keys of a window to Processing's `key` and `keyCode`.

The window tells which key went down and, apart from that and after it, which character it typed:
only the keyboard's layout knows. Processing has both in one event, so a press waits for its
character. The window's key codes are GLFW's; they are plain numbers here.
"""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.api.events import Event, KeyEvent
from sketchkit.core import constants as c

# Keys that always have the same character; no layout has another.
CHARACTERS = {
    256: (c.ESC, 27),
    257: (c.ENTER, 10),
    258: (c.TAB, 9),
    259: (c.BACKSPACE, 8),
    261: (c.DELETE, 127),
    335: (c.ENTER, 10),  # of the number pad
}

# Keys without a character: key is CODED, and keyCode is Java's number.
CODED_KEYS = {
    260: 155,  # Insert
    262: c.RIGHT,
    263: c.LEFT,
    264: c.DOWN,
    265: c.UP,
    266: 33,  # Page up
    267: 34,  # Page down
    268: 36,  # Home
    269: 35,  # End
    280: 20,  # Caps lock
    281: 145,  # Scroll lock
    282: 144,  # Num lock
    283: 154,  # Print screen
    284: 19,  # Pause
    340: c.SHIFT,
    341: c.CONTROL,
    342: c.ALT,
    343: 157,  # Command, Windows
    344: c.SHIFT,
    345: c.CONTROL,
    346: c.ALT,
    347: 157,
    348: 525,  # Menu
    **{302 + number: 61440 + number for number in range(12)},  # F13 to F24
    **{290 + number: 112 + number for number in range(12)},  # F1 to F12
}

# Where GLFW's number of a key that types differs from Java's.
JAVA_CODES = {
    39: 222,  # '
    96: 192,  # `
    330: 110,  # of the number pad: .
    331: 111,  # /
    332: 106,  # *
    333: 109,  # -
    334: 107,  # +
    336: 61,  # =
    **{320 + digit: 96 + digit for digit in range(10)},
}

MODIFIERS = ((1, Event.SHIFT), (2, Event.CTRL), (4, Event.ALT), (8, Event.META))  # GLFW's, ours
CONTROL_MODIFIER = 2  # GLFW's


@dataclass(frozen=True)
class Press:
    """A key that has gone down, and may type a character yet."""

    code: int
    modifiers: int
    is_repeat: bool
    millis: int


class Keys:
    """Joins keys and characters into events."""

    def __init__(self) -> None:
        self._waiting: Press | None = None
        self._down: dict[int, tuple[str, int]] = {}  # by GLFW's code: key and keyCode

    def press(
        self, code: int, modifiers: int, *, is_repeat: bool = False, millis: int = 0
    ) -> list[KeyEvent]:
        """Take a key that went down, or is held; return the events that are complete now."""
        events = self.settle()
        press = Press(code, modifiers, is_repeat, millis)
        if code in CHARACTERS:
            return events + self._typed(press, *CHARACTERS[code])
        if code in CODED_KEYS:
            return events + self._pressed(press, c.CODED, CODED_KEYS[code])
        self._waiting = press
        return events

    def character(self, text: str) -> list[KeyEvent]:
        """Take the character that the last key typed."""
        press, self._waiting = self._waiting, None
        if press is None:
            return [KeyEvent(KeyEvent.TYPE, key=text)]
        return self._typed(press, text, _code(press.code, text))

    def settle(self) -> list[KeyEvent]:
        """Return the press that still waits: no character has come, as with Control held."""
        press, self._waiting = self._waiting, None
        if press is None:
            return []
        text = chr(press.code).lower() if 0 < press.code < 128 else c.CODED
        if press.modifiers & CONTROL_MODIFIER and text.isalpha():
            text = chr(ord(text.upper()) - 64)  # as terminals and Java have it: Ctrl+A is 1
            return self._typed(press, text, press.code)
        return self._pressed(press, text, JAVA_CODES.get(press.code, max(press.code, 0)))

    def release(self, code: int, modifiers: int, *, millis: int = 0) -> list[KeyEvent]:
        """Take a key that came up."""
        events = self.settle()
        text, java_code = self._down.pop(code, (c.CODED, CODED_KEYS.get(code, max(code, 0))))
        action, held = KeyEvent.RELEASE, modifiers_of(modifiers)
        return [*events, KeyEvent(action, held, millis, text, java_code)]

    def _pressed(self, press: Press, text: str, java_code: int) -> list[KeyEvent]:
        self._down[press.code] = text, java_code
        held = modifiers_of(press.modifiers)
        event = KeyEvent(KeyEvent.PRESS, held, press.millis, text, java_code, press.is_repeat)
        return [event]

    def _typed(self, press: Press, text: str, java_code: int) -> list[KeyEvent]:
        events = self._pressed(press, text, java_code)
        held, is_repeat = events[0].modifiers, press.is_repeat
        return [*events, KeyEvent(KeyEvent.TYPE, held, press.millis, text, is_repeat=is_repeat)]


def modifiers_of(modifiers: int) -> int:
    """Return GLFW's modifiers as Processing's."""
    return sum(ours for theirs, ours in MODIFIERS if modifiers & theirs)


def _code(code: int, text: str) -> int:
    """Return keyCode: that of the letter or digit itself, wherever the layout has its key."""
    if text.isascii() and text.isalnum() and code < 128:
        return ord(text.upper())
    return JAVA_CODES.get(code, max(code, 0))  # a key that GLFW does not know is -1
