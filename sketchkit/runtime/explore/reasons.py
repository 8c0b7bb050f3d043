"""Why what a call has drawn does not show, in whole sentences; nothing if it does, or is unsure."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

import numpy as np

from sketchkit.backends.cpu.reach import Reach, reach
from sketchkit.draw.commands import Draw, DrawMesh
from sketchkit.draw.pipeline import Program
from sketchkit.draw.recorder import Kind
from sketchkit.draw.resources import Pixels, Target
from sketchkit.imaging.flatness import ALIKE
from sketchkit.runtime.explore.cases import Case, Piece, pieces_of
from sketchkit.runtime.explore.describe import describe, light_in_words
from sketchkit.runtime.explore.layers import Layer, Part
from sketchkit.runtime.explore.log import FrameLog, Moment
from sketchkit.runtime.explore.obstacles import obstacle_in_words
from sketchkit.runtime.explore.pixel import history

LEAST = 3  # vertices of a fill
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
    color : (r, g, b, a) or None
        Of what is SHOWN on the main canvas: the colour that the picture has there, then.
    """

    verdict: Verdict
    text: str = ""
    culprit: Layer | None = None
    color: tuple[int, int, int, int] | None = None


UNSURE = Reason(Verdict.UNSURE)


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
        if alike := [reason for reason in reasons if reason.verdict is verdict]:
            return alike[0]
    return reasons[0]


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
        if run.count < LEAST and not has_stroke:
            return _hidden(f"It has only {run.count} of the {LEAST} vertices that a fill needs.")
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
        return _hidden(obstacle_in_words(case, piece, reached, surface))
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
        over = history(case.log, target, place)
        mine = [own for own in over.layers if _is_of(own, piece)]
        if any(layer.is_visible and layer.change > ALIKE for layer in mine):
            is_main = target is case.around.canvas
            return Reason(Verdict.SHOWN, color=over.color if is_main else None)
        found += mine
    if not found:
        return UNSURE
    alpha = max(int(layer.color[3]) for layer in found)  # letters have soft edges
    if 0 < alpha <= 2 * ALIKE and piece.pipeline.shading is None:
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
