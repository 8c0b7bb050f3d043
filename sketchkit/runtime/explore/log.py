"""The log: what has been drawn since each canvas was last cleared, ready to be looked into.

A reader of the renderer. It keeps draw lists as they are executed, with the rows that they were
made from, and forgets what a `background()` in a later frame has covered.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import ClassVar, NamedTuple, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.style import Style
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import (
    Clear,
    Command,
    Draw,
    DrawList,
    DrawMesh,
    Upload,
    target_of,
)
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.recorder import Kind, Recorder, ShapeRun, origin_of
from sketchkit.draw.resources import CubeMap, Pixels, Target
from sketchkit.draw.rows import Rows
from sketchkit.draw.stage import Stage
from sketchkit.runtime.explore.noting import Chain, Notes, Writers

MOST_KEPT = 4_000_000  # vertices, of all canvases: what is older is forgotten
CANVAS_SIZE = 2000  # vertices: what it counts to keep a canvas that is drawn on another one
VERTEX_BYTES = 64  # about: so many bytes of pixels count as a vertex

_Made = TypeVar("_Made")
Moment = tuple[int, int]  # a step of the log, a command of its list


@dataclass(frozen=True)
class Records:
    """The rows that a draw list was made from, which the recorder has forgotten by now."""

    table: NDArray[np.void]
    corners: NDArray[np.void]
    styles: list[Style]
    stages: list[Stage]
    matrices: list[float]
    nestings: list[int]
    shapes: list[ShapeRun]
    parts: list[MeshPart]
    origins: list[tuple[int, object]]

    @classmethod
    def of(cls, recorder: Recorder) -> Records:
        """Return what a recorder holds now."""
        return cls(
            recorder.row_array().copy(),
            recorder.corner_array().copy(),
            recorder.styles,
            recorder.stages,
            recorder.matrices,
            recorder.nestings,
            recorder.shapes,
            recorder.parts,
            list(recorder.origins),
        )

    def call(self, row: int) -> Chain:
        """Return which calls of the sketch have recorded a row."""
        return as_chain(origin_of(self.origins, row))


class Step(NamedTuple):
    """A draw list, and what has to be known about it later.

    Attributes
    ----------
    serial : int
        Its place among all steps.
    frame : int
        In which it was drawn.
    rows : list of int
        The row of each command that has one alone: a clear or a mesh; else -1.
    surfaces : dict of Target to Target
        What each canvas was then: its size, and which way up it was.
    pictures : dict of Pixels to Pixels
        Copies of the images that it is drawn with.
    setter : Chain
        Of an upload: who has set the pixels.
    writers : dict of int to Chain
        And who has written single ones of them.
    """

    serial: int
    frame: int
    commands: DrawList
    records: Records | None
    rows: list[int]
    surfaces: dict[Target, Target]
    pictures: dict[Pixels, Pixels]
    setter: Chain = ()
    writers: Writers = {}  # nobody changes it

    @property
    def size(self) -> int:
        """How much room it takes, in vertices."""
        pixels = (own.data.nbytes for own in self.commands.commands if isinstance(own, Upload))
        vertices = (len(block.positions) for block in self.commands.blocks.values())
        return sum(vertices) + sum(pixels) // VERTEX_BYTES + CANVAS_SIZE * len(self.canvases)

    @property
    def canvases(self) -> set[Target]:
        """The canvases whose pictures it shows; as long as it is kept, they are."""
        draws = (own for own in self.commands.commands if isinstance(own, Draw | DrawMesh))
        shown = (own.pipeline.texture for own in draws)
        return {texture for texture in shown if isinstance(texture, Target)}


@dataclass
class History:
    """What is on a canvas.

    Attributes
    ----------
    moments : list of Moment
        The commands that concern it, in order.
    is_whole : bool
        Whether nothing older is on it.
    """

    moments: list[Moment] = field(default_factory=list)
    is_whole: bool = False


class FrameLog:
    """Keeps what is drawn.

    Parameters
    ----------
    notes : Notes, optional
        Who has set pixels.
    limit : int
        How much is kept of frames that are past, in vertices, of all canvases.
    now : callable, optional
        Returns the number of the frame that is being drawn, if nobody calls `begin_frame`.

    Attributes
    ----------
    frame : int
        The one that is being drawn.
    backend : Backend or None
        What draws, to be asked for what shaders of the sketch's own do.
    forgets : bool
        Whether what is covered is forgotten at the next frame.
    steps : dict of int to Step
    histories : mapping of Target to History
    """

    reads_shapes: ClassVar = False

    def __init__(
        self,
        notes: Notes | None = None,
        limit: int = MOST_KEPT,
        now: Callable[[], int] | None = None,
    ) -> None:
        self.frame = 0
        self.notes = notes
        self.limit = limit
        self.forgets = True
        self.backend: Backend | None = None
        self._now = now
        self.steps: dict[int, Step] = {}
        self.histories: weakref.WeakKeyDictionary[Target, History] = weakref.WeakKeyDictionary()
        self._copies: weakref.WeakKeyDictionary[Pixels, Pixels] = weakref.WeakKeyDictionary()
        self._textures: weakref.WeakKeyDictionary[Pixels, object] = weakref.WeakKeyDictionary()
        self._pending: Records | None = None
        self._serial = 0
        self._size = 0

    def begin_frame(self, number: int) -> None:
        """Go on to a frame; forget what is covered by now."""
        self.frame = number
        if not self.forgets:
            return
        for history in self.histories.values():
            last = self._last_clear(history)
            if last > 0:
                history.moments = history.moments[last:]
                history.is_whole = True
        self._drop_unused()
        while self._size > self.limit and len(self.steps) > 1:
            self._forget_oldest()

    def skip_frames(self) -> None:
        """Take that frames have been drawn in between: what is on the canvases is not known."""
        for history in self.histories.values():
            history.moments, history.is_whole = [], False

    def read_rows(self, rows: Rows) -> None:
        """Take what was recorded."""
        self._pending = Records.of(rows.recorder)

    def read_commands(self, commands: DrawList) -> None:
        """Take what is about to be drawn."""
        if self._now is not None and (frame := self._now()) != self.frame:
            self.begin_frame(frame)
        commands = _with_own_pixels(commands)
        records, self._pending = self._pending, None
        targets = [target_of(command) for command in commands.commands]
        surfaces = {target: _as_it_is(target) for target in targets}
        setter: Chain = ()
        writers: Writers = {}
        if self.notes is not None and targets and records is None:
            setter = self.notes.pixel_setters.get(targets[0], ())
            writers = self.notes.take_writers(targets[0])
        step = Step(
            self._serial,
            self.frame,
            commands,
            records,
            _rows_of(commands, records),
            surfaces,
            self._pictures(commands),
            setter,
            writers,
        )
        self.steps[self._serial] = step
        self._size += step.size
        for index, target in enumerate(targets):
            moment = self._serial, index
            history = self.histories.setdefault(target, History())
            history.moments.append(moment)
        self._serial += 1

    def command(self, moment: Moment) -> Command:
        """Return a command."""
        serial, index = moment
        return self.steps[serial].commands.commands[index]

    def before(self, target: Target, moment: Moment | None = None) -> tuple[list[Moment], bool]:
        """Return what was on a canvas at a moment, or is now: moments, and whether that is all."""
        history = self.histories.get(target, History())
        moments = [own for own in history.moments if moment is None or own < moment]
        is_whole = history.is_whole
        for index in range(len(moments) - 1, -1, -1):
            if self._clears_all(moments[index]):
                return moments[index:], True
        return moments, is_whole

    def texture(self, picture: Pixels, make: Callable[[Pixels], _Made]) -> _Made:
        """Return what is made of an image to read its colours: made once for each."""
        if picture not in self._textures:
            self._textures[picture] = make(picture)
        return cast(_Made, self._textures[picture])

    def _pictures(self, commands: DrawList) -> dict[Pixels, Pixels]:
        """Return copies of the images that are drawn with: they may be changed afterwards."""
        pictures = {}
        draws = (own for own in commands.commands if isinstance(own, Draw | DrawMesh))
        for pixels in (image for own in draws for image in _images(own.pipeline)):
            if pixels in pictures:
                continue
            copy = self._copies.get(pixels)
            if copy is None or copy.version != pixels.version:
                copy = Pixels(pixels.data.copy(), pixels.version, pixels.mipmaps)
                self._copies[pixels] = copy
            pictures[pixels] = copy
        return pictures

    def _clears_all(self, moment: Moment) -> bool:
        command = self.command(moment)
        return isinstance(command, Clear) and command.clip is None

    def _last_clear(self, history: History) -> int:
        """Return which of a history's moments has covered all before it, or -1."""
        moments = history.moments
        own = (i for i in range(len(moments) - 1, -1, -1) if self._clears_all(moments[i]))
        return next(own, -1)

    def _drop_unused(self) -> None:
        """Forget the steps that are on no canvas any more.

        While nobody inspects, also the canvases that the last frame has neither drawn nor shown.
        """
        if self.limit < MOST_KEPT:
            recent = [step for step in self.steps.values() if step.frame >= self.frame - 1]
            shown = {target for step in recent for target in (*step.surfaces, *step.canvases)}
            for target in [target for target in self.histories if target not in shown]:
                del self.histories[target]
        used = {serial for history in self.histories.values() for serial, _ in history.moments}
        for serial in [serial for serial in self.steps if serial not in used]:
            self._size -= self.steps.pop(serial).size

    def _forget_oldest(self) -> None:
        oldest = min(self.steps)
        self._size -= self.steps.pop(oldest).size
        for history in self.histories.values():
            kept = [moment for moment in history.moments if moment[0] != oldest]
            if len(kept) < len(history.moments):
                history.moments, history.is_whole = kept, False


