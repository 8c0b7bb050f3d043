"""Inspecting a sketch without a window: which line of it has drawn a pixel of a frame."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from sketchkit.core.clock import VirtualClock
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.explore.describe import Description, Surroundings, describe, surroundings
from sketchkit.runtime.explore.layers import History, Layer
from sketchkit.runtime.explore.log import FrameLog
from sketchkit.runtime.explore.noting import noting
from sketchkit.runtime.explore.pixel import DEEPEST, history, texel
from sketchkit.runtime.explore.telling import (
    as_json,
    call_lines,
    color_text,
    detail_lines,
    part_in_words,
    why,
)
from sketchkit.runtime.headless import Launch, Steps, opened
from sketchkit.runtime.loader import Program, seed_everything

Place = tuple[int, int]


class OutsideError(Exception):
    """A pixel lies outside of the picture; the message is a sentence."""


@dataclass
class Inspection:
    """What is to be said about a pixel.

    Attributes
    ----------
    frame : int
        The frame that is shown; less than what was asked for, if the sketch draws no more.
    color : (r, g, b, a)
        As the picture has it.
    inner : Inspection or None
        Of a pixel that shows another canvas: the pixel of that.
    """

    place: Place
    size: tuple[int, int]
    frame: int
    color: tuple[int, int, int, int]
    found: History
    log: FrameLog
    around: Surroundings
    inner: Inspection | None = None

    @property
    def answer(self) -> Description | None:
        """The call that has drawn the pixel."""
        layer = self.found.answer
        return None if layer is None else describe(self.log, layer, self.around)

    def beneath(self) -> Iterator[tuple[Description, str]]:
        """Yield all other layers, the uppermost first, and whether they show."""
        for layer in reversed(self.found.layers):
            if layer is not self.found.answer:
                own = describe(self.log, layer, self.around)
                yield own, why(self.log, layer, self.around)


def inspect(
    launch: Launch, frame: int, places: Sequence[Place], backend: Backend
) -> list[Inspection]:
    """Return what has drawn pixels of a frame.

    Parameters
    ----------
    launch : Launch
        The sketch.
    frame : int
        frameCount; 0 is the picture after `setup()`.
    places : sequence of (x, y)
        From the top left of the picture.
    backend : Backend
        What draws.

    Raises
    ------
    StoppedError
        If the sketch stops by a mistake before the frame is complete.
    OutsideError
        If the picture has no such pixel.
    """
    renderer = Renderer(backend)
    clock = VirtualClock()
    with opened(launch, renderer, clock) as loop:
        seed_everything(launch.seed)
        with noting(loop.program, each_pixel=True) as notes:
            log = FrameLog(notes)
            log.backend = backend
            renderer.readers.append(log)
            steps = Steps(loop, clock, launch.replay)
            loop.begin()
            while steps.frame < frame and steps.can_go_on:
                log.begin_frame(steps.frame + 1)
                steps.step()
            renderer.flush()
            renderer.readers.remove(log)
        canvas = loop.program.sketch.canvas
        outside = _outside(places, (canvas.width, canvas.height))
        if outside is None:
            found = [look(loop.program, log, place, steps.frame) for place in places]
        loop.end()
    if outside is not None:  # here, since it is no mistake of the sketch
        raise outside
    return found


def _outside(places: Sequence[Place], size: tuple[int, int]) -> OutsideError | None:
    """Return what is wrong with pixels that a picture does not have."""
    width, height = size
    for x, y in places:
        if not (0 <= x < width and 0 <= y < height):
            return OutsideError(f"The picture is {width} x {height}: there is no pixel {x}, {y}.")
    return None


def look(program: Program, log: FrameLog, place: Place, frame: int) -> Inspection:
    """Return what has drawn a pixel of the main canvas, which has such a pixel."""
    canvas = program.sketch.canvas
    width, height = canvas.width, canvas.height
    picture = canvas.image_data()
    density = picture.shape[1] // width  # pixels for each unit of the sketch, along a side
    column, row = (at * density + density // 2 for at in place)
    red, green, blue, alpha = picture[row, column].tolist()
    around = surroundings(program)
    found = history(log, canvas.target, (column, row))
    inner = _inner(log, found.answer, around, frame)
    color = red, green, blue, alpha
    return Inspection(place, (width, height), frame, color, found, log, around, inner)


def _inner(
    log: FrameLog, layer: Layer | None, around: Surroundings, frame: int, depth: int = 0
) -> Inspection | None:
    """Return what has drawn the pixel of another canvas that a layer shows."""
    texture = layer.pipeline.texture if layer and layer.pipeline else None
    if not isinstance(texture, Target) or layer is None or layer.uv is None or depth > DEEPEST:
        return None
    place = texel(texture, layer.uv)
    found = history(log, texture, place, layer.moment)
    if not found.layers:
        return None
    size = texture.width, texture.height
    inner = _inner(log, found.answer, around, frame, depth + 1)
    return Inspection(place, size, frame, found.color, found, log, around, inner)


def report(inspection: Inspection, name: str) -> list[str]:
    """Return what is said in the terminal.

    Parameters
    ----------
    name : str
        Of the sketch's file.
    """
    x, y = inspection.place
    lines = [
        f"{name}, frame {inspection.frame}, pixel {x}, {y}: {color_text(inspection.color)}",
        "",
    ]
    return [*lines, *_body(inspection, "")]


def short_report(inspection: Inspection) -> str:
    """Return what is said beside the pointer: the call, or that the line is not known."""
    answer = inspection.answer
    if answer is None:
        return "Nothing was drawn here."
    if not answer.sites and answer.kind != "background":
        return "Drawn before the lines were noted down: F6 draws the next frame."
    return f"{answer.title} ({part_in_words(answer)})"


def _body(inspection: Inspection, margin: str) -> list[str]:
    answer = inspection.answer
    if answer is None:
        return [margin + "Nothing was drawn here."]
    head, *calls = call_lines(answer)
    lines = [f"Drawn by {head}", *calls]
    if answer.frame != inspection.frame:
        lines.append(f"    in frame {answer.frame}, and nothing has covered it since")
    lines += [f"    {line}" for line in detail_lines(answer)]
    if inspection.inner is not None:
        x, y = inspection.inner.place
        width, height = inspection.inner.size
        lines += ["", f"There it shows pixel {x}, {y} of a canvas of {width} x {height}."]
        lines += _body(inspection.inner, "    ")
    others = list(inspection.beneath())
    if others:
        lines += ["", "All else that was drawn here, the last first:"]
    for number, (own, reason) in enumerate(others, 1):
        frame = f" (frame {own.frame})" if own.frame != inspection.frame else ""
        lines += [f"{number:>3}  {own.title}{frame}", f"     {part_in_words(own)}; {reason}"]
    if not inspection.found.is_whole:
        lines += ["", "What was drawn before that has not been kept."]
    return [margin + line if line else "" for line in lines]


def as_value(inspection: Inspection) -> dict[str, object]:
    """Return an inspection as JSON has it."""
    answer = inspection.answer
    value: dict[str, object] = {
        "frame": inspection.frame,
        "pixel": list(inspection.place),
        "size": list(inspection.size),
        "color": list(inspection.color),
        "drawn_by": None if answer is None else as_json(inspection.log, answer, inspection.around),
        "others": [
            as_json(inspection.log, own, inspection.around) for own, _ in inspection.beneath()
        ],
        "complete": inspection.found.is_whole,
    }
    if inspection.inner is not None:
        value["inner"] = as_value(inspection.inner)
    return value
