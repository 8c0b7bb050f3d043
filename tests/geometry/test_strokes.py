"""Strokes of P2D: thin quads, caps and joins. Numbers by hand, for lines along the axes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.constants import BEVEL, MITER, PROJECT, ROUND, SQUARE
from sketchkit.geometry.circles import fan
from sketchkit.geometry.strokes import Polylines, thin_stroke, wide_stroke

places = st.integers(-50, 50)
polylines = st.lists(st.tuples(places, places), min_size=2, max_size=6)
joins = st.sampled_from([MITER, BEVEL, ROUND])
caps = st.sampled_from([ROUND, SQUARE, PROJECT])

RIGHT_ANGLE = [(0, 0), (10, 0), (10, 10)]  # its outer side is up and right
NEEDLE = [(0, 0), (50, 1), (0, 2)]


def line(points, *, is_closed=False):
    x, y = np.array(points, np.float32).T
    return Polylines(x[None], y[None], is_closed)


def thin(points, weight):
    lines = line(points)
    return thin_stroke(lines, np.full(lines.x.shape, weight, np.float32))


def area(pieces):
    """Return what fans of the pieces' corners cover; overlaps count twice."""
    total = 0.0
    for x, y in zip(pieces.x.astype(float), pieces.y.astype(float), strict=True):
        a, b, c = (np.stack([x, y], axis=1)[corner] for corner in fan(len(x), closed=False).T)
        u, v = b - a, c - a
        total += np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]).sum() / 2
    return total


def total_area(points, weight, cap, join, *, is_closed=False):
    parts = wide_stroke(line(points, is_closed=is_closed), weight, cap, join)
    return sum(area(part) for part in parts)


def rim_of_the_joint(points, weight, join):
    """Return the corners of the fan around the only joint, its centre left out."""
    fans = wide_stroke(line(points), weight, SQUARE, join)[2]
    return list(zip(fans.x[0, 1:].tolist(), fans.y[0, 1:].tolist(), strict=True))


def test_thin_line_is_half_a_pixel_longer_at_each_end():
    quad = thin([(10, 20), (30, 20)], 1)

    assert sorted(set(quad.x[0].tolist())) == [9.5, 30.5]
    assert sorted(set(quad.y[0].tolist())) == [19.5, 20.5]


def test_thin_line_is_at_most_three_quarters_longer():
    quad = thin([(10, 20), (10, 40)], 1.75)

    assert sorted(set(quad.y[0].tolist())) == [19.25, 40.75]
    assert sorted(set(quad.x[0].tolist())) == [9.125, 10.875]


def test_thin_polyline_is_a_quad_for_each_segment():
    quads = thin(RIGHT_ANGLE, 1)

    assert quads.x.shape == (2, 4)
    assert quads.points.tolist() == [[0, 0, 1, 1], [1, 1, 2, 2]]


def test_thin_closed_line_returns_to_its_start():
    lines = line(RIGHT_ANGLE, is_closed=True)

    quads = thin_stroke(lines, np.ones((1, 3), np.float32))

    assert quads.points.tolist() == [[0, 0, 1, 1], [1, 1, 2, 2], [2, 2, 0, 0]]


@given(st.tuples(places, places), st.tuples(places, places), st.floats(0.25, 1.5, width=32))
def test_thin_line_covers_its_length_times_its_weight(start, end, weight):
    length = math.dist(start, end)

    covered = area(thin([start, end], weight))

    # A line of no length has no direction to be wide in.
    expected = (length + weight) * weight if length else 0
    assert covered == pytest.approx(expected, abs=1e-3)


def test_square_cap_ends_with_the_line():
    assert total_area([(0, 0), (20, 0)], 6, SQUARE, MITER) == 120


def test_projecting_caps_add_a_square_of_the_weight():
    assert total_area([(0, 0), (20, 0)], 6, PROJECT, MITER) == 156


def test_round_caps_add_nearly_a_disc():
    added = total_area([(0, 0), (20, 0)], 10, ROUND, MITER) - 200

    assert 0.95 * math.pi * 25 < added < math.pi * 25


def test_miter_fills_the_corner_to_its_tip():
    assert (11, -1) in rim_of_the_joint(RIGHT_ANGLE, 2, MITER)


def test_bevel_cuts_the_corner():
    assert rim_of_the_joint(RIGHT_ANGLE, 2, BEVEL) == [(10, -1), (11, 0)]


def test_round_join_stays_within_half_the_weight():
    rim = rim_of_the_joint(RIGHT_ANGLE, 12, ROUND)

    distances = [math.dist(corner, (10, 0)) for corner in rim]

    assert len(set(rim)) > 3
    assert distances == pytest.approx([6] * len(rim))


def test_tip_that_would_be_too_long_is_cut_off():
    rim = rim_of_the_joint(NEEDLE, 2, MITER)

    assert max(x for x, _ in rim) < 51.01


@pytest.mark.parametrize(
    ("join", "expected"), [(BEVEL, 400 + 4 * 2), (MITER, 400 + 4 * 4)], ids=["BEVEL", "MITER"]
)
def test_closed_line_has_a_join_at_every_corner(join, expected):
    square = [(0, 0), (25, 0), (25, 25), (0, 25)]

    # Four sides of 25 x 4, and at each corner half a square, or a square, of 2 x 2.
    assert total_area(square, 4, ROUND, join, is_closed=True) == expected


@pytest.mark.parametrize("end", [(0, 20), (0, -20), (20, 0), (-20, 0)])
def test_rim_of_a_round_cap_goes_round_once_whichever_way_the_line_goes(end):
    half_disc = 12 * 2 * 2 * math.sin(math.pi / 6) / 4  # of a regular polygon of 12 sides, radius 2

    for cap in wide_stroke(line([(0, 0), end]), 4, ROUND, MITER)[2:]:
        x, y = cap.x[0, 1:].astype(float), cap.y[0, 1:].astype(float)
        enclosed = abs((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2
        assert enclosed == pytest.approx(half_disc, rel=1e-5)


def test_two_lines_of_one_length_are_stroked_at_once():
    x, y = np.array([(0, 9), (5, 5)], np.float32), np.array([(0, 0), (0, 9)], np.float32)

    for pieces in wide_stroke(Polylines(x, y, is_closed=False), 3, SQUARE, MITER):
        assert pieces.lines.tolist() == [0, 1]


@given(polylines, caps, joins, st.booleans())
def test_stroke_of_any_line_is_finite_and_near_it(points, cap, join, is_closed):
    lines = line(points, is_closed=is_closed)

    for pieces in wide_stroke(lines, 8, cap, join):
        # As far as a miter's tip at most: ten half weights.
        assert np.abs(pieces.x).max() <= 50 + 40 + 1e-3
        assert np.abs(pieces.y).max() <= 50 + 40 + 1e-3
