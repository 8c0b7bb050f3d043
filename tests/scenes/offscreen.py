"""Canvases out of sight: what stays on them, what they show where they are drawn.

They are drawn before the window's `background()`: when its first canvas appears, Processing loses
what was in the window.
"""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    ADD,
    BLEND,
    BOX,
    CENTER,
    NORMAL,
    P2D,
    P3D,
    QUADS,
    RECT,
    SPHERE,
)
from tests.scenes.registry import createGraphics, scene


@scene()
def offscreen_canvases_of_two_kinds(g: PGraphics) -> None:
    flat, deep = createGraphics(g, 44, 80, P2D), createGraphics(g, 44, 80, P3D)
    for pg in (flat, deep):
        pg.beginDraw()
        pg.background(250, 220, 120)
        pg.strokeWeight(3)
        pg.fill(0, 120, 220)
        pg.ellipse(22, 20, 32, 24)
        pg.line(4, 40, 40, 46)
        pg.endDraw()
    deep.beginDraw()
    deep.lights()
    deep.translate(22, 62)
    deep.rotateX(radians(-30))
    deep.rotateY(radians(40))
    deep.box(18)
    deep.endDraw()
    g.background(40)
    g.image(flat, 4, 10)
    g.image(deep, 52, 10)


@scene()
def offscreen_canvas_is_transparent(g: PGraphics) -> None:
    pg = createGraphics(g, 60, 60, P2D)
    pg.beginDraw()
    pg.noStroke()
    pg.fill(0, 200, 100, 120)
    pg.circle(24, 24, 40)
    pg.fill(220, 0, 60)
    pg.circle(40, 40, 30)
    pg.endDraw()
    g.background(70, 60, 130)
    g.image(pg, 4, 4)
    g.image(pg, 40, 40, 58, 30)


@scene()
def offscreen_style_and_picture_stay(g: PGraphics) -> None:
    pg = createGraphics(g, 90, 90, P2D)
    pg.beginDraw()
    pg.background(220)
    pg.fill(255, 80, 0)
    pg.stroke(0, 0, 200)
    pg.strokeWeight(4)
    pg.rectMode(CENTER)
    pg.translate(40, 40)  # lasts until endDraw()
    pg.endDraw()
    for i in range(3):
        pg.beginDraw()
        pg.rotate(0.2 * i)
        pg.rect(24 + 18 * i, 24, 20, 30)
        pg.line(5, 70.5, 80, 82)
        pg.endDraw()
    g.background(40)
    g.image(pg, 5, 5)


@scene(P3D)
def offscreen_camera_stays_and_lights_go(g: PGraphics) -> None:
    pg = createGraphics(g, 90, 90, P3D)
    for i in range(2):
        pg.beginDraw()
        if i == 0:
            pg.background(30, 60, 60)
            pg.lights()
            pg.camera(30, -40, 120, 0, 0, 0, 0, 1, 0)
        pg.translate(36 * i - 18, 0, 0)
        pg.box(26)
        pg.endDraw()
    g.background(220)
    g.image(pg, 5, 5)


@scene()
def offscreen_canvas_changes_between_two_uses(g: PGraphics) -> None:
    pg = createGraphics(g, 40, 40, P2D)
    pg.beginDraw()
    pg.background(0)
    pg.endDraw()
    g.background(70, 60, 130)
    for i in range(3):
        pg.beginDraw()
        pg.noStroke()
        pg.fill(0, 90)
        pg.rect(0, 0, 40, 40)
        pg.fill(255, 120 * i, 0)
        pg.circle(10 + 10 * i, 20, 14)
        pg.endDraw()
        g.image(pg, 5 + 25 * i, 5 + 25 * i)


@scene()
def offscreen_canvas_within_itself(g: PGraphics) -> None:
    pg = createGraphics(g, 90, 90, P2D)
    pg.beginDraw()
    pg.background(20, 40, 90)
    pg.endDraw()
    for i in range(3):
        pg.beginDraw()
        pg.image(pg, 6, 6, 78, 78)
        pg.noStroke()
        pg.fill(255, 80 * i, 0)
        pg.rect(8 + 22 * i, 60, 18, 14)
        pg.endDraw()
    g.background(220)
    g.image(pg, 5, 5)


@scene()
def offscreen_canvas_drawn_like_an_image(g: PGraphics) -> None:
    pg = createGraphics(g, 40, 40, P2D)
    pg.beginDraw()
    pg.background(250, 220, 120)
    pg.triangle(6, 34, 20, 5, 34, 34)
    pg.endDraw()
    g.background(70, 60, 130)
    g.tint(255, 120, 60, 160)
    g.image(pg, 4, 4)
    g.noTint()
    g.blendMode(ADD)
    g.image(pg, 30, 20, 30, 46)
    g.blendMode(BLEND)
    g.clip(60, 4, 36, 20)
    g.image(pg, 58, 4)
    g.noClip()
    g.imageMode(CENTER)
    g.translate(60, 74)
    g.rotate(0.3)
    g.image(pg, 0, 0)


@scene()
def offscreen_canvas_with_hard_edges(g: PGraphics) -> None:
    pg = createGraphics(g, 90, 90, P2D)
    pg.noSmooth()
    pg.beginDraw()
    pg.background(255)
    pg.fill(0, 160, 100)
    pg.strokeWeight(3)
    pg.ellipse(45, 40, 70, 50)
    pg.line(5, 70, 84, 84)
    pg.endDraw()
    g.background(40)
    g.image(pg, 5, 5)


@scene(P3D)
def offscreen_canvas_as_texture(g: PGraphics) -> None:
    pg = createGraphics(g, 32, 32, P2D)
    pg.beginDraw()
    pg.background(250, 220, 120)
    pg.fill(220, 0, 60)
    pg.triangle(2, 30, 12, 2, 30, 30)
    pg.endDraw()
    g.background(40)
    g.noStroke()
    g.textureMode(NORMAL)
    g.beginShape(QUADS)
    g.texture(pg)
    g.vertex(6, 8, 0, 0, 0)
    g.vertex(46, 8, -30, 1, 0)
    g.vertex(46, 46, -30, 1, 1)
    g.vertex(6, 46, 0, 0, 1)
    g.endShape()
    ball = g.createShape(SPHERE, 20)
    ball.setTexture(pg)
    g.shape(ball, 74, 28)
    g.translate(50, 72)
    g.rotateX(-0.5)
    g.rotateY(0.6)
    cube = g.createShape(BOX, 30)
    cube.setTexture(pg)
    g.shape(cube)


@scene(P3D)
def offscreen_canvas_shows_shapes(g: PGraphics) -> None:
    pg = createGraphics(g, 90, 90, P3D)
    cube = g.createShape(BOX, 30)
    cube.setFill(g.color(0, 160, 100))
    plate = g.createShape(RECT, 0, 0, 30, 20)
    pg.beginDraw()
    pg.background(30, 60, 90)
    pg.shape(plate, 6, 6)
    pg.lights()
    pg.translate(50, 52)
    pg.rotateX(-0.5)
    pg.rotateY(0.6)
    pg.shape(cube)
    pg.endDraw()
    g.background(220)
    g.image(pg, 5, 5)
