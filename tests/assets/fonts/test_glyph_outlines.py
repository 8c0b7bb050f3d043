import numpy as np
import pytest

from sketchkit.assets.fonts.glyph_outlines import rings, spaced, whole_parts

SQUARE = np.array([[0.0, 0.0], [4, 0], [4, 4], [0, 4]])


def area(ring):
    x, y = ring.T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def test_a_letter_with_a_hole_has_rings_that_run_opposite_ways():
    areas = [area(ring) for ring in rings("", "o", whole_parts(20))]

    assert len(areas) == 2
    assert areas[0] * areas[1] < 0


def test_straight_letters_have_their_corners():
    (ring,) = rings("", "H", whole_parts(5))

    assert len(np.unique(ring.round(6), axis=0)) == 12
    assert ring[:, 1].min() == -0.656  # y runs down from the baseline
    assert ring[:, 1].max() == 0


def test_finer_parts_of_curves_give_more_points():
    assert len(rings("", "s", whole_parts(8))[0]) > len(rings("", "s", whole_parts(2))[0])


def test_a_space_has_no_outline():
    assert rings("", " ", whole_parts(3)) == ()


def test_parts_end_where_a_curve_ends():
    assert whole_parts(4) == (0.25, 0.5, 0.75, 1.0)


@pytest.mark.parametrize(("spacing", "count"), [(1, 16), (2, 8), (3, 5), (100, 1)])
def test_points_are_equally_far_from_one_another(spacing, count):
    places = spaced(SQUARE, spacing)

    assert len(places) == count
    assert places[0].tolist() == [0, 0]


def test_points_lie_on_the_ring():
    assert spaced(SQUARE, 2).tolist() == [
        [0, 0], [2, 0], [4, 0], [4, 2], [4, 4], [2, 4], [0, 4], [0, 2],
    ]  # fmt: skip
