"""Hints: what depth, and distance, do."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    CENTER,
    DISABLE_DEPTH_MASK,
    DISABLE_DEPTH_TEST,
    DISABLE_OPTIMIZED_STROKE,
    DISABLE_STROKE_PERSPECTIVE,
    ENABLE_DEPTH_MASK,
    ENABLE_DEPTH_SORT,
    ENABLE_DEPTH_TEST,
    ENABLE_OPTIMIZED_STROKE,
    ENABLE_STROKE_PERSPECTIVE,
    P3D,
)
from tests.scenes.registry import scene


@scene(P3D)
def without_depth_test_the_last_wins(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.fill(220, 60, 40)
    g.rect(10, 10, 50, 50)
    g.hint(DISABLE_DEPTH_TEST)
    g.translate(0, 0, -40)
    g.fill(40, 60, 220)
    g.rect(20, 30, 60, 50)
    g.hint(ENABLE_DEPTH_TEST)
    g.translate(0, 0, 20)
    g.fill(40, 160, 60)
    g.rect(40, 0, 40, 90)


@scene(P3D)
def without_depth_mask_nothing_hides(g: PGraphics) -> None:
    g.background(245)
    g.noStroke()
    g.translate(0, 0, 20)
    g.hint(DISABLE_DEPTH_MASK)
    g.fill(255, 180, 0, 150)
    g.rect(16, 16, 50, 40)
    g.hint(ENABLE_DEPTH_MASK)
    g.translate(0, 0, -30)
    g.fill(0, 120, 120)
    g.rect(30, 40, 60, 44)


@scene(P3D)
def faces_sorted_by_depth(g: PGraphics) -> None:
    g.background(255, 255, 235)
    g.hint(ENABLE_DEPTH_SORT)
    g.noStroke()
    g.translate(50, 50)
    g.rotateX(radians(30))
    g.rotateY(radians(-28))
    g.rectMode(CENTER)
    for i in range(3):
        g.fill(240 - 100 * i, 40 + 80 * i, 60, 130)
        with g.pushMatrix():
            g.translate(10 * i - 10, 0, 30 - 30 * i)
            g.rect(0, 0, 50, 50)
    g.fill(60, 60, 220, 120)
    g.box(24, 60, 24)


@scene(P3D)
def strokes_thinner_with_distance(g: PGraphics) -> None:
    g.background(230, 240, 255)
    g.noFill()
    g.strokeWeight(5)
    g.hint(ENABLE_STROKE_PERSPECTIVE)
    g.stroke(180, 60, 30)
    for i in range(4):
        with g.pushMatrix():
            g.translate(28, 50, 30 - 50 * i)
            g.rect(-16, -34, 32, 68)
    g.hint(DISABLE_STROKE_PERSPECTIVE)
    g.stroke(30, 60, 180)
    g.line(60, 90, 30, 96, 20, -160)


@scene(P3D)
def coplanar_shapes_show_the_later_one(g: PGraphics) -> None:
    g.background(20, 40, 60)
    g.noStroke()
    g.translate(48, 50, -12)
    g.rotateZ(radians(15))  # facing the camera: in another plane, rounding would decide
    for i in range(4):
        g.fill(255 - 60 * i, 100, 60 * i)
        g.rect(-40 + 10 * i, -36 + 9 * i, 46, 40)


@scene(P3D)
def outlines_one_by_one(g: PGraphics) -> None:
    g.background(255)
    g.hint(DISABLE_OPTIMIZED_STROKE)
    g.translate(45, 50)
    g.rotateY(0.5)
    g.strokeWeight(3)
    g.fill(255, 0, 0)
    g.box(30)
    g.translate(0, 0, 25)
    g.stroke(0, 150, 0)
    g.fill(0, 0, 255, 80)
    g.rect(-30, -30, 45, 45)
    g.hint(ENABLE_OPTIMIZED_STROKE)
    g.translate(0, 0, 15)
    g.fill(255, 255, 0, 120)
    g.rect(-25, -10, 40, 40)
