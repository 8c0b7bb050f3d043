"""Where the events of a sketch in a window come from: its user, who may be recorded, or a file.

A recorded hand is one that `render --input` replays exactly. So the sketch has `render`'s clock and
random numbers meanwhile, and sees each event as the file will have it.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Protocol

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.core.constants import CODED
from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.keys import CHARACTERS, CODED_KEYS, JAVA_CODES
from sketchkit.runtime.keys import MODIFIERS as KEY_MODIFIERS
from sketchkit.runtime.mouse import BUTTONS as MOUSE_BUTTONS
from sketchkit.runtime.replay import BUTTONS, KEYS, MODIFIERS, Hand, Replay

Entry = dict[str, object]

BUTTON_NAMES = {MOUSE_BUTTONS[number]: name for name, number in BUTTONS.items()}
KEY_NAMES = {code: name for name, code in reversed(KEYS.items())}


class Inputs(Protocol):
    """Where events come from. `frame` counts from 1; after `noLoop()` it goes on."""

    @property
    def is_repeatable(self) -> bool:
        """Whether time and random numbers are to be as in `render`."""
        ...

    def begin(self) -> None:
        """Take that the sketch begins, for the first time or anew."""
        ...

    def take(self, event: AnyEvent, frame: int) -> Sequence[AnyEvent]:
        """Return what becomes of an event of the window."""
        ...

    def at(self, frame: int) -> Sequence[AnyEvent]:
        """Return what happens in a frame besides."""
        ...


class Live:
    """The user's own hand."""

    is_repeatable = False

    def begin(self) -> None:
        """Do nothing."""

    def take(self, event: AnyEvent, frame: int) -> Sequence[AnyEvent]:
        """Return the event."""
        return [event]

    def at(self, frame: int) -> Sequence[AnyEvent]:
        """Return nothing."""
        return ()


class Replayed:
    """A file's events; those of the window are not heard."""

    is_repeatable = True

    def __init__(self, replay: Replay) -> None:
        self._replay = replay

    def begin(self) -> None:
        """Do nothing: frames are counted by whoever plays."""

    def take(self, event: AnyEvent, frame: int) -> Sequence[AnyEvent]:
        """Return nothing."""
        return ()

    def at(self, frame: int) -> Sequence[AnyEvent]:
        """Return what the file has for a frame."""
        return self._replay.at(frame)


class Recorded:
    """The user's hand, written down."""

    is_repeatable = True

    def __init__(self) -> None:
        self._hand = Hand()
        self._entries: list[Entry] = []
        self._pressed = ""  # the character of the last event, if a key went down

    def begin(self) -> None:
        """Forget what was before: the file is about the sketch as it is now."""
        self._hand = Hand()
        self._entries.clear()

    def take(self, event: AnyEvent, frame: int) -> Sequence[AnyEvent]:
        """Write an event down, and return what the file will make of it."""
        pressed, self._pressed = self._pressed, ""
        match event:
            case MouseEvent():
                entry = _mouse_entry(event)
            case KeyEvent(action=KeyEvent.TYPE):
                entry = {} if event.key == pressed else {"type": event.key}
            case KeyEvent():
                self._pressed = event.key if event.action == KeyEvent.PRESS else ""
                entry = _key_entry(event)
            case WindowEvent():
                entry = _window_entry(event)
        if not entry:
            return ()
        self._entries.append({"frame": frame} | entry)
        return self._hand.does(self._entries[-1])

    def at(self, frame: int) -> Sequence[AnyEvent]:
        """Return nothing."""
        return ()

    def text(self) -> str:
        """Return the events file."""
        lines = ",\n  ".join(json.dumps(entry, ensure_ascii=False) for entry in self._entries)
        return '{"events": [\n  ' + lines + "\n]}\n"


def _mouse_entry(event: MouseEvent) -> Entry:
    """Return an event of the mouse as an events file has it; empty for what follows by itself."""
    match event.action:
        case MouseEvent.MOVE | MouseEvent.DRAG:
            entry: Entry = {"move": [event.x, event.y]}
        case MouseEvent.PRESS:
            entry = {"press": BUTTON_NAMES[event.button], "at": [event.x, event.y]}
        case MouseEvent.RELEASE:
            entry = {"release": BUTTON_NAMES[event.button]}
        case MouseEvent.WHEEL:
            entry = {"wheel": event.count}
        case MouseEvent.ENTER:
            entry = {"enter": True}
        case MouseEvent.EXIT:
            entry = {"exit": True}
        case _:  # a click is made of press and release
            return {}
    return entry | _held(event.modifiers)


def _key_entry(event: KeyEvent) -> Entry:
    """Return a key that went down or up as an events file has it."""
    what = "keyDown" if event.action == KeyEvent.PRESS else "keyUp"
    code = _glfw_code(event)
    repeat: Entry = {"repeat": True} if event.is_repeat else {}
    if code in KEY_NAMES:
        return {what: KEY_NAMES[code]} | repeat | _held(event.modifiers)
    text = event.key
    if text == CODED or ord(text) < 32:
        text = chr(code).lower() if 32 < code < 127 else ""
    if not text:
        return {}  # a key that no name is known for
    own: Entry = {} if code == ord(text.upper()[0]) else {"code": code}
    return {what: text} | own | repeat | _held(event.modifiers)


def _window_entry(event: WindowEvent) -> Entry:
    if event.size:
        return {"resize": list(event.size)}
    if event.handler in ("focusGained", "focusLost"):
        return {"focus": event.handler == "focusGained"}
    return {}


def _glfw_code(event: KeyEvent) -> int:
    """Return GLFW's number of a key; of two keys that sketches cannot tell apart, the first."""
    if event.key == CODED:
        return next((g for g, java in CODED_KEYS.items() if java == event.keyCode), event.keyCode)
    if (event.key, event.keyCode) in CHARACTERS.values():
        return next(g for g, pair in CHARACTERS.items() if pair == (event.key, event.keyCode))
    return next((g for g, java in JAVA_CODES.items() if java == event.keyCode), event.keyCode)


def _held(modifiers: int) -> Entry:
    """Return which keys are held, as an events file has it."""
    ours = dict(KEY_MODIFIERS)
    names = [name for name, number in MODIFIERS.items() if modifiers & ours[number]]
    return {"with": names} if names else {}
