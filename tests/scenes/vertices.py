"""Shapes vertex by vertex: their kinds, their colours, their holes."""

from math import cos, radians, sin

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    CLOSE,
    LINES,
    POINTS,
    QUAD_STRIP,
    QUADS,
    TRIANGLE_FAN,
    TRIANGLE_STRIP,
    TRIANGLES,
)
from tests.scenes.registry import scene


@scene()
def triangles_blend_their_vertex_colors(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.beginShape(TRIANGLES)
    for x, y, red, green, blue in (
        (8, 90, 255, 0, 0),
        (40, 8, 0, 255, 0),
        (60, 84, 0, 0, 255),
        (52, 10, 255, 255, 0),
        (94, 14, 0, 255, 255),
        (90, 92, 255, 0, 255),
        (0, 0, 255, 255, 255),  # left over
    ):
        g.fill(red, green, blue)
        g.vertex(x, y)
    g.endShape()


@scene()
def triangle_strip_with_outlines(g: PGraphics) -> None:
    g.background(245, 235, 220)
    g.stroke(60, 0, 90)
    g.beginShape(TRIANGLE_STRIP)
    for i in range(7):
        g.fill(255 - 30 * i, 120, 30 * i)
        g.vertex(8 + 14 * i, 25 if i % 2 else 78)
    g.endShape()


@scene()
def triangle_fan_around_its_hub(g: PGraphics) -> None:
    g.background(20, 20, 40)
    g.stroke(255)
    g.beginShape(TRIANGLE_FAN)
    g.fill(255, 220, 0)
    g.vertex(42, 55)
    for i in range(8):
        g.fill(200, 25 * i, 60)
        angle = radians(-30 + 42 * i)
        g.vertex(50 + 42 * cos(angle), 50 + 38 * sin(angle))
    g.endShape()


@scene()
def quads_split_from_first_to_third(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.beginShape(QUADS)
    for x, y, gray in (
        (8, 12, 0),
        (46, 8, 255),
        (44, 90, 0),
        (10, 84, 0),
        (54, 10, 0),
        (90, 16, 0),
        (93, 88, 255),
        (58, 92, 0),
    ):
        g.fill(gray, gray // 2, 120)
        g.vertex(x, y)
    g.endShape()


@scene()
def quad_strip_with_outlines(g: PGraphics) -> None:
    g.background(230, 250, 240)
    g.strokeWeight(2)
    g.beginShape(QUAD_STRIP)
    for i in range(5):
        g.fill(240, 60 + 40 * i, 60)
        g.vertex(10 + 20 * i, 22 + 9 * (i % 2))
        g.fill(40, 60 + 40 * i, 200)
        g.vertex(10 + 20 * i, 74 - 12 * (i % 3))
    g.endShape()


@scene()
def lines_and_points_of_shapes(g: PGraphics) -> None:
    g.background(250)
    g.strokeWeight(4)
    g.beginShape(LINES)
    for i in range(7):
        g.stroke(36 * i, 40, 220 - 36 * i)
        g.vertex(10 + 13 * i, 10 + 34 * (i % 2))
    g.endShape()
    g.strokeWeight(7)
    g.beginShape(POINTS)
    for i in range(6):
        g.stroke(220, 36 * i, 40)
        g.vertex(12 + 15 * i, 60 + 6 * i)
    g.endShape()


@scene()
def polygon_left_open_or_closed(g: PGraphics) -> None:
    g.background(255, 235, 240)
    g.strokeWeight(3)
    g.fill(150, 200, 60)
    for left, mode in ((4, None), (52, CLOSE)):
        g.beginShape()
        for x, y in ((6, 10), (38, 22), (20, 38), (40, 88), (10, 70), (18, 50)):
            g.vertex(left + x, y)
        if mode is None:
            g.endShape()
        else:
            g.endShape(mode)


@scene()
def polygon_with_two_holes(g: PGraphics) -> None:
    g.background(90, 140, 255)
    g.fill(250, 220, 160)
    g.stroke(100, 40, 0)
    g.beginShape()
    for x, y in ((6, 8), (92, 14), (86, 93), (14, 84)):
        g.vertex(x, y)
    for x, y in ((22, 24), (58, 22)):
        g.beginContour()  # wound against the outline
        for across, down in ((0, 0), (2, 40), (20, 44), (24, 6)):
            g.vertex(x + across, y + down)
        g.endContour()
    g.endShape(CLOSE)


@scene()
def polygon_that_crosses_itself(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.beginShape()
    for i in range(7):  # every third corner of a heptagon: gone round several times
        angle = radians(-80 + 3 * 360 / 7 * i)
        g.fill(255 - 36 * i, 20, 36 * i)
        g.vertex(50 + 45 * cos(angle), 52 + 44 * sin(angle))
    g.endShape(CLOSE)
