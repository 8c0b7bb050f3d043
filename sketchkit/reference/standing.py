"""How sketchkit stands to Processing: which names are here, and what is said of the others."""

from __future__ import annotations

import builtins
import keyword
from collections.abc import Iterator, Mapping
from enum import Enum
from typing import NamedTuple

from sketchkit.reference.instead import instead_of
from sketchkit.reference.names import Name, every_name

# Classes of Java's that are here under the names of those that inherit from them.
KNOWN_AS = {"Event": "MouseEvent", "PMatrix": "PMatrix3D"}

# What the author of a sketch defines, and the runtime calls.
HANDLERS = frozenset(
    {
        *("settings", "setup", "draw", "stop", "dispose"),
        *("mousePressed", "mouseReleased", "mouseClicked", "mouseDragged", "mouseMoved"),
        *("mouseEntered", "mouseExited", "mouseWheel", "keyPressed", "keyReleased", "keyTyped"),
        *("windowMoved", "windowResized"),
    }
)


class Standing(Enum):
    """Where a name of Processing's stands."""

    HERE = "here"
    INSTEAD = "a sentence says what to use instead"
    MISSING = "missing"


class Entry(NamedTuple):
    """A name, where it stands, and what is said about it; nothing if it is here."""

    name: Name
    standing: Standing
    instead: str | None


def entries(names: Mapping[str, object]) -> Iterator[Entry]:
    """Yield every name of Processing's.

    Parameters
    ----------
    names : mapping
        What a sketch sees, and what it stands for.
    """
    for name in every_name():
        if is_here(name, names):
            yield Entry(name, Standing.HERE, None)
            continue
        sentence = instead_of(name.name, [name.owner])
        yield Entry(name, Standing.INSTEAD if sentence else Standing.MISSING, sentence)


def is_here(entry: Name, names: Mapping[str, object]) -> bool:
    """Tell whether sketches can use a name."""
    if not entry.owner:
        if entry.kind == "handler" and entry.name in HANDLERS:
            return True
        if keyword.iskeyword(entry.name) or hasattr(builtins, entry.name):
            return True
        return entry.name in names or entry.name in KNOWN_AS
    owner = names.get(KNOWN_AS.get(entry.owner, entry.owner))
    return owner is not None and _has(owner, entry.name)


def _has(owner: object, name: str) -> bool:
    """Tell whether a class has an attribute, or gives one to each of its objects."""
    kinds = owner.__mro__ if isinstance(owner, type) else ()
    return hasattr(owner, name) or any(name in vars(k).get("__annotations__", ()) for k in kinds)
