"""Textures: coordinates in pixels or from 0 to 1, beyond the edges, in perspective, in light."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.core.constants import CLAMP, IMAGE, NORMAL, P3D, QUADS, REPEAT, RGB, TRIANGLES
from tests.scenes.registry import scene


def _tiles(g: PGraphics, size: int) -> PImage:
    """Return a chequered image whose left and upper edges are marked."""
    tiles = g.createImage(size, size, RGB)
    for y in range(size):
        for x in range(size):
            light = (x * 4 // size + y * 4 // size) % 2 == 0
            tiles.set(x, y, g.color(250, 240, 200) if light else g.color(40, 110, 160))
    for i in range(size):
        tiles.set(i, 0, g.color(220, 0, 0))
        tiles.set(0, i, g.color(0, 160, 0))
    return tiles


@scene()
def texture_coordinates_in_pixels(g: PGraphics) -> None:
    g.background(80)
    g.noStroke()
    g.textureMode(IMAGE)
    g.beginShape()
    g.texture(_tiles(g, 16))
    g.vertex(10, 16, 0, 0)
    g.vertex(90, 8, 16, 0)
    g.vertex(80, 92, 16, 12)
    g.vertex(24, 80, 4, 16)
    g.endShape()


@scene(P3D)
def texture_in_perspective(g: PGraphics) -> None:
    g.background(200, 220, 255)
    g.noStroke()
    g.textureMode(NORMAL)
    g.translate(50, 56)
    g.rotateX(radians(62))
    g.beginShape(QUADS)
    g.texture(_tiles(g, 32))
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        g.vertex(90 * x - 45, 140 * y - 90, 0, x, y)
    g.endShape()


@scene()
def texture_beyond_its_edges(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.textureMode(NORMAL)
    tiles = _tiles(g, 8)
    for left, wrap in ((4, CLAMP), (52, REPEAT)):
        g.textureWrap(wrap)
        g.beginShape(QUADS)
        g.texture(tiles)
        g.vertex(left, 6, -0.6, -0.8)
        g.vertex(left + 44, 6, 1.9, -0.8)
        g.vertex(left + 44, 94, 1.9, 2.3)
        g.vertex(left, 94, -0.6, 2.3)
        g.endShape()


@scene(P3D)
def texture_tinted_and_lit(g: PGraphics) -> None:
    g.background(30, 20, 40)
    g.noStroke()
    g.lights()
    g.textureMode(NORMAL)
    g.fill(255, 0, 0)  # the ambient colour
    g.tint(255, 220, 120, 200)
    g.translate(50, 50)
    g.rotateY(radians(38))
    g.beginShape(QUADS)
    g.texture(_tiles(g, 32))
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        g.vertex(70 * x - 35, 70 * y - 35, 0, x, y)
    g.endShape()


@scene(P3D)
def texture_and_tint_of_each_corner(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    g.textureMode(NORMAL)
    g.beginShape(TRIANGLES)
    g.texture(_tiles(g, 64))
    for x, y, u, v, red in (
        (8, 88, 0, 1, 255),
        (30, 8, 0.5, 0, 60),
        (52, 80, 1, 1, 255),
        (56, 12, 0, 0, 0),
        (94, 20, 1, 0, 255),
        (84, 92, 1, 1, 120),
    ):
        g.tint(red, 200, 255 - red)
        g.vertex(x, y, 0, u, v)
    g.endShape()
