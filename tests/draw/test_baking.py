"""Meshes moved by a matrix, for shaders of the sketch's own."""

from __future__ import annotations

import numpy as np

from sketchkit.core.matrix import IDENTITY, rotate_z, scale, translate
from sketchkit.draw.baking import baked
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.vertex import Layer, VertexBlock


def part() -> MeshPart:
    positions = np.array([[0, 0, 0], [10, 0, 0], [0, 10, 0]], np.float32)
    block = VertexBlock(
        positions=positions,
        colors=np.full((3, 4), 255, np.uint8),
        indices=np.arange(3, dtype=np.uint32),
        normals=np.array([[1, 0, 0]] * 3, np.float32),
    )
    return MeshPart(Mesh({Layer.FILLS: block}), Layer.FILLS, 0, 3, None)


def test_vertices_lie_where_the_matrix_takes_them() -> None:
    moved = baked(part(), scale(translate(IDENTITY, 5, 6, 0), 2, 2, 2))

    block = moved.mesh.blocks[Layer.FILLS]
    assert block.positions.tolist() == [[5, 6, 0], [25, 6, 0], [5, 26, 0]]


def test_normals_take_the_matrix_as_it_is_like_processings() -> None:
    moved = baked(part(), scale(IDENTITY, 2, 1, 1))

    block = moved.mesh.blocks[Layer.FILLS]
    assert block.normals is not None
    assert block.normals.tolist() == [[2, 0, 0]] * 3


def test_the_mesh_itself_stays() -> None:
    original = part()

    baked(original, translate(IDENTITY, 5, 6, 0))

    assert original.mesh.blocks[Layer.FILLS].positions[0].tolist() == [0, 0, 0]


def test_same_matrix_gives_the_same_mesh_until_it_is_edited() -> None:
    original = part()
    matrix = rotate_z(IDENTITY, 1.0)

    first = baked(original, matrix)
    again = baked(original, matrix)
    original.mesh.note_change(Layer.FILLS, "positions", np.array([0]))
    later = baked(original, matrix)

    assert again.mesh is first.mesh
    assert later.mesh is not first.mesh
