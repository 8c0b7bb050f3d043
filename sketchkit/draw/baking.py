"""Meshes moved by a matrix: what a shader of the sketch's finds of a shape with transforms.

The built-in programs take a shape's own transforms as a part of the modelview. Processing carries
them out on the vertices, once; a shader that colours by the place in the shape sees the difference.
"""

from __future__ import annotations

import weakref
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Affine
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.recorder import CustomKind
from sketchkit.draw.vertex import VertexBlock

F32 = NDArray[np.float32]


class _Baked(NamedTuple):
    """A moved mesh, and what it was made from."""

    version: int
    matrix: Affine
    mesh: Mesh


_baked: weakref.WeakKeyDictionary[Mesh, _Baked] = weakref.WeakKeyDictionary()


def baked(part: MeshPart, matrix: Affine) -> MeshPart:
    """Return a part whose vertices lie where a matrix takes them."""
    held = _baked.get(part.mesh)
    if held is None or (held.version, held.matrix) != (part.mesh.version, matrix):
        held = _Baked(part.mesh.version, matrix, _moved(part.mesh, matrix))
        _baked[part.mesh] = held
    return part._replace(mesh=held.mesh)


def _moved(mesh: Mesh, matrix: Affine) -> Mesh:
    kinds = _kinds(mesh)
    m = np.array(matrix, np.float32).reshape(3, 4)
    return Mesh({layer: _moved_block(block, m, kinds) for layer, block in mesh.blocks.items()})


def _kinds(mesh: Mesh) -> dict[str, CustomKind]:
    """Return what each attribute of the sketch's own is."""
    entries = [] if mesh.source is None else mesh.source.attributes
    return {
        name: custom.kind
        for entry in entries
        if entry.custom
        for name, custom in entry.custom.items()
    }


def _moved_block(block: VertexBlock, m: F32, kinds: dict[str, CustomKind]) -> VertexBlock:
    linear = m[:, :3]
    moved = replace(block, positions=_placed(block.positions, m), custom=dict(block.custom))
    if block.normals is not None:
        moved.normals = _turned(block.normals, linear)
    if block.directions is not None:
        moved.directions = block.directions.copy()
        moved.directions[:, :3] = block.directions[:, :3] @ linear.T
    for name, column in block.custom.items():
        match kinds.get(name):
            case CustomKind.PLACE:
                moved.custom[name] = _placed(column, m)
            case CustomKind.DIRECTION:
                moved.custom[name] = _turned(column, linear)
    return moved


def _placed(places: F32, m: F32) -> F32:
    """Return places after a matrix; the sums run in Processing's order, to round alike."""
    x, y, z = places.T
    columns = [x * row[0] + y * row[1] + z * row[2] + row[3] for row in m]
    return np.stack(columns, axis=1).astype(np.float32)


def _turned(normals: F32, linear: F32) -> F32:
    """Return normals after a matrix: as Processing does it, without the inverse."""
    turned: F32 = (normals @ linear.T).astype(np.float32)
    return turned
