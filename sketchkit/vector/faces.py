"""What a draw list draws, as units of a page: triangles, lines and points on the screen."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import groupby
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.fonts.glyph_atlas import Sheet
from sketchkit.core.constants import BEVEL, ROUND, SQUARE
from sketchkit.core.matrix import Affine
from sketchkit.core.style import NO_COLOR
from sketchkit.draw.commands import Draw, DrawList, DrawMesh
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.resources import Target, Texture
from sketchkit.draw.rows import project
from sketchkit.draw.vertex import Layer, VertexBlock
from sketchkit.geometry.painter import CORNERS, paint_order
from sketchkit.vector.page import (
    Ellipse,
    Ink,
    Item,
    Mark,
    Page,
    Path,
    Picture,
    Rect,
    Setting,
    joined,
    polyline,
    scaled,
)
from sketchkit.vector.pictures import fitted, letter_path, tinted_picture
from sketchkit.vector.views import on_screen

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]

OPAQUE = 255
ALPHA_FIRST = np.array([24, 16, 8, 0])
TO_ARGB = np.array([3, 0, 1, 2])


class Unit(NamedTuple):
    """Something to paint, and where it lies: (4, 3), x, y and nearness on the screen."""

    polygon: F64
    item: Item


class Batch(NamedTuple):
    """A range of triangles that are drawn in one way; `modelview` takes them to eye space."""

    pipeline: Pipeline
    layer: Layer
    block: VertexBlock
    triangles: I64  # (t, 3)
    modelview: Affine | None = None
    weight_scale: float = 1.0

    @property
    def setting(self) -> Setting:
        """Where it is drawn, and how it is mixed in."""
        return Setting(self.pipeline.clip, self.pipeline.blend)

    def eye(self, vertices: I64) -> F64:
        """Return places of some vertices in eye space, (n, 3)."""
        return self._turned(self.block.positions[vertices].astype(np.float64), moves=True)

    def _turned(self, vectors: F64, *, moves: bool) -> F64:
        if self.modelview is None:
            return vectors
        matrix = np.array(self.modelview).reshape(3, 4)
        turned: F64 = vectors @ matrix[:, :3].T + matrix[:, 3] * moves
        return turned

    def directions(self, vertices: I64) -> F64:
        """Return where the other ends of strokes are, from these, in eye space, (n, 3)."""
        assert self.block.directions is not None
        return self._turned(self.block.directions[vertices, :3].astype(np.float64), moves=False)

    def screen(self, eye: F64) -> F64:
        """Return eye-space points on the screen; NaN where they are not before the eye."""
        return on_screen(self.pipeline.projection, self.pipeline.target, eye)

    def pixels(self, lengths: F64, eye: F64) -> F64:
        """Return lengths across strokes in pixels, (n,), at places in eye space."""
        if not self.pipeline.stroke_perspective:
            return lengths * self.weight_scale
        across = abs(self.pipeline.projection[0]) * self.pipeline.target.across / 2
        return lengths * self.weight_scale * across / project(self.pipeline.projection, *eye.T)[3]


def batch_of(command: Draw | DrawMesh, commands: DrawList) -> Batch:
    """Return what a command of a list draws."""
    if isinstance(command, Draw):
        block = commands.blocks[command.layer]
        triangles = _range(block, command.first, command.count)
        return Batch(command.pipeline, command.layer, block, triangles)
    part = command.part
    block = part.mesh.blocks[part.layer]
    triangles = _range(block, part.first, part.count)
    return Batch(
        command.pipeline, part.layer, block, triangles, command.modelview, part.weight_scale
    )


def _range(block: VertexBlock, first: int, count: int) -> I64:
    return block.indices[first : first + count].reshape(-1, 3).astype(np.int64)


def in_depth(units: list[Unit]) -> list[Item]:
    """Return what units paint, what is far first."""
    if not units:
        return []
    order = paint_order(np.stack([unit.polygon for unit in units]))
    return [units[i].item for i in order.tolist()]


def units_of(batch: Batch, page_of: Callable[[Target], Page]) -> Iterator[Unit]:
    """Yield what a batch draws, in the order in which it does.

    `page_of` returns the page of another canvas.
    """
    if batch.layer is Layer.LINES:
        yield from _lines(batch)
    elif batch.layer is Layer.POINTS:
        yield from _points(batch)
    elif batch.pipeline.texture is None:
        yield from _triangles(batch)
    else:
        yield from _textured(batch, page_of)


def _triangles(batch: Batch) -> Iterator[Unit]:
    places = _places(batch)
    colors = packed(batch.block.colors[batch.triangles].mean(axis=1))
    is_seen = ~np.isnan(places).any(axis=(1, 2))
    shown = [i for i in np.flatnonzero(is_seen).tolist() if colors[i] >> 24]
    # Where depth does not matter, triangles of one opaque colour become one path, without seams.
    joins = not batch.pipeline.depth_test
    for (color, _), run in groupby(
        shown, key=lambda i: (colors[i], 0 if joins and colors[i] >> 24 == OPAQUE else i)
    ):
        own = places[list(run)]
        path = joined([corners[:, :2] for corners in own])
        yield Unit(_padded(own[0]), Mark(path, Ink(fill=color), batch.setting))


def _places(batch: Batch) -> F64:
    """Return the corners of triangles on the screen, (t, 3, 3)."""
    return batch.screen(batch.eye(batch.triangles.ravel())).reshape(-1, 3, 3)


def _textured(batch: Batch, page_of: Callable[[Target], Page]) -> Iterator[Unit]:
    """Yield parts of images, and letters: of the two triangles of one, the first stands for it."""
    texture, all_uvs = batch.pipeline.texture, batch.block.uvs
    assert texture is not None
    assert all_uvs is not None
    colors = packed(batch.block.colors[batch.triangles].mean(axis=1))
    images = {color: tinted_picture(texture, color, page_of) for color in set(colors)}
    lettered: set[int] = set()
    for place, corners, color in zip(_places(batch), batch.triangles, colors, strict=True):
        uvs = all_uvs[corners].astype(np.float64)
        matrix = fitted(place[:, :2], uvs)
        if np.isnan(place).any() or matrix is None or lettered & set(corners.tolist()):
            continue
        path = _letter(texture, uvs)
        if path is None:
            within = polyline(place[:, :2], is_closed=True)
            image, opacity = images[color]
            item: Item = Picture(image, batch.setting, matrix, within, opacity)
        else:
            lettered.update(corners.tolist())
            small = scaled(matrix, texture.width, texture.height)
            item = Mark(path, Ink(fill=color), batch.setting, small)
        yield Unit(_padded(place), item)


def _letter(texture: Texture, uvs: F64) -> Path | None:
    """Return the outline of the letter whose image has these corners, if it is one."""
    if not isinstance(texture, Sheet):
        return None
    u, v = uvs.min(axis=0) * (texture.width, texture.height)
    return letter_path(texture, round(u), round(v))


def _lines(batch: Batch) -> Iterator[Unit]:
    """Yield the segments of strokes: each is two triangles, the first from its begin to its end."""
    assert batch.block.directions is not None
    triangles = batch.triangles
    steps = triangles - triangles[:, :1]
    begins = triangles[(steps == (0, 1, 2)).all(axis=1), 0]  # all others are joins, or second ones
    eye = batch.eye(begins)
    pull = np.array(batch.pipeline.line_scale)
    ends = [batch.screen(place * pull) for place in (eye, eye + batch.directions(begins))]
    segments = np.stack(ends, axis=1)  # (n, 2, 3)
    half = np.abs(batch.block.directions[begins, 3].astype(np.float64))
    weights = 2 * batch.pixels(half, eye)
    colors = packed(batch.block.colors[begins].astype(np.float64))
    keys = [[tuple(end) for end in segment] for segment in segments.round(2).tolist()]
    meetings = Counter(key for pair in keys for key in set(pair))
    for segment, weight, color, pair in zip(segments, weights.tolist(), colors, keys, strict=True):
        if np.isnan(segment).any():
            continue
        is_joined = min(meetings[key] for key in pair) > 1
        cap = ROUND if is_joined else SQUARE  # strokes of P3D have no caps, but they have joins
        ink = Ink(NO_COLOR, color, weight, cap, BEVEL)
        path = polyline(segment[:, :2], is_closed=False)
        yield Unit(_padded(segment), Mark(path, ink, batch.setting))


def _points(batch: Batch) -> Iterator[Unit]:
    """Yield points: each is a fan around its place."""
    assert batch.block.offsets is not None
    hubs, first, sides = np.unique(batch.triangles[:, 0], return_index=True, return_counts=True)
    hubs, sides = hubs[np.argsort(first)], sides[np.argsort(first)]
    eye = batch.eye(hubs)
    rims = batch.triangles[np.sort(first), 1]
    reach = np.abs(batch.block.offsets[rims].astype(np.float64)).max(axis=1)
    sizes = batch.pixels(reach, eye)
    colors = packed(batch.block.colors[hubs].astype(np.float64))
    for place, size, count, color in zip(
        batch.screen(eye), sizes.tolist(), sides.tolist(), colors, strict=True
    ):
        if np.isnan(place).any():
            continue
        x, y, _ = place.tolist()
        is_square = count == CORNERS
        outline = (
            Rect(x - size, y - size, 2 * size, 2 * size) if is_square else Ellipse(x, y, size, size)
        )
        yield Unit(_padded(place[None]), Mark(outline, Ink(fill=color), batch.setting))


def _padded(corners: F64) -> F64:
    """Return a polygon of four corners: the last one is repeated."""
    return np.concatenate([corners, corners[-1:].repeat(CORNERS - len(corners), axis=0)])


def packed(colors: F64) -> list[int]:
    """Return RGBA colours, (n, 4), 0..255, as packed ARGB."""
    channels = colors.round().astype(np.int64)[:, TO_ARGB]
    return [int(color) for color in (channels << ALPHA_FIRST).sum(axis=1)]
