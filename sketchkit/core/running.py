"""Which sketch is running: `from sketchkit import *` in its file means that one's names.

This file is loaded before all others, and needs no module of Python's library: a sketch's folder
may have files that hide some, and `python -m sketchkit` would take those.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


class Running:
    """A sketch that is running.

    Attributes
    ----------
    names : dict
        All that it sees, live values as they are now.
    lasting : sequence of str
        The names that always mean the same, so that a copy of them stays right.
    """

    def __init__(self, names: Mapping[str, object], lasting: Sequence[str]) -> None:
        self.names = names
        self.lasting = lasting


_running: list[Running] = []


def enter(sketch: Running) -> None:
    """Take a sketch as the running one, until `leave`."""
    _running.append(sketch)


def leave(sketch: Running) -> None:
    """Go back to the sketch that was running before."""
    _running.remove(sketch)


def current() -> Running | None:
    """Return the sketch that runs now, if there is one."""
    return _running[-1] if _running else None
