"""The file of mouse and keys: here only what an assignment needs to know of it, and in words.

What the events do to a sketch is the runtime's.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sketchkit.grading.assignment.errors import AssignmentError

EXAMPLE = 'Write {"events": [{"frame": 3, "move": [40, 50]}, {"frame": 4, "press": "left"}]}.'


@dataclass(frozen=True)
class Happening:
    """One event.

    Attributes
    ----------
    frame : int
        Before which it happens.
    words : str
        "the left button is pressed".
    """

    frame: int
    words: str


def read_events(path: Path, name: str) -> tuple[Happening, ...]:
    """Return what happens, in the order of the frames.

    Raises
    ------
    AssignmentError
        If the file is no list of events.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, OSError) as problem:
        line = getattr(problem, "lineno", None)
        raise AssignmentError(
            f"It cannot be read as JSON: {getattr(problem, 'msg', problem)}.",
            file=name,
            line=line,
            hint=EXAMPLE,
        ) from None
    events = content.get("events") if isinstance(content, Mapping) else None
    if not isinstance(events, list) or not events:
        raise AssignmentError("It has no list of events.", file=name, hint=EXAMPLE)
    happenings = [_happening(event, place, name) for place, event in enumerate(events, 1)]
    return tuple(sorted(happenings, key=lambda happening: happening.frame))


def _happening(event: object, place: int, name: str) -> Happening:
    frame = event.get("frame") if isinstance(event, Mapping) else None
    if isinstance(frame, bool) or not isinstance(frame, int) or frame < 0:
        raise AssignmentError(f"Event {place} does not say its frame.", file=name, hint=EXAMPLE)
    assert isinstance(event, Mapping)
    actions = [_words(str(key), value) for key, value in event.items() if key != "frame"]
    return Happening(frame, " and ".join(filter(None, actions)) or "something happens")


def _words(action: str, value: object) -> str:
    match action, value:
        case ("move" | "drag", [x, y, *_]):
            return f"the mouse moves to {x}, {y}"
        case "press", str(button):
            return f"the {button} mouse button is pressed"
        case "release", str(button):
            return f"the {button} mouse button is released"
        case "click", str(button):
            return f"the {button} mouse button is clicked"
        case "wheel", _:
            return "the wheel is turned"
        case action, str(key) if action.lower().startswith("key"):
            done = "released" if "release" in action.lower() else "pressed"
            return f"the key {key!r} is {done}"
        case _:
            return f"{action}: {value}"
