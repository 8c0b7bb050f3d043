"""The triangles of polygons. The tables of splits were measured on Processing 4 (P2D)."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketchkit.geometry.polygons import Winding, interpolate, tessellate

SQUARE = [(0, 0), (9, 0), (9, 9), (0, 9)]
HOLE = [(3, 3), (3, 6), (6, 6), (6, 3)]  # wound against the square
EIGHT = [(0, 0), (8, 8), (8, 0), (0, 8)]

SPLITS = {
    "convex": ([(0, 0), (9, 1), (8, 9), (1, 8)], {(0, 1, 3), (1, 2, 3)}),
    "convex, begun at the next corner": (
        [(9, 1), (8, 9), (1, 8), (0, 0)],
        {(0, 1, 2), (0, 2, 3)},
    ),
    "convex, the other way round": ([(1, 8), (8, 9), (9, 1), (0, 0)], {(0, 1, 2), (0, 2, 3)}),
    "square": (SQUARE, {(0, 1, 3), (1, 2, 3)}),
    "square, the other way round": ([(0, 0), (0, 9), (9, 9), (9, 0)], {(0, 1, 2), (0, 2, 3)}),
    "pentagon": (
        [(5, 0), (9, 4), (7, 9), (3, 9), (1, 4)],
        {(0, 1, 2), (0, 2, 3), (0, 3, 4)},
    ),
    "dart": ([(0, 0), (9, 4), (0, 9), (3, 4)], {(0, 1, 3), (1, 2, 3)}),
    "arrow": (
        [(0, 3), (5, 3), (5, 0), (9, 4), (5, 8), (5, 6), (0, 6)],
        {(0, 1, 6), (1, 2, 3), (1, 3, 5), (1, 5, 6), (3, 4, 5)},
    ),
    "comb": (
        [(0, 0), (0, 5), (2, 5), (2, 2), (4, 2), (4, 6), (6, 6), (6, 0)],
        {(0, 1, 2), (0, 2, 3), (0, 3, 7), (3, 4, 7), (4, 5, 6), (4, 6, 7)},
    ),
    "notch": (
        [(12, 10), (13, 19), (6, 13), (8, 8), (13, 1)],
        {(0, 1, 3), (0, 3, 4), (1, 2, 3)},
    ),
    "corner in an edge": (
        [(0, 0), (8, 0), (8, 8), (0, 8), (0, 4)],
        {(0, 1, 4), (1, 2, 3), (1, 3, 4)},
    ),
    "figure of eight": (EIGHT, {(0, 4, 3), (1, 4, 2)}),
    "touching itself": (
        [(0, 0), (4, 4), (8, 0), (8, 8), (4, 4), (0, 8)],
        {(0, 6, 5), (2, 3, 6)},
    ),
    "first point repeated": ([*SQUARE, SQUARE[0]], {(1, 2, 3), (1, 3, 5)}),
}


def flat(outline):
    return np.array([(x, y, 0) for x, y in outline], float)


def from_the_smallest(triangle):
    start = triangle.index(min(triangle))
    return tuple(triangle[start:] + triangle[:start])


def split(points, ring_lengths=None, winding=Winding.NONZERO):
    triangles = tessellate(points, ring_lengths or [len(points)], winding).triangles
    return {from_the_smallest(triangle) for triangle in triangles.tolist()}


def signed_areas(points, tessellation):
    a, b, c = interpolate(tessellation, points)[tessellation.triangles, :2].transpose(1, 2, 0)
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2


def shoelace(ring):
    x, y = ring[:, 0], ring[:, 1]
    return (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2


def winding_numbers(rings, places):
    """Sum up the angles under which each place, (p, 2), sees the sides of the rings."""
    turns = np.zeros(len(places))
    for ring in rings:
        here = ring[:, :2] - places[:, None]
        there = np.roll(here, -1, axis=1)
        cross = here[..., 0] * there[..., 1] - here[..., 1] * there[..., 0]
        turns += np.arctan2(cross, (here * there).sum(axis=2)).sum(axis=1)
    return np.rint(turns / math.tau).astype(int)


def covering_triangles(points, tessellation, places):
    """Count the triangles over each place; tell which places are too near a side to be sure."""
    corners = interpolate(tessellation, points)[tessellation.triangles, :2]
    towards = np.roll(corners, -1, axis=1) - corners
    there = places[:, None, None] - corners
    sides = towards[..., 0] * there[..., 1] - towards[..., 1] * there[..., 0]
    is_near = (np.abs(sides) < 1e-4 * np.hypot(*towards.transpose(2, 0, 1))).any(axis=(1, 2))
    counts = ((sides > 0).all(axis=2) | (sides < 0).all(axis=2)).sum(axis=1)
    return counts, is_near


def assert_covers(points, tessellation, places, is_inside):
    counts, is_near = covering_triangles(points, tessellation, places)
    assert np.array_equal(counts[~is_near], is_inside[~is_near])


PLACES = np.random.default_rng(1).uniform(0, 1, (800, 2))

GRID_PLACES = st.tuples(st.integers(0, 12), st.integers(0, 12))
GRID_RINGS = st.lists(st.lists(GRID_PLACES, min_size=1, max_size=9), min_size=1, max_size=3)


@st.composite
def star_shaped(draw):
    radii = draw(st.lists(st.floats(1, 50), min_size=3, max_size=30))
    angles = np.arange(len(radii)) * (math.tau / len(radii)) + draw(st.floats(0, 6))
    outline = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1) * np.c_[radii]
    return outline[:: draw(st.sampled_from([1, -1]))]


@pytest.mark.parametrize(("outline", "expected"), SPLITS.values(), ids=SPLITS)
def test_a_polygon_is_split_as_on_Processing(outline, expected):
    assert split(flat(outline)) == expected


def test_a_ring_wound_the_other_way_is_a_hole_and_split_as_on_Processing():
    triangles = split(flat(SQUARE + HOLE), [4, 4])

    assert triangles == {
        (0, 1, 4), (0, 4, 3), (1, 2, 6), (1, 6, 7), (1, 7, 4), (2, 3, 5), (2, 5, 6), (3, 4, 5),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("ring", "winding", "area"),
    [
        (HOLE, Winding.NONZERO, 72),
        (HOLE[::-1], Winding.NONZERO, 81),
        (HOLE, Winding.EVEN_ODD, 72),
        (HOLE[::-1], Winding.EVEN_ODD, 72),
    ],
    ids=["nonzero, against", "nonzero, alike", "even-odd, against", "even-odd, alike"],
)
def test_the_winding_rule_decides_what_is_a_hole(ring, winding, area):
    points = flat(SQUARE + ring)

    tessellation = tessellate(points, [4, 4], winding)

    assert signed_areas(points, tessellation).sum() == pytest.approx(area)


@settings(max_examples=100, deadline=None)
@given(star_shaped())
def test_a_simple_polygon_keeps_its_area_and_direction(outline):
    areas = signed_areas(outline, tessellate(outline, [len(outline)]))

    assert len(areas) == len(outline) - 2
    assert areas.sum() == pytest.approx(shoelace(outline), rel=1e-9)
    assert (areas * np.sign(shoelace(outline)) >= -1e-9).all()


@settings(max_examples=150, deadline=None)
@given(GRID_RINGS, st.sampled_from(Winding))
def test_exactly_the_inside_is_covered_and_once(rings, winding):
    points = flat([place for ring in rings for place in ring])

    tessellation = tessellate(points, [len(ring) for ring in rings], winding)

    numbers = winding_numbers([np.array(ring, float) for ring in rings], 12 * PLACES)
    is_inside = numbers != 0 if winding is Winding.NONZERO else numbers % 2 != 0
    assert_covers(points, tessellation, 12 * PLACES, is_inside)


@settings(max_examples=50, deadline=None)
@given(star_shaped(), st.floats(-3, 3), st.floats(-3, 3))
def test_a_tilted_polygon_keeps_its_area(outline, along_x, along_y):
    tilted = outline.copy()
    tilted[:, 2] = along_x * outline[:, 0] + along_y * outline[:, 1]

    areas = signed_areas(outline, tessellate(tilted, [len(outline)]))

    assert areas.sum() == pytest.approx(shoelace(outline), rel=1e-9)


def test_a_steep_polygon_is_split_by_the_shadow_that_it_faces():
    outline = np.array(SQUARE, float)
    upright = np.stack([0 * outline[:, 0], outline[:, 0], outline[:, 1]], axis=1)  # faces x

    assert split(upright) == SPLITS["square"][1]


@pytest.mark.parametrize("z", [0, -40])
def test_a_polygon_at_any_depth_is_split_alike(z):
    points = np.array([(x, y, z) for x, y in SQUARE], float)

    assert split(points) == SPLITS["square"][1]


def test_a_crossing_is_a_mixture_of_the_four_ends():
    tessellation = tessellate(flat(EIGHT), [4])

    assert sorted(tessellation.sources[0]) == [0, 1, 2, 3]
    assert tessellation.weights.tolist() == [[0.25] * 4]
    assert interpolate(tessellation, flat(EIGHT))[4].tolist() == [4, 4, 0]


def test_the_nearer_ends_of_a_crossing_count_more():
    outline = flat([(0, 0), (8, 2), (8, 0), (0, 6)])  # crosses at (6, 1.5)

    tessellation = tessellate(outline, [4])

    shares = dict(zip(tessellation.sources[0].tolist(), tessellation.weights[0], strict=True))
    assert shares == pytest.approx({0: 0.125, 1: 0.375, 2: 0.375, 3: 0.125})


def test_coinciding_points_become_their_middle():
    outline = flat([*SQUARE, SQUARE[0]])
    greys = np.array([[0], [10], [20], [30], [100]], float)

    tessellation = tessellate(outline, [5])

    assert interpolate(tessellation, greys)[5] == pytest.approx([50])


def test_a_new_point_may_be_a_mixture_of_new_ones():
    points = flat([(0, 0), (9, 1), (2, 9), (4, -2), (8, 8), (0, 5)])

    tessellation = tessellate(points, [6])

    assert tessellation.sources.max() >= len(points)
    values = interpolate(tessellation, np.c_[points, points @ (1, 2, 3)])
    assert values[:, 3] == pytest.approx(values[:, :3] @ (1, 2, 3))


@pytest.mark.parametrize(
    "outline",
    [
        [],
        [(1, 1)],
        [(1, 1), (2, 2)],
        [(1, 1), (1, 1), (1, 1), (1, 1)],
        [(0, 0), (1, 1), (0, 0), (1, 1)],
        [(0, 0), (3, 3), (1, 1), (2, 2)],
        [(0, 0), (0, 3), (0, 1)],
        [(0, 0), (9, 0), (9, math.nan)],
        [(0, 0), (9, 0), (9, math.inf)],
        [(0, 0), (1e300, 0), (9, 1e300)],
    ],
    ids=str,
)
def test_a_polygon_without_a_finite_area_has_no_triangles(outline):
    points = flat(outline).reshape(-1, 3)

    assert split(points) == set()


def test_empty_rings_are_left_out():
    assert split(flat(SQUARE), [0, 4, 0]) == SPLITS["square"][1]


def nudged(*nudges):
    nudge = st.sampled_from([0, *nudges, *(-nudge for nudge in nudges)])
    place = st.tuples(st.integers(0, 3), st.integers(0, 3), nudge, nudge)
    return st.lists(place, min_size=3, max_size=14)


@settings(max_examples=100, deadline=None)
@given(nudged(1e-7, 3e-7))  # float32 has no smaller steps at 1 and 3
def test_places_that_almost_coincide_do_no_harm(places):
    points = flat([(x + dx, y + dy) for x, y, dx, dy in places])

    tessellation = tessellate(points, [len(points)])

    rounded = np.array([(x, y) for x, y, _, _ in places], float)
    is_inside = winding_numbers([rounded], 3 * PLACES) != 0
    assert_covers(points, tessellation, 3 * PLACES, is_inside)


@settings(max_examples=200, deadline=1000)
@given(nudged(1e-16, 3e-16, 1e-14))
def test_the_sweep_ends_even_where_rounding_misleads_it(places):
    points = flat([(x + dx, y + dy) for x, y, dx, dy in places])

    tessellation = tessellate(points, [len(points)])

    assert tessellation.triangles.max(initial=0) < len(points) + len(tessellation.sources)
