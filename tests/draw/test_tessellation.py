"""What a shape is drawn with, as corners."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import LINES, POINTS, TRIANGLES
from sketchkit.core.matrix import IDENTITY, rotate_z, scale, translate
from sketchkit.draw.tessellation import pack_rgba, placed, tessellate_parts


def corners_of(canvas, kind, places, matrix=IDENTITY, **look):
    """Return the tessellation of one shape, by kind."""
    s = canvas.createShape()
    s.beginShape(kind)
    if look.get("stroke") is None:
        s.noStroke()
    else:
        s.stroke(look["stroke"])
        s.strokeWeight(look["weight"])
    for x, y in places:
        s.vertex(x, y)
    s.endShape()
    return dict(tessellate_parts([(part, matrix) for part in s._up_to_date(canvas)]))


def test_places_are_moved_and_turned():
    matrix = rotate_z(translate(IDENTITY, 10, 0), np.pi / 2)

    moved = placed(np.array([(1, 0, 0), (0, 2, 3)], np.float32), matrix)

    assert moved == pytest.approx(np.array([(10, 1, 0), (8, 0, 3)]), abs=1e-6)


def test_colours_are_packed():
    packed = pack_rgba(np.array([(0x10, 0x20, 0x30, 0x40)], np.uint8))

    assert packed.tolist() == [0x40102030]


def test_triangles_are_given_corner_by_corner(deep):
    made = corners_of(deep, TRIANGLES, [(0, 0), (10, 0), (0, 10)])

    assert list(made) == [TRIANGLES]
    assert made[TRIANGLES].places.tolist() == [[0, 0, 0], [10, 0, 0], [0, 10, 0]]
    assert made[TRIANGLES].colors.tolist() == [0xFFFFFFFF] * 3


def test_lines_are_given_by_their_ends(deep):
    made = corners_of(deep, LINES, [(0, 0), (10, 0), (0, 10), (5, 10)], stroke=80, weight=3)

    assert list(made) == [LINES]
    assert made[LINES].places[:, :2].tolist() == [[0, 0], [10, 0], [0, 10], [5, 10]]
    assert made[LINES].weights.tolist() == [3, 3, 3, 3]
    assert made[LINES].colors.tolist() == [0xFF505050] * 4


def test_joins_of_an_outline_are_no_lines(deep):
    made = corners_of(deep, TRIANGLES, [(0, 0), (10, 0), (0, 10)], stroke=80, weight=3)

    assert len(made[LINES].places) == 2 * 3


def test_points_are_given_by_their_middles(deep):
    made = corners_of(deep, POINTS, [(1, 2), (3, 4)], stroke=80, weight=6)

    assert list(made) == [POINTS]
    assert made[POINTS].places[:, :2].tolist() == [[1, 2], [3, 4]]
    assert made[POINTS].weights == pytest.approx([6, 6])


def test_places_and_weights_follow_the_matrix(deep):
    doubled = scale(IDENTITY, 2, 2, 2)

    made = corners_of(deep, LINES, [(0, 0), (10, 0)], doubled, stroke=80, weight=3)

    assert made[LINES].places[1, 0] == 20
    assert made[LINES].weights.tolist() == [6, 6]
