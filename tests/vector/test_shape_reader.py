from __future__ import annotations

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.core import constants as c
from sketchkit.vector.page import Ellipse, Mark, Page, Path, Picture, Rect
from tests.vector.pages import Drawing, page_of


def marks(draw: Drawing, renderer: str = c.P2D) -> list[Mark]:
    items = page_of(draw, renderer).items
    assert all(isinstance(item, Mark) for item in items)
    return items  # type: ignore[return-value] # see above


def test_calls_become_the_shapes_they_name() -> None:
    def drawing(g: PGraphics) -> None:
        g.rect(1, 2, 3, 4)
        g.ellipse(5, 6, 8, 2)
        g.line(1, 1, 9, 9)
        g.triangle(0, 0, 5, 0, 0, 5)

    rect, ellipse, line, triangle = (mark.outline for mark in marks(drawing))

    assert rect == Rect(1, 2, 3, 4)
    assert ellipse == Ellipse(5, 6, 4, 1)
    assert isinstance(line, Path)
    assert line.letters == "ML"
    assert isinstance(triangle, Path)
    assert triangle.letters == "MLLZ"


def test_modes_give_the_numbers_their_meaning() -> None:
    def drawing(g: PGraphics) -> None:
        g.rectMode(c.RADIUS)
        g.rect(50, 50, 10, 5)
        g.ellipseMode(c.CORNERS)
        g.ellipse(10, 10, 30, 20)

    rect, ellipse = (mark.outline for mark in marks(drawing))

    assert rect == Rect(40, 45, 20, 10)
    assert ellipse == Ellipse(20, 15, 10, 5)


def test_curves_stay_curves() -> None:
    def drawing(g: PGraphics) -> None:
        g.bezier(0, 0, 10, 0, 20, 10, 20, 20)

    (mark,) = marks(drawing)

    assert isinstance(mark.outline, Path)
    assert mark.outline.letters == "MC"
    assert mark.outline.points.tolist() == [[0, 0], [10, 0], [20, 10], [20, 20]]


def test_spline_becomes_the_curves_that_equal_it() -> None:
    def drawing(g: PGraphics) -> None:
        g.curve(0, 0, 10, 10, 20, 10, 30, 0)

    (mark,) = marks(drawing)

    # Of Catmull and Rom: the tangents are half the way between the neighbours.
    assert isinstance(mark.outline, Path)
    assert mark.outline.letters == "MC"
    expected = [(10, 10), (10 + 20 / 6, 10 + 10 / 6), (20 - 20 / 6, 10 + 10 / 6), (20, 10)]
    assert np.allclose(mark.outline.points, expected)


def test_background_leaves_nothing_of_what_was_there() -> None:
    def drawing(g: PGraphics) -> None:
        g.rect(1, 2, 3, 4)
        g.background(255, 0, 0)

    (mark,) = marks(drawing)

    assert mark.outline == Rect(0, 0, 100, 100)
    assert mark.ink.fill == 0xFFFF0000


def test_shape_without_colours_leaves_no_trace() -> None:
    def drawing(g: PGraphics) -> None:
        g.noFill()
        g.noStroke()
        g.rect(1, 2, 3, 4)
        g.stroke(0)
        g.strokeWeight(0)
        g.line(1, 2, 3, 4)

    assert marks(drawing) == []


def test_arc_without_mode_has_an_open_outline_and_a_whole_fill() -> None:
    fill, outline = marks(lambda g: g.arc(50, 50, 20, 20, 0, c.HALF_PI))

    assert isinstance(fill.outline, Path)
    assert fill.outline.letters == "MLCZ"
    assert isinstance(outline.outline, Path)
    assert outline.outline.letters == "MC"
    assert np.allclose(outline.outline.points[[0, -1]], [(60, 50), (50, 60)])


def test_text_is_outlines_in_the_fill_colour() -> None:
    def drawing(g: PGraphics) -> None:
        g.fill(0xFF123456)
        g.text("ab", 10, 50)

    letters = marks(drawing)

    assert len(letters) == 2
    assert {mark.ink.fill for mark in letters} == {0xFF123456}
    assert all("C" in mark.outline.letters for mark in letters)  # type: ignore[union-attr] # a Path


def test_vertices_of_many_colours_give_their_mean() -> None:
    def drawing(g: PGraphics) -> None:
        g.beginShape(c.TRIANGLES)
        for gray in (0, 90, 180):
            g.fill(gray)
            g.vertex(gray, gray % 91)
        g.endShape()

    (mark,) = marks(drawing)

    assert mark.ink.fill == 0xFF5A5A5A


def test_p3d_lies_on_the_page_as_on_the_screen() -> None:
    def drawing(g: PGraphics) -> None:
        g.translate(50, 50, -86.60254)  # as far again as the eye is from the screen
        g.rect(-20, -20, 40, 40)

    (mark,) = marks(drawing, c.P3D)

    assert isinstance(mark.outline, Path)
    assert np.allclose(mark.outline.points.min(axis=0), 40, atol=1e-3)
    assert np.allclose(mark.outline.points.max(axis=0), 60, atol=1e-3)


def test_what_is_behind_the_eye_is_left_out() -> None:
    def drawing(g: PGraphics) -> None:
        g.translate(50, 50, 500)
        g.rect(0, 0, 40, 40)

    assert marks(drawing, c.P3D) == []


def test_part_of_an_image_is_cut_out() -> None:
    def drawing(g: PGraphics) -> None:
        img = g.createImage(4, 4, c.RGB)
        img.set(2, 1, g.color(255, 0, 0))
        img.updatePixels()
        g.image(img, 10, 20, 30, 40, 2, 1, 4, 3)

    (picture,) = page_of(drawing).items

    assert isinstance(picture, Picture)
    assert picture.matrix == pytest.approx((30, 0, 0, 40, 10, 20))
    assert isinstance(picture.image, np.ndarray)
    assert picture.image.shape == (2, 2, 4)
    assert picture.image[0, 0].tolist() == [255, 0, 0, 255]


def test_retained_shape_is_what_it_was_made_from() -> None:
    def drawing(g: PGraphics) -> None:
        shape = g.createShape()
        shape.beginShape()
        shape.vertex(0, 0)
        shape.bezierVertex(10, 0, 20, 10, 20, 20)
        shape.endShape()
        g.shape(shape, 5, 6)
        shape.setFill(0xFF00FF00)
        g.shape(shape)

    before, after = marks(drawing)

    assert isinstance(before.outline, Path)
    assert before.outline.letters == "MC"
    assert before.matrix == (1, 0, 0, 1, 5, 6)
    assert (before.ink.fill, after.ink.fill) == (0xFFFFFFFF, 0xFF00FF00)


def test_picture_of_another_canvas_is_a_page_on_the_page() -> None:
    def drawing(g: PGraphics) -> None:
        small = g.offscreen(10, 10, c.P2D, 4)
        with small.beginDraw():
            small.rect(1, 2, 3, 4)
        g.tint(255, 128)
        g.image(small, 20, 30, 40, 40)

    (picture,) = page_of(drawing).items

    assert isinstance(picture, Picture)
    assert isinstance(picture.image, Page)
    assert picture.opacity == 128 / 255
    assert picture.matrix == pytest.approx((40, 0, 0, 40, 20, 30))
    assert [type(item) for item in picture.image.items][-1] is Mark
