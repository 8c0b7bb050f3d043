"""Strokes: caps, joins and weights in the plane, strips in space."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import BEVEL, MITER, P3D, PROJECT, ROUND, SQUARE
from tests.scenes.registry import scene


@scene()
def line_caps_beyond_the_end(g: PGraphics) -> None:
    g.background(255, 245, 235)
    for i, cap in enumerate((SQUARE, PROJECT, ROUND)):
        g.strokeCap(cap)
        g.stroke(40, 90 * i, 160)
        g.strokeWeight(13)
        g.line(20, 18 + 22 * i, 78, 14 + 22 * i)
        g.stroke(255)
        g.strokeWeight(1)
        g.line(20, 18 + 22 * i, 78, 14 + 22 * i)
    g.strokeWeight(9)
    g.stroke(200, 30, 30)
    g.strokeCap(ROUND)
    g.line(30, 86, 30, 86)  # no length: a dot, or nothing


@scene()
def joins_from_blunt_to_sharp(g: PGraphics) -> None:
    g.background(230, 240, 230)
    g.noFill()
    g.strokeWeight(7)
    for i, join in enumerate((MITER, BEVEL, ROUND)):
        g.strokeJoin(join)
        g.stroke(30 + 80 * i, 60, 150 - 60 * i)
        g.beginShape()
        for x, y in ((8, 26), (24, 12), (40, 27), (52, 9), (62, 28), (70, 9), (76, 28), (81, 8)):
            g.vertex(x, y + 30 * i)
        g.endShape()


@scene()
def miter_is_cut_off_when_too_long(g: PGraphics) -> None:
    g.background(250)
    g.noFill()
    g.strokeWeight(4)
    for i, spread in enumerate((9.0, 6.0, 4.5, 3.5, 2.5)):
        g.stroke(50 * i, 0, 220 - 50 * i)
        g.beginShape()
        g.vertex(12 + 19 * i - spread, 92)
        g.vertex(12 + 19 * i, 40)
        g.vertex(12 + 19 * i + spread, 92)
        g.endShape()


@scene()
def thin_lines_of_every_slope(g: PGraphics) -> None:
    g.background(15, 20, 50)
    for i in range(12):
        g.stroke(255, 20 * i, 255 - 20 * i)
        g.strokeWeight((0.5, 1, 1.5)[i % 3])
        g.line(4, 4 + 8.3 * i, 96, 50 + 4.1 * i)


@scene()
def thin_outlines_lie_on_whole_pixels(g: PGraphics) -> None:
    g.background(255)
    g.noFill()
    g.stroke(0)
    g.rect(8.3, 7.6, 35, 30)
    g.rect(55.5, 10.5, 30.2, 24.7)
    g.stroke(200, 0, 0)
    g.line(10.4, 55.3, 90.4, 55.3)
    g.line(30.7, 60.1, 30.7, 92.6)
    g.strokeWeight(1.5)
    g.line(10.4, 75.3, 90.4, 75.3)
    g.line(60.7, 60.1, 60.7, 92.6)


@scene()
def translucent_stroke_paints_once(g: PGraphics) -> None:
    g.background(255)
    g.noFill()
    g.stroke(200, 0, 60, 110)
    g.strokeWeight(10)
    g.strokeJoin(ROUND)
    g.beginShape()
    for x, y in ((12, 80), (80, 18), (18, 24), (88, 78), (50, 90), (52, 10)):
        g.vertex(x, y)
    g.endShape()
    g.stroke(0, 90, 200, 110)
    g.line(6, 50, 94, 56)


@scene()
def translucent_outline_covers_half_of_its_fill(g: PGraphics) -> None:
    g.background(250, 250, 200)
    g.fill(0, 130, 90)
    g.stroke(160, 0, 160, 130)
    g.strokeWeight(12)
    g.rect(16, 14, 40, 34)
    g.ellipse(62, 66, 44, 40)


@scene()
def weight_grows_with_the_scale(g: PGraphics) -> None:
    g.background(240)
    g.strokeWeight(2)
    for i, factor in enumerate((0.5, 1.0, 2.0, 3.0)):
        with g.pushMatrix():
            g.translate(8, 10 + 22 * i)
            g.scale(factor)
            g.stroke(40 * i, 120, 40)
            g.line(0, 0, 80 / factor, 6 / factor)
    g.stroke(200, 60, 0)
    g.noFill()
    g.scale(2, 0.5)
    g.circle(36, 120, 18)


@scene(P3D)
def strips_in_space_are_bevelled(g: PGraphics) -> None:
    g.background(255, 240, 230)
    g.noFill()
    g.strokeWeight(9)
    g.strokeJoin(MITER)  # has no effect in space
    g.stroke(40, 60, 180)
    g.beginShape()
    for x, y, z in ((10, 80, 0), (30, 20, -40), (50, 80, 20), (70, 20, -60), (92, 82, 0)):
        g.vertex(x, y, z)
    g.endShape()
    g.stroke(180, 40, 40, 128)
    g.rect(30, 42, 40, 22)


@scene(P3D)
def thin_strips_have_no_joins(g: PGraphics) -> None:
    g.background(20)
    g.noFill()
    g.translate(50, 50)
    g.rotateX(radians(35))
    for i in range(4):
        g.strokeWeight(0.5 + 0.5 * i)
        g.stroke(255, 255 - 60 * i, 60 * i)
        g.rect(-38 + 9 * i, -38 + 9 * i, 76 - 18 * i, 76 - 18 * i)


@scene(P3D)
def stroke_of_a_solid_wins_over_its_fill(g: PGraphics) -> None:
    g.background(200, 220, 240)
    g.translate(50, 52, -10)
    g.rotateX(radians(-24))
    g.rotateY(radians(33))
    g.strokeWeight(3)
    g.stroke(255, 255, 255)
    g.fill(20, 90, 60)
    g.box(46, 38, 52)
