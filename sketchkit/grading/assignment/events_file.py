"""The file of mouse and keys: what happens in it, and when, in words.

What the events do to a sketch is the runtime's (`replay`).
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.runtime.replay import EventsError, read_replay

EXAMPLE = 'Write {"events": [{"frame": 3, "move": [40, 50]}, {"frame": 4, "press": "left"}]}.'
DONE = {"press": "pressed", "release": "released", "click": "clicked"}


@dataclass(frozen=True)
class Happening:
    """One event.

    Attributes
    ----------
    frame : int
        In which it happens.
    words : str
        "the left mouse button is pressed".
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
        read_replay(path)
    except EventsError as problem:
        said = problem.problem.removeprefix(path.name).lstrip(", ")
        raise AssignmentError(
            f"{said[0].upper()}{said[1:]}", file=name, hint=problem.hint or EXAMPLE
        ) from None
    content = json.loads(path.read_text(encoding="utf-8-sig"))
    events = content["events"] if isinstance(content, Mapping) else content
    if not events:
        raise AssignmentError("Nothing happens in it.", file=name, hint=EXAMPLE)
    happenings = [Happening(event["frame"], _words(event)) for event in events]
    return tuple(sorted(happenings, key=lambda happening: happening.frame))


def _words(event: Mapping[str, object]) -> str:
    match event:
        case {"move": [x, y, *_]}:
            return f"the mouse moves to {x}, {y}"
        case {"drag": [*_, [x, y]]}:
            return f"the mouse is dragged to {x}, {y}"
        case {"press": button} | {"release": button} | {"click": button}:
            done = next(DONE[action] for action in DONE if action in event)
            return f"the {button} mouse button is {done}"
        case {"wheel": _}:
            return "the wheel is turned"
        case {"key": key} | {"keyDown": key}:
            return f"the key {key} is pressed"
        case {"keyUp": key}:
            return f"the key {key} is released"
        case {"type": text}:
            return f"{text!r} is typed"
        case {"resize": [width, height]}:
            return f"the window becomes {width} x {height}"
        case _:
            return "the mouse enters or leaves the window"
