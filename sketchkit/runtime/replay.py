"""Replaying what a hand did: an events file, written by hand or recorded in a window.

The file is JSON, `{"events": [...]}`. Each entry names a frame and one thing that happens in it:

    {"frame": 3, "move": [40, 50]}                     the pointer moves; drags if a button is held
    {"frame": 4, "press": "left", "at": [40, 50]}      "left", "right" or "center"; "at" moves first
    {"frame": 9, "release": "left"}
    {"frame": 12, "click": "left", "at": [10, 20]}     press and release
    {"frame": 20, "drag": [[10, 20], [80, 20]], "frames": 10, "button": "right"}
    {"frame": 35, "wheel": 2}                          notches, positive downwards
    {"frame": 40, "key": "a"}                          press and release; or "UP", "SHIFT", "ENTER"
    {"frame": 41, "keyDown": "UP"}, {"frame": 60, "keyUp": "UP"}
    {"frame": 61, "type": "hello"}                     each character pressed and released
    {"frame": 70, "enter": true}, {"frame": 71, "exit": true}
    {"frame": 72, "resize": [300, 200]}                before that frame's `draw()`
    {"frame": 73, "focus": false}                      other windows get the keys; true: this one

`"with": ["SHIFT", "CTRL"]` adds keys that are held meanwhile. A `keyDown` that comes from holding
the key has `"repeat": true`; `"code"` is GLFW's number of a key that is not the character's own, as
on the number pad.

As in Processing, what happens in a frame is handled when its `draw()` has ended: a handler draws on
that frame's picture, and `draw()` sees the new `mouseX` in the next one. Only what happens to the
window comes before `draw()`. If the sketch has stopped by `noLoop()`, frames go on being counted, a
60th of a second each.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from sketchkit.core.clock import milliseconds_of
from sketchkit.core.errors import SketchError, nearest
from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.keys import Keys
from sketchkit.runtime.mouse import Mouse

BUTTONS = {"left": 0, "right": 1, "center": 2}  # GLFW's numbers
MODIFIERS = {"SHIFT": 1, "CTRL": 2, "ALT": 4, "META": 8}  # GLFW's numbers
CONTROL, ALT = MODIFIERS["CTRL"], MODIFIERS["ALT"]
# Keys that are written by name: GLFW's numbers.
KEYS = {
    "ESC": 256, "ENTER": 257, "RETURN": 257, "TAB": 258, "BACKSPACE": 259, "INSERT": 260,
    "DELETE": 261, "RIGHT": 262, "LEFT": 263, "DOWN": 264, "UP": 265, "PAGE_UP": 266,
    "PAGE_DOWN": 267, "HOME": 268, "END": 269, "SHIFT": 340, "CONTROL": 341, "ALT": 342,
    "META": 343, "CAPS_LOCK": 280, "SCROLL_LOCK": 281, "NUM_LOCK": 282, "PRINT_SCREEN": 283,
    "PAUSE": 284, "MENU": 348, **{f"F{number}": 289 + number for number in range(1, 25)},
}  # fmt: skip # many short ones
BESIDE = {
    "frame",
    "at",
    "with",
    "button",
    "frames",
    "code",
    "repeat",
}  # what an entry has besides what happens
LAST_FRAME = 1_000_000  # four and a half hours

Number = int | float
Entry = Mapping[str, object]


class EventsError(SketchError):
    """An events file cannot be used."""


@dataclass
class Replay:
    """What happens in each frame.

    Attributes
    ----------
    events : dict of int to list
        By frame, from 1.
    """

    events: dict[int, list[AnyEvent]] = field(default_factory=dict)

    def at(self, frame: int) -> Sequence[AnyEvent]:
        """Return what happens in a frame, in order."""
        return self.events.get(frame, ())

    def goes_on_after(self, frame: int) -> bool:
        """Return whether anything happens later."""
        return any(later > frame for later in self.events)


def read_replay(path: Path) -> Replay:
    """Read an events file.

    Raises
    ------
    EventsError
        If there is none, or something in it cannot be understood.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8-sig"))
    except OSError as reason:
        raise EventsError(
            f"The events file {path.name} cannot be read: {reason.strerror}."
        ) from None
    except (json.JSONDecodeError, UnicodeDecodeError, RecursionError) as reason:
        line = f", line {reason.lineno}" if isinstance(reason, json.JSONDecodeError) else ""
        raise EventsError(f"{path.name}{line} is not JSON.", got=f"{reason}") from None
    return replay_of(content, path.name)


