"""What rectMode() makes of four numbers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.constants import CENTER, CORNER, CORNERS, RADIUS
from sketchkit.geometry.rects import rect_corners, rect_edges

lengths = st.floats(-1000, 1000, width=32)


def edges(mode, *numbers):
    return tuple(float(edge[0]) for edge in rect_edges(mode, np.array([numbers], np.float32)))


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (CORNER, (30, 20, 40, 26)),
        (CORNERS, (10, 6, 30, 20)),
        (CENTER, (25, 17, 35, 23)),
        (RADIUS, (20, 14, 40, 26)),
    ],
    ids=["CORNER", "CORNERS", "CENTER", "RADIUS"],
)
def test_mode_gives_the_same_numbers_another_meaning(mode, expected):
    assert edges(mode, 30, 20, 10, 6) == expected


@pytest.mark.parametrize("mode", [CORNER, CENTER, RADIUS], ids=["CORNER", "CENTER", "RADIUS"])
def test_negative_size_reaches_the_other_way(mode):
    left, top, right, bottom = edges(mode, 30, 20, -10, -6)

    assert left < right
    assert top < bottom


def test_negative_size_from_a_corner_ends_there():
    assert edges(CORNER, 30, 20, -10, -6) == (20, 14, 30, 20)


@given(st.sampled_from([CORNER, CORNERS, CENTER, RADIUS]), st.tuples(*[lengths] * 4))
def test_left_is_never_right_of_right(mode, numbers):
    left, top, right, bottom = edges(mode, *numbers)

    assert left <= right
    assert top <= bottom


def test_many_rectangles_are_worked_out_at_once():
    numbers = np.array([(0, 0, 5, 6), (10, 10, 1, 1)], np.float32)

    left, top, right, bottom = rect_edges(CORNER, numbers)

    assert right.tolist() == [5, 11]
    assert bottom.tolist() == [6, 11]
    assert left.tolist() == top.tolist() == [0, 10]


def test_corners_go_clockwise_from_the_top_left():
    x, y = rect_corners(CORNER, np.array([(10, 20, 30, 40)], np.float32))

    corners = list(zip(x[0].tolist(), y[0].tolist(), strict=True))

    assert corners == [(10, 20), (40, 20), (40, 60), (10, 60)]
