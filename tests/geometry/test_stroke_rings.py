"""The ring around a stroke covers what the stroke does, once."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sketchkit.core.constants import BEVEL, MITER, PROJECT, ROUND, SQUARE
from sketchkit.geometry.polygons import interpolate, tessellate
from sketchkit.geometry.stroke_rings import stroke_rings
from sketchkit.geometry.strokes import Polylines

SQUARE_25 = [(0, 0), (25, 0), (25, 25), (0, 25)]


def covered_area(points, weight, cap, join, *, is_closed=False):
    x, y = np.array(points, np.float32).T
    x, y, _, lengths = stroke_rings(Polylines(x[None], y[None], is_closed), weight, cap, join)
    places = np.stack([x, y, np.zeros_like(x)], axis=1).astype(float)
    found = tessellate(places, lengths)
    places = interpolate(found, places)
    a, b, c = (places[found.triangles[:, i]] for i in range(3))
    return float(np.abs(np.cross(b - a, c - a)[:, 2]).sum() / 2)


@pytest.mark.parametrize(
    ("cap", "expected"), [(SQUARE, 120), (PROJECT, 156)], ids=["SQUARE", "PROJECT"]
)
def test_ring_around_a_line_has_its_caps(cap, expected):
    assert covered_area([(0, 0), (20, 0)], 6, cap, MITER) == pytest.approx(expected)


def test_ring_with_round_caps_covers_nearly_two_half_discs():
    added = covered_area([(0, 0), (20, 0)], 10, ROUND, MITER) - 200

    assert 0.95 * math.pi * 25 < added < math.pi * 25


@pytest.mark.parametrize("cap", [SQUARE, PROJECT, ROUND], ids=["SQUARE", "PROJECT", "ROUND"])
def test_closed_ring_has_no_caps(cap):
    # 29 x 29 without 21 x 21
    assert covered_area(SQUARE_25, 4, cap, MITER, is_closed=True) == pytest.approx(400)


def test_bevelled_ring_lacks_its_outer_corners():
    covered = covered_area(SQUARE_25, 4, SQUARE, BEVEL, is_closed=True)

    assert covered == pytest.approx(400 - 4 * 2)


def test_corner_has_the_color_of_its_point():
    x, y = np.array([(0, 10, 10)], np.float32), np.array([(0, 0, 10)], np.float32)

    ring = stroke_rings(Polylines(x, y, is_closed=False), 2, SQUARE, BEVEL)

    for corner_x, corner_y, source in zip(*ring[:3], strict=True):
        point = x[0, source], y[0, source]
        assert math.dist((corner_x, corner_y), point) <= math.sqrt(2) + 1e-5
