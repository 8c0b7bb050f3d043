"""Curves: where they run, and of how many lines they are made."""

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CLOSE, P3D
from tests.scenes.registry import scene


@scene()
def bezier_filled_and_not(g: PGraphics) -> None:
    g.background(245, 250, 255)
    g.fill(255, 190, 60)
    g.stroke(120, 0, 60)
    g.strokeWeight(3)
    g.bezier(8, 44, 20, -30, 70, 90, 92, 10)
    g.noFill()
    g.stroke(0, 100, 140)
    g.bezier(8, 90, 90, 40, 6, 50, 94, 92)


@scene()
def bezier_of_few_lines(g: PGraphics) -> None:
    g.background(30)
    g.noFill()
    for i, detail in enumerate((1, 2, 3, 5, 30)):
        g.bezierDetail(detail)
        g.stroke(255, 250 - 50 * i, 50 * i)
        g.bezier(6, 80 - 4 * i, 30, -10 - 4 * i, 60, 20 - 4 * i, 94, 94 - 4 * i)


@scene()
def outline_of_cubic_and_quadratic_pieces(g: PGraphics) -> None:
    g.background(255, 250, 240)
    g.fill(60, 160, 120)
    g.strokeWeight(2)
    g.beginShape()
    g.vertex(50, 20)
    g.bezierVertex(60, -8, 98, 10, 88, 42)
    g.quadraticVertex(80, 60, 94, 80)
    g.vertex(54, 92)
    g.quadraticVertex(2, 90, 12, 40)
    g.bezierVertex(0, 10, 38, -6, 50, 20)
    g.endShape(CLOSE)


@scene()
def spline_through_its_points(g: PGraphics) -> None:
    g.background(20, 30, 20)
    points = ((4, 60), (14, 78), (30, 16), (52, 82), (70, 12), (90, 66), (97, 90))
    g.noFill()
    g.stroke(120, 255, 120)
    g.strokeWeight(2)
    g.beginShape()
    for x, y in points:
        g.curveVertex(x, y)
    g.endShape()
    g.stroke(255, 80, 80)
    g.strokeWeight(5)
    for x, y in points:
        g.point(x, y)


@scene()
def spline_of_each_tightness(g: PGraphics) -> None:
    g.background(250)
    g.noFill()
    for i, tightness in enumerate((-2.0, -0.5, 0.0, 0.6, 1.0)):
        g.curveTightness(tightness)
        g.stroke(50 * i, 30, 220 - 50 * i)
        g.curve(2, 94, 12, 30, 88, 62, 96, 4)


@scene(P3D)
def curves_in_space(g: PGraphics) -> None:
    g.background(235, 240, 255)
    g.noFill()
    g.strokeWeight(3)
    g.stroke(180, 30, 90)
    g.bezier(6, 80, 40, 30, 0, -150, 70, 0, 60, 94, 84, -60)
    g.stroke(20, 90, 160)
    g.curveDetail(7)
    g.curve(0, 0, 90, 8, 30, -80, 92, 24, 50, 100, 90, 0)
