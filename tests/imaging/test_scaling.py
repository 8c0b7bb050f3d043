import numpy as np
import pytest

from sketchkit.imaging.blits import Region
from sketchkit.imaging.scaling import nearest, resized


def gray(*rows):
    values = np.array(rows, np.uint8)
    opaque = np.full_like(values, 255)
    return np.stack([values, values, values, opaque], axis=2)


def test_the_same_size_gives_the_same_pixels():
    data = np.random.default_rng(0).integers(0, 255, (5, 7, 4), np.uint8)
    data[..., 3] = 255

    assert (resized(data, 7, 5) == data).all()


def test_enlarging_goes_in_straight_lines_between_centres():
    # Centres of the new pixels lie at -0.25, 0.25, 0.75 and 1.25 of the old ones.
    assert resized(gray([0, 100]), 4, 1)[0, :, 0].tolist() == [0, 25, 75, 100]


def test_half_the_size_is_the_mean_of_four():
    assert resized(gray([0, 100, 40, 40], [100, 200, 40, 80]), 2, 1)[0, :, 0].tolist() == [100, 50]


def test_shrinking_goes_by_halves():
    # 8 to 1: every pixel counts, in one go only the two in the middle would.
    assert resized(gray([80, 0, 0, 0, 0, 0, 0, 0]), 1, 1)[0, 0, 0] == 10


def test_colours_of_clear_pixels_do_not_bleed():
    data = np.array([[[255, 0, 0, 255], [0, 0, 255, 0]]], np.uint8)

    assert resized(data, 4, 1)[0].tolist() == [
        [255, 0, 0, 255],
        [255, 0, 0, 191],
        [255, 0, 0, 64],
        [0, 0, 0, 0],
    ]


@pytest.mark.parametrize(("width", "height"), [(1, 1), (3, 9), (50, 2), (13, 13)])
def test_a_plain_colour_stays(width, height):
    data = np.full((6, 8, 4), (200, 30, 90, 255), np.uint8)

    got = resized(data, width, height)

    assert got.shape == (height, width, 4)
    assert (got == (200, 30, 90, 255)).all()


def test_nearest_repeats_pixels_and_leaves_some_out():
    row = gray([0, 10, 20, 30])

    assert nearest(row, Region(1, 0, 2, 1), 4, 1)[0, :, 0].tolist() == [10, 10, 20, 20]
    assert nearest(row, Region(0, 0, 4, 1), 2, 1)[0, :, 0].tolist() == [10, 30]


def test_nearest_goes_on_with_the_edge_outside():
    assert nearest(gray([5, 9]), Region(-1, 0, 4, 1), 4, 1)[0, :, 0].tolist() == [5, 5, 9, 9]
