"""Meshes: what has changed since somebody last looked."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.draw.meshes import MOST_EDITS, NEAR, Edit, Mesh
from sketchkit.draw.vertex import Layer, VertexBlock


@pytest.fixture
def mesh():
    block = VertexBlock(
        positions=np.zeros((1000, 3), np.float32),
        colors=np.zeros((1000, 4), np.uint8),
        indices=np.arange(999, dtype=np.uint32),
    )
    return Mesh({Layer.FILLS: block})


def change(mesh, *vertices):
    mesh.note_change(Layer.FILLS, "positions", np.array(vertices, np.int64))


def test_new_mesh_has_no_edits(mesh):
    assert mesh.edits_since(0) == []
    assert mesh.vertex_count == 1000


def test_edit_names_layer_column_and_vertices(mesh):
    change(mesh, 5, 6, 7)

    assert mesh.edits_since(0) == [Edit(Layer.FILLS, "positions", 5, 8)]


def test_what_was_seen_is_not_told_again(mesh):
    change(mesh, 5)
    seen = mesh.version

    change(mesh, 400)

    assert mesh.edits_since(seen) == [Edit(Layer.FILLS, "positions", 400, 401)]


def test_changes_near_together_are_one_edit(mesh):
    change(mesh, 10, 10 + NEAR)

    assert [(edit.first, edit.last) for edit in mesh.edits_since(0)] == [(10, 11 + NEAR)]


def test_changes_far_apart_are_two_edits(mesh):
    change(mesh, 10, 11 + NEAR)

    edits = [(edit.first, edit.last) for edit in mesh.edits_since(0)]

    assert edits == [(10, 11), (11 + NEAR, 12 + NEAR)]


def test_change_of_nothing_is_no_edit(mesh):
    change(mesh)

    assert mesh.version == 0


def test_too_many_edits_are_forgotten_and_everything_is_sent(mesh):
    seen = mesh.version
    for _ in range(MOST_EDITS + 1):
        change(mesh, 3)

    assert mesh.edits_since(seen) is None


def test_edits_after_the_forgotten_ones_are_told(mesh):
    for _ in range(MOST_EDITS + 1):
        change(mesh, 3)
    seen = mesh.version

    change(mesh, 9)

    assert [edit.first for edit in mesh.edits_since(seen)] == [9]
