"""The history of one pixel: everything that was drawn there, and what of it still shows.

The pixel's samples are painted again, fragment by fragment, as the renderers do it; beside each
sample's colour and depth stands how much of the colour every layer has given.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.blending import blend
from sketchkit.backends.cpu.frames import FARTHEST, NO_TRIANGLE, average, window_of
from sketchkit.backends.cpu.probe import TEXTURED, Fragment, Range, probe
from sketchkit.backends.cpu.shading import Sampled
from sketchkit.backends.cpu.textures import Texture
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.commands import Clear, Draw, DrawMesh, Settle, Settling, Upload
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.pipeline import Blend, Pipeline
from sketchkit.draw.resources import Pixels, Target, Wrap
from sketchkit.draw.vertex import F32, U8, VertexBlock
from sketchkit.draw.vertex import Layer as Block
from sketchkit.runtime.explore.layers import VISIBLE, History, Layer, Part
from sketchkit.runtime.explore.log import FrameLog, Moment, Step
from sketchkit.runtime.explore.noting import Chain
from sketchkit.runtime.explore.own_shaders import own_fragments

FAR = FARTHEST << 32 | NO_TRIANGLE
DEEPEST = 6  # canvases drawn on canvases


@dataclass
class _Samples:
    """The state of a pixel while it is painted again."""

    colors: U8
    depths: NDArray[np.int64]
    nearest: list[Layer | None]
    layers: list[Layer] = field(default_factory=list)


class _Picture:
    """Another canvas as a texture: its colour where it is asked for, at a moment."""

    is_opaque = False

    def __init__(self, log: FrameLog, target: Target, moment: Moment, depth: int) -> None:
        self._log, self._target, self._moment, self._depth = log, target, moment, depth

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows."""
        return self._target.width, self._target.height

    def sample(self, uv: F32, texels_squared: F32, wrap: Wrap) -> U8:
        """Return colours, (4, k): those of the nearest pixels."""
        columns = []
        for u, v in uv.T:
            place = texel(self._target, (float(u), float(v)))
            found = history(self._log, self._target, place, self._moment, self._depth + 1)
            columns.append(found.color)
        return np.array(columns, np.uint8).T


def texel(target: Target, uv: tuple[float, float]) -> tuple[int, int]:
    """Return the pixel of a canvas at a place on its picture."""
    x, y = int(np.floor(uv[0] * target.width)), int(np.floor(uv[1] * target.height))
    return min(max(x, 0), target.width - 1), min(max(y, 0), target.height - 1)


def history(
    log: FrameLog,
    target: Target,
    place: tuple[int, int],
    moment: Moment | None = None,
    depth: int = 0,
) -> History:
    """Return what was drawn over a pixel of a canvas.

    Parameters
    ----------
    place : (x, y)
        From the top left of the picture.
    moment : Moment, optional
        What came before it alone; without it, all there is.
    depth : int
        On how many other canvases this one was met.
    """
    moments, is_whole = log.before(target, moment) if depth < DEEPEST else ([], False)
    count = target.samples
    samples = _Samples(
        np.zeros((count, 4), np.uint8), np.full(count, FAR, np.int64), [None] * count
    )
    for own in moments:
        _paint(samples, log, own, place, depth)
    return History(samples.layers, samples.colors, is_whole)


def _paint(
    samples: _Samples, log: FrameLog, moment: Moment, place: tuple[int, int], depth: int
) -> None:
    """Carry out one command on the pixel."""
    step = log.steps[moment[0]]
    match step.commands.commands[moment[1]]:
        case Clear() as command:
            _clear(samples, step, moment, command, place)
        case Settle(_, how):
            _settle(samples, how)
        case Upload(_, data, left, top):
            x, y = place[0] - left, place[1] - top
            if 0 <= y < data.shape[0] and 0 <= x < data.shape[1]:
                setter = step.writers.get(y * data.shape[1] + x, step.setter)
                _upload(samples, moment, data[y, x], setter)
        case Draw(pipeline, block, first, count):
            drawn = Range(first, count, IDENTITY)
            vertices = step.commands.blocks[block]
            for fragment in _fragments(log, moment, pipeline, (vertices, drawn), place, depth):
                row, is_stroke = step.commands.orders[block].owner(fragment.triangle)
                layer = _layer(samples, moment, row, _part(block, is_stroke))
                _add(samples, layer, fragment, pipeline)
        case DrawMesh(pipeline, part, modelview):
            drawn = Range(part.first, part.count, modelview, part.weight_scale)
            vertices = part.mesh.blocks[part.layer]
            for fragment in _fragments(log, moment, pipeline, (vertices, drawn), place, depth):
                inner, is_stroke = _owner(part, fragment.triangle)
                kind = _part(part.layer, is_stroke)
                layer = _layer(samples, moment, step.rows[moment[1]], kind, inner)
                _add(samples, layer, fragment, pipeline)


def _owner(part: MeshPart, triangle: int) -> tuple[int | None, bool]:
    """Return the row of a shape's own recorder that a triangle was made from."""
    order = part.mesh.orders.get(part.layer)
    return (None, False) if order is None else order.owner(triangle)


def _clear(
    samples: _Samples, step: Step, moment: Moment, command: Clear, place: tuple[int, int]
) -> None:
    layer = _layer(samples, moment, step.rows[moment[1]], Part.BACKGROUND)
    layer.color = np.array(command.color, np.uint8)
    surface = step.surfaces[command.target]
    window = window_of(surface, command.clip)
    row = place[1] if surface.top_row_first else surface.height - 1 - place[1]
    if not (window.left <= place[0] < window.right and window.top <= row < window.bottom):
        layer.clipped = layer.covered = len(samples.colors)
        return
    _replace_all(samples, layer)
    if command.depth:
        _forget_depth(samples)


