"""What `attrib()` gave, as columns of vertices."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CLOSE, HALF_PI, TRIANGLES
from tests.canvases import fills, flat_canvas


@pytest.fixture
def g() -> PGraphics:
    canvas = flat_canvas()
    canvas.noStroke()
    return canvas


def triangle(g: PGraphics) -> None:
    for x, y in [(0, 0), (10, 0), (0, 10)]:
        g.vertex(x, y)


def test_numbers_hold_for_the_vertices_that_follow(g: PGraphics) -> None:
    g.beginShape(TRIANGLES)
    g.attrib("heat", 0.25)
    g.vertex(0, 0)
    g.attrib("heat", 0.75)
    g.vertex(10, 0)
    g.vertex(0, 10)
    g.endShape()

    assert fills(g).custom["heat"].ravel().tolist() == [0.25, 0.75, 0.75]


def test_places_are_transformed_as_vertices_are(g: PGraphics) -> None:
    g.translate(5, 7)
    g.scale(2)
    g.beginShape(TRIANGLES)
    g.attribPosition("tip", 1, 2, 3)
    triangle(g)
    g.endShape()

    assert fills(g).custom["tip"].tolist() == [[7, 11, 6]] * 3


def test_directions_are_turned_and_not_moved(g: PGraphics) -> None:
    g.translate(5, 7)
    g.rotate(HALF_PI)
    g.beginShape(TRIANGLES)
    g.attribNormal("along", 1, 0, 0)
    triangle(g)
    g.endShape()

    np.testing.assert_allclose(fills(g).custom["along"], [[0, 1, 0]] * 3, atol=1e-6)


def test_colours_are_four_numbers_up_to_one(g: PGraphics) -> None:
    g.beginShape(TRIANGLES)
    g.attribColor("glow", g.color(255, 0, 51))
    triangle(g)
    g.endShape()

    np.testing.assert_allclose(fills(g).custom["glow"], [[1, 0, 0.2, 1]] * 3, atol=1e-6)


def test_what_has_none_gets_zeros_beside_what_has_some(g: PGraphics) -> None:
    g.rect(0, 0, 10, 10)
    g.beginShape(TRIANGLES)
    g.attrib("heat", 1.0)
    triangle(g)
    g.endShape()

    assert fills(g).custom["heat"].ravel().tolist() == [0, 0, 0, 0, 1, 1, 1]


def test_next_shape_begins_without_attributes(g: PGraphics) -> None:
    g.beginShape(TRIANGLES)
    g.attrib("heat", 1.0)
    triangle(g)
    g.endShape()
    g.beginShape(TRIANGLES)
    triangle(g)
    g.endShape()

    assert fills(g).custom["heat"].ravel().tolist() == [1, 1, 1, 0, 0, 0]


def test_corners_of_polygons_keep_their_numbers(g: PGraphics) -> None:
    g.beginShape()
    for i, (x, y) in enumerate([(0, 0), (10, 0), (10, 10), (0, 10)]):
        g.attrib("heat", i)
        g.vertex(x, y)
    g.endShape(CLOSE)

    block = fills(g)
    places = {(0, 0): 0, (10, 0): 1, (10, 10): 2, (0, 10): 3}
    expected = [places[tuple(place[:2])] for place in block.positions.tolist()]
    assert block.custom["heat"].ravel().tolist() == expected


def test_drawing_without_attributes_has_no_such_columns(g: PGraphics) -> None:
    g.rect(0, 0, 10, 10)

    assert fills(g).custom == {}
