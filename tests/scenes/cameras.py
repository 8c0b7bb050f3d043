"""Cameras and projections: where a simple scene comes to lie on the picture."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P3D
from tests.scenes.registry import scene


def _three_boxes(g: PGraphics) -> None:
    """Draw a box at the origin, one along x and one along y, each in its colour."""
    g.strokeWeight(2)
    for x, y, red in ((0, 0, 250), (34, 0, 150), (0, 34, 50)):
        with g.pushMatrix():
            g.translate(x, y)
            g.fill(red, 130, 255 - red)
            g.box(22)


@scene(P3D)
def camera_from_above(g: PGraphics) -> None:
    g.background(240)
    g.camera(70, -60, 90, 10, 8, 0, 0, 1, 0)
    _three_boxes(g)


@scene(P3D)
def camera_held_aslant(g: PGraphics) -> None:
    g.background(240)
    g.camera(-30, -20, 110, 12, 12, 0, 0.5, 1, 0.2)
    _three_boxes(g)


@scene(P3D)
def camera_moved_by_transforms(g: PGraphics) -> None:
    g.background(240)
    g.beginCamera()
    g.camera()
    g.rotateX(radians(-12))
    g.translate(6, -14, -20)
    g.endCamera()
    g.translate(40, 40)
    _three_boxes(g)


@scene(P3D)
def perspective_of_a_wide_lens(g: PGraphics) -> None:
    g.background(220, 230, 240)
    g.perspective(radians(100), 0.8, 5, 400)
    g.translate(30, 30, 20)
    g.rotateY(radians(-20))
    _three_boxes(g)


@scene(P3D)
def parallel_projection(g: PGraphics) -> None:
    g.background(220, 230, 240)
    g.ortho(-40, 60, -55, 45)
    g.translate(36, 42)
    g.rotateX(radians(-35))
    g.rotateY(radians(45))
    _three_boxes(g)


@scene(P3D)
def frustum_aside(g: PGraphics) -> None:
    g.background(220, 230, 240)
    g.frustum(-6, 14, -12, 8, 16, 900)
    g.translate(56, 42)
    g.rotateX(radians(20))
    _three_boxes(g)


@scene(P3D)
def cut_by_the_near_plane(g: PGraphics) -> None:
    g.background(250, 240, 250)
    g.perspective(radians(60), 1, 60, 400)
    g.translate(50, 50, 10)
    g.rotateY(radians(35))
    g.fill(90, 190, 120)
    g.box(60, 40, 60)
