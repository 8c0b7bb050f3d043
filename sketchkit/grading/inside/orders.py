"""Orders: what a process behind the wall is told to do. They travel as JSON on its command line."""

from __future__ import annotations

import json
from dataclasses import dataclass

from sketchkit.grading.results import from_json, to_json

SUBMISSION = "/submission"  # the sketch's folder
EVENTS = "/events.json"
TAPE = "/tape"
LARGEST_SIDE = 8192  # px of a picture


@dataclass(frozen=True)
class RecordOrder:
    """Run a sketch and write a tape.

    Attributes
    ----------
    sketch : str
        Its file, relative to its folder.
    last : int
        The last frame that is wanted.
    renderer : str
        What draws, should the sketch read its own picture.
    seed : int
    watched : tuple of str
        Values of the sketch to write down after each frame.
    has_events : bool
        Whether there is an events file to replay.
    """

    sketch: str
    last: int
    renderer: str
    seed: int = 0
    watched: tuple[str, ...] = ()
    has_events: bool = False


@dataclass(frozen=True)
class RedrawOrder:
    """Draw what a tape says, and look into it.

    Attributes
    ----------
    renderer : str
    frames : tuple of int
        Whose pictures are wanted.
    traces : tuple of int
        Frames that are looked into.
    varied : tuple of int
        Frames whose pictures are wanted in each of `VARIANTS` too.
    watched : tuple of str
        The values that the tape has.
    reads_source : bool
        Whether the sketch's own text is there, to be looked at.
    """

    renderer: str
    frames: tuple[int, ...]
    traces: tuple[int, ...] = ()
    varied: tuple[int, ...] = ()
    watched: tuple[str, ...] = ()
    reads_source: bool = False


def written(order: RecordOrder | RedrawOrder) -> str:
    """Return an order as an argument of a command line."""
    return json.dumps(to_json(order))


def record_order(text: str) -> RecordOrder:
    """Return the order that was written."""
    return from_json(RecordOrder, json.loads(text))


def redraw_order(text: str) -> RedrawOrder:
    """Return the order that was written."""
    return from_json(RedrawOrder, json.loads(text))
