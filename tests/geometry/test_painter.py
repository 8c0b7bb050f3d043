from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.geometry.painter import paint_order

Corner = tuple[float, float, float]


def order(*polygons: list[Corner]) -> list[int]:
    """Return the order of polygons of at most four corners."""
    padded = [corners + corners[-1:] * (4 - len(corners)) for corners in polygons]
    return paint_order(np.array(padded, np.float64)).tolist()


def square(left: float, nearness: float, size: float = 10) -> list[Corner]:
    right = left + size
    return [(x, y, nearness) for x, y in ((left, 0), (right, 0), (right, size), (left, size))]


def test_far_comes_before_near() -> None:
    assert order(square(0, 0.5), square(5, 0.2)) == [1, 0]


def test_in_one_plane_the_given_order_holds() -> None:
    assert order(*(square(i, 0.5) for i in range(6))) == [0, 1, 2, 3, 4, 5]


def test_equal_polygons_keep_their_order() -> None:
    assert order(square(0, 0.5), square(0, 0.5)) == [0, 1]


def test_large_slanted_polygon_lies_under_a_small_one_though_its_middle_is_nearer() -> None:
    slanted = [(0, 0, 0.0), (100, 0, 1.0), (100, 100, 1.0), (0, 100, 0.0)]
    small = [(2, 20, 0.2), (8, 20, 0.2), (8, 30, 0.2)]  # the other is at most 0.08 there

    assert order(slanted, small) == [0, 1]
    assert order(small, slanted) == [1, 0]


def test_outline_follows_the_face_whose_edge_it_is() -> None:
    face = square(0, 0.5)
    edge = [(0, 0, 0.5001), (10, 0, 0.5001)]

    assert order(edge, face) == [1, 0]


def test_point_behind_a_face_comes_before_it() -> None:
    assert order(square(0, 0.5), [(5, 5, 0.4)]) == [1, 0]


def test_circle_of_three_gives_each_once() -> None:
    def bar(x1: float, y1: float, x2: float, y2: float) -> list[Corner]:  # rises along its way
        return [(x1, y1, 0.0), (x2, y2, 1.0), (x2 + 1, y2 + 2, 1.0), (x1 + 1, y1 + 2, 0.0)]

    bars = (bar(0, 0, 20, 0), bar(15, -5, 5, 15), bar(12, 15, 0, -5))

    assert sorted(order(*bars)) == [0, 1, 2]


@given(st.lists(st.tuples(st.integers(0, 30), st.integers(-9, 9)), max_size=12))
def test_squares_that_face_the_viewer_are_in_order_where_they_overlap(
    places: list[tuple[int, int]],
) -> None:
    squares = [square(left, level / 10) for left, level in places]

    found = order(*squares) if squares else []

    turns = {polygon: turn for turn, polygon in enumerate(found)}
    for i, (left, level) in enumerate(places):
        for j, (other_left, other_level) in enumerate(places):
            if abs(left - other_left) < 10 and (level, i) < (other_level, j):
                assert turns[i] < turns[j]
