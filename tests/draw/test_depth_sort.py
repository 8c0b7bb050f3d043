"""Triangles from far to near."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.draw.depth_sort import MOST_COMPARED, depth_order

nearnesses = st.lists(st.integers(-40, 40), min_size=1, max_size=12, unique=True)


def facing(nearness, x=0.0):
    """Return a triangle that faces the viewer; larger is nearer."""
    return [(x, 0, nearness), (x + 10, 0, nearness), (x, 10, nearness)]


def order_of(*triangles):
    return depth_order(np.array(triangles, np.float32)).tolist()


@given(nearnesses)
def test_triangles_behind_each_other_go_from_far_to_near(nearness):
    order = order_of(*(facing(value) for value in nearness))

    assert [nearness[i] for i in order] == sorted(nearness)


def test_large_triangle_behind_a_small_one_comes_first_though_it_reaches_nearer():
    # A floor that rises toward the viewer, and a small triangle that floats above its far end.
    floor = [(0, 0, 0), (100, 0, 0), (50, 100, 90)]
    small = [(45, 10, 20), (55, 10, 20), (50, 15, 20)]

    assert order_of(small, floor) == [1, 0]
    assert order_of(floor, small) == [0, 1]


@given(st.permutations([facing(0), facing(5, x=3), facing(9, x=6)]))
def test_order_does_not_depend_on_the_order_given(triangles):
    order = order_of(*triangles)

    assert [triangles[i][0][2] for i in order] == [0, 5, 9]


@given(
    st.lists(
        st.lists(st.tuples(*[st.integers(-9, 9)] * 3), min_size=3, max_size=3),
        min_size=1,
        max_size=10,
    )
)
def test_every_triangle_is_drawn_once_whatever_crosses_what(triangles):
    assert sorted(order_of(*triangles)) == list(range(len(triangles)))


def test_too_many_triangles_are_sorted_by_their_farthest_corner():
    nearness = np.arange(MOST_COMPARED + 1)[::-1]

    order = order_of(*(facing(value) for value in nearness))

    assert (np.diff(nearness[order]) > 0).all()
