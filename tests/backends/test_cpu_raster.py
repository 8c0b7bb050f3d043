"""Which samples are covered: worked out by hand from the places of the samples."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.cpu.raster import batches, ramps
from sketchkit.draw.pipeline import Clip
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8, VertexBlock
from tests.backends.draw_lists import flat_pipeline, on, rect, triangles

WHITE = (255, 255, 255, 255)


def red_of(block: VertexBlock, target: Target, clip: Clip | None = None) -> U8:
    """Return the red channel after drawing over black."""
    backend = CpuBackend()
    backend.execute(on(target, block, flat_pipeline(target, clip=clip)))
    return backend.read(target)[..., 0]


@pytest.mark.parametrize("samples", [1, 4])
def test_a_rect_covers_whole_pixels_up_to_its_right_and_bottom(samples: int) -> None:
    target = Target(40, 40, samples)

    red = red_of(rect(10, 10, 30, 20, WHITE), target)

    expected = np.zeros((40, 40), np.uint8)
    expected[10:20, 10:30] = 255
    assert np.array_equal(red, expected)


@pytest.mark.parametrize("top_row_first", [True, False])
def test_of_edges_through_pixel_centres_left_and_bottom_are_in(top_row_first: bool) -> None:
    target = Target(4, 4, 1, top_row_first)

    red = red_of(rect(0.5, 0.5, 2.5, 2.5, WHITE), target)

    expected = np.zeros((4, 4), np.uint8)
    expected[1:3, 0:2] = 255
    assert np.array_equal(red, expected)


@pytest.mark.parametrize(
    ("top_row_first", "right", "bottom", "share"),
    [
        (True, 0.5, 1, 128),  # (3/8, 1/8) and (1/8, 5/8)
        (True, 0.5, 0.25, 64),  # (3/8, 1/8)
        (True, 1, 0.75, 191),  # all but (5/8, 7/8)
        (False, 0.5, 0.25, 0),  # the places are upside down: there is only (5/8, 1/8)
        (False, 0.75, 0.25, 64),
    ],
)
def test_samples_lie_where_processing_has_them(
    top_row_first: bool, right: float, bottom: float, share: int
) -> None:
    target = Target(1, 1, 4, top_row_first)

    red = red_of(rect(0, 0, right, bottom, WHITE), target)

    assert red[0, 0] == share


def test_triangles_that_share_an_edge_paint_no_sample_twice() -> None:
    rng = np.random.default_rng(1)
    target = Target(60, 60)
    middle = rng.uniform(20, 40, (200, 2))
    corners = np.array([(5, 5), (55, 9), (50, 52), (3, 58)], float)
    for centre in middle[:20]:
        fan = [(centre, corners[i], corners[(i + 1) % 4]) for i in range(4)]

        red = red_of(triangles(fan, [(255, 255, 255, 100)] * 4), target)

        whole = red_of(triangles(fan, [WHITE] * 4), target) == 255
        assert np.all(red[whole] == 100)


@pytest.mark.parametrize(
    "corners",
    [
        [(5, 5), (5, 5), (20, 20)],
        [(5, 5), (10, 10), (20, 20)],
        [(float("nan"), 5), (10, 10), (5, 20)],
        [(float("inf"), 5), (10, 10), (5, 20)],
    ],
    ids=["point", "line", "nan", "inf"],
)
def test_triangles_without_area_draw_nothing(corners: list[tuple[float, float]]) -> None:
    target = Target(30, 30)

    assert not red_of(triangles([corners], [WHITE]), target).any()


def test_a_clip_leaves_whole_pixels_of_a_plain_target() -> None:
    target = Target(20, 20, 1, top_row_first=False)

    red = red_of(rect(0, 0, 20, 20, WHITE), target, Clip(3, 4, 5, 6))

    expected = np.zeros((20, 20), np.uint8)
    expected[4:10, 3:8] = 255
    assert np.array_equal(red, expected)


def test_a_clip_outside_of_the_target_leaves_nothing() -> None:
    target = Target(20, 20)

    assert not red_of(rect(0, 0, 20, 20, WHITE), target, Clip(30, 0, 5, 5)).any()


def test_batches_hold_about_the_limit_and_at_least_one() -> None:
    costs = np.array([3, 3, 9, 1, 1, 0, 5])

    parts = list(batches(costs, 6))

    assert parts == [slice(0, 2), slice(2, 3), slice(3, 6), slice(6, 7)]


def test_ramps_count_anew() -> None:
    assert ramps(np.array([2, 0, 3])).tolist() == [0, 1, 0, 1, 2]
