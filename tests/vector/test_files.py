"""SVG and PDF files, drawn by others' programs, look like the canvas."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.core import constants as c
from sketchkit.draw.vertex import U8
from sketchkit.vector.page import Page
from sketchkit.vector.pdf import pdf_bytes
from sketchkit.vector.svg import svg_bytes
from tests.vector.pages import (
    Drawing,
    page_of,
    pdf_picture,
    picture_of,
    raw_page_of,
    svg_picture,
)

# A soft edge may be off by half a pixel: outlines of weight 1 are moved to whole pixels on the
# canvas, and its ellipses are polygons. It shows as a difference of at most half of the contrast.
EDGE = 140
MOST_EDGES = 0.05  # of all pixels may differ at all

every_drawer = pytest.mark.parametrize("drawn", [svg_picture, pdf_picture], ids=["svg", "pdf"])


def shapes(g: PGraphics) -> None:
    g.background(240)
    g.fill(200, 80, 40)
    g.strokeWeight(4)
    g.rect(8, 8, 30, 20)
    g.noStroke()
    g.fill(0, 100, 200, 128)
    g.ellipse(40, 30, 40, 24)
    g.stroke(0, 120)
    g.strokeWeight(6)
    g.noFill()
    g.triangle(70, 10, 95, 15, 80, 40)
    g.fill(60, 180, 60)
    g.noStroke()
    g.quad(10, 60, 35, 55, 40, 85, 5, 90)
    g.arc(60, 70, 30, 30, 0.3, 4.5)
    g.arc(85, 80, 24, 30, 0.3, 3, c.CHORD)


def matrices(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.fill(0)
    g.translate(50, 20)
    g.rotate(0.5)
    g.shearX(0.3)
    g.scale(1.5, 0.8)
    g.rectMode(c.CENTER)
    g.rect(0, 0, 40, 20)
    g.ellipse(20, 50, 30, 40)


def holes_and_curves(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.fill(20, 40, 160)
    g.beginShape()
    for x, y in ((5, 5), (50, 5), (50, 50), (5, 50)):
        g.vertex(x, y)
    g.beginContour()
    for x, y in ((15, 15), (15, 40), (40, 40), (40, 15)):
        g.vertex(x, y)
    g.endContour()
    g.endShape(c.CLOSE)
    g.beginShape()
    g.vertex(60, 10)
    g.bezierVertex(110, 0, 90, 80, 60, 50)
    g.endShape()
    g.rect(10, 60, 40, 30, 12)
    g.clip(60, 60, 20, 20)
    g.circle(70, 70, 40)


def strip(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.fill(0, 128, 0)
    g.beginShape(c.TRIANGLE_STRIP)
    for i in range(8):
        g.vertex(10 + 10 * i, 20 + 60 * (i % 2))
    g.endShape()


def cubes(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    for depth, gray in ((0, 0), (-60, 160)):  # the nearer one is drawn first
        g.push()
        g.translate(50, 50, depth)
        g.rotateY(0.5)
        g.fill(gray)
        g.box(40)
        g.pop()


def assert_alike(picture: U8, expected: U8) -> None:
    difference = np.abs(picture.astype(int) - expected).max(axis=2)
    assert difference.max() <= EDGE
    assert (difference > 2).mean() <= MOST_EDGES


@every_drawer
@pytest.mark.parametrize("drawing", [shapes, matrices, holes_and_curves, strip])
def test_file_looks_like_the_canvas(drawn: Callable[[Page], U8], drawing: Drawing) -> None:
    picture = drawn(page_of(drawing))

    assert_alike(picture, picture_of(drawing))


@every_drawer
@pytest.mark.parametrize("made", [page_of, raw_page_of])
def test_what_is_near_covers_what_is_far(
    drawn: Callable[[Page], U8], made: Callable[[Drawing, str], Page]
) -> None:
    picture = drawn(made(cubes, c.P3D))

    assert picture[50, 50].tolist() == [0, 0, 0]
    assert_alike(picture, picture_of(cubes, c.P3D))


@every_drawer
def test_translucent_stroke_lies_over_its_fill(drawn: Callable[[Page], U8]) -> None:
    def drawing(g: PGraphics) -> None:
        g.background(255)
        g.fill(255, 0, 0)
        g.stroke(0, 0, 255, 128)
        g.strokeWeight(20)
        g.rect(20, 20, 60, 60)

    picture = drawn(page_of(drawing)).astype(int)

    assert np.abs(picture[50, 15] - (127, 127, 255)).max() <= 1  # over white
    assert np.abs(picture[50, 25] - (127, 0, 128)).max() <= 1  # over the fill


@every_drawer
def test_letters_are_where_they_are_on_the_canvas(drawn: Callable[[Page], U8]) -> None:
    def drawing(g: PGraphics) -> None:
        g.background(255)
        g.fill(0)
        g.textSize(60)
        g.text("HI", 10, 80)

    ink = np.argwhere(drawn(page_of(drawing))[:, :, 0] < 128)
    expected = np.argwhere(picture_of(drawing)[:, :, 0] < 128)

    assert np.abs(ink.min(axis=0) - expected.min(axis=0)).max() <= 1
    assert np.abs(ink.max(axis=0) - expected.max(axis=0)).max() <= 1
    assert len(ink) == pytest.approx(len(expected), rel=0.2)  # there are hints on the canvas


@every_drawer
def test_images_keep_place_tint_and_transparency(drawn: Callable[[Page], U8]) -> None:
    def drawing(g: PGraphics) -> None:
        img = g.createImage(2, 1, c.ARGB)
        img.set(0, 0, g.color(255))
        img.updatePixels()
        g.background(0)
        g.tint(255, 128, 0)
        g.image(img, 20, 20, 60, 40)

    picture = drawn(page_of(drawing)).astype(int)

    assert np.abs(picture[40, 25] - (255, 128, 0)).max() <= 8  # each enlarges in its own way
    assert picture[40, 78].tolist() == [0, 0, 0]
    assert picture[15, 40].tolist() == [0, 0, 0]


@every_drawer
def test_blend_modes_hold(drawn: Callable[[Page], U8]) -> None:
    def drawing(g: PGraphics) -> None:
        g.background(200, 100, 50)
        g.noStroke()
        g.blendMode(c.MULTIPLY)
        g.fill(128)
        g.rect(20, 20, 60, 60)

    picture = drawn(page_of(drawing)).astype(int)

    assert np.abs(picture[50, 50] - (100, 50, 25)).max() <= 1


@pytest.mark.parametrize("write", [svg_bytes, pdf_bytes])
def test_same_drawing_gives_the_same_bytes(write: Callable[[Page], bytes]) -> None:
    assert write(page_of(shapes)) == write(page_of(shapes))
