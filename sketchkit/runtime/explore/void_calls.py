"""Void calls: those that draw nothing at all, such as a text without letters, and why.

They leave no trace in what is recorded. So while somebody takes notes, the names of the few
functions that may draw nothing stand for others, which look at whether anything was recorded.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, MutableMapping
from contextlib import contextmanager
from functools import wraps
from typing import Any

from sketchkit.api.graphics import PGraphics
from sketchkit.draw.recorder import CORNER
from sketchkit.runtime.explore.matrices import number

Note = Callable[[str], None]
Reason = Callable[[PGraphics, tuple[Any, ...], int], str]  # Any: whatever the sketch has written


def _text(canvas: PGraphics, args: tuple[Any, ...], vertices: int) -> str:
    written = str(args[0])
    if written.strip():
        is_placed = all(math.isfinite(place) for place in args[1:3])
        return "" if is_placed else "One of its numbers is none (NaN) or infinite."
    what = "only spaces" if written else "empty"
    return f"Its text is {what}: there is no letter to draw."


def _shape(canvas: PGraphics, args: tuple[Any, ...], vertices: int) -> str:
    shape = args[0]
    if not shape.isVisible():
        return "It was made invisible: setVisible(False)."
    if not shape.getChildCount() and not shape.getVertexCount() and shape.getFamily() != PRIMITIVE:
        return "It is empty: it has neither vertices nor children."
    if shape._fill < 0 and (shape._stroke < 0 or shape._weight <= 0):
        return "noFill() and noStroke() were in force when it was made: nothing of it is left."
    return ""


def _end_shape(canvas: PGraphics, args: tuple[Any, ...], vertices: int) -> str:
    if vertices == 0:
        return "There is no vertex between its beginShape() and it."
    return f"It has only {'1 vertex' if vertices == 1 else '2 vertices'}: a polygon has 3 or more."


def _arc(canvas: PGraphics, args: tuple[Any, ...], vertices: int) -> str:
    start, stop = (number(float(angle)) for angle in args[4:6])
    return f"It ends where it begins, or before: it goes from {start} to {stop}."


REASONS: dict[str, Reason] = {"text": _text, "shape": _shape, "endShape": _end_shape, "arc": _arc}
PRIMITIVE = 101  # PShape.PRIMITIVE: a family whose vertices are not counted


@contextmanager
def noting_void_calls(names: MutableMapping[str, object], note: Note) -> Iterator[None]:
    """Note, in this block, which calls draw nothing.

    Parameters
    ----------
    names : mapping
        What the sketch sees behind its own names.
    note : callable
        Called, within such a call, with why it draws nothing.
    """
    originals = {name: names[name] for name in REASONS if name in names}
    for name, original in originals.items():
        canvas = getattr(original, "__self__", None)
        if isinstance(canvas, PGraphics) and callable(original):
            names[name] = _watched(original, canvas, REASONS[name], note)
    try:
        yield
    finally:
        names.update(originals)


def _watched(
    original: Callable[..., object], canvas: PGraphics, reason: Reason, note: Note
) -> Callable[..., object]:
    """Return a function that does the same, and tells if nothing was recorded."""

    @wraps(original)
    def call(*args: Any, **named: Any) -> object:  # noqa: ANN401 # the original says what is wrong
        __tracebackhide__ = True  # to a mistake in the call, it is the original that was called
        recorder = canvas._recorder
        before, shape = recorder.row_end, canvas._shape
        vertices = 0 if shape is None else (recorder.corner_end - shape.first) // CORNER
        result = original(*args, **named)
        if recorder.row_end == before:
            try:
                text = reason(canvas, args, vertices)
            except Exception:  # whatever it may be: no remark is worth a sketch that stops
                text = ""
            if text:
                note(text)
        return result

    return call
