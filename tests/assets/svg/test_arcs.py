import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.assets.svg.arcs import Arc, arc_curves
from sketchkit.geometry.curves import bezier_points


def drawn(arc):
    """Return points along the curves of an arc, (n, 2)."""
    points, start = [], arc.start
    for first, second, end in arc_curves(arc):
        points.append(bezier_points(np.array([start, first, second, end]), 8))
        start = end
    return np.vstack(points)


@given(
    angle=st.integers(0, 359),
    sweep=st.integers(5, 175),
    is_large=st.booleans(),
    is_clockwise=st.booleans(),
)
def test_an_arc_of_a_circle_keeps_to_the_circle(angle, sweep, is_large, is_clockwise):
    first, last = math.radians(angle), math.radians(angle + sweep)
    start = 50 * math.cos(first), 50 * math.sin(first)
    end = 50 * math.cos(last), 50 * math.sin(last)
    points = drawn(Arc(start, end, (50, 50), 0, is_large, is_clockwise))

    # The short way clockwise and the long way back are on the circle about the origin.
    centre = (0, 0) if is_large != is_clockwise else np.add(start, end)
    assert np.hypot(*(points - centre).T) == pytest.approx(
        50, abs=0.1
    )  # Processing's curves are a little inside
    length = np.hypot(*np.diff(np.vstack([start, points]), axis=0).T).sum()
    assert length == pytest.approx(50 * math.radians(360 - sweep if is_large else sweep), rel=0.01)


def test_radii_that_are_too_small_grow_until_both_ends_are_reached():
    points = drawn(Arc((0, 0), (20, 0), (1, 2), 0, False, True))

    # Radii 10 and 20: clockwise with y down, over the top
    assert points[:, 1].min() == pytest.approx(-20, abs=0.02)
    assert points[-1].tolist() == [20, 0]


def test_a_turned_ellipse_is_turned():
    points = drawn(Arc((0, -9), (0, 9), (9, 4), 90, False, True))

    assert points[:, 0].max() == pytest.approx(4, abs=0.01)