def _with_own_pixels(commands: DrawList) -> DrawList:
    """Return a list whose uploads do not follow later changes of the pixels."""
    own = [
        replace(command, data=command.data.copy()) if isinstance(command, Upload) else command
        for command in commands.commands
    ]
    return replace(commands, commands=own)


def _images(pipeline: Pipeline) -> Iterator[Pixels]:
    """Yield the images that a draw reads, those of its shader too."""
    values = pipeline.shading.uniforms.values.values() if pipeline.shading else ()
    for value in (pipeline.texture, *values):
        parts = value.faces if isinstance(value, CubeMap) else value
        yield from (
            own
            for own in (parts if isinstance(parts, tuple) else (parts,))
            if isinstance(own, Pixels)
        )


def as_chain(origin: object) -> Chain:
    """Return the calls that a recorder has noted; none if it has not."""
    return origin if isinstance(origin, tuple) else ()


def _as_it_is(target: Target) -> Target:
    return Target(target.width, target.height, target.samples, target.top_row_first)


def _rows_of(commands: DrawList, records: Records | None) -> list[int]:
    """Return the row that each clear, and each mesh, was made from: they keep their order."""
    if records is None:
        return [-1] * len(commands.commands)
    kinds = records.table["kind"]
    clears, meshes = (iter(np.flatnonzero(kinds == kind)) for kind in (Kind.CLEAR, Kind.MESH))
    rows = []
    for command in commands.commands:
        match command:
            case Clear():
                rows.append(int(next(clears)))
            case DrawMesh():
                rows.append(int(next(meshes)))
            case _:
                rows.append(-1)
    return rows
