"""The vertex stage: from a block's columns to corners in clip space, with what they carry.

In float32 and in the order in which the shaders compute (shaders/*.vert), so that both renderers
round a corner to the same place.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketchkit.backends.cpu.lighting import light_vertices
from sketchkit.backends.cpu.lines import widen_lines, widen_points
from sketchkit.core.matrix import Mat4
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.vertex import F32, U8, Materials, VertexBlock

LIT = (Program.LIT, Program.TEXTURED_LIT)
TEXTURED = (Program.TEXTURED, Program.TEXTURED_LIT)


class Vertices(NamedTuple):
    """What the vertex stage hands on; one row a vertex.

    Attributes
    ----------
    clip : (n, 4) float32, clip space, +y towards the top of the picture
    varyings : (n, 8 or 10) float32
        The colours of front and back, not clamped, and u, v where there is a texture.
    """

    clip: F32
    varyings: F32


def shade_vertices(block: VertexBlock, pipeline: Pipeline) -> Vertices:
    """Return the vertices of a block as the pipeline's program makes them."""
    clip = _place(block, pipeline)
    front = back = unit_colors(block.colors)
    if pipeline.program in LIT:
        front, back = light_vertices(block, pipeline.lights)
    columns = [front, back]
    if pipeline.program in TEXTURED and block.uvs is not None:
        columns.append(block.uvs)
    return Vertices(clip, np.concatenate(columns, axis=1))


def part_of(block: VertexBlock, first: int, last: int) -> VertexBlock:
    """Return the vertices from `first` to before `last`, with no indices."""
    rows = slice(first, last)
    materials = block.materials
    return VertexBlock(
        positions=block.positions[rows],
        colors=block.colors[rows],
        indices=block.indices[:0],
        uvs=None if block.uvs is None else block.uvs[rows],
        normals=None if block.normals is None else block.normals[rows],
        materials=materials
        and Materials(
            materials.ambient[rows],
            materials.specular[rows],
            materials.emissive[rows],
            materials.shininess[rows],
        ),
        directions=None if block.directions is None else block.directions[rows],
        offsets=None if block.offsets is None else block.offsets[rows],
    )


def _place(block: VertexBlock, pipeline: Pipeline) -> F32:
    """Return the vertices in clip space, (n, 4)."""
    if pipeline.program is Program.LINE and block.directions is not None:
        return widen_lines(block.positions, block.directions, pipeline)
    if pipeline.program is Program.POINT and block.offsets is not None:
        return widen_points(block.positions, block.offsets, pipeline)
    return project(block.positions, pipeline.projection)
