"""A run that an assignment needs: which events, as far as which frame, what to look at."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Run:
    """One run of a sketch, and what is needed of it.

    Attributes
    ----------
    events : str
        The file of mouse and keys that is replayed, relative to the assignment; "" for none.
    frames : tuple of int
        Pictures of these are needed: of submissions and of references.
    reference_frames : tuple of int
        Pictures of these, too, are needed of references alone: frames before and after, to which
        a picture of the wrong moment is compared.
    varied : tuple of int
        Frames that references are redrawn otherwise for, to explain a difference: without lights,
        without depth.
    traced : tuple of int
        What is drawn in these is needed.
    watched : tuple of str
        Names whose numbers are needed, from frame 1 to the last.
    last_frame : int
        The run ends with this one.
    """

    events: str
    frames: tuple[int, ...] = ()
    reference_frames: tuple[int, ...] = ()
    varied: tuple[int, ...] = ()
    traced: tuple[int, ...] = ()
    watched: tuple[str, ...] = ()
    last_frame: int = 0


def merged(parts: Iterable[Run]) -> tuple[Run, ...]:
    """Return one run for each file of events, with all that any part needs of it."""
    groups: dict[str, list[Run]] = {}
    for part in parts:
        groups.setdefault(part.events, []).append(part)
    return tuple(_joined(events, groups[events]) for events in sorted(groups))


def _joined(events: str, parts: list[Run]) -> Run:
    frames = _union(part.frames for part in parts)
    return Run(
        events,
        frames,
        tuple(
            number
            for number in _union(part.reference_frames for part in parts)
            if number not in frames
        ),
        _union(part.varied for part in parts),
        _union(part.traced for part in parts),
        tuple(dict.fromkeys(name for part in parts for name in part.watched)),
        max(part.last_frame for part in parts),
    )


def _union(groups: Iterable[tuple[int, ...]]) -> tuple[int, ...]:
    return tuple(sorted({number for group in groups for number in group}))
