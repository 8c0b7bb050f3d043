"""Renderer: one stream of recorded calls, made into draw lists and handed to a backend."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np

from sketchkit.draw.assemble import Assembler
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import Draw, DrawList, DrawMesh, Upload
from sketchkit.draw.expand import expand
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.resources import Target
from sketchkit.draw.rows import Rows
from sketchkit.draw.vertex import U8


class RecordsRows(Protocol):
    """A canvas that records into a renderer's stream."""

    def forget_state(self) -> None:
        """Give up indices into the recorder: it has been cleared."""

    def take_upload(self) -> Upload | None:
        """Return the pixels that the sketch has set since they were last taken, if any.

        They come before everything that is recorded: whoever sets pixels flushes what was
        recorded before them.
        """


class Reader(Protocol):
    """Follows what is drawn, to make something else of it than pixels.

    Attributes
    ----------
    reads_shapes : bool
        Whether it reads what retained shapes were made from: they are drawn at once then, before
        the sketch can edit them.
    """

    reads_shapes: ClassVar[bool]

    def read_rows(self, rows: Rows) -> None:
        """Take what was recorded, before it becomes triangles; the rows must not be kept."""

    def read_commands(self, commands: DrawList) -> None:
        """Take what is about to be drawn."""


@dataclass
class Stats:
    """What was drawn.

    Attributes
    ----------
    draw_calls : int
        Calls of the graphics interface.
    vertices : int
        Of what was drawn at once, and of retained shapes that were new or whose vertices have
        changed: those that were sent.
    """

    draw_calls: int = 0
    vertices: int = 0


class Renderer:
    """Turns what canvases record into pixels.

    Attributes
    ----------
    recorder : Recorder
        One for all canvases of a sketch, so that their drawing keeps its order.
    stats : Stats
        Counted since `reset_stats()`.
    observers : list
        Called with each draw list before it is executed.
    readers : list of Reader
    """

    def __init__(self, backend: Backend) -> None:
        self.backend = backend
        self.recorder = Recorder()
        self.stats = Stats()
        self.observers: list[Callable[[DrawList], None]] = []
        self.readers: list[Reader] = []
        self._canvases: weakref.WeakSet[RecordsRows] = weakref.WeakSet()
        self._sent: weakref.WeakKeyDictionary[Mesh, int] = weakref.WeakKeyDictionary()

    def register(self, canvas: RecordsRows) -> None:
        """Have a canvas told when the recorder is cleared."""
        self._canvases.add(canvas)

    def flush(self) -> None:
        """Draw everything recorded so far."""
        taken = [canvas.take_upload() for canvas in self._canvases]
        if uploads := [upload for upload in taken if upload is not None]:
            self.upload(uploads)
        if not self.recorder.row_end:
            return
        commands = self.assemble(self.recorder)
        self.recorder.clear()
        for canvas in self._canvases:
            canvas.forget_state()
        if commands is not None:
            self._execute(commands)

    def upload(self, uploads: Sequence[Upload]) -> None:
        """Draw pixels that the sketch has set."""
        self._execute(DrawList(list(uploads)))

    def draw(self, recorder: Recorder) -> None:
        """Draw what a recorder holds that is no canvas's."""
        if commands := self.assemble(recorder):
            self._execute(commands)

    def assemble(self, recorder: Recorder) -> DrawList | None:
        """Return the draw list of what a recorder holds; None if it is drawn elsewhere."""
        rows = Rows(recorder)
        for reader in self.readers:
            reader.read_rows(rows)
        with np.errstate(all="ignore"):  # a sketch may draw at NaN: then nothing shows
            return Assembler(rows).assemble(expand(rows))

    def _execute(self, commands: DrawList) -> None:
        is_draw = [isinstance(command, Draw | DrawMesh) for command in commands.commands]
        self.stats.draw_calls += sum(is_draw)
        self.stats.vertices += sum(len(block.positions) for block in commands.blocks.values())
        for command in commands.commands:
            if isinstance(command, DrawMesh):
                self.stats.vertices += self._count_new(command.part.mesh)
        for observer in self.observers:
            observer(commands)
        for reader in self.readers:
            reader.read_commands(commands)
        self.backend.execute(commands)

    def _count_new(self, mesh: Mesh) -> int:
        """Return how many of a mesh's vertices the backend has not seen yet."""
        seen = self._sent.get(mesh)
        self._sent[mesh] = mesh.version
        edits = None if seen is None else mesh.edits_since(seen)
        if edits is None:
            return mesh.vertex_count
        return sum(edit.last - edit.first for edit in edits)

    def read(self, target: Target) -> U8:
        """Return what was drawn on a target so far, (h, w, 4) RGBA, top row first."""
        self.flush()
        return self.backend.read(target)

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return one pixel of it, (4,) RGBA, x and y from the top left."""
        self.flush()
        return self.backend.read_pixel(target, x, y)

    def reset_stats(self) -> None:
        """Count from zero."""
        self.stats = Stats()
