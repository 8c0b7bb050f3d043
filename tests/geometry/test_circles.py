"""Circles are polygons; the numbers of sides were measured on Processing 4."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.geometry.circles import fan, side_count, unit_circle


@pytest.mark.parametrize(("diameter", "sides"), [(3, 20), (40, 35), (100, 88), (200, 177)])
def test_circle_has_a_side_for_about_ten_pixels(diameter, sides):
    diagonal = np.array([diameter * math.sqrt(2)], np.float32)

    assert side_count(diagonal) == [sides]


@pytest.mark.parametrize(("diagonal", "sides"), [(0, 20), (math.nan, 20), (1e6, 200), (1e30, 200)])
def test_circle_has_20_to_200_sides(diagonal, sides):
    assert side_count(np.array([diagonal], np.float32)) == [sides]


def test_corners_lie_at_whole_half_degrees():
    cosines, sines = unit_circle(7)

    half_degrees = np.degrees(np.arctan2(sines, cosines)) % 360 * 2

    assert half_degrees.round(2).tolist() == [0, 102, 205, 308, 411, 514, 617]  # int(720 i / 7)


def test_circle_begins_at_the_right_and_goes_down():
    cosines, sines = unit_circle(20)

    assert (cosines[0], sines[0]) == (1, 0)
    assert sines[1] == pytest.approx(math.sin(math.radians(18)))


@given(st.integers(20, 200))
def test_every_corner_is_on_the_unit_circle_and_follows_the_last(sides):
    cosines, sines = unit_circle(sides)

    angles = np.unwrap(np.arctan2(sines, cosines))

    np.testing.assert_allclose(np.hypot(cosines, sines), 1, atol=1e-6)
    assert len(angles) == sides
    assert (np.diff(angles) > 0).all()
    assert angles[-1] < 2 * math.pi


def test_closed_fan_returns_to_its_first_corner():
    assert fan(5, closed=True).tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]


def test_open_fan_leaves_a_gap():
    assert fan(5, closed=False).tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]