def replay_of(content: object, name: str = "the events file") -> Replay:
    """Return what the content of an events file means.

    Parameters
    ----------
    content : object
        As JSON has it.
    name : str
        What messages call it.

    Raises
    ------
    EventsError
        If something in it cannot be understood.
    """
    entries = content.get("events") if isinstance(content, dict) else content
    if not isinstance(entries, list):
        raise EventsError(
            f"{name} has no list of events.", hint='Write {"events": [{"frame": 1, "key": "a"}]}.'
        )
    steps: list[_Step] = []
    for index, entry in enumerate(entries, 1):
        try:
            steps += _steps(entry)
        except _EntryError as problem:
            raise EventsError(
                f"{name}, event {index}: {problem}", got=json.dumps(entry)[:200]
            ) from None
    return _perform(steps)


class _EntryError(Exception):
    """An entry is wrong; the message is a sentence."""


@dataclass(frozen=True)
class _Step:
    """One thing that the hand does: what, in which frame, holding which keys."""

    frame: int
    action: Callable[[Hand, int, int], Sequence[AnyEvent]]
    modifiers: int = 0


class Hand:
    """The mouse and the keyboard that are moved."""

    def __init__(self) -> None:
        self.mouse = Mouse()
        self.keys = Keys()

    def does(self, entry: Entry) -> Sequence[AnyEvent]:
        """Do what an entry of an events file says; return what it makes happen in its frame."""
        return [event for step in _steps(entry) for event in self.takes(step)]

    def takes(self, step: _Step) -> Sequence[AnyEvent]:
        """Do one thing; return what it makes happen."""
        return step.action(self, step.modifiers, milliseconds_of(step.frame))


def _perform(steps: list[_Step]) -> Replay:
    """Let a hand take all steps, in order of their frames."""
    hand, replay = Hand(), Replay()
    for step in sorted(steps, key=lambda step: step.frame):
        events = hand.takes(step)
        if events:
            replay.events.setdefault(step.frame, []).extend(events)
    return replay


def _steps(entry: object) -> Iterator[_Step]:
    """Yield what one entry means."""
    if not isinstance(entry, dict):
        raise _EntryError('An event is written in braces: {"frame": 1, "key": "a"}.')
    actions = [name for name in entry if name not in BESIDE]
    unknown = [name for name in actions if name not in ACTIONS]
    if unknown:
        known = nearest(unknown[0], [*ACTIONS, *BESIDE])
        raise _EntryError(
            f"There is no {unknown[0]!r}." + (f" Do you mean {known}?" if known else "")
        )
    if len(actions) != 1:
        raise _EntryError(f"One of these is wanted: {', '.join(ACTIONS)}.")
    frame, modifiers = _frame(entry), _modifiers(entry)
    if "at" in entry:
        yield _move(frame, _place(entry["at"]))
    for step in ACTIONS[actions[0]](frame, entry[actions[0]], entry):
        yield _Step(step.frame, step.action, modifiers)


def _frame(entry: Entry) -> int:
    frame = entry.get("frame")
    if isinstance(frame, bool) or not isinstance(frame, int) or not 1 <= frame <= LAST_FRAME:
        raise _EntryError('"frame" is a whole number from 1 on.')
    return frame


def _modifiers(entry: Entry) -> int:
    names = entry.get("with", [])
    names = [names] if isinstance(names, str) else names
    if not isinstance(names, list) or not all(name in MODIFIERS for name in names):
        raise _EntryError(f'"with" is a list of {", ".join(MODIFIERS)}.')
    return sum({MODIFIERS[name] for name in names})


def _place(value: object) -> tuple[Number, Number]:
    match value:
        case [int() | float() as x, int() | float() as y]:
            return x, y
    raise _EntryError("A place is written [x, y], in pixels from the top left.")


def _button(value: object) -> int:
    if value not in BUTTONS:
        raise _EntryError(f"A button is one of {', '.join(BUTTONS)}.")
    return BUTTONS[str(value)]


def _move(frame: int, place: tuple[Number, Number]) -> _Step:
    return _Step(frame, lambda hand, held, millis: hand.mouse.move(*place, millis, held))


def _press(frame: int, button: int) -> _Step:
    return _Step(frame, lambda hand, held, millis: hand.mouse.press(button, held, millis))


def _release(frame: int, button: int) -> _Step:
    return _Step(frame, lambda hand, held, millis: hand.mouse.release(button, held, millis))


