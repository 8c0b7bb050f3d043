"""CpuBackend: carries out draw lists with NumPy.

A draw goes through the stages of a graphics card, each a module: vertices, clipping, triangles
(set-up), raster, then visibility or layers, with shading for the colours.
"""

from __future__ import annotations

import weakref
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.clipping import clip_triangles
from sketchkit.backends.cpu.frames import Frame, Surface, window_of
from sketchkit.backends.cpu.layers import draw_in_layers
from sketchkit.backends.cpu.raster import rasterize
from sketchkit.backends.cpu.shading import Shading
from sketchkit.backends.cpu.textures import Texture
from sketchkit.backends.cpu.triangles import set_up
from sketchkit.backends.cpu.vertices import TEXTURED, Range, assemble
from sketchkit.backends.cpu.visibility import draw_visible
from sketchkit.core.errors import SketchError
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.commands import Clear, Draw, DrawList, DrawMesh, Settle, Upload
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.pipeline import Blend, Pipeline
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import U8, VertexBlock

MOST_PARTS = 16  # more runs of opaque and translucent triangles than this are drawn as one


class CpuBackend:
    """Draws with NumPy alone."""

    name = "cpu"

    def __init__(self) -> None:
        self._frames: weakref.WeakKeyDictionary[Target, Frame] = weakref.WeakKeyDictionary()
        self._textures: weakref.WeakKeyDictionary[Pixels, Texture] = weakref.WeakKeyDictionary()

    def describe(self) -> dict[str, str]:
        """Return what draws."""
        return {"renderer": "sketchkit's own, in NumPy", "version": np.__version__}

    def execute(self, commands: DrawList) -> None:
        """Carry out the commands in order."""
        for command in commands.commands:
            match command:
                case Clear(target, color, depth, clip):
                    self._frame(target).clear(window_of(target, clip), color, depth=depth)
                case Settle(target, how):
                    self._frame(target).settle(how)
                case Upload(target, data, left, top):
                    if not target.top_row_first:
                        data, top = data[::-1], target.height - top - len(data)
                    self._frame(target).replace(data, left, top)
                case Draw(pipeline, layer, first, count):
                    block = commands.blocks[layer]
                    self._draw(pipeline, block, Range(first, count, IDENTITY))
                case DrawMesh(pipeline, part, modelview):
                    block = part.mesh.blocks[part.layer]
                    whole = Range(part.first, part.count, modelview, part.weight_scale)
                    self._draw(pipeline, block, whole)

    def prepare(self, source: ShaderSource) -> None:
        """Refuse a shader of the sketch's.

        Raises
        ------
        SketchError
            Always: GLSL is for graphics cards.
        """
        raise SketchError(
            f"The CPU renderer does not run shaders, and {source.name} is one.",
            hint="Draw with OpenGL: --renderer gl.",
        )

    def read(self, target: Target) -> U8:
        """Return what was drawn, (h, w, 4) RGBA, top row first, samples averaged."""
        rows = self._frame(target).picture()
        return rows if target.top_row_first else rows[::-1].copy()

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return one pixel of it, (4,) RGBA."""
        row = y if target.top_row_first else target.height - 1 - y
        pixel: U8 = self._frame(target).picture()[row, x]
        return pixel

    def forget(self, resource: Pixels | Target | Mesh) -> None:
        """Let go of what is kept for a resource."""
        match resource:
            case Target():
                self._frames.pop(resource, None)
            case Pixels():
                self._textures.pop(resource, None)

    def close(self) -> None:
        """Let go of everything."""
        self._frames.clear()
        self._textures.clear()

    def _frame(self, target: Target) -> Frame:
        """Return a target's frame, made anew if its size has changed."""
        frame = self._frames.get(target)
        if frame is None or frame.version != target.version:
            frame = self._frames[target] = Frame(target)
        return frame

    def _texture(self, pipeline: Pipeline) -> Texture | None:
        """Return what a pipeline's program samples, made anew if the image has changed."""
        pixels = pipeline.texture
        if pixels is None or pipeline.program not in TEXTURED:
            return None
        if isinstance(pixels, Target):  # as it is now
            return Texture(Pixels(self.read(pixels), mipmaps=False))
        texture = self._textures.get(pixels)
        if texture is None or texture.version != pixels.version:
            texture = self._textures[pixels] = Texture(pixels)
        return texture

    def _draw(self, pipeline: Pipeline, block: VertexBlock, drawn: Range) -> None:
        """Take a draw through the stages."""
        # As on a graphics card: what is divided by 0 is infinite, or no number.
        with np.errstate(all="ignore"):
            self._rasterize(pipeline, block, drawn)

    def _rasterize(self, pipeline: Pipeline, block: VertexBlock, drawn: Range) -> None:
        frame = self._frame(pipeline.target)
        triangles = set_up(clip_triangles(assemble(block, pipeline, drawn)), frame)
        window = window_of(pipeline.target, pipeline.clip)
        reached = triangles.within(window.widened())
        if reached.is_empty:
            return
        shading = Shading(triangles, pipeline, frame.grid.centre, self._texture(pipeline))
        for part, is_opaque in _parts(shading.is_opaque, pipeline.blend):
            turned = pipeline.target.top_row_first
            spans = rasterize(triangles, part, window, frame.grid, turned=turned)
            draw = draw_visible if is_opaque else draw_in_layers
            draw(spans, shading, Surface(frame, reached, pipeline))


def _parts(is_opaque: NDArray[np.bool_], mode: Blend) -> Iterator[tuple[slice, bool]]:
    """Yield runs of triangles that hide what is behind them, and of others."""
    if mode is Blend.REPLACE:
        yield slice(0, len(is_opaque)), True
        return
    changes = np.flatnonzero(np.diff(is_opaque)) + 1
    if mode is not Blend.BLEND or len(changes) > MOST_PARTS:
        yield slice(0, len(is_opaque)), False
        return
    edges = [0, *changes.tolist(), len(is_opaque)]
    for first, last in pairwise(edges):
        yield slice(first, last), bool(is_opaque[first])
