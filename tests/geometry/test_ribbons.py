"""Strips of P3D: which corners, which triangles."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.geometry.ribbons import ribbon


def test_segment_is_two_triangles_between_its_ends():
    strip = ribbon(2, is_closed=False, is_joined=True)

    assert strip.points.tolist() == [0, 0, 1, 1]
    assert strip.others.tolist() == [1, 1, 0, 0]
    assert strip.triangles.tolist() == [[0, 1, 2], [2, 1, 3]]


def test_sides_change_hands_at_the_other_end():
    """Seen from the other end, left is right: the same side has the other sign there."""
    strip = ribbon(2, is_closed=False, is_joined=True)

    assert strip.sides.tolist() == [1, -1, -1, 1]


def test_joint_is_two_triangles_from_its_middle():
    strip = ribbon(3, is_closed=False, is_joined=True)

    (middle,) = (i for i, side in enumerate(strip.sides) if side == 0)
    touching = [triangle for triangle in strip.triangles.tolist() if middle in triangle]

    assert strip.points[middle] == strip.others[middle] == 1
    assert len(touching) == 2
    for triangle in touching:
        before, after = (corner for corner in triangle if corner != middle)
        assert strip.points[before] == strip.points[after] == 1
        assert {int(strip.others[before]), int(strip.others[after])} == {0, 2}


def test_thin_strips_have_no_joints():
    strip = ribbon(4, is_closed=True, is_joined=False)

    assert 0 not in strip.sides
    assert len(strip.triangles) == 2 * 4


@pytest.mark.parametrize(
    ("is_closed", "segments", "joints"), [(False, 4, 3), (True, 5, 5)], ids=["open", "closed"]
)
def test_closed_line_has_one_segment_more_and_two_joints(is_closed, segments, joints):
    strip = ribbon(5, is_closed=is_closed, is_joined=True)

    assert len(strip.points) == 4 * segments + joints
    assert len(strip.triangles) == 2 * segments + 2 * joints


@given(st.integers(2, 9), st.booleans(), st.booleans())
def test_every_corner_is_part_of_a_triangle(count, is_closed, is_joined):
    strip = ribbon(count, is_closed=is_closed, is_joined=is_joined)

    assert set(strip.triangles.ravel().tolist()) == set(range(len(strip.points)))
