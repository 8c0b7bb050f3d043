import numpy as np
import pytest

from sketchkit.imaging import filters


def picture(*colors):
    return np.array([colors], np.uint8)


def test_gray_keeps_brightness_and_alpha():
    # 77, 151 and 28 of 256 parts: 15400 + 15100 + 1400 are 124.6 of them.
    assert filters.gray(picture((200, 100, 50, 7)))[0, 0].tolist() == [124, 124, 124, 7]


def test_invert_keeps_alpha():
    assert filters.inverted(picture((200, 0, 255, 7)))[0, 0].tolist() == [55, 255, 0, 7]


def test_opaque_keeps_colours():
    assert filters.opaque(picture((1, 2, 3, 4)))[0, 0].tolist() == [1, 2, 3, 255]


@pytest.mark.parametrize(
    ("level", "expected"), [(0.5, [0, 255]), (0.0, [255, 255]), (0.51, [0, 0]), (1.0, [0, 0])]
)
def test_threshold_asks_for_the_largest_part(level, expected):
    data = picture((126, 0, 0, 255), (0, 128, 0, 255))  # 0.5 is 127, 0.51 is 130

    assert filters.threshold(data, level)[0, :, 1].tolist() == expected


@pytest.mark.parametrize(
    ("levels", "value", "expected"),
    [(2, 127, 0), (2, 128, 255), (4, 64, 85), (4, 63, 0), (5, 255, 255), (255, 255, 255)],
)
def test_posterize_leaves_evenly_spread_values(levels, value, expected):
    assert filters.posterized(picture((value, 0, 0, 9)), levels)[0, 0].tolist() == [
        expected,
        0,
        0,
        9,
    ]


def test_dilate_takes_the_lightest_of_the_cross():
    data = np.zeros((3, 3, 4), np.uint8)
    data[1, 1] = (9, 9, 9, 255)

    lit = filters.dilated(data)[..., 0] > 0

    assert lit.tolist() == [[False, True, False], [True, True, True], [False, True, False]]


def test_erode_takes_the_darkest_of_the_cross():
    data = np.full((3, 3, 4), 255, np.uint8)
    data[0, 0, :3] = 5

    dark = filters.eroded(data)[..., 0] == 5

    assert dark.tolist() == [[True, True, False], [True, False, False], [False, False, False]]


def test_of_equally_bright_neighbours_the_left_one_counts():
    row = picture((0, 28, 0, 255), (0, 0, 0, 255), (0, 0, 151, 255))  # both 151 * 28

    assert filters.dilated(row)[0, 1].tolist() == [0, 28, 0, 255]


def test_filters_leave_the_picture_alone():
    data = np.random.default_rng(0).integers(0, 256, (5, 6, 4), np.uint8)
    before = data.copy()

    for change in (filters.gray, filters.inverted, filters.opaque, filters.eroded, filters.dilated):
        change(data)

    assert (data == before).all()