def _part(block: Block, is_stroke: bool) -> Part:  # as the order of pieces has it
    if block is Block.FILLS:
        return Part.STROKE if is_stroke else Part.FILL
    return Part.STROKE if block is Block.LINES else Part.POINT


def _fragments(
    log: FrameLog,
    moment: Moment,
    pipeline: Pipeline,
    geometry: tuple[VertexBlock, Range],
    place: tuple[int, int],
    depth: int,
) -> list[Fragment]:
    step = log.steps[moment[0]]
    surface = step.surfaces[pipeline.target]
    texture = _texture(log, moment, step, pipeline, depth)
    known = probe(pipeline._replace(target=surface), *geometry, place, texture)
    return own_fragments(log, moment, pipeline, place, known)


def _texture(
    log: FrameLog, moment: Moment, step: Step, pipeline: Pipeline, depth: int
) -> Sampled | None:
    """Return what covers the triangles of a draw, as it was then."""
    source = pipeline.texture
    if source is None or pipeline.program not in TEXTURED:
        return None
    if isinstance(source, Pixels):
        return log.texture(step.pictures[source], Texture)
    return _Picture(log, source, moment, depth)


def _layer(
    samples: _Samples, moment: Moment, row: int, part: Part, inner_row: int | None = None
) -> Layer:
    """Return the layer of a part of a call; a new one if it is the first of it."""
    for layer in reversed(samples.layers):
        if layer.moment[0] != moment[0]:
            break
        key = layer.row, layer.part, layer.inner_row
        if row >= 0 and key == (row, part, inner_row) and part is not Part.BACKGROUND:
            return layer
    count = len(samples.colors)
    made = Layer(moment, row, part, np.zeros(4, np.uint8), np.zeros(count), inner_row)
    samples.layers.append(made)
    return made


def _add(samples: _Samples, layer: Layer, fragment: Fragment, pipeline: Pipeline) -> None:
    """Draw a fragment over the samples that it covers and that nothing nearer has."""
    layer.pipeline = pipeline
    layer.color, layer.uv = fragment.color, fragment.uv
    layer.covered += int(fragment.is_covered.sum())
    if fragment.is_clipped:
        layer.clipped += int(fragment.is_covered.sum())
        return
    if fragment.is_discarded:
        layer.discarded += int(fragment.is_covered.sum())
        return
    for sample in np.flatnonzero(fragment.is_covered):
        if pipeline.depth_test:
            if fragment.depths[sample] > samples.depths[sample]:
                layer.behind = samples.nearest[sample]
                continue
            if pipeline.depth_write:
                samples.depths[sample] = fragment.depths[sample] | NO_TRIANGLE
                samples.nearest[sample] = layer
        _mix(samples, int(sample), layer, fragment.color, pipeline.blend)


def _mix(samples: _Samples, sample: int, layer: Layer, color: U8, mode: Blend) -> None:
    """Blend a colour into a sample."""
    before = samples.colors[sample].copy()
    after = blend(mode, color, before)
    samples.colors[sample] = after
    change = int(np.abs(after[:3].astype(np.int64) - before[:3]).max())
    layer.change = max(layer.change, change)
    is_same = change == 0
    given, left = _proportions(mode, color, after, is_same=is_same)
    if not given:
        if color[3]:
            layer.unchanging += 1
        else:
            layer.transparent += 1
        return
    for other in samples.layers:
        if other is layer:
            continue
        other.shares[sample] *= left
        if left <= VISIBLE and other.shares[sample] <= VISIBLE and other.beneath is None:
            other.beneath = layer
    layer.shares[sample] = layer.shares[sample] * left + given


def _proportions(mode: Blend, color: U8, after: U8, *, is_same: bool) -> tuple[float, float]:
    """Return how much of a blended colour is new, and how much of the old one is left."""
    alpha = float(color[3]) / 255
    if mode is Blend.REPLACE:
        return 1.0, 0.0
    if mode is Blend.BLEND:
        return alpha, 1 - alpha
    if is_same:
        return 0.0, 1.0
    return (1.0, 0.0) if bool((after[:3] == color[:3]).all()) else (1.0, 1.0)


def _replace_all(samples: _Samples, layer: Layer) -> None:
    """Give all samples a layer's colour."""
    samples.colors[:] = layer.color
    for other in samples.layers:
        other.shares[:] = 0
        if other is not layer and other.beneath is None:
            other.beneath = layer
    layer.shares[:] = 1
    layer.covered = len(samples.colors)


def _upload(samples: _Samples, moment: Moment, color: U8, setter: Chain) -> None:
    """Take over a pixel that the sketch has set; the others of the canvas come as they are."""
    mean = average(samples.colors).astype(np.int64)
    if np.abs(mean - color.astype(np.int64)).max() <= 1 and samples.layers:
        samples.colors[:] = color
        _average_shares(samples)
        return
    layer = _layer(samples, moment, -1, Part.PIXELS)
    layer.color, layer.setter = color.copy(), setter
    _replace_all(samples, layer)


def _settle(samples: _Samples, how: Settling) -> None:
    """Begin a frame over the old picture."""
    if how is Settling.MEAN:
        samples.colors[:] = average(samples.colors)
        _average_shares(samples)
    elif how is Settling.TURN:
        samples.colors[:] = samples.colors[0]
        for layer in samples.layers:
            layer.shares[:] = layer.shares[0]
    if how in (Settling.KEEP, Settling.TURN):
        _forget_depth(samples)


def _average_shares(samples: _Samples) -> None:
    for layer in samples.layers:
        layer.shares[:] = layer.shares.mean()


def _forget_depth(samples: _Samples) -> None:
    samples.depths[:] = FAR
    samples.nearest = [None] * len(samples.nearest)
