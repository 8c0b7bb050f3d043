"""Solids: which faces they have, in which order."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P3D
from tests.scenes.registry import scene


@scene(P3D)
def box_of_three_sizes(g: PGraphics) -> None:
    g.background(250, 245, 235)
    g.fill(230, 140, 60)
    g.translate(30, 40)
    g.rotateX(radians(-30))
    g.rotateY(radians(40))
    g.box(26, 44, 16)
    g.translate(34, 16, 10)
    g.fill(60, 150, 200)
    g.box(22)


@scene(P3D)
def box_faces_in_processings_order(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.fill(200, 30, 60, 100)
    g.translate(50, 50)
    g.rotateX(radians(27))
    g.rotateY(radians(-38))
    g.box(52, 40, 46)


@scene(P3D)
def sphere_of_few_corners(g: PGraphics) -> None:
    g.background(225, 235, 255)
    g.fill(250, 210, 90)
    g.stroke(60, 40, 120)
    g.sphereDetail(6, 5)
    g.translate(32, 34)
    g.rotateX(radians(-20))
    g.sphere(27)
    g.translate(36, 34, -4)
    g.sphereDetail(3, 2)
    g.sphere(22)


@scene(P3D)
def sphere_shaded_by_the_usual_lights(g: PGraphics) -> None:
    g.background(10, 10, 30)
    g.lights()
    g.noStroke()
    g.fill(90, 220, 140)
    g.translate(46, 52)
    g.scale(1.2, 0.7, 1)
    g.sphere(38)


@scene(P3D)
def solids_cut_into_each_other(g: PGraphics) -> None:
    g.background(255, 240, 220)
    g.noStroke()
    g.lights()
    g.translate(50, 52)
    g.rotateX(radians(-25))
    g.rotateY(radians(20))
    g.fill(220, 60, 60)
    g.box(70, 18, 44)
    g.fill(60, 90, 220)
    g.box(20, 66, 30)
    g.fill(240, 220, 80)
    g.sphere(24)


@scene(P3D)
def flat_shapes_stand_in_space(g: PGraphics) -> None:
    g.background(30, 40, 40)
    g.translate(50, 50)
    for i in range(3):
        with g.pushMatrix():
            g.rotateY(radians(25 + 50 * i))
            g.fill(255 - 80 * i, 80 + 70 * i, 90)
            g.ellipse(0, 0, 70, 80 - 14 * i)
            g.rect(-12, -9, 24, 18)
