import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketchkit.imaging.blurring import blurred, reach


def plainly_blurred(data, pixels):
    """Return what the weights say, summed one by one."""
    for _ in range(2):
        sums, weights = np.zeros(data.shape, int), np.zeros((len(data), 1, 1), int)
        for offset in range(1 - pixels, pixels):
            weight = (pixels - abs(offset)) ** 2
            places = np.arange(len(data)) + offset
            is_inside = (places >= 0) & (places < len(data))
            sums[is_inside] += weight * data[places[is_inside]].astype(int)
            weights[is_inside] += weight
        data = (sums // weights).transpose(1, 0, 2)
    return data


@settings(max_examples=60, deadline=None)
@given(
    width=st.integers(1, 40),
    height=st.integers(1, 40),
    radius=st.floats(0, 12),
    seed=st.integers(0, 999),
)
def test_running_sums_are_the_weighted_means(width, height, radius, seed):
    data = np.random.default_rng(seed).integers(0, 256, (height, width, 3), np.uint8)

    expected = plainly_blurred(data.transpose(1, 0, 2), reach(radius, width, height))

    assert (blurred(data, radius) == expected.transpose(1, 0, 2)).all()


@pytest.mark.parametrize(
    ("radius", "size", "expected"),
    [
        (1, (100, 100), 3),
        (6, (640, 480), 21),
        (0, (9, 9), 1),
        (30, (61, 47), 23),
        (99, (999, 999), 248),
    ],
)
def test_reach_is_cut_to_the_picture(radius, size, expected):
    assert reach(radius, *size) == expected


def test_no_blur_reaches_no_neighbour():
    data = np.random.default_rng(1).integers(0, 256, (7, 8, 4), np.uint8)

    assert (blurred(data, 0) == data).all()


def test_the_sums_of_a_wide_blur_of_white_do_not_overflow():
    white = np.full((600, 600, 1), 255, np.uint8)

    assert (blurred(white, 80) == 255).all()
