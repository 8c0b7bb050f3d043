"""The kinds of beginShape(): faces, and normals of faces without any."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from sketchkit.core.constants import QUAD_STRIP, QUADS, TRIANGLE_FAN, TRIANGLE_STRIP, TRIANGLES
from sketchkit.geometry.shapes import (
    faces,
    is_aligned,
    ragged_ranges,
    triangle_normals,
    vertex_normals,
)

KINDS = {
    "TRIANGLES": (TRIANGLES, 7, [[0, 1, 2], [3, 4, 5]]),
    "TRIANGLE_FAN": (TRIANGLE_FAN, 5, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]),
    "TRIANGLE_STRIP": (TRIANGLE_STRIP, 5, [[1, 2, 0], [2, 1, 3], [3, 4, 2]]),
    "QUADS": (QUADS, 9, [[0, 1, 2, 3], [4, 5, 6, 7]]),
    "QUAD_STRIP": (QUAD_STRIP, 7, [[0, 1, 3, 2], [2, 3, 5, 4]]),
}
FACING = [0, 0, 1]


def faces_of(kind, *counts):
    counts = np.array(counts)
    return faces(kind, np.cumsum(counts) - counts, counts)


def column(*points):
    return tuple(np.array([point], np.float32) for point in points)


@pytest.mark.parametrize(("kind", "count", "corners"), KINDS.values(), ids=KINDS)
def test_kind_makes_faces_of_its_vertices_and_leaves_the_rest(kind, count, corners):
    assert faces_of(kind, count).corners.tolist() == corners


@pytest.mark.parametrize("kind", [kind for kind, _, _ in KINDS.values()], ids=KINDS)
@pytest.mark.parametrize("count", [0, 1, 2])
def test_too_few_vertices_make_no_face(kind, count):
    assert len(faces_of(kind, count).corners) == 0


def test_faces_of_several_shapes_know_their_shape():
    found = faces_of(TRIANGLES, 3, 5, 6)

    assert found.corners.tolist() == [[0, 1, 2], [3, 4, 5], [8, 9, 10], [11, 12, 13]]
    assert found.shapes.tolist() == [0, 1, 2, 2]


def test_quad_is_split_from_its_first_to_its_third_corner():
    assert faces_of(QUADS, 4).triangles.tolist() == [[0, 1, 2], [2, 3, 0]]


def test_ragged_ranges_count_each_shape_from_zero():
    local, owner = ragged_ranges(np.array([2, 0, 3]))

    assert local.tolist() == [0, 1, 0, 1, 2]
    assert owner.tolist() == [0, 0, 2, 2, 2]


def test_clockwise_on_the_screen_faces_the_viewer():
    a, b, c = column((0, 0, 0), (4, 0, 0), (0, 4, 0))  # y points down

    assert triangle_normals(a, b, c).tolist() == [FACING]
    assert triangle_normals(a, c, b).tolist() == [[0, 0, -1]]


def test_triangle_without_area_has_no_normal():
    a, b, c = column((1, 1, 1), (2, 2, 2), (3, 3, 3))

    assert triangle_normals(a, b, c).tolist() == [[0, 0, 0]]


@given(arrays(np.float32, (3, 1, 3), elements=st.integers(-50, 50)))
def test_normals_are_unit_and_upright_on_their_triangle(corners):
    a, b, c = corners

    normal = triangle_normals(a, b, c)[0].astype(float)

    length = np.linalg.norm(normal)
    assert length == 0 or length == pytest.approx(1, abs=1e-5)
    for edge in (b - a, c - b):
        assert normal @ edge[0] == pytest.approx(0, abs=1e-3)


def test_vertex_takes_the_normal_of_its_last_triangle():
    strip = np.array([(0, 0, 0), (0, 9, 0), (9, 0, 0), (9, 9, -9)], np.float32)

    normals = vertex_normals(strip, faces_of(TRIANGLE_STRIP, 4))

    assert normals[0].tolist() != normals[3].tolist()
    assert normals[1].tolist() == normals[2].tolist() == normals[3].tolist()


def test_vertex_of_no_face_faces_the_viewer():
    positions = np.zeros((2, 3), np.float32)

    assert vertex_normals(positions, faces_of(TRIANGLES, 2)).tolist() == [FACING, FACING]


@pytest.mark.parametrize(
    ("corners", "expected"),
    [
        ([(0, 0), (5, 0), (5, 3), (0, 3)], True),
        ([(0, 0), (5, 0), (5, 3), (0, 3.5)], False),
        ([(0, 0), (5, 1), (4, 6), (-1, 5)], False),
    ],
    ids=["upright", "one side aslant", "turned"],
)
def test_quad_is_aligned_if_its_sides_lie_along_the_axes(corners, expected):
    x, y = np.array(corners, np.float32).T[:, None]

    assert is_aligned(x, y, triangles=False).tolist() == [expected]


@pytest.mark.parametrize(
    ("corners", "expected"),
    [([(0, 0), (5, 0), (0, 3)], True), ([(0, 0), (5, 0), (1, 3)], False)],
    ids=["right angle along the axes", "one side along an axis"],
)
def test_triangle_is_aligned_if_two_sides_lie_along_the_axes(corners, expected):
    x, y = np.array(corners, np.float32).T[:, None]

    assert is_aligned(x, y, triangles=True).tolist() == [expected]
