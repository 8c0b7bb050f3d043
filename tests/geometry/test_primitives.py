"""Whose normal corners take. The groups were measured on the GLU tessellator that Processing uses.

For thousands of random polygons more the same was found, whether simple, with holes or crossing;
but not for all of those where many points and edges coincide.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketchkit.geometry.polygons import Winding, tessellate
from sketchkit.geometry.primitives import normal_givers

COMB = [(0, 0), (1, 6), (2, 2), (3, 7), (4, 1), (5, 6), (6, 3), (7, 8), (8, 0), (4, -2)]
QUAD = [(0, 0), (9, 1), (8, 9), (1, 8)]
HOLE = [(3, 3), (2, 6), (6, 7), (7, 4)]

GROUPS = {
    "quad": (QUAD, [4], [("fan", (3, 0, 1, 2))]),
    "hexagon": (
        [(2, 0), (7, 1), (9, 5), (7, 9), (2, 8), (0, 4)],
        [6],
        [("strip", (5, 0, 4, 1, 3, 2))],
    ),
    "arrow": (
        [(0, 3), (5, 3), (5, 0), (9, 4), (5, 8), (5, 6), (0, 6)],
        [7],
        [("fan", (1, 2, 3, 5, 6, 0)), ("triangles", (5, 3, 4))],
    ),
    "zigzag": (
        [(0, 0), (2, 3), (4, 0), (6, 3), (8, 0), (8, 5), (6, 8), (4, 5), (2, 8), (0, 5)],
        [10],
        [("strip", (9, 1, 8, 2, 7, 3, 6, 4, 5)), ("triangles", (1, 9, 0))],
    ),
    "comb": (
        COMB,
        [10],
        [
            ("strip", (4, 5, 9, 6, 8, 7)),
            ("fan", (9, 0, 2, 3, 4)),
            ("triangles", (2, 0, 1)),
        ],
    ),
    "comb, the other way round": (
        COMB[::-1],
        [10],
        [
            ("strip", (2, 3, 1, 5, 0, 6, 7)),
            ("fan", (7, 8, 9, 0)),
            ("triangles", (5, 3, 4)),
        ],
    ),
    "lying comb": (
        [(y, x) for x, y in COMB],
        [10],
        [("fan", (4, 5, 6, 8, 0, 2, 3)), ("triangles", (0, 8, 9, 2, 0, 1, 8, 6, 7))],
    ),
    "hole": (
        QUAD + HOLE,
        [4, 4],
        [("strip", (5, 6, 2, 7, 1, 4, 0, 3)), ("fan", (5, 2, 3, 4))],
    ),
    "two holes": (
        [(0, 0), (20, 1), (19, 9), (1, 8), *HOLE, (13, 3), (12, 6), (16, 7), (17, 4)],
        [4, 4, 4],
        [
            ("strip", (2, 11, 1, 8, 7, 9, 2, 10, 11)),
            ("strip", (4, 5, 3, 6, 2, 7)),
            ("fan", (4, 3, 0, 1, 7)),
        ],
    ),
    "islands": (
        [(0, 0), (4, 1), (3, 5), (6, 4), (9, 3), (8, 8), (1, 9), (2, 7), (5, 6)],
        [3, 3, 3],
        [("triangles", (8, 6, 7, 4, 5, 3, 1, 2, 0))],
    ),
    "figure of eight": (
        [(0, 0), (8, 7), (8, 0), (0, 8)],
        [4],
        [("triangles", (4, 3, 0, 1, 4, 2))],
    ),
    "pentagram": (
        [(5, 0), (8, 9), (0, 3), (10, 4), (2, 10)],
        [5],
        [("strip", (3, 9, 8, 7, 6, 5, 2)), ("triangles", (1, 7, 9, 8, 6, 0, 7, 4, 5))],
    ),
    "crossing often": (
        [(0, 0), (9, 5), (1, 8), (6, -1), (8, 9), (-1, 4)],
        [6],
        [
            ("fan", (7, 3, 9, 10, 8, 6, 0)),
            ("triangles", (8, 2, 6, 0, 6, 5, 1, 10, 9, 4, 8, 10)),
        ],
    ),
}


def flat(outline):
    return np.array([(x, y, 0) for x, y in outline], float).reshape(-1, 3)


def places_of_triangles(kind, count):
    """Return which vertices of a group each of its triangles has."""
    if kind == "triangles":
        return [(i, i + 1, i + 2) for i in range(0, count, 3)]
    return [(0 if kind == "fan" else i, i + 1, i + 2) for i in range(count - 2)]


def expected_givers(groups):
    """Return the giver of each point of each triangle; a triangle is the set of its points."""
    givers = {}
    for kind, points in groups:
        triangles = places_of_triangles(kind, len(points))
        sets = [frozenset(points[place] for place in places) for places in triangles]
        last = {place: own for places, own in zip(triangles, sets, strict=True) for place in places}
        for places, own in zip(triangles, sets, strict=True):
            givers[own] = {points[place]: last[place] for place in places}
    return givers


def found_givers(points, ring_lengths):
    triangles = tessellate(points, ring_lengths).triangles.tolist()
    sets = [frozenset(triangle) for triangle in triangles]
    givers = normal_givers(points, ring_lengths).tolist()
    return {
        own: {point: sets[giver] for point, giver in zip(triangle, row, strict=True)}
        for own, triangle, row in zip(sets, triangles, givers, strict=True)
    }


@pytest.mark.parametrize(("outline", "ring_lengths", "groups"), GROUPS.values(), ids=GROUPS)
def test_corners_take_the_normals_that_they_take_on_Processing(outline, ring_lengths, groups):
    assert found_givers(flat(outline), ring_lengths) == expected_givers(groups)


def test_a_triangle_gives_its_own_normal():
    assert normal_givers(flat([(0, 0), (9, 1), (4, 8)]), [3]).tolist() == [[0, 0, 0]]


@pytest.mark.parametrize("outline", [[], [(1, 1)], [(0, 0), (1, 1), (2, 2)]], ids=str)
def test_without_triangles_there_are_no_givers(outline):
    assert normal_givers(flat(outline), [len(outline)]).shape == (0, 3)


COARSE_RINGS = st.lists(
    st.lists(st.tuples(st.integers(0, 5), st.integers(0, 5)), min_size=1, max_size=9),
    min_size=1,
    max_size=3,
)


@settings(max_examples=150, deadline=None)
@given(COARSE_RINGS, st.sampled_from(Winding))
def test_who_gives_a_corner_its_normal_has_that_corner(rings, winding):
    points = flat([place for ring in rings for place in ring])
    ring_lengths = [len(ring) for ring in rings]

    givers = normal_givers(points, ring_lengths, winding)

    triangles = tessellate(points, ring_lengths, winding).triangles
    assert givers.shape == triangles.shape
    assert (triangles[givers] == triangles[..., None]).any(axis=2).all()
