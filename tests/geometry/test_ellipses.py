"""What ellipseMode() makes of four numbers, and the corners of arcs."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.constants import CENTER, CHORD, CORNER, CORNERS, OPEN, PIE, RADIUS
from sketchkit.geometry.ellipses import (
    Boxes,
    arc_outline_passes_hub,
    ellipse_boxes,
    unit_arc,
    upright,
    wrap_angles,
)

QUARTER = math.pi / 2
DEFAULT = 0

angles = st.floats(-50, 50)


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (CORNER, (30, 20, 10, 6)),
        (CORNERS, (30, 20, -20, -14)),
        (CENTER, (25, 17, 10, 6)),
        (RADIUS, (20, 14, 20, 12)),
    ],
    ids=["CORNER", "CORNERS", "CENTER", "RADIUS"],
)
def test_mode_gives_the_same_numbers_another_meaning(mode, expected):
    box = ellipse_boxes(mode, np.array([(30, 20, 10, 6)], np.float32))

    assert tuple(float(column[0]) for column in box) == expected


def test_upright_box_covers_the_same_place():
    reversed_box = Boxes(*(np.array([value], np.float32) for value in (30, 20, -20, 14)))

    box = upright(reversed_box)

    assert tuple(float(column[0]) for column in box) == (10, 20, 20, 14)


@pytest.mark.parametrize(("start", "stop"), [(1, 1), (2, 1), (math.nan, 1), (0, math.inf)])
def test_no_arc_unless_it_goes_forward(start, stop):
    assert wrap_angles(start, stop) is None


def test_arc_before_zero_is_moved_by_whole_turns():
    assert wrap_angles(-QUARTER, QUARTER) == pytest.approx((3 * QUARTER, 5 * QUARTER))


@given(angles, angles)
def test_wrapped_angles_begin_above_zero_and_span_a_turn_at_most(start, stop):
    wrapped = wrap_angles(start, stop)

    if stop <= start:
        assert wrapped is None
    else:
        first, last = wrapped
        assert first >= 0
        assert last - first == pytest.approx(min(stop - start, math.tau))
        assert math.cos(first) == pytest.approx(math.cos(start), abs=1e-9)


def test_arc_runs_from_start_to_stop():
    arc = unit_arc(0, QUARTER, PIE, 40)

    assert (arc.x[0], arc.y[0]) == pytest.approx((1, 0), abs=1e-6)
    assert (arc.x[-1], arc.y[-1]) == pytest.approx((0, 1), abs=1e-6)
    assert not arc.is_full


def test_arc_has_its_share_of_a_whole_ellipses_corners():
    arc = unit_arc(0, QUARTER, PIE, 40)

    assert len(arc.x) == 11  # a quarter of 40 sides


@pytest.mark.parametrize(
    ("mode", "hub"),
    [(DEFAULT, (0, 0)), (PIE, (0, 0)), (OPEN, (0.5, 0.5)), (CHORD, (0.5, 0.5))],
    ids=["none", "PIE", "OPEN", "CHORD"],
)
def test_fill_spreads_from_the_centre_or_from_the_chord(mode, hub):
    arc = unit_arc(0, QUARTER, mode, 40)

    assert arc.hub == pytest.approx(hub, abs=1e-6)


def test_full_pie_ends_where_it_began():
    arc = unit_arc(0, math.tau, PIE, 40)

    assert arc.is_full
    assert (arc.x[0], arc.y[0]) == (arc.x[-1], arc.y[-1])


def test_full_chord_does_not_repeat_its_first_corner():
    arc = unit_arc(0, math.tau, CHORD, 40)

    assert (arc.x[0], arc.y[0]) != (arc.x[-1], arc.y[-1])


def test_outline_passes_the_hub_only_where_it_is_closed():
    passes = [mode for mode in (DEFAULT, OPEN, CHORD, PIE) if arc_outline_passes_hub(mode)]

    assert passes == [CHORD, PIE]
