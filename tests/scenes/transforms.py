"""Transforms: their order, their stack, and what they do to flat shapes in space."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CENTER, P3D
from tests.scenes.registry import scene


@scene()
def order_of_rotation_and_translation(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    with g.pushMatrix():
        g.translate(55, 12)
        g.rotate(radians(28))
        g.fill(220, 40, 40)
        g.rect(0, 0, 34, 16)
    with g.pushMatrix():
        g.rotate(radians(28))
        g.translate(55, 12)
        g.fill(40, 40, 220)
        g.rect(0, 0, 34, 16)


@scene()
def mirrored_by_a_negative_scale(g: PGraphics) -> None:
    g.background(240, 235, 220)
    g.translate(50, 50)
    for across, down, red in ((1, 1, 0), (-1, 1, 80), (1, -1, 160), (-0.5, -0.7, 240)):
        with g.pushMatrix():
            g.scale(across, down)
            g.fill(red, 120, 90)
            g.triangle(6, 6, 44, 12, 10, 40)


@scene()
def sheared_along_both_axes(g: PGraphics) -> None:
    g.background(20)
    g.stroke(255)
    with g.pushMatrix():
        g.translate(14, 10)
        g.shearX(radians(25))
        g.fill(255, 120, 0)
        g.rect(0, 0, 50, 30)
    with g.pushMatrix():
        g.translate(14, 52)
        g.shearY(radians(-14))
        g.shearX(radians(12))
        g.fill(0, 120, 255)
        g.rect(8, 14, 60, 24)


@scene()
def each_pop_goes_back_one_push(g: PGraphics) -> None:
    g.background(255, 255, 245)
    g.rectMode(CENTER)
    g.translate(50, 50)
    for i in range(6):
        g.pushMatrix()
        g.rotate(radians(11))
        g.scale(0.86)
        g.fill(255 - 40 * i, 40 * i, 120)
        g.rect(0, 0, 84, 70)
    for i in range(6):
        g.popMatrix()
        g.noFill()
        g.stroke(0, 60, 40 * i)
        g.rect(0, 0, 6 + 3 * i, 6 + 3 * i)


@scene()
def matrix_of_six_numbers(g: PGraphics) -> None:
    g.background(230, 230, 255)
    g.applyMatrix(0.7, -0.45, 36, 0.3, 0.8, 6)
    g.fill(255, 200, 0)
    g.rect(4, 4, 56, 46)
    g.applyMatrix(0.5, 0, 30, 0.2, 0.5, 24)
    g.fill(180, 0, 90)
    g.circle(10, 16, 50)


@scene(P3D)
def rotations_about_each_axis(g: PGraphics) -> None:
    g.background(245)
    g.rectMode(CENTER)
    for x, y, red in ((26, 28, 0), (74, 28, 80), (26, 74, 160), (74, 74, 240)):
        with g.pushMatrix():
            g.translate(x, y)
            if red == 0:
                g.rotateX(radians(48))
            elif red == 80:
                g.rotateY(radians(-52))
            elif red == 160:
                g.rotateZ(radians(25))
            else:
                g.rotate(radians(60), 1, 2, -0.5)
            g.fill(red, 150, 110)
            g.rect(0, 0, 34, 34)
            g.fill(255)
            g.triangle(-12, 10, 0, -12, 4, 8)


@scene(P3D)
def matrix_of_sixteen_numbers(g: PGraphics) -> None:
    g.background(40, 30, 60)
    g.translate(52, 50, -10)
    g.applyMatrix(0.8, -0.2, 0.5, 0, 0.3, 0.9, -0.1, 0, -0.5, 0.2, 0.8, -14, 0, 0, 0, 1)
    g.stroke(255, 200, 0)
    g.fill(90, 200, 170)
    g.box(50, 44, 30)
