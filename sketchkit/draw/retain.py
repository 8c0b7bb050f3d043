"""Recorded calls to a mesh, and what is edited afterwards: what a retained shape consists of.

An edit that only gives vertices other values changes those vertices; `VertexBlock.sources` leads
to them. Whatever else changes, the shape is expanded anew.
"""

from __future__ import annotations

from enum import Enum

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.draw.assemble import Assembler
from sketchkit.draw.commands import Draw
from sketchkit.draw.expand import expand
from sketchkit.draw.layers import unpack_argb
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.rows import Rows
from sketchkit.draw.vertex import Layer
from sketchkit.geometry.shapes import FACE_KINDS

I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]


class Quality(Enum):
    """What of a corner can be edited."""

    PLACE = "place"
    FILL = "fill"
    STROKE = "stroke"
    NORMAL = "normal"
    UV = "uv"


# In which layer, and in which column, each quality shows.
_COLUMNS: dict[Quality, tuple[tuple[Layer, str], ...]] = {
    Quality.PLACE: ((Layer.FILLS, "positions"), (Layer.POINTS, "positions")),
    Quality.FILL: ((Layer.FILLS, "colors"),),
    Quality.STROKE: ((Layer.LINES, "colors"), (Layer.POINTS, "colors")),
    Quality.NORMAL: ((Layer.FILLS, "normals"),),
    Quality.UV: ((Layer.FILLS, "uvs"),),
}
_FOLLOWING = {Quality.FILL: ("ambient",)}  # columns that may follow another


def retain(recorder: Recorder, weight_scale: float) -> list[MeshPart]:
    """Return the parts of the mesh that all rows of a recorder make, in the order of drawing.

    The rows' states have the identity for matrix, and stages with a `sighting`. Outlines are made
    `weight_scale` times as wide as they were recorded.
    """
    if not recorder.row_end:
        return []
    rows = Rows(recorder, weight_scale)
    commands = Assembler(rows).assemble(expand(rows))
    mesh = Mesh(commands.blocks, recorder, weight_scale, orders=commands.orders)
    return [
        MeshPart(mesh, draw.layer, draw.first, draw.count, draw.pipeline.texture)
        for draw in commands.commands
        if isinstance(draw, Draw)
    ]


def shows_corners(kind: int, quality: Quality) -> bool:
    """Return whether a shape's vertices are its corners, so that an edit need not expand it anew.

    Parameters
    ----------
    kind : int
        As `beginShape()` has it.
    """
    if kind in FACE_KINDS:
        return True
    return kind == c.POINTS and quality in (Quality.PLACE, Quality.STROKE)


def revise(mesh: Mesh, recorder: Recorder, quality: Quality, corners: I64) -> None:
    """Let the vertices of a mesh show what some corners of the recorder are now.

    Outlines in 3D stay where they were, and so do normals made from faces: Processing's do.
    """
    table = recorder.corner_array()
    is_changed = np.zeros(len(table) + 1, np.bool_)  # the last one stands for a source of -1
    is_changed[corners] = True
    for layer, column in _COLUMNS[quality]:
        block = mesh.blocks.get(layer)
        if block is None or block.sources is None:
            continue
        vertices = np.flatnonzero(is_changed[block.sources])
        values = _values(recorder, table, quality, block.sources[vertices].astype(np.int64))
        _write(mesh, layer, column, vertices, values)


def repaint(mesh: Mesh, quality: Quality, color: int, *, with_ambient: bool = False) -> None:
    """Give everything that is filled, or stroked, one colour.

    `with_ambient` says whether the colour in ambient light is the fill colour.
    """
    painted = unpack_argb(np.array([color], np.int64))
    for layer, block in mesh.blocks.items():
        assert block.sources is not None
        is_fill = (block.sources >= 0) & (layer is Layer.FILLS)  # strokes of P2D have no source
        vertices = np.flatnonzero(is_fill if quality is Quality.FILL else ~is_fill)
        columns = ("colors", *_FOLLOWING.get(quality, ())[:with_ambient])
        for column in columns:
            _write(mesh, layer, column, vertices, painted)


def _values(
    recorder: Recorder, table: NDArray[np.void], quality: Quality, sources: I64
) -> NDArray[np.generic]:
    """Return what corners are now, as the columns of a block have it."""
    match quality:
        case Quality.PLACE:
            places: NDArray[np.float32] = table["place"][sources]
            return places
        case Quality.FILL | Quality.STROKE:
            return unpack_argb(np.maximum(table[quality.value][sources], 0))
        case Quality.NORMAL:
            assert recorder.normals is not None
            return recorder.normals[sources]
        case Quality.UV:
            return recorder.uv_array()[sources]


def _write(mesh: Mesh, layer: Layer, name: str, vertices: I64, values: NDArray[np.generic]) -> None:
    """Put values into a column of a layer, and note which vertices they are."""
    block = mesh.blocks[layer]
    owner = block.materials if name == "ambient" else block
    if owner is None or getattr(owner, name) is None or not len(vertices):
        return
    column = getattr(owner, name)
    if not column.flags.writeable:
        column = column.copy()
        setattr(owner, name, column)
    column[vertices] = values
    mesh.note_change(layer, name, vertices)
