from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.backends.cpu.clipping import SIDES, clip_triangles
from sketchkit.draw.vertex import F32

INSIDE = [(0, 0, 0, 1), (0.5, 0, 0, 1), (0, 0.5, 0, 1)]
coordinates = st.floats(-4, 4, width=32)
corners = st.tuples(coordinates, coordinates, coordinates, st.floats(-1, 4, width=32))


def clip(*triangles: object) -> F32:
    with np.errstate(all="ignore"):  # as the executor has it
        return clip_triangles(np.array(triangles, np.float32))


def area_on_screen(triangles: F32) -> float:
    """Return the sum of the areas, where the whole screen is 4."""
    x, y = (triangles[..., i].astype(float) / triangles[..., 3] for i in (0, 1))
    doubled = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    return float(np.abs(doubled).sum() / 2)


def test_triangles_in_view_stay_as_they_are() -> None:
    assert np.array_equal(clip(INSIDE), np.array([INSIDE], np.float32))


@pytest.mark.parametrize("side", range(len(SIDES)))
def test_triangles_beyond_a_side_are_gone(side: int) -> None:
    beyond = np.array(INSIDE, np.float32)
    beyond[:, side // 2] += 9 if side in (0, 2, 5) else -9

    assert len(clip(beyond)) == 0


def test_no_triangles_stay_none() -> None:
    assert clip_triangles(np.zeros((0, 3, 8), np.float32)).shape == (0, 3, 8)


def test_a_triangle_around_the_screen_fills_it() -> None:
    pieces = clip([(-50, -50, 0, 1), (50, -50, 0, 1), (0, 80, 0, 1)])

    assert area_on_screen(pieces) == pytest.approx(4, abs=1e-5)


def test_what_is_carried_is_interpolated() -> None:
    cut = clip([(0, 0, 0, 1, 10), (2, 0, 0, 1, 30), (0, 0.5, 0, 1, 10)])

    at_the_edge = cut[np.isclose(cut[..., 0], 1)]
    assert len(at_the_edge) == 3  # two corners, one of them in both triangles of the fan
    assert np.allclose(at_the_edge[:, 4], 20)


def test_pieces_stay_in_the_order_of_their_triangles() -> None:
    across = [(0, 0, 0, 1, 1), (5, 0, 0, 1, 1), (0, 0.5, 0, 1, 1)]
    inside = [(*corner, 0) for corner in INSIDE]
    third = [(*corner, 2) for corner in INSIDE]

    assert clip(inside, across, third)[:, 0, 4].tolist() == [0, 1, 1, 2]


@pytest.mark.parametrize("number", [float("nan"), float("inf")])
def test_triangles_that_are_nowhere_are_gone(number: float) -> None:
    nowhere = [(number, 0, 0, 1), *INSIDE[1:]]

    assert np.array_equal(clip(nowhere, INSIDE), np.array([INSIDE], np.float32))


@given(st.lists(st.tuples(corners, corners, corners), max_size=6))
def test_all_that_is_left_is_in_view(triangles: list[object]) -> None:
    left = clip(*triangles) if triangles else np.zeros((0, 3, 4), np.float32)

    distances = left @ SIDES.T
    assert np.all(distances >= -1e-5)
