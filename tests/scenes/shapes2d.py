"""Flat shapes: where their edges lie, and how many sides they have."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    CENTER,
    CHORD,
    CORNER,
    CORNERS,
    JAVA2D,
    OPEN,
    P3D,
    PIE,
    PROJECT,
    RADIUS,
    ROUND,
    SQUARE,
)
from tests.scenes.registry import scene

OF_JAVA = "Java's own rasteriser has more than four steps along an edge"


@scene()
def rect_mode_of_each_quarter(g: PGraphics) -> None:
    g.background(240)
    g.stroke(20, 20, 120)
    for i, mode in enumerate((CORNER, CORNERS, CENTER, RADIUS)):
        with g.pushMatrix():
            g.translate(50 * (i % 2), 50 * (i // 2))
            g.rectMode(mode)
            g.fill(250, 120 + 40 * i, 30)
            g.rect(22, 25, 18, 12)


@scene()
def rect_from_any_two_corners(g: PGraphics) -> None:
    g.background(30, 30, 60)
    g.rectMode(CORNERS)
    g.fill(255, 160, 0, 160)
    g.noStroke()
    g.rect(60, 10, 10, 45)
    g.rect(40, 70, 90, 30)
    g.rectMode(CORNER)
    g.fill(0, 220, 160, 160)
    g.rect(90, 92, -60, -14)


@scene()
def rect_moves_up_to_whole_pixels(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    for i in range(5):
        g.fill(40 * i, 0, 200 - 40 * i)
        g.rect(6.2 + 18.2 * i, 10.1 + 0.2 * i, 12.4, 30)
    g.rotate(radians(1))
    for i in range(5):
        g.fill(200 - 40 * i, 120, 0)
        g.rect(6.2 + 18.2 * i, 55.1 + 0.2 * i, 12.4, 30)


@scene()
def rect_radius_of_each_corner(g: PGraphics) -> None:
    g.background(250, 245, 230)
    g.fill(90, 160, 220)
    g.stroke(120, 20, 60)
    g.strokeWeight(3)
    g.rect(8, 8, 52, 36, 4, 10, 17, 0)
    g.noStroke()
    g.rect(68, 12, 24, 60, 40)
    g.fill(230, 90, 60)
    g.rect(10, 56, 46, 34, 9)


@scene()
def ellipse_mode_of_each_quarter(g: PGraphics) -> None:
    g.background(225, 235, 245)
    g.noFill()
    g.strokeWeight(2)
    for i, mode in enumerate((CORNER, CORNERS, CENTER, RADIUS)):
        with g.pushMatrix():
            g.translate(50 * (i % 2), 50 * (i // 2))
            g.ellipseMode(mode)
            g.stroke(60 * i, 90, 200 - 50 * i)
            g.ellipse(24, 22, 20, 13)


@scene()
def circle_has_more_sides_when_large(g: PGraphics) -> None:
    g.background(10)
    g.noStroke()
    for i, size in enumerate((96, 70, 46, 27, 14, 6, 3)):
        g.fill(255 if i % 2 == 0 else 60, 90 + 20 * i, 20 + 30 * i)
        g.circle(49.5 + i, 50, size)


@scene()
def arc_closed_in_each_way(g: PGraphics) -> None:
    g.background(40)
    g.fill(70, 170, 255)
    g.stroke(255, 230, 0)
    g.strokeWeight(2)
    g.arc(27, 26, 42, 36, radians(-40), radians(190))
    g.arc(75, 26, 42, 36, radians(-40), radians(190), OPEN)
    g.arc(27, 76, 42, 36, radians(-40), radians(190), CHORD)
    g.arc(75, 76, 42, 36, radians(-40), radians(190), PIE)


@scene()
def arc_of_a_full_turn_and_more(g: PGraphics) -> None:
    g.background(245)
    g.fill(230, 60, 110)
    g.arc(28, 30, 44, 44, 0, radians(360), CHORD)
    g.arc(74, 30, 40, 40, radians(100), radians(700), PIE)
    g.noStroke()
    g.fill(30, 140, 90)
    g.arc(50, 76, 84, 34, radians(-200), radians(20))


@scene()
def triangle_of_either_winding(g: PGraphics) -> None:
    g.background(255, 250, 220)
    g.fill(30, 110, 80)
    g.triangle(6, 46, 30, 7, 47, 41)
    g.fill(220, 60, 40)
    g.triangle(94, 44, 58, 38, 80, 6)
    g.noStroke()
    g.fill(40, 40, 160)
    g.triangle(10, 90, 60, 90, 10, 60.5)  # two of its edges lie along the axes


@scene()
def quad_concave_and_crossed(g: PGraphics) -> None:
    g.background(235)
    g.fill(240, 150, 30, 200)
    g.quad(10, 10, 46, 24, 12, 44, 20, 25)
    g.quad(56, 10, 92, 42, 92, 12, 58, 40)
    g.noStroke()
    g.quad(12.5, 60.5, 84.25, 60.5, 84.25, 90, 12.5, 90)  # along the axes


@scene()
def points_round_and_square(g: PGraphics) -> None:
    g.background(20, 30, 30)
    for i, cap in enumerate((ROUND, SQUARE, PROJECT)):
        g.strokeCap(cap)
        for j, weight in enumerate((1, 2, 3.5, 8, 15, 24)):
            g.stroke(255, 250 - 40 * j, 60 + 60 * i)
            g.strokeWeight(weight)
            g.point(6 + j * j * 3, 20 + 30 * i)


@scene(P3D)
def points_in_space_keep_their_size(g: PGraphics) -> None:
    g.background(20, 30, 30)
    for i in range(6):
        g.strokeCap(ROUND if i % 2 else SQUARE)
        g.stroke(255, 240 - 40 * i, 40 * i)
        g.strokeWeight(11)
        g.point(10 + 16 * i, 30, -40 * i)
        g.strokeWeight(3 + 2 * i)
        g.point(10 + 16 * i, 70, 10)


@scene(is_smooth=False)
def hard_edges_without_smoothing(g: PGraphics) -> None:
    g.background(250)
    g.fill(255, 120, 0)
    g.circle(35, 38, 55)
    g.strokeWeight(5)
    g.line(12, 92, 90, 55)
    g.strokeWeight(1)
    g.triangle(60, 10, 93, 17, 71, 48)


@scene(JAVA2D, processing_share=0.97, why=OF_JAVA)
def default_renderer_keeps_fills_between_pixels(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    for i in range(4):
        g.fill(200 - 60 * i, 40, 60 * i)
        g.rect(5 + 23.25 * i, 8.25 + 0.25 * i, 16.5, 34)
    g.noFill()
    for i in range(4):
        g.stroke(60 * i, 110, 20)
        g.strokeWeight(1 + i)
        g.rect(5 + 23.25 * i, 56.25 + 0.25 * i, 16.5, 34)


@scene(JAVA2D, processing_share=0.92, why=OF_JAVA)
def default_renderer_draws_curved_edges(g: PGraphics) -> None:
    g.background(30, 30, 50)
    g.fill(255, 190, 60)
    g.stroke(255)
    g.strokeWeight(4)
    g.ellipse(34, 40, 52, 60)
    g.line(12, 90, 90, 70)
    g.triangle(62, 12, 94, 30, 66, 54)
