import numpy as np
import pytest

from sketchkit.core.constants import ADD
from sketchkit.imaging.blits import Region, blit, part, paste


def grays(*rows):
    values = np.array(rows, np.uint8)
    return np.stack([values, values, values, np.full_like(values, 255)], axis=2)


def first_row(data):
    return data[0, :, 0].tolist()


@pytest.fixture
def target():
    return grays([0] * 6, [0] * 6)


def test_the_same_size_is_copied_as_it_is(target):
    blit(grays([10, 20, 30]), Region(1, 0, 2, 1), target, Region(3, 1, 2, 1))

    assert target[1, :, 0].tolist() == [0, 0, 0, 20, 30, 0]
    assert first_row(target) == [0] * 6


def test_enlarged_pixels_begin_at_corners_and_go_over_to_the_next(target):
    blit(grays([0, 100]), Region(0, 0, 2, 1), target, Region(0, 0, 4, 1))

    assert first_row(target) == [0, 50, 100, 100, 0, 0]


def test_shrunk_pixels_are_left_out(target):
    blit(grays([10, 20, 30, 40]), Region(0, 0, 4, 1), target, Region(0, 0, 2, 1))

    assert first_row(target) == [10, 30, 0, 0, 0, 0]


def test_a_target_that_begins_outside_loses_its_first_pixels(target):
    blit(grays([10, 20, 30]), Region(0, 0, 3, 1), target, Region(-1, 0, 3, 1))

    assert first_row(target) == [20, 30, 0, 0, 0, 0]


def test_a_source_that_is_cut_fills_the_target_still(target):
    blit(grays([10, 20]), Region(0, 0, 4, 1), target, Region(0, 0, 4, 1))

    assert first_row(target) == [10, 15, 20, 20, 0, 0]


@pytest.mark.parametrize(
    ("taken", "placed"),
    [
        (Region(0, 0, 0, 1), Region(0, 0, 2, 1)),
        (Region(5, 0, 2, 1), Region(0, 0, 2, 1)),
        (Region(0, 0, 2, 1), Region(6, 0, 2, 1)),
        (Region(0, 0, 2, 1), Region(-2, 0, 2, 1)),
        (Region(0, 0, 2, 1), Region(0, 0, -2, 1)),
    ],
    ids=["nothing", "beside the source", "beside the target", "before the target", "negative"],
)
def test_what_covers_nothing_does_nothing(target, taken, placed):
    blit(grays([10, 20]), taken, target, placed)

    assert not target[..., :3].any()


def test_overlapping_regions_of_one_picture_read_what_was_there():
    picture = grays([1, 2, 3, 4, 5])

    blit(picture, Region(0, 0, 4, 1), picture, Region(1, 0, 4, 1))

    assert first_row(picture) == [1, 1, 2, 3, 4]


def test_a_mode_blends(target):
    target[..., :3] = 100

    blit(grays([10, 20]), Region(0, 0, 2, 1), target, Region(0, 0, 2, 1), ADD)

    assert first_row(target) == [110, 120, 100, 100, 100, 100]


def test_a_part_beyond_the_edge_is_clear_there():
    cut = part(grays([10, 20]), Region(-1, 0, 2, 2))

    assert cut[..., 0].tolist() == [[0, 10], [0, 0]]
    assert cut[..., 3].tolist() == [[0, 255], [0, 0]]


@pytest.mark.parametrize("place", [(-1, -1), (5, 1), (9, 9), (-9, 0)])
def test_pasting_is_cut_at_the_edges(target, place):
    paste(grays([7, 7], [7, 7]), target, *place)

    x, y = place
    covered = {(x + i, y + j) for i in range(2) for j in range(2)}
    inside = {(i, j) for i in range(6) for j in range(2)}
    assert {(i, j) for j, i in np.argwhere(target[..., 0] == 7).tolist()} == covered & inside
