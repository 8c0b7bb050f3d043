"""Noting: which call of the sketch records each row, while somebody inspects it.

The hot path is left as it is. As long as a block of `noting()` lasts, `Recorder.row_end` is a
property instead of a slot: whoever sets it has recorded rows, and the stack says who that is.
"""

from __future__ import annotations

import sys
import weakref
from collections.abc import Container, Iterator, Mapping
from contextlib import contextmanager
from types import CodeType, FrameType
from typing import Any, NamedTuple

from sketchkit.api.pixel_array import PixelArray
from sketchkit.api.pixels import CanvasPixels
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.resources import Pixels, Target
from sketchkit.runtime.explore.void_calls import noting_void_calls
from sketchkit.runtime.loader import Program

MOST_CALLS = 200  # of a recursion that goes deeper, the outermost calls are left out


class Call(NamedTuple):
    """A place in the sketch that was being run: its code, and how far it had come."""

    code: CodeType
    instruction: int


Chain = tuple[Call, ...]  # innermost first; empty if no line of the sketch has called
Writers = dict[int, Chain]  # by the place in `pixels`


class Notes:
    """What is noted besides the origins that recorders keep.

    Attributes
    ----------
    pixel_setters : mapping of Target to Chain
        Who has last set pixels of a canvas, by `set()`, `updatePixels()` and their like.
    void_calls : dict of Chain to str
        Which calls have drawn nothing at all, and why.
    """

    def __init__(self, names: Mapping[str, object], files: Container[str]) -> None:
        self._names, self._files = names, files
        self._chains: dict[Chain, Chain] = {}
        self.void_calls: dict[Chain, str] = {}
        self.pixel_setters: weakref.WeakKeyDictionary[Target, Chain] = weakref.WeakKeyDictionary()
        self._writers: weakref.WeakKeyDictionary[Pixels, Writers] = weakref.WeakKeyDictionary()
        self._images: weakref.WeakKeyDictionary[Target, Pixels] = weakref.WeakKeyDictionary()

    def note_void_call(self, reason: str) -> None:
        """Note why a call draws nothing."""
        self.void_calls.setdefault(self.chain(), reason)

    def note_setter(self, target: Target, image: Pixels) -> None:
        """Note who has pixels of a canvas sent, which lie in an image until then."""
        self.pixel_setters[target] = self.chain()
        self._images[target] = image

    def note_writer(self, image: Pixels, place: object) -> None:
        """Note who has written single pixels of an image, by `set()` or `pixels[i] = ...`."""
        count = image.width * image.height
        places = range(*place.indices(count)) if isinstance(place, slice) else [place]
        chain, writers = self.chain(), self._writers.setdefault(image, {})
        for own in places:
            if isinstance(own, int | float):
                writers[int(own) % count] = chain

    def take_writers(self, target: Target) -> Writers:
        """Return who has written which pixel of a canvas since this was last asked."""
        image = self._images.get(target)
        return {} if image is None else self._writers.pop(image, {})

    def chain(self) -> Chain:
        """Return the calls of the sketch that are being carried out; equal ones are one object."""
        calls: list[Call] = []
        frame: FrameType | None = sys._getframe(1)
        while frame is not None and len(calls) < MOST_CALLS:
            if frame.f_builtins is self._names and frame.f_code.co_filename in self._files:
                calls.append(Call(frame.f_code, frame.f_lasti))
            frame = frame.f_back
        found = tuple(calls)
        return self._chains.setdefault(found, found)


@contextmanager
def noting(program: Program, *, each_pixel: bool = False) -> Iterator[Notes]:
    """Note who records rows, in all recorders there are.

    Parameters
    ----------
    program : Program
        The sketch: its code is known by its files, and by the names that it sees.
    each_pixel : bool
        Whether it is noted as well who writes each pixel: it makes that five times as slow.
    """
    notes = Notes(program.names, program.sources)
    # Any: a slot's descriptor and a method, taken from their classes and put back.
    slot: Any = Recorder.__dict__["row_end"]
    touch: Any = CanvasPixels.__dict__["_touch"]
    write: Any = PixelArray.__dict__["__setitem__"]

    def set_row_end(recorder: Recorder, end: int) -> None:
        slot.__set__(recorder, end)
        origins = getattr(recorder, "origins", None)  # a copy gets its attributes one by one
        if origins is None or end <= (origins[-1][0] if origins else 0):
            return
        chain = notes.chain()
        if origins and origins[-1][1] is chain:
            origins.pop()
        origins.append((end, chain))

    def note_touch(canvas: CanvasPixels) -> None:
        touch(canvas)
        notes.note_setter(canvas._target, canvas._own)

    def note_write(array: PixelArray, place: object, color: object) -> None:
        write(array, place, color)
        notes.note_writer(array._image, place)

    # Through `type`: for the type checker, the classes stay what they are.
    type.__setattr__(Recorder, "row_end", property(slot.__get__, set_row_end))
    type.__setattr__(CanvasPixels, "_touch", note_touch)
    if each_pixel:
        type.__setattr__(PixelArray, "__setitem__", note_write)
    try:
        with noting_void_calls(program.names, notes.note_void_call):
            yield notes
    finally:
        type.__setattr__(Recorder, "row_end", slot)
        type.__setattr__(CanvasPixels, "_touch", touch)
        type.__setattr__(PixelArray, "__setitem__", write)
