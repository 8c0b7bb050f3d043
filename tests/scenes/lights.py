"""Lights and materials: one kind of light, or one property of a surface, at a time."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P3D, QUADS, TRIANGLES
from tests.scenes.registry import scene


@scene(P3D)
def directional_light_from_the_left(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.directionalLight(255, 200, 120, 1, 0.4, -0.3)
    g.translate(50, 50)
    g.fill(255)
    g.sphere(40)


@scene(P3D)
def point_light_grows_weaker(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.lightFalloff(0.6, 0.01, 0.0004)
    g.pointLight(255, 240, 200, 20, 50, 24)
    g.fill(200, 255, 220)
    g.beginShape(QUADS)
    for j in range(10):
        for i in range(10):
            g.normal(0, 0, 1)
            for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                g.vertex(10 * x, 10 * y)
    g.endShape()


@scene(P3D)
def spot_light_in_its_cone(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.ambientLight(30, 30, 60)
    g.spotLight(255, 255, 180, 44, 50, 70, 0.1, -0.05, -1, radians(36), 6)
    g.fill(255)
    g.beginShape(QUADS)
    for j in range(20):
        for i in range(20):
            g.normal(0, 0, 1)
            for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                g.vertex(5 * x, 5 * y)
    g.endShape()


@scene(P3D)
def highlights_of_each_shininess(g: PGraphics) -> None:
    g.background(20)
    g.noStroke()
    g.lightSpecular(255, 255, 255)
    g.directionalLight(120, 120, 120, 0.5, 0.6, -1)
    g.fill(40, 80, 190)
    g.specular(230, 230, 200)
    for i, shine in enumerate((1, 5, 20, 80)):
        with g.pushMatrix():
            g.translate(27 + 46 * (i % 2), 27 + 46 * (i // 2))
            g.shininess(shine)
            g.sphere(21)


@scene(P3D)
def ambient_emissive_and_fill(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.ambientLight(150, 90, 90)
    g.directionalLight(90, 150, 90, 0, 0.5, -1)
    g.fill(200, 200, 40)
    g.rect(4, 4, 44, 44)
    g.ambient(20, 60, 250)
    g.rect(52, 4, 44, 44)
    g.emissive(70, 0, 90)
    g.rect(4, 52, 44, 44)
    g.fill(0, 120)
    g.rect(52, 52, 44, 44)


@scene(P3D)
def light_placed_by_the_matrix(g: PGraphics) -> None:
    g.background(15, 15, 15)
    g.noStroke()
    with g.pushMatrix():
        g.translate(80, 10, 30)
        g.rotateZ(radians(50))
        g.pointLight(255, 90, 60, 10, 20, 0)
        g.directionalLight(60, 120, 255, 1, 0, 0)
    g.translate(50, 54)
    g.rotateY(radians(35))
    g.fill(255)
    g.box(46)


@scene(P3D)
def normals_of_each_vertex(g: PGraphics) -> None:
    g.background(60, 60, 60)
    g.noStroke()
    g.directionalLight(255, 255, 255, 0, 0, -1)
    g.fill(255, 180, 60)
    g.beginShape(TRIANGLES)
    g.normal(0, 0, 1)
    g.vertex(8, 90)
    g.normal(0.8, 0, 0.6)
    g.vertex(48, 12)
    g.normal(0, 1, 0)
    g.vertex(92, 88)
    g.endShape()


@scene(P3D)
def either_side_of_a_face_is_lit(g: PGraphics) -> None:
    g.background(40, 20, 20)
    g.noStroke()
    g.directionalLight(240, 240, 240, 0.3, 0.2, -1)
    for left, corners in (
        (6, ((0, 0), (38, 0), (38, 80), (0, 80))),
        (54, ((0, 0), (0, 80), (38, 80), (38, 0))),
    ):
        g.fill(120, 220, 255)
        g.beginShape(QUADS)
        for x, y in corners:
            g.vertex(left + x, 10 + y, -0.4 * x)
        g.endShape()


@scene(P3D)
def no_lights_from_here_on(g: PGraphics) -> None:
    g.background(230)
    g.lights()
    g.translate(28, 50)
    g.rotateY(radians(40))
    g.fill(255, 120, 120)
    g.box(28)
    g.noLights()
    g.translate(30, 0, 32)
    g.box(28)
