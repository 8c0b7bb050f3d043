"""The vertex stage: from a block's columns to the corners of triangles in clip space.

In float32 and in the order in which the shaders compute (shaders/*.vert), so that both renderers
round a corner to the same place.
"""

from __future__ import annotations

import numpy as np

from sketchkit.backends.cpu.columns import given, part_of
from sketchkit.backends.cpu.lighting import light_vertices, unit_colors
from sketchkit.backends.cpu.lines import widen_lines, widen_points
from sketchkit.backends.cpu.projection import project
from sketchkit.draw.commands import Draw
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.vertex import F32, VertexBlock

LIT = (Program.LIT, Program.TEXTURED_LIT)
TEXTURED = (Program.TEXTURED, Program.TEXTURED_LIT)


def assemble(block: VertexBlock, draw: Draw) -> F32:
    """Return the corners of a draw's triangles, (n, 3, 4 + k).

    Four columns of clip space (+y is where the frame's rows count to), then what is interpolated:
    the colour, not clamped; if lit, another one for the back of the face; if textured, u and v.
    """
    pipeline = draw.pipeline
    indices = block.indices[draw.first : draw.first + draw.count].astype(np.int64)
    first, last = (indices.min(), indices.max() + 1) if len(indices) else (0, 0)
    vertices = part_of(block, int(first), int(last))
    clip = _places(vertices, pipeline)
    if pipeline.target.top_row_first:
        clip[:, 1] = -clip[:, 1]
    columns = [clip]
    if pipeline.program in LIT:
        columns += light_vertices(vertices, pipeline.lights)
    else:
        columns.append(unit_colors(vertices.colors))
    if pipeline.program in TEXTURED:
        columns.append(given(vertices.uvs))
    corners: F32 = np.concatenate(columns, axis=1)[indices - first]
    return corners.reshape(-1, 3, corners.shape[1])


def _places(block: VertexBlock, pipeline: Pipeline) -> F32:
    """Return the vertices in Processing's clip space, (n, 4): +y is the top of the picture."""
    match pipeline.program:
        case Program.LINE:
            return widen_lines(block.positions, given(block.directions), pipeline)
        case Program.POINT:
            return widen_points(block.positions, given(block.offsets), pipeline)
        case _:
            return project(block.positions, pipeline.projection)
