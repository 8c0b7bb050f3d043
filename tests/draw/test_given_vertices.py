"""Vertices as they were given, told from the corners that curves became."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.api.pshape.shape import PShape
from sketchkit.core import constants as c
from sketchkit.draw.given_vertices import corner_of, given_places, vertex_codes, with_given


@pytest.fixture
def drawn_with():
    """Return what gives the run and the places of what some calls record."""

    def record(canvas, *calls):
        shape: PShape = canvas.createShape()
        shape.beginShape()
        for name, *numbers in calls:
            getattr(shape, name)(*numbers)
        shape.endShape()
        return shape._recorder.shapes[0], shape._recorder.corner_array()["place"].copy()

    return record


MIXED = (
    ("vertex", 30, 20),
    ("bezierVertex", 80, 0, 80, 75, 30, 75),
    ("quadraticVertex", 10, 60, 30, 20),
    ("beginContour",),
    ("vertex", 40, 30),
    ("vertex", 40, 40),
    ("vertex", 50, 40),
    ("endContour",),
)
SPLINE = tuple(("curveVertex", *place) for place in ((0, 0), (10, 0), (20, 10), (30, 0), (40, 5)))


def test_control_points_are_vertices(flat, drawn_with):
    run, places = drawn_with(flat, *MIXED)

    flat_places = given_places(run, places)[:, :2].tolist()

    assert flat_places == [
        *([30, 20], [80, 0], [80, 75], [30, 75], [10, 60], [30, 20]),
        *([40, 30], [40, 40], [50, 40]),
    ]


def test_codes_say_which_vertices_belong_together(flat, drawn_with):
    run, places = drawn_with(flat, *MIXED)

    codes = vertex_codes(run, places)

    expected = [c.VERTEX, c.BEZIER_VERTEX, c.QUADRATIC_VERTEX, c.BREAK, *[c.VERTEX] * 3]
    assert codes == expected


def test_spline_gives_back_its_first_and_last_points_too(flat, drawn_with):
    run, places = drawn_with(flat, *SPLINE)

    assert given_places(run, places)[:, 0].tolist() == [0, 10, 20, 30, 40]
    assert vertex_codes(run, places) == [c.CURVE_VERTEX] * 5


@pytest.mark.parametrize("calls", [MIXED, SPLINE], ids=["mixed", "spline"])
def test_nothing_moves_if_no_vertex_does(flat, drawn_with, calls):
    run, places = drawn_with(flat, *calls)

    _, again = with_given(run, places, given_places(run, places))

    np.testing.assert_allclose(again, places, atol=1e-5)


def test_moved_vertices_make_the_same_curves_as_drawn_there(flat, drawn_with):
    run, places = drawn_with(flat, *MIXED)
    given = given_places(run, places)
    given[3] = 60, 90, 0

    _, moved = with_given(run, places, given)

    there = [*MIXED[:1], ("bezierVertex", 80, 0, 80, 75, 60, 90), *MIXED[2:]]
    np.testing.assert_allclose(moved, drawn_with(flat, *there)[1], atol=1e-4)


def test_control_point_stands_for_the_end_of_its_curve(flat, drawn_with):
    run, places = drawn_with(flat, *MIXED)

    assert [corner_of(run, places, given) for given in (0, 1, 3, 4, 6)] == [0, 20, 20, 40, 41]
