"""Retained shapes: of each kind, in groups, moved and changed after they were first drawn."""

from math import cos, radians, sin

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.api.pshape.shape import PShape
from sketchkit.core.constants import (
    ADD,
    ARC,
    BEVEL,
    BOX,
    CENTER,
    CLOSE,
    CORNER,
    CORNERS,
    ELLIPSE,
    GROUP,
    LINE,
    LINES,
    MITER,
    MULTIPLY,
    NORMAL,
    P3D,
    PIE,
    POINT,
    POINTS,
    QUAD,
    QUAD_STRIP,
    QUADS,
    RADIUS,
    RECT,
    RGB,
    ROUND,
    SPHERE,
    TRIANGLE,
    TRIANGLE_FAN,
    TRIANGLE_STRIP,
    TRIANGLES,
)
from tests.scenes.registry import scene


def _chequers(g: PGraphics, size: int) -> PImage:
    """Return an image of four by four squares, the first of them red."""
    picture = g.createImage(size, size, RGB)
    for y in range(size):
        for x in range(size):
            light = (x * 4 // size + y * 4 // size) % 2 == 0
            paint = g.color(250, 240, 200) if light else g.color(40, 110, 160)
            if x < size // 4 and y < size // 4:
                paint = g.color(220, 0, 0)
            picture.set(x, y, paint)
    return picture


def _zigzag(g: PGraphics, kind: int) -> PShape:
    """Return eight corners in two rows, of different colours."""
    s = g.createShape()
    s.beginShape(kind)
    s.strokeWeight(2)
    for i in range(8):
        s.fill(30 * i, 220 - 25 * i, 100)
        s.stroke(20 * i, 0, 90)
        s.vertex(i // 2 * 8, i % 2 * 20 + i % 3)
    s.endShape()
    return s


@scene()
def shapes_of_one_call(g: PGraphics) -> None:
    g.background(235)
    g.fill(255, 190, 40)
    g.stroke(60, 20, 100)
    g.strokeWeight(3)
    shapes = [
        g.createShape(RECT, 0, 0, 20, 14),
        g.createShape(RECT, 0, 0, 20, 14, 5),
        g.createShape(RECT, 0, 0, 20, 14, 0, 3, 6, 9),
        g.createShape(ELLIPSE, 10, 7, 20, 14),
        g.createShape(ARC, 10, 7, 20, 14, 0.5, 4),
        g.createShape(ARC, 10, 7, 20, 14, 0.5, 4, PIE),
        g.createShape(TRIANGLE, 0, 14, 10, 0, 20, 14),
        g.createShape(QUAD, 2, 0, 20, 2, 16, 14, 0, 12),
        g.createShape(LINE, 0, 0, 20, 14),
        g.createShape(POINT, 10, 7),
    ]
    for i in range(10):
        g.shape(shapes[i], 6 + i % 3 * 32, 4 + i // 3 * 25)


@scene()
def shapes_keep_the_modes_of_their_making(g: PGraphics) -> None:
    g.background(235)
    for i, mode in enumerate((CORNER, CORNERS, CENTER, RADIUS)):
        g.rectMode(mode)
        g.ellipseMode(mode)
        box, disc = g.createShape(RECT, 5, 4, 16, 12), g.createShape(ELLIPSE, 5, 4, 16, 12)
        g.rectMode(CORNER)
        g.ellipseMode(CORNER)
        g.shape(box, 20, 14 + i * 24)
        g.shape(disc, 70, 14 + i * 24)


@scene()
def shapes_of_each_kind_of_corners(g: PGraphics) -> None:
    g.background(235)
    kinds = (POINTS, LINES, TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN, QUADS, QUAD_STRIP)
    for i, kind in enumerate(kinds):
        g.shape(_zigzag(g, kind), 6 + i % 3 * 32, 6 + i // 3 * 32)


@scene()
def shapes_with_curves_and_a_hole(g: PGraphics) -> None:
    g.background(235)
    s = g.createShape()
    s.beginShape()
    s.fill(0, 150, 200)
    s.strokeWeight(2)
    s.vertex(8, 8)
    s.bezierVertex(50, -10, 50, 60, 90, 20)
    s.quadraticVertex(60, 60, 90, 60)
    s.vertex(10, 52)
    s.beginContour()
    s.vertex(20, 20)
    s.vertex(20, 44)
    s.vertex(40, 40)
    s.endContour()
    s.endShape(CLOSE)
    g.shape(s)
    line = g.createShape()
    line.beginShape()
    line.noFill()
    line.stroke(200, 0, 60)
    line.strokeWeight(3)
    for i in range(8):
        line.curveVertex(i * 14, 70 + i % 2 * 20)
    line.endShape()
    g.shape(line)


@scene()
def shapes_with_each_join(g: PGraphics) -> None:
    g.background(235)
    for i, join in enumerate((MITER, BEVEL, ROUND)):
        s = g.createShape()
        s.beginShape()
        s.noFill()
        s.strokeJoin(join)
        s.strokeWeight(8)
        for x, y in ((8, 8), (34, 12), (10, 30), (38, 32)):
            s.vertex(x, y)
        s.endShape()
        g.shape(s, i % 2 * 50, i // 2 * 50)


@scene()
def shapes_with_textures(g: PGraphics) -> None:
    g.background(60)
    picture = _chequers(g, 16)
    g.textureMode(NORMAL)
    box = g.createShape(RECT, 4, 4, 40, 26)
    box.setTexture(picture)
    g.shape(box)
    s = g.createShape()
    s.beginShape(QUADS)
    s.texture(picture)
    s.strokeWeight(2)
    s.vertex(54, 6, 0, 0)
    s.tint(255, 120, 0)
    s.vertex(96, 10, 1, 0)
    s.vertex(90, 42, 1, 1)
    s.tint(0, 200, 255, 120)
    s.vertex(56, 36, 0, 1)
    s.endShape()
    g.shape(s)
    fan = g.createShape()
    fan.beginShape(TRIANGLE_FAN)
    fan.texture(picture)
    fan.noStroke()
    fan.vertex(26, 70, 0.5, 0.5)
    for i in range(8):
        u, v = cos(i), sin(i)
        fan.vertex(26 + 22 * u, 70 + 22 * v, 0.5 + 0.5 * u, 0.5 + 0.5 * v)
    fan.endShape()
    fan.setTint(g.color(255, 255, 0))
    g.shape(fan)
    g.shape(fan, 50, 0)


@scene()
def shape_modes_with_and_without_a_size(g: PGraphics) -> None:
    g.background(235)
    s = g.createShape(RECT, 4, 2, 20, 12)
    for i, mode in enumerate((CORNER, CENTER, CORNERS)):
        g.shapeMode(mode)
        g.shape(s, 16, 16 + 30 * i)
        right, bottom = (82, 26 + 30 * i) if mode == CORNERS else (32, 10)
        g.shape(s, 50, 16 + 30 * i, right, bottom)


@scene()
def shape_groups_in_groups(g: PGraphics) -> None:
    g.background(235)
    g.noStroke()
    arm, whole = g.createShape(GROUP), g.createShape(GROUP)
    for i in range(4):
        g.fill(60 * i, 200 - 40 * i, 100)
        part = g.createShape(RECT, 0, 0, 14, 9)
        part.translate(i * 10, i * 6)
        part.rotate(0.1 * i)
        arm.addChild(part)
    arm.scale(0.9)
    arm.translate(10, 14)
    whole.addChild(arm)
    g.fill(200, 60, 60)
    whole.addChild(g.createShape(ELLIPSE, 20, 12, 24, 14), 0)
    whole.rotate(0.25)
    g.shape(whole, 10, 0)
    g.shape(whole, 40, 46, 50, 50)


@scene()
def shapes_moved_after_they_were_drawn(g: PGraphics) -> None:
    g.background(235)
    group = g.createShape(GROUP)
    for i in range(2):
        child = g.createShape(RECT, 0, 0, 16, 10)
        child.setFill(g.color(255 * i, 120, 90))
        child.translate(0, 14 * i)
        group.addChild(child)
    group.rotate(0.3)
    group.translate(20, 6)
    g.shape(group)
    group.getChild(1).rotate(0.5)  # now after the steps of the group
    g.shape(group, 40, 0)
    group.translate(0, 44)
    group.scale(1.3)
    g.shape(group)
    g.shape(group.getChild(1), 34, 0)


@scene()
def shapes_in_the_sketchs_style(g: PGraphics) -> None:
    g.background(235)
    group = g.createShape(GROUP)
    for i in range(2):
        child = g.createShape(RECT, i * 22, 0, 18, 26)
        child.setFill(g.color(200 * i, 50, 0))
        group.addChild(child)
    group.disableStyle()
    g.fill(0, 90, 220, 150)
    g.stroke(255, 0, 0)
    g.strokeWeight(4)
    g.shape(group, 30, 6)
    disc = g.createShape(ELLIPSE, 20, 20, 30, 24)
    disc.disableStyle()
    g.noFill()
    g.stroke(0, 130, 60)
    g.shape(disc, 4, 52)


@scene()
def shapes_blended_tinted_and_clipped(g: PGraphics) -> None:
    g.background(100, 150, 200)
    g.noStroke()
    g.fill(200, 100, 50, 128)
    s = g.createShape(RECT, 0, 0, 40, 40)
    g.blendMode(ADD)
    g.shape(s, 6, 6)
    g.blendMode(MULTIPLY)
    g.shape(s, 54, 6)
    g.clip(20, 60, 60, 20)
    g.shape(s, 6, 54)
    g.shape(s, 54, 54)


@scene()
def shapes_of_triangles_drawn_with(g: PGraphics) -> None:
    g.background(235)
    g.strokeWeight(3)
    g.fill(200, 100, 0)
    disc = g.createShape(ELLIPSE, 24, 20, 36, 26)
    g.shape(disc)
    g.shape(disc.getTessellation(), 50, 0)
    g.noStroke()
    group = g.createShape(GROUP)
    part = g.createShape(RECT, 0, 0, 22, 14)
    part.rotate(0.4)
    group.addChild(part)
    group.addChild(g.createShape(TRIANGLE, 4, 32, 20, 18, 34, 32))
    g.shape(group, 12, 54)
    g.shape(group.getTessellation(), 62, 54)


@scene(P3D)
def shapes_of_solids_in_light(g: PGraphics) -> None:
    g.background(235)
    g.lights()
    g.fill(210, 120, 60)
    g.sphereDetail(8)
    g.strokeWeight(2)
    for i, s in enumerate((g.createShape(BOX, 26), g.createShape(BOX, 14, 24, 34))):
        g.pushMatrix()
        g.translate(28 + 46 * i, 28)
        g.rotateX(radians(-28))
        g.rotateY(radians(35))
        g.shape(s)
        g.popMatrix()
    g.shape(g.createShape(SPHERE, 17), 28, 74)
    ball = g.createShape(SPHERE, 17)
    ball.setStroke(False)
    ball.setFill(g.color(60, 140, 220))
    ball.rotateX(0.6)
    g.shape(ball, 74, 74)


@scene(P3D)
def shapes_with_materials_and_normals(g: PGraphics) -> None:
    g.background(20)
    g.noStroke()
    g.ambientLight(70, 70, 70)
    g.lightSpecular(220, 220, 220)
    g.directionalLight(140, 140, 140, 0.3, 0.4, -1)
    g.fill(150, 100, 50)
    ball = g.createShape(SPHERE, 20)
    ball.setSpecular(g.color(255, 255, 255))
    ball.setShininess(12)
    g.shape(ball, 28, 28)
    ball.setAmbient(g.color(255, 0, 0))
    ball.setEmissive(g.color(0, 0, 80))
    g.shape(ball, 74, 28)
    s = g.createShape()
    s.beginShape(QUADS)
    s.fill(180)
    s.specular(255, 255, 0)
    s.shininess(6)
    for x, y in ((-36, -16), (36, -16), (36, 16), (-36, 16)):
        s.normal(x / 50, y / 30, 1)
        s.vertex(x, y)
    s.endShape()
    g.shape(s, 50, 76)


@scene(P3D)
def shapes_of_points_and_lines_under_scale(g: PGraphics) -> None:
    g.background(235)
    for i, kind in enumerate((POINTS, LINES)):
        for j in range(3):
            s = g.createShape()
            s.beginShape(kind)
            s.strokeWeight(4)
            s.stroke(200 * i, 0, 160)
            for k in range(4):
                s.vertex(k * 7, k % 2 * 9, k * 4)
            s.endShape()
            if j == 1:
                s.scale(1.5)  # before it is drawn, it counts twice for the weight
            g.shape(s, 6, 6 + 30 * j + 15 * i)
            if j == 2:
                s.scale(1.5)
            g.shape(s, 54, 6 + 30 * j + 15 * i)


@scene(P3D)
def shapes_with_corners_moved_later(g: PGraphics) -> None:
    g.background(235)
    for i, kind in enumerate((TRIANGLES, QUADS)):
        s = g.createShape()
        s.beginShape(kind)
        s.fill(210, 120, 60)
        s.strokeWeight(2)
        for x, y in ((4, 4), (34, 8), (30, 36), (8, 30)):
            s.vertex(x, y)
        s.endShape()
        s.setVertex(0, 10, 10)
        g.shape(s, 0, 50 * i)
        s.setVertex(2, 42, 44, 5)  # the outline stays
        g.shape(s, 50, 50 * i)


@scene(P3D)
def shape_groups_with_textures(g: PGraphics) -> None:
    g.background(235)
    g.noStroke()
    g.lights()
    picture = _chequers(g, 16)
    group = g.createShape(GROUP)
    for i in range(2):
        s = g.createShape(BOX, 26)
        s.translate(34 * i, 0)
        s.setTexture(picture)
        group.addChild(s)
    g.fill(60, 160, 90)
    ball = g.createShape(SPHERE, 12)
    ball.translate(17, -24)
    group.addChild(ball)
    g.translate(32, 50)
    g.rotateX(0.5)
    g.rotateY(-0.5)
    g.shape(group)
