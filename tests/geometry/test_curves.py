"""Points of Bezier curves and splines."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.geometry.curves import (
    bezier_point,
    bezier_points,
    bezier_tangent,
    quadratic_to_cubic,
    spline_point,
    spline_points,
    spline_tangent,
    spline_to_bezier,
)

ARCH = np.array([(0, 0), (0, 8), (8, 8), (8, 0)], float)

coordinates = st.floats(-100, 100)
four_points = st.tuples(*[coordinates] * 4)
parameters = st.floats(0.01, 0.99)


def test_bezier_curve_has_its_middle_at_the_weights_1_3_3_1():
    points = bezier_points(ARCH, 2)

    assert points.tolist() == [[4, 6], [8, 0]]  # (0 + 3*0 + 3*8 + 8) / 8, (0 + 3*8 + 3*8 + 0) / 8


@pytest.mark.parametrize("detail", [1, 2, 7, 20])
def test_detail_is_the_number_of_points_after_the_start(detail):
    points = bezier_points(ARCH, detail)

    assert len(points) == detail
    assert points[-1].tolist() == [8, 0]


def test_bezier_curve_along_a_line_stays_on_it():
    control = np.array([(0, 0), (1, 2), (5, 10), (3, 6)], float)

    points = bezier_points(control, 9)

    np.testing.assert_allclose(points[:, 1], 2 * points[:, 0])


def test_quadratic_curve_is_a_cubic_one():
    start, control, end = np.array([(0, 0), (6, 9), (12, 0)], float)

    cubic = quadratic_to_cubic(start, control, end)

    assert cubic.tolist() == [[0, 0], [4, 6], [8, 6], [12, 0]]
    assert bezier_points(cubic, 2)[0].tolist() == [6, 4.5]  # (0 + 2 * 9 + 0) / 4


def test_spline_ends_at_its_third_point():
    points = spline_points(ARCH, 4, 0.0)

    np.testing.assert_allclose(points[-1], (8, 8))


def test_spline_through_a_row_of_points_is_straight_and_even():
    row = np.array([(0, 0), (10, 5), (20, 10), (30, 15)], float)

    points = spline_points(row, 4, 0.0)

    np.testing.assert_allclose(points, [(12.5, 6.25), (15, 7.5), (17.5, 8.75), (20, 10)])


def test_tightness_of_one_makes_straight_lines():
    points = spline_points(ARCH, 5, 1.0)

    np.testing.assert_allclose(points[:, 1], 8, atol=1e-12)


def test_catmull_rom_weights_at_the_middle():
    assert spline_point((0, 16, 32, 16), 0.5, 0.0) == 26  # (-0 + 9 * 16 + 9 * 32 - 16) / 16


@given(four_points)
def test_bezier_curve_begins_and_ends_at_its_ends(points):
    assert bezier_point(*points, 0) == points[0]
    assert bezier_point(*points, 1) == points[3]


@given(four_points, st.floats(-2, 2))
def test_spline_passes_its_second_and_third_point(points, tightness):
    assert spline_point(points, 0, tightness) == pytest.approx(points[1], abs=1e-9)
    assert spline_point(points, 1, tightness) == pytest.approx(points[2], abs=1e-9)


@given(four_points, parameters)
def test_bezier_tangent_is_the_slope(points, t):
    step = 1e-5
    slope = (bezier_point(*points, t + step) - bezier_point(*points, t - step)) / (2 * step)

    assert bezier_tangent(*points, t) == pytest.approx(slope, abs=1e-4)


@given(four_points, parameters, st.floats(-2, 2))
def test_spline_tangent_is_the_slope(points, t, tightness):
    step = 1e-5
    before, after = (spline_point(points, t + sign * step, tightness) for sign in (-1, 1))

    assert spline_tangent(points, t, tightness) == pytest.approx(
        (after - before) / (2 * step), abs=1e-4
    )


@given(four_points, st.integers(1, 30))
def test_points_of_a_curve_are_those_of_its_formula(points, detail):
    column = np.array(points)[:, None]

    drawn = bezier_points(column, detail)[:, 0]

    expected = [bezier_point(*points, i / detail) for i in range(1, detail + 1)]
    np.testing.assert_allclose(drawn, expected, atol=1e-9)


@given(four_points, st.floats(-2, 2))
def test_bezier_curve_of_a_spline_runs_through_its_points(points, tightness):
    control = np.array(points)[:, None]

    bezier = spline_to_bezier(control, tightness)

    expected = spline_points(control, 8, tightness)
    assert bezier[0] == pytest.approx(control[1], abs=1e-9)
    assert bezier_points(bezier, 8) == pytest.approx(expected, abs=1e-9)
