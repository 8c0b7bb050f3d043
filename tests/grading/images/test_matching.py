import numpy as np
import pytest
from numpy.typing import NDArray

from sketchkit.grading.images.matching import (
    ROUNDING,
    STRIP,
    difference,
    left_over,
    movement,
    residue,
    slight,
    without_match,
)

U8 = NDArray[np.uint8]


def scene(height: int = 60, width: int = 80) -> U8:
    """Two squares and a line, black on white."""
    picture = np.full((height, width, 3), 255, np.uint8)
    picture[10:25, 10:30] = 0
    picture[35:50, 45:70] = (200, 0, 0)
    picture[5, 40:75] = 0
    return picture


def test_edge_of_another_mixture_leaves_nothing() -> None:
    submitted = scene()
    submitted[10:25, 30] = 128  # half of the next pixel is black too

    assert not residue(submitted, scene()).any()


def test_black_line_matches_two_grey_ones_of_the_same_mean() -> None:
    submitted = scene()
    submitted[5:7, 40:75] = 127

    assert residue(submitted, scene()).max() <= 8


@pytest.mark.parametrize("is_turned_round", [False, True])
def test_line_that_one_picture_lacks_is_found(is_turned_round: bool) -> None:
    without = scene()
    without[5] = 255
    pair = (without, scene())[:: -1 if is_turned_round else 1]

    assert residue(*pair)[5, 45:70].min() > 30


def test_line_of_another_grey_is_found() -> None:
    submitted = scene()
    submitted[5, 40:75] = 127

    assert residue(submitted, scene())[5, 45:70].min() > 8


def test_rounding_is_forgiven_and_no_more() -> None:
    rounded, darker = scene(), scene()
    rounded[scene() == 255] = 255 - ROUNDING
    darker[scene() == 255] = 255 - ROUNDING - 3

    assert not residue(rounded, scene()).any()
    assert residue(darker, scene())[55, 5].tolist() == [3, 3, 3]


def test_residue_never_exceeds_the_difference() -> None:
    random = np.random.default_rng(3)
    one, other = random.integers(0, 256, (2, 40, 50, 3), dtype=np.uint8)

    plain = np.abs(one.astype(int) - other)

    assert (residue(one, other) <= plain).all()


def test_strips_join_without_a_seam() -> None:
    expected = np.full((2 * STRIP, 20, 3), 255, np.uint8)
    submitted = expected.copy()
    expected[:STRIP] = 0
    submitted[: STRIP + 1] = 0  # the edge lies a pixel further down

    assert not residue(submitted, expected).any()


def test_picture_without_its_matches_differs_by_the_residue() -> None:
    random = np.random.default_rng(4)
    one, other = random.integers(0, 256, (2, 20, 30, 3), dtype=np.uint8)
    remaining = residue(one, other)

    plain = np.abs(without_match(one, other, remaining).astype(int) - other)

    assert np.array_equal(plain, remaining)


@pytest.mark.parametrize(("right", "down"), [(1, 0), (0, -1), (-1, 1)])
def test_movement_of_the_whole_picture_is_seen(right: int, down: int) -> None:
    submitted = np.roll(scene(), (down, right), (0, 1))

    assert movement(submitted, scene()) == (right, down)


def test_half_a_pixel_is_seen() -> None:
    moved = np.roll(scene(), 1, 1)
    submitted = ((moved.astype(int) + scene()) // 2).astype(np.uint8)

    assert movement(submitted, scene()) == (0.5, 0)


def test_what_moved_as_a_whole_is_forgiven_nothing() -> None:
    submitted = np.roll(scene(), 1, 0)

    assert not residue(submitted, scene()).any()
    assert np.array_equal(left_over(submitted, scene()), difference(submitted, scene()))


def test_one_object_among_others_may_lie_a_pixel_off() -> None:
    submitted = scene()
    submitted[10:25, 10:31] = 255
    submitted[10:25, 11:31] = 0

    assert movement(submitted, scene()) == (0, 0)
    assert not left_over(submitted, scene()).any()


def test_object_a_pixel_off_is_slight_and_what_lies_elsewhere_is_not() -> None:
    submitted = scene()
    submitted[10:25, 10:31] = 255
    submitted[10:25, 11:31] = 0

    found = slight(submitted, scene()).any(axis=2)

    assert found[13:22, [10, 30]].all()
    assert not found[:, 34:].any()


def test_edges_of_other_mixtures_are_not_even_slight() -> None:
    submitted = scene()
    submitted[10:25, 30] = 128  # half of the next pixel is black too
    submitted[5:7, 40:75] = 127  # a line of one pixel is drawn as two grey ones

    assert not slight(submitted, scene()).any()


def test_missing_object_is_no_movement() -> None:
    submitted = scene()
    submitted[35:50, 45:70] = 255

    assert movement(submitted, scene()) == (0, 0)
