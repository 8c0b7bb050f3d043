"""Values of a running sketch by name: `angle`, `ball.x`, `balls[0].place.y`."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

_STEP = re.compile(r"\.([^\W\d]\w*)|\[(-?\d+)\]|\[(['\"])(.*?)\3\]")
_NAME = re.compile(r"[^\W\d]\w*")


def is_watchable(path: str) -> bool:
    """Return whether a text names a value: a variable, its attributes and its items."""
    found = _NAME.match(path)
    at = found.end() if found else -1
    while 0 <= at < len(path):
        step = _STEP.match(path, at)
        at = step.end() if step else -1
    return at == len(path)


def number_at(path: str, namespace: Mapping[str, object]) -> float:
    """Return the number that a text names; NaN if there is none.

    Parameters
    ----------
    path : str
        See `is_watchable`.
    namespace : mapping
        The variables of the sketch.
    """
    name = _NAME.match(path)
    if name is None:
        return math.nan
    try:
        value = namespace[name[0]]
        for step in _STEP.finditer(path, name.end()):
            attribute, index, _, key = step.groups()
            item = int(index) if index else key
            value = getattr(value, attribute) if attribute else value[item]  # type: ignore[index]
        return float(value)  # type: ignore[arg-type] # or it is no number
    except Exception:  # whatever the sketch's own objects raise
        return math.nan
