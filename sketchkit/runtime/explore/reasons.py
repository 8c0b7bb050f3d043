"""Why what a call has drawn does not show, in whole sentences; nothing if it does, or is unsure."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.probe import Range
from sketchkit.backends.cpu.reach import Obstacle, Reach, reach
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.commands import Draw, DrawMesh
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.recorder import Kind
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.vertex import Layer as Block
from sketchkit.draw.vertex import VertexBlock
from sketchkit.runtime.explore.describe import Surroundings, describe, light_in_words
from sketchkit.runtime.explore.log import FrameLog, Moment, Records
from sketchkit.runtime.explore.matrices import number
from sketchkit.runtime.explore.pixel import Layer, Part, history

ALIKE = 2  # of 255: colours that differ by no more look the same
LIT = (Program.LIT, Program.TEXTURED_LIT)
NOTHING_LEFT = {
    Kind.LINE: "noStroke() is in force, or strokeWeight(0): of a line nothing is left.",
    Kind.POINT: "noStroke() is in force, or strokeWeight(0): of a point nothing is left.",
}


class Verdict(Enum):
    """What is known of a part of a call."""

    HIDDEN = "hidden"
    SHOWN = "shown"
    UNSURE = "unsure"


class Reason(NamedTuple):
    """Why something does not show.

    Attributes
    ----------
    verdict : Verdict
    text : str
        Whole sentences, of what is HIDDEN.
    culprit : Layer or None
        What hides it.
    """

    verdict: Verdict
    text: str = ""
    culprit: Layer | None = None


SHOWN, UNSURE = Reason(Verdict.SHOWN), Reason(Verdict.UNSURE)


@dataclass(frozen=True)
class Piece:
    """What a row has drawn in one command: its fill, its outline or its points."""

    moment: Moment
    row: int
    part: Part
    pipeline: Pipeline
    block: VertexBlock
    drawn: Range

    @property
    def alphas(self) -> NDArray[np.uint8]:
        """The alphas of its vertices."""
        first = self.drawn.first
        used = self.block.indices[first : first + self.drawn.size]
        return np.asarray(self.block.colors[used, 3])


@dataclass(frozen=True)
class Case:
    """A row that is asked about."""

    log: FrameLog
    around: Surroundings
    serial: int
    row: int

    @property
    def records(self) -> Records:
        """The rows that it is one of."""
        records = self.log.steps[self.serial].records
        assert records is not None
        return records

    @property
    def kind(self) -> Kind:
        """What it draws."""
        return Kind(int(self.records.table["kind"][self.row]))

    @property
    def modelview(self) -> NDArray[np.float64]:
        """Its matrix, (3, 4)."""
        state = int(self.records.table["state"][self.row])
        return np.array(self.records.matrices[12 * state : 12 * state + 12]).reshape(3, 4)


def reason_of(case: Case) -> Reason:
    """Return why a row does not show; of fill and outline the first that has a reason speaks."""
    if not np.isfinite(case.modelview).all():
        return _hidden("The matrix holds a number that is none (NaN) or infinite.")
    pieces = list(pieces_of(case))
    if not pieces:
        return _nothing_made(case)
    if any(_moves_vertices(piece) for piece in pieces):
        return UNSURE  # only its own shader knows where that is
    target = pieces[0].pipeline.target
    if target is not case.around.canvas and not _is_used(case.log, target):
        name = case.around.images.get(target, "pg")
        return _hidden(f"It is drawn on another canvas, which is never shown: image({name}, 0, 0).")
    reasons = [_reason_of_piece(case, piece) for piece in pieces]
    for verdict in (Verdict.SHOWN, Verdict.UNSURE):
        if any(reason.verdict is verdict for reason in reasons):
            return Reason(verdict)
    return reasons[0]


def pieces_of(case: Case) -> Iterator[Piece]:
    """Yield what a row has drawn, command by command."""
    step = case.log.steps[case.serial]
    for index, command in enumerate(step.commands.commands):
        moment = case.serial, index
        if isinstance(command, DrawMesh) and step.rows[index] == case.row:
            part = command.part
            drawn = Range(part.first, part.count, command.modelview, part.weight_scale)
            yield Piece(
                moment,
                case.row,
                _part(part.layer),
                command.pipeline,
                part.mesh.blocks[part.layer],
                drawn,
            )
        elif isinstance(command, Draw):
            order = step.commands.orders[command.layer]
            for key, kind in (
                (2 * case.row, _part(command.layer)),
                (2 * case.row + 1, Part.STROKE),
            ):
                at = np.flatnonzero(order.keys == key)
                if not len(at):
                    continue
                begin = int(order.ends[at[0] - 1]) if at[0] else 0
                end = int(order.ends[at[-1]])
                begin, end = max(begin, command.first), min(end, command.first + command.count)
                if begin < end:
                    block = step.commands.blocks[command.layer]
                    drawn = Range(begin, end - begin, IDENTITY)
                    yield Piece(moment, case.row, kind, command.pipeline, block, drawn)


def _part(block: Block) -> Part:
    return {Block.FILLS: Part.FILL, Block.LINES: Part.STROKE, Block.POINTS: Part.POINT}[block]


def _hidden(text: str, culprit: Layer | None = None) -> Reason:
    return Reason(Verdict.HIDDEN, text, culprit)


def _moves_vertices(piece: Piece) -> bool:
    shading = piece.pipeline.shading
    return shading is not None and shading.source.vertex is not None


def _is_used(log: FrameLog, target: Target) -> bool:
    """Return whether a canvas is drawn on another one, or read by a shader."""
    for step in log.steps.values():
        for command in step.commands.commands:
            if not isinstance(command, Draw | DrawMesh):
                continue
            if command.pipeline.texture is target or command.pipeline.shading is not None:
                return True
    return False


def _nothing_made(case: Case) -> Reason:
    """Return why a row makes no triangles at all."""
    row = case.records.table[case.row]
    if not np.isfinite(row["numbers"]).all():
        return _hidden("One of its numbers is none (NaN) or infinite.")
    has_stroke = int(row["stroke"]) >= 0 and float(row["weight"]) > 0
    if case.kind in NOTHING_LEFT:
        return UNSURE if has_stroke else _hidden(NOTHING_LEFT[case.kind])
    if case.kind is Kind.SHAPE:
        run = case.records.shapes[int(row["link"])]
        corners = case.records.corners[run.first : run.first + run.count]
        if not np.isfinite(corners["place"]).all():
            return _hidden("One of its vertices is no place: a number is NaN or infinite.")
        if (corners["fill"] < 0).all() and (corners["stroke"] < 0).all():
            return _hidden("noFill() and noStroke() are in force: nothing of it is left.")
        return UNSURE
    if int(row["fill"]) < 0 and not has_stroke:
        return _hidden("noFill() and noStroke() are in force: nothing of it is left.")
    return UNSURE


def _reason_of_piece(case: Case, piece: Piece) -> Reason:
    """Return why a part of a row does not show."""
    what = "outline" if piece.part is Part.STROKE and case.kind is not Kind.LINE else ""
    if len(piece.alphas) and not piece.alphas.any() and piece.pipeline.shading is None:
        return _hidden(_transparent(case, what))
    texture = piece.pipeline.texture
    if isinstance(texture, Pixels):
        shown = case.log.steps[case.serial].pictures.get(texture, texture)
        if not shown.data[..., 3].any():
            return _hidden("Its image is transparent everywhere: all alphas are 0.")
    surface = case.log.steps[case.serial].surfaces[piece.pipeline.target]
    reached = reach(piece.pipeline._replace(target=surface), piece.block, piece.drawn)
    if reached.obstacle is not None:
        return _hidden(_obstacle(case, piece, reached, surface))
    return _seen(case, piece, reached)


def _transparent(case: Case, what: str) -> str:
    if case.kind is Kind.IMAGE:
        return "It is transparent: the alpha of tint() is 0."
    if what:
        return "It is transparent: the alpha of its stroke is 0."
    return "It is transparent: the alpha of its colour is 0, of 255."


def _seen(case: Case, piece: Piece, reached: Reach) -> Reason:
    """Return why a part does not show, though it lies on the picture."""
    target = piece.pipeline.target
    moments, is_whole = case.log.before(target)
    if not is_whole:
        return UNSURE  # what it was drawn on is not known
    if moments and piece.moment < moments[0]:
        return _hidden(_covered_later(case, moments[0]))
    found = []
    for place in reached.places:
        layers = history(case.log, target, place).layers
        found += [own for own in layers if _is_of(own, piece)]
    if not found:
        return UNSURE
    if any(layer.is_visible and layer.change > ALIKE for layer in found):
        return SHOWN
    if 0 < (alpha := int(found[0].color[3])) <= 2 * ALIKE and piece.pipeline.shading is None:
        return _hidden(f"It is all but transparent: the alpha of its colour is {alpha}, of 255.")
    if piece.pipeline.shading is not None and any(layer.is_visible for layer in found):
        return UNSURE  # its colours are the shader's
    layer = next((own for own in found if own.is_visible), found[0])
    if layer.is_visible:
        return _hidden(_same_color(case, piece, layer, reached))
    return _out_of_sight(case, layer)


def _is_of(layer: Layer, piece: Piece) -> bool:
    return (layer.moment[0], layer.row, layer.part) == (piece.moment[0], piece.row, piece.part)


def _covered_later(case: Case, clear: Moment) -> str:
    step = case.log.steps[clear[0]]
    blank = np.zeros(4, np.uint8)
    layer = Layer(clear, step.rows[clear[1]], Part.BACKGROUND, blank, np.zeros(1))
    title = describe(case.log, layer, case.around).title
    own = case.log.steps[case.serial].frame
    when = (
        ""
        if step.frame == own
        else f", in {_frame(step.frame)}, after it was drawn in {_frame(own)}"
    )
    return f"It is painted over by {title}{when}."


def _frame(number: int) -> str:
    return "setup()" if number == 0 else f"frame {number}"


def _out_of_sight(case: Case, layer: Layer) -> Reason:
    """Return what hides a layer."""
    if layer.behind is not None and layer.behind.row != layer.row:
        title = describe(case.log, layer.behind, case.around).title
        return _hidden(f"It is hidden behind {title}.", layer.behind)
    if layer.transparent:
        texture = layer.pipeline.texture if layer.pipeline else None
        name = case.around.images.get(texture, "its canvas") if isinstance(texture, Target) else ""
        if name:
            return _hidden(f"What it shows of {name} is transparent: nothing was drawn there.")
        return _hidden("What it shows is transparent: its alpha is 0.")
    if layer.unchanging and layer.pipeline is not None:
        mode = layer.pipeline.blend.name
        return _hidden(f"blendMode({mode}) is in force: with this colour it changes nothing.")
    over = layer.beneath
    while over is not None and (over.moment[0], over.row) == (layer.moment[0], layer.row):
        over = over.beneath  # its own outline
    if over is None:
        return UNSURE
    title = describe(case.log, over, case.around).title
    return _hidden(f"It is painted over by {title}.", over)


def _same_color(case: Case, piece: Piece, layer: Layer, reached: Reach) -> str:
    """Return why what is drawn cannot be told from what is behind it."""
    red, green, blue, _ = layer.color.tolist()
    vertices = piece.block.indices[piece.drawn.first : piece.drawn.first + piece.drawn.size]
    given = int(piece.block.colors[vertices, :3].max(initial=0))
    if piece.pipeline.program in LIT and max(red, green, blue) <= ALIKE < given:
        lights = "; ".join(light_in_words(light) for light in piece.pipeline.lights)
        about = (
            f"there is only {lights}" if lights else "lights are switched on, but there are none"
        )
        return (
            f"No light reaches what is seen of it, and so it is black: {about}. "
            "Write lights(), or ambientLight(100, 100, 100), before it."
        )
    behind = _behind(case, piece, layer, reached)
    color = f"{red}, {green}, {blue}"
    return f"It has the same colour, {color}, as what is behind it{behind}."


def _behind(case: Case, piece: Piece, layer: Layer, reached: Reach) -> str:
    """Return what is behind a layer, if that is a single call."""
    layers = history(case.log, piece.pipeline.target, reached.places[0]).layers
    before = [own for own in layers if own.moment < layer.moment or own.row < layer.row]
    below = next(
        (own for own in reversed(before) if own.part is not layer.part or own.row != layer.row),
        None,
    )
    return "" if below is None else f": {describe(case.log, below, case.around).title}"


def _obstacle(case: Case, piece: Piece, reached: Reach, surface: Target) -> str:
    """Return what keeps a part off the picture, with the numbers that tell."""
    match reached.obstacle:
        case Obstacle.NO_NUMBER:
            return "One of its numbers is none (NaN) or infinite."
        case Obstacle.BEHIND:
            return "It lies behind the camera: give it a smaller z, or move the camera back."
        case Obstacle.TOO_NEAR:
            near, _ = depth_range(piece.pipeline)
            return f"It is too near: the picture begins {near} in front of the camera."
        case Obstacle.TOO_FAR:
            _, far = depth_range(piece.pipeline)
            return f"It is too far away: the picture ends {far} in front of the camera."
        case Obstacle.LEFT | Obstacle.RIGHT | Obstacle.ABOVE | Obstacle.BELOW:
            return _beside(reached, surface, is_window=piece.pipeline.target is case.around.canvas)
        case Obstacle.FLAT:
            return _without_size(case, piece)
        case Obstacle.CLIPPED:
            clip = piece.pipeline.clip
            assert clip is not None
            return (
                "It lies outside of clip(), which lets through "
                f"{clip.width} x {clip.height} pixels at {clip.left}, {clip.top}."
            )
        case Obstacle.SMALL:
            return "It is smaller than a pixel."
    return "It lies outside of what the camera sees."


def _beside(reached: Reach, surface: Target, *, is_window: bool) -> str:
    """Return on which side of the window something lies."""
    sides = {
        Obstacle.LEFT: ("to the left of", "x", 0),
        Obstacle.RIGHT: ("to the right of", "x", 0),
        Obstacle.ABOVE: ("above", "y", 1),
        Obstacle.BELOW: ("below", "y", 1),
    }
    assert reached.obstacle is not None
    where, axis, index = sides[reached.obstacle]
    picture = "the window" if is_window else "its canvas"
    text = f"It lies {where} {picture}"
    if reached.bounds is None:
        return f"{text}."
    first, last = reached.bounds[index], reached.bounds[index + 2]
    size = (surface.width, surface.height)[index]
    shown = f"{first:.0f} to {last:.0f}" if last - first >= 1 else f"{first:.0f}"
    return f"{text}: there its {axis} is {shown}, and {picture} goes from 0 to {size}."


def depth_range(pipeline: Pipeline) -> tuple[str, str]:
    """Return how far from the camera the picture begins and ends, as numbers to be shown."""
    p = pipeline.projection
    if p[12:] == (0.0, 0.0, 0.0, 1.0):
        return number((p[11] + 1) / p[10]), number((p[11] - 1) / p[10])
    near, far = p[11] / (p[10] - 1), p[11] / (p[10] + 1)
    return number(near), number(far)


def _without_size(case: Case, piece: Piece) -> str:
    """Return why something has no area on the picture."""
    linear = case.modelview[:, :3] if case.kind is not Kind.MESH else _linear(piece)
    sizes = np.linalg.norm(linear, axis=0)
    if (sizes[:2] < 1e-9).any():
        return "The matrix squeezes it to nothing: scale(0) is in force."
    block = piece.block
    first, size = piece.drawn.first, piece.drawn.size
    corners = block.positions[block.indices[first : first + size]].reshape(-1, 3, 3).astype(float)
    if block.directions is None and block.offsets is None:
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        if np.sqrt((across**2).sum(axis=1)).max(initial=0.0) > 1e-9 and math.isfinite(across.sum()):
            return "It is seen exactly from its edge, and flat things have no thickness."
    return "It has no size: its width, its height or its radius is 0."


def _linear(piece: Piece) -> NDArray[np.float64]:
    return np.array(piece.drawn.modelview).reshape(3, 4)[:, :3]
