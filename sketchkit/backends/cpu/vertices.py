"""The vertex stage: from a block's columns to the corners of triangles in clip space.

In float32 and in the order in which the shaders compute (shaders/*.vert), so that both renderers
round a corner to the same place.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from sketchkit.backends.cpu.columns import given, part_of
from sketchkit.backends.cpu.lighting import light_vertices, unit_colors
from sketchkit.backends.cpu.lines import widen_lines, widen_points
from sketchkit.backends.cpu.projection import project
from sketchkit.core.matrix import IDENTITY, Affine, multiply4, normal_matrix, to_mat4
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.vertex import F32, VertexBlock

LIT = (Program.LIT, Program.TEXTURED_LIT)
TEXTURED = (Program.TEXTURED, Program.TEXTURED_LIT)


class Range(NamedTuple):
    """Which indices of a block are drawn, and what takes its vertices to eye space."""

    first: int
    size: int
    modelview: Affine
    weight_scale: float = 1.0


def assemble(block: VertexBlock, pipeline: Pipeline, drawn: Range) -> F32:
    """Return the corners of a draw's triangles, (n, 3, 4 + k).

    Four columns of clip space (+y is where the frame's rows count to), then what is interpolated:
    the colour, not clamped; if lit, another one for the back of the face; if textured, u and v.
    """
    indices = block.indices[drawn.first : drawn.first + drawn.size].astype(np.int64)
    first, last = (indices.min(), indices.max() + 1) if len(indices) else (0, 0)
    vertices = part_of(block, int(first), int(last))
    clip = _places(vertices, pipeline, drawn)
    if pipeline.target.top_row_first:
        clip[:, 1] = -clip[:, 1]
    columns = [clip]
    if pipeline.program in LIT:
        columns += light_vertices(_in_eye_space(vertices, drawn.modelview), pipeline.lights)
    else:
        columns.append(unit_colors(vertices.colors))
    if pipeline.program in TEXTURED:
        columns.append(given(vertices.uvs))
    corners: F32 = np.concatenate(columns, axis=1)[indices - first]
    return corners.reshape(-1, 3, corners.shape[1])


def _places(block: VertexBlock, pipeline: Pipeline, drawn: Range) -> F32:
    """Return the vertices in Processing's clip space, (n, 4): +y is the top of the picture."""
    scale = np.float32(drawn.weight_scale)
    match pipeline.program:
        case Program.LINE:
            seen = _in_eye_space(block, drawn.modelview)
            weighted = given(seen.directions) * np.array([1, 1, 1, scale], np.float32)
            return widen_lines(seen.positions, weighted, pipeline)
        case Program.POINT:
            seen = _in_eye_space(block, drawn.modelview)
            return widen_points(seen.positions, given(block.offsets) * scale, pipeline)
        case _:
            transform = multiply4(pipeline.projection, to_mat4(drawn.modelview))
            return project(block.positions, transform)


def _in_eye_space(block: VertexBlock, modelview: Affine) -> VertexBlock:
    """Return vertices with places, normals and directions as the camera sees them."""
    if modelview == IDENTITY:
        return block
    rows = np.array(modelview, np.float32).reshape(3, 4)
    linear = rows[:, :3].T
    seen = replace(block, positions=block.positions @ linear + rows[:, 3])
    if block.normals is not None:
        turned = np.array(normal_matrix(modelview), np.float32).reshape(3, 3).T
        seen.normals = block.normals @ turned
    if block.directions is not None:
        along = block.directions[:, :3] @ linear
        seen.directions = np.concatenate([along, block.directions[:, 3:]], axis=1)
    return seen