def _steps_of_move(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    yield _move(frame, _place(value))


def _steps_of_press(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    yield _press(frame, _button(value))


def _steps_of_release(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    yield _release(frame, _button(value))


def _steps_of_click(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    button = _button(value)
    yield _press(frame, button)
    yield _release(frame, button)


def _steps_of_drag(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    """Press at the first place, move evenly to the last, and let go there."""
    count = entry.get("frames", 10)
    if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= LAST_FRAME:
        raise _EntryError('"frames" is how many frames the drag takes: a whole number.')
    if not isinstance(value, list) or len(value) < 2:
        raise _EntryError("A drag is written [[x, y], [x, y]]: from where to where.")
    places = [_place(place) for place in value]
    button = _button(entry.get("button", "left"))
    yield _move(frame, places[0])
    yield _press(frame, button)
    for step in range(1, count + 1):
        yield _move(frame + step, _along(places, step / count))
    yield _release(frame + count, button)


def _along(places: Sequence[tuple[Number, Number]], part: float) -> tuple[float, float]:
    """Return the place after a part, 0..1, of a way of equally long stretches of time."""
    whole = part * (len(places) - 1)
    index = min(int(whole), len(places) - 2)
    (x1, y1), (x2, y2) = places[index], places[index + 1]
    rest = whole - index
    return x1 + (x2 - x1) * rest, y1 + (y2 - y1) * rest


def _steps_of_wheel(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    if isinstance(value, bool) or not isinstance(value, int):
        raise _EntryError('"wheel" is a whole number of notches, positive downwards.')
    notches = -value  # the mouse counts them positive away from the user
    yield _Step(frame, lambda hand, held, millis: hand.mouse.scroll(notches, millis, held))


def _steps_of_key(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    yield from _steps_of_key_down(frame, value, entry)
    yield from _steps_of_key_up(frame, value, entry)


def _steps_of_key_down(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    code, text = _key(value, entry)
    is_repeat = entry.get("repeat") is True

    def press(hand: Hand, held: int, millis: int) -> Sequence[AnyEvent]:
        events = hand.keys.press(code, held, is_repeat=is_repeat, millis=millis)
        is_control = held & CONTROL and not held & ALT  # these two together are AltGr
        is_typed = text and not is_control
        return [*events, *(hand.keys.character(text) if is_typed else hand.keys.settle())]

    yield _Step(frame, press)


def _steps_of_key_up(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    code, _ = _key(value, entry)
    yield _Step(frame, lambda hand, held, millis: hand.keys.release(code, held, millis=millis))


def _steps_of_type(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    if not isinstance(value, str):
        raise _EntryError('"type" is a text.')
    for character in value:
        yield from _steps_of_key(frame, "ENTER" if character == "\n" else character, entry)


def _key(value: object, entry: Entry) -> tuple[int, str]:
    """Return GLFW's number of a key, and the character that it types."""
    code = entry.get("code")
    if code is not None and (isinstance(code, bool) or not isinstance(code, int)):
        raise _EntryError('"code" is a whole number.')
    if value in KEYS:
        return KEYS[str(value)], ""
    if not isinstance(value, str) or len(value) != 1:
        raise _EntryError(f"A key is one character, or one of {', '.join(KEYS)}.")
    return ord(value.upper()[0]) if code is None else code, value


def _steps_of_edge(is_inside: bool) -> Callable[[int, object, Entry], Iterator[_Step]]:
    def steps(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
        yield _Step(
            frame, lambda hand, held, millis: hand.mouse.cross_edge(is_inside, millis, held)
        )

    return steps


def _steps_of_resize(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    width, height = (int(side) for side in _place(value))
    if not (0 < width <= 16384 and 0 < height <= 16384):
        raise _EntryError('"resize" is [width, height], in pixels.')
    yield _Step(frame, lambda *_: [WindowEvent("windowResized", (width, height))])


def _steps_of_focus(frame: int, value: object, entry: Entry) -> Iterator[_Step]:
    handler = "focusGained" if value else "focusLost"
    yield _Step(frame, lambda *_: [WindowEvent(handler)])


ACTIONS: dict[str, Callable[[int, object, Entry], Iterator[_Step]]] = {
    "move": _steps_of_move,
    "press": _steps_of_press,
    "release": _steps_of_release,
    "click": _steps_of_click,
    "drag": _steps_of_drag,
    "wheel": _steps_of_wheel,
    "key": _steps_of_key,
    "keyDown": _steps_of_key_down,
    "keyUp": _steps_of_key_up,
    "type": _steps_of_type,
    "enter": _steps_of_edge(is_inside=True),
    "exit": _steps_of_edge(is_inside=False),
    "resize": _steps_of_resize,
    "focus": _steps_of_focus,
}
