"""Drawing what a tape says: pictures, traces, values. No code of the sketch is here.

What it finds goes out as messages of the same form as a tape's: `renderer`, `source`, `picture` (a
PNG file), `trace`, `remark`, `values`, and at the end `told`: what the tape says of the run itself.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import BinaryIO, TextIO, cast

from sketchkit.assets.output import picture_bytes
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.grading.inside.orders import (
    LARGEST_SIDE,
    SUBMISSION,
    TAPE,
    RedrawOrder,
    redraw_order,
)
from sketchkit.grading.inside.reading import read_sources
from sketchkit.grading.inside.tracing import Tracer
from sketchkit.grading.inside.variants import VARIANTS, changing
from sketchkit.grading.results import to_json
from sketchkit.grading.sandbox import inside
from sketchkit.runtime.backends import open_backend
from sketchkit.tape.messages import Message, TapeError, read_messages
from sketchkit.tape.playing import Player

Send = Callable[[Message], None]
MOST_REMARKS = 50
LONGEST_REMARK = 2000  # characters


@dataclass
class Told:
    """What a tape says of the run itself.

    Attributes
    ----------
    mistake : str
        What stopped the sketch, as it is told to its author; "" if nothing did.
    end : int or None
        The frame with which it came to its end; None if it never did.
    damage : str
        Why the tape could not be drawn to its end; "" if it could.
    """

    mistake: str = ""
    end: int | None = None
    damage: str = ""


@dataclass
class Drawing:
    """A tape on its way through a renderer.

    Attributes
    ----------
    values : list of list of float
        The watched ones, for each frame from frame 1.
    """

    frames: tuple[int, ...]
    traces: tuple[int, ...]
    send: Send
    player: Player
    tracer: Tracer | None
    variant: str = ""
    told: Told = field(default_factory=Told)
    values: list[list[float]] = field(default_factory=list)
    _remarks: int = 0
    _canvas: int = -1
    _trace: object = None  # of the last frame, as JSON has it

    def play(self, file: BinaryIO) -> None:
        """Draw all of a tape; of a damaged one, what comes before the damage."""
        try:
            for message in read_messages(file):
                self._take(message)
        except TapeError as problem:
            self.told.damage = str(problem)
        except Exception as problem:  # whatever a made-up tape brings about is its own doing
            self.told.damage = f"The recording cannot be drawn ({type(problem).__name__})."
        if self.told.end is not None and not self.told.damage:
            self._repeat()

    def _take(self, message: Message) -> None:
        match message.kind, message.value:
            case "frame", {"number": int(number), "canvas": int(canvas), "values": list(values)}:
                self._mark(number, canvas, values)
            case "remark", [str(file), int(line), str(text)] if self._remarks < MOST_REMARKS:
                self._remarks += 1
                self.send(remark(file, line, text))
            case "mistake", [str(), int(), str(text)]:
                self.told.mistake = text[:8000]
            case "end", int(frame):
                self.told.end = frame
            case _:
                self.player.play(message)

    def _mark(self, number: int, canvas: int, values: list[object]) -> None:
        """Take what is wanted of a frame that is complete."""
        if number >= 1:
            self.values.append([float(cast(float, value)) for value in values])
        if self.tracer is not None:
            target = self.player.resources[canvas]
            self._trace = to_json(self.tracer.take(cast(Target, target)))
            if number in self.traces:
                self.send(Message("trace", {"frame": number, "trace": self._trace}))
        self._canvas = canvas
        if number in self.frames:
            self._send_picture([number])

    def _repeat(self) -> None:
        """Let frames after the last one that was drawn be like it."""
        end = cast(int, self.told.end)
        if later := [number for number in self.frames if number > end]:
            self._send_picture(later)
        if self.tracer is not None:
            for number in (number for number in self.traces if number > end):
                self.send(Message("trace", {"frame": number, "trace": self._trace}))

    def _send_picture(self, numbers: Sequence[int]) -> None:
        """Send what is on the canvas as the picture of some frames."""
        canvas = cast(Target, self.player.resources[self._canvas])
        if max(canvas.width, canvas.height) > LARGEST_SIDE:
            raise TapeError(
                f"Its picture is {canvas.width} x {canvas.height} pixels, and no more "
                f"than {LARGEST_SIDE} are looked at either way."
            )
        data = picture_bytes(self.player.read(self._canvas)[:, :, :3], ".png")
        for number in numbers:
            self.send(Message("picture", {"frame": number, "variant": self.variant}, data))


def remark(file: str, line: int, text: str) -> Message:
    """Return what is told to a sketch's author."""
    return Message("remark", f"{file}, line {line}: {text}"[:LONGEST_REMARK])


def redraw(order: RedrawOrder, tape: Path, send: Send, backend: Backend) -> None:
    """Carry out an order.

    Parameters
    ----------
    order : RedrawOrder
    tape : Path
    send : callable
        Takes what is found.
    backend : Backend
    """
    told = None
    for variant in ("", *(VARIANTS if order.varied else ())):
        renderer = Renderer(backend)
        player = Player(renderer, changing(variant) if variant else None)
        tracer = None if variant else Tracer(player.mesh_kinds)
        if tracer is not None:
            renderer.readers.append(tracer)
        frames = order.varied if variant else order.frames
        drawing = Drawing(frames, order.traces, send, player, tracer, variant)
        with tape.open("rb") as file:
            drawing.play(file)
        if told is None:
            told = drawing.told
            send(Message("values", _by_name(order.watched, drawing.values)))
    assert told is not None
    send(Message("told", to_json(told)))


def _by_name(names: tuple[str, ...], rows: list[list[float]]) -> dict[str, list[float]]:
    columns: Iterator[tuple[float, ...]] = zip(*rows, strict=False)
    return {name: list(column) for name, column in zip(names, columns, strict=False)}


def main() -> None:
    """Do what the command line says, and write what is found to descriptor 3."""
    order = redraw_order(sys.argv[1])
    backend = open_backend(order.renderer).backend
    with os.fdopen(inside.OUTPUT, "wb", closefd=False) as out:

        def send(message: Message) -> None:
            out.write(bytes(message))

        def tell(
            message: Warning | str,
            category: type[Warning],
            filename: str,
            lineno: int,
            file: TextIO | None = None,
            line: str | None = None,
        ) -> None:
            send(remark(Path(filename).name, lineno, str(message)))

        warnings.simplefilter("ignore")
        warnings.simplefilter("default", SketchWarning)  # of shaders: they show when drawing
        warnings.showwarning = tell
        send(Message("renderer", {"name": backend.name, **backend.describe()}))
        if order.reads_source:
            facts = read_sources(inside.path(SUBMISSION))
            send(Message("source", to_json(facts)))
        redraw(order, inside.path(TAPE), send, backend)
    inside.leave()


if __name__ == "__main__":
    main()
