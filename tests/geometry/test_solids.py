"""Box and sphere: unit size, closed, facing outwards."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.geometry.shapes import triangle_normals
from sketchkit.geometry.solids import Solid, unit_box, unit_sphere

SOLIDS = {
    "box": unit_box(),
    "sphere": unit_sphere(30, 30),
    "coarse sphere": unit_sphere(3, 2),
    "tall sphere": unit_sphere(5, 9),
}
details = st.tuples(st.integers(3, 12), st.integers(2, 12))

every_solid = pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)


def edges_by_place(solid: Solid) -> Counter:
    """Return how often each edge is passed, in its direction, by place rather than by corner."""
    names = [tuple((1000 * place).round().astype(int)) for place in solid.positions]
    return Counter(
        (names[a], names[b])
        for triangle in solid.triangles
        for a, b in zip(triangle, np.roll(triangle, -1), strict=True)
        if names[a] != names[b]  # the poles of a sphere are repeated
    )


@every_solid
def test_solid_has_no_boundary(solid):
    edges = edges_by_place(solid)

    assert set(edges.values()) == {1}
    assert {(b, a) for a, b in edges} == set(edges)


@given(details)
def test_sphere_of_any_detail_has_no_boundary(detail):
    edges = edges_by_place(unit_sphere(*detail))

    assert set(edges.values()) == {1}
    assert {(b, a) for a, b in edges} == set(edges)


@every_solid
def test_normals_are_unit(solid):
    np.testing.assert_allclose(np.linalg.norm(solid.normals, axis=1), 1, atol=1e-6)


@every_solid
def test_faces_and_normals_point_outwards(solid):
    a, b, c = (solid.positions[solid.triangles[:, i]] for i in range(3))
    outward = triangle_normals(a, b, c)

    centres = (a + b + c) / 3

    assert ((outward * centres).sum(axis=1) > 0).all()
    assert ((outward * solid.normals[solid.triangles[:, 0]]).sum(axis=1) > 0).all()


def test_box_is_one_long_each_way():
    positions = unit_box().positions

    assert positions.min(axis=0).tolist() == [-0.5] * 3
    assert positions.max(axis=0).tolist() == [0.5] * 3


def test_box_faces_come_in_processings_order():
    normals = unit_box().normals[::4].astype(int).tolist()

    assert normals == [[0, 0, -1], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, -1, 0], [0, 1, 0]]


def test_each_face_of_the_box_shows_the_whole_texture():
    for uvs in unit_box().uvs.reshape(6, 4, 2):
        assert sorted(uvs.tolist()) == [[0, 0], [0, 1], [1, 0], [1, 1]]


def test_box_is_outlined_face_by_face():
    box = unit_box()

    assert box.is_closed
    assert box.outlines.shape == (6, 4)


@given(details)
def test_sphere_corners_are_a_unit_from_the_middle(detail):
    sphere = unit_sphere(*detail)

    np.testing.assert_allclose(np.linalg.norm(sphere.positions, axis=1), 1, atol=1e-6)
    np.testing.assert_array_equal(sphere.normals, sphere.positions)


@given(details)
def test_sphere_has_two_triangles_a_cell_and_one_at_the_poles(detail):
    around, along = detail

    assert len(unit_sphere(around, along).triangles) == 2 * around * (along - 1)


def test_sphere_rows_have_the_latitudes_of_their_steps():
    heights = np.unique(unit_sphere(6, 4).positions[:, 1].round(5))

    np.testing.assert_allclose(heights, [-1, -np.sqrt(0.5), 0, np.sqrt(0.5), 1], atol=1e-5)


def test_sphere_is_wrapped_in_its_texture_once():
    uvs = unit_sphere(8, 4).uvs

    assert uvs.min() == 0
    assert uvs.max() == 1
