"""Shaders of the sketch's own: what they draw, what they are given, and in which space."""

from math import radians

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pmatrix import PMatrix3D
from sketchkit.core.constants import (
    ADD,
    BLEND,
    BOX,
    CLOSE,
    LINES,
    MULTIPLY,
    NORMAL,
    P2D,
    P3D,
    POINTS,
    QUADS,
    TRIANGLES,
)
from tests.scenes.registry import createGraphics, scene


def card(g: PGraphics, x: float, y: float, side: float) -> None:
    """Draw a textured square."""
    g.beginShape(QUADS)
    g.texture(g.loadImage("sign.png"))
    g.textureMode(NORMAL)
    g.vertex(x, y, 0, 0)
    g.vertex(x + side, y, 1, 0)
    g.vertex(x + side, y + side, 1, 1)
    g.vertex(x, y + side, 0, 1)
    g.endShape()


def cube(g: PGraphics, x: float, y: float, side: float) -> None:
    """Draw a box, turned so that three faces show."""
    g.pushMatrix()
    g.translate(x, y)
    g.rotateX(radians(-30))
    g.rotateY(radians(40))
    g.box(side)
    g.popMatrix()


@scene(P2D, runs_glsl=True)
def shader_on_fills_and_strokes_of_p2d(g: PGraphics) -> None:
    g.background(230)
    g.shader(g.loadShader("swapped.frag"))
    g.fill(250, 120, 30)
    g.stroke(30, 60, 200)
    g.strokeWeight(5)
    g.rect(10, 10, 35, 30)
    g.ellipse(72, 26, 40, 34)
    g.line(10, 55, 45, 90)
    g.beginShape()
    g.vertex(60, 55)
    g.vertex(90, 60)
    g.vertex(75, 90)
    g.endShape(CLOSE)
    g.image(g.loadImage("sign.png"), 30, 60, 24, 24)


@scene(P3D, runs_glsl=True)
def shader_with_lights_that_came_after_it(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.shader(g.loadShader("plain.frag", "lit_color.vert"))
    g.directionalLight(90, 110, 130, 0, 0.5, -1)
    g.pointLight(220, 120, 40, 0, 50, 60)
    g.pointLight(30, 160, 60, 100, 20, 40)
    g.fill(230)
    cube(g, 28, 50, 34)
    g.translate(72, 50)
    g.sphere(22)


@scene(P3D, runs_glsl=True)
def shader_with_texture_and_light(g: PGraphics) -> None:
    g.background(60)
    g.noStroke()
    g.shader(g.loadShader("textured.frag", "lit.vert"))
    g.pointLight(255, 240, 200, 20, 20, 60)
    g.translate(50, 50)
    g.rotateY(radians(35))
    card(g, -35, -35, 70)


@scene(P3D, runs_glsl=True)
def shader_sees_shapes_in_their_own_space(g: PGraphics) -> None:
    """At the left drawn directly, in eye space; at the right kept, with a transform of its own."""
    g.background(60)
    g.noStroke()
    g.shader(g.loadShader("plain.frag", "places.vert"))
    cube(g, 27, 50, 30)
    s = g.createShape(BOX, 30)
    s.setStroke(False)
    s.rotateZ(radians(20))
    s.scale(1.1)
    g.translate(74, 50)
    g.rotateX(radians(-30))
    g.rotateY(radians(40))
    g.shape(s)


@scene(P3D, runs_glsl=True)
def shader_of_lines_and_points(g: PGraphics) -> None:
    g.background(230)
    g.shader(g.loadShader("stroke.frag", "stroke.vert"), LINES)
    g.shader(g.loadShader("dot.frag", "dot.vert"), POINTS)
    g.stroke(200, 30, 30)
    g.strokeWeight(4)
    g.fill(250, 220, 120)
    cube(g, 35, 60, 36)
    g.line(10, 10, 0, 90, 20, -30)
    g.strokeWeight(20)
    g.point(75, 50)
    g.point(75, 80, -20)


@scene(P3D, runs_glsl=True)
def shader_reset_leaves_those_of_lines(g: PGraphics) -> None:
    g.background(230)
    g.stroke(200, 30, 30)
    g.strokeWeight(5)
    g.fill(250, 120, 30)
    g.shader(g.loadShader("swapped.frag"))
    g.shader(g.loadShader("stroke.frag", "stroke.vert"), LINES)
    g.rect(10, 10, 35, 35)
    g.resetShader()
    g.rect(55, 10, 35, 35)
    g.resetShader(LINES)
    g.rect(10, 55, 35, 35)


@scene(P2D, runs_glsl=True, is_smooth=False)
def shader_as_filter_three_times(g: PGraphics) -> None:
    g.background(120, 90, 60)
    g.fill(250, 120, 30)
    g.ellipse(40, 40, 50, 40)
    shifted = g.loadShader("shifted.frag")
    g.filter(shifted)
    g.filter(shifted)
    g.fill(30, 120, 250)
    g.rect(60, 60, 25, 25)
    g.filter(shifted)


@scene(P2D, runs_glsl=True)
def shader_counts_pixels_from_the_bottom(g: PGraphics) -> None:
    window = g.loadShader("window.frag")
    pg = createGraphics(g, 40, 50, P2D)
    pg.beginDraw()
    pg.background(250, 220, 120)
    pg.shader(window)
    pg.ellipse(20, 25, 36, 46)
    pg.endDraw()
    g.background(230)
    g.shader(window)
    g.rect(5, 5, 45, 90)
    g.resetShader()
    g.image(pg, 55, 5)


@scene(P2D, runs_glsl=True, is_smooth=False)
def shader_with_numbers_of_every_type(g: PGraphics) -> None:
    numbers = g.loadShader("numbers.frag")
    numbers.set("one", 0.7)
    numbers.set("whole", 6)
    numbers.set("choice", True)
    numbers.set("two", 0.3, 0.8)
    numbers.set("three", 0.3, 0.8, 0.5)
    numbers.set("four", 0.9, 0.6, 0.2, 0.7)
    numbers.set("list", [0.1, 0.5, 0.9])
    numbers.set("pairs", [0.1, 0.2, 0.3, 0.9], 2)
    matrix = PMatrix3D(0.5, 0.2, 0.3, 0.1, 0.1, 0.6, 0.2, 0.3, 0.4, 0.1, 0.8, 0.2, 0, 0, 0, 1)
    numbers.set("move", matrix)
    numbers.set("turn", matrix, True)
    numbers.set("lamp.place", 0.2, 0.5, 0.9)
    numbers.set("lamp.power", 0.9)
    g.shader(numbers)
    g.noStroke()
    g.rect(0, 0, 100, 100)


@scene(P2D, runs_glsl=True)
def shader_with_an_attribute(g: PGraphics) -> None:
    g.background(230)
    g.noStroke()
    g.shader(g.loadShader("plain.frag", "heat.vert"))
    g.beginShape()
    for i, (x, y) in enumerate([(50, 5), (95, 40), (75, 60), (25, 60), (5, 40)]):
        g.attrib("heat", i / 4)
        g.vertex(x, y)
    g.endShape(CLOSE)
    s = g.createShape()
    s.beginShape(TRIANGLES)
    s.noStroke()
    s.attrib("heat", 1.0)
    s.vertex(0, 0)
    s.attrib("heat", 0.0)
    s.vertex(60, 5)
    s.vertex(30, 30)
    s.endShape()
    g.shape(s, 20, 65)


@scene(P3D, runs_glsl=True)
def shader_with_a_second_place_at_each_vertex(g: PGraphics) -> None:
    g.background(230)
    g.noStroke()
    g.shader(g.loadShader("plain.frag", "tip.vert"))
    g.translate(20, 10)
    g.rotate(radians(15))
    g.beginShape(TRIANGLES)
    for x, y in [(0, 0), (60, 10), (20, 70)]:
        g.attribPosition("tip", y, x, 5)
        g.vertex(x, y)
    g.endShape()


@scene(P2D, runs_glsl=True)
def shader_reads_uvs_without_a_texture(g: PGraphics) -> None:
    g.background(230)
    g.noStroke()
    g.textureMode(NORMAL)
    g.shader(g.loadShader("plain.frag", "uv.vert"))
    g.beginShape(QUADS)
    g.vertex(5, 5, 0, 0)
    g.vertex(45, 5, 1, 0)
    g.vertex(45, 45, 1, 1)
    g.vertex(5, 45, 0, 1)
    g.endShape()
    g.beginShape()
    g.vertex(55, 5, 0, 0)
    g.vertex(95, 10, 0.9, 0)
    g.vertex(80, 45, 0.9, 0.9)
    g.endShape(CLOSE)
    g.rect(5, 55, 40, 40)
    card(g, 55, 55, 40)


@scene(P2D, runs_glsl=True)
def shader_sees_images_upside_down_and_canvases_not(g: PGraphics) -> None:
    pg = createGraphics(g, 40, 40, P2D)
    pg.beginDraw()
    pg.background(250, 220, 120)
    pg.fill(200, 30, 30)
    pg.rect(5, 5, 20, 10)
    pg.endDraw()
    both = g.loadShader("two_pictures.frag")
    both.set("upper", g.loadImage("sign.png"))
    both.set("lower", pg)
    both.set("size", 100.0, 100.0)
    g.background(230)
    g.shader(both)
    g.rect(0, 50, 100, 50)


@scene(P3D, runs_glsl=True)
def shader_with_blend_modes(g: PGraphics) -> None:
    g.background(120, 90, 60)
    g.noStroke()
    tone = g.loadShader("tone.frag")
    tone.set("tone", 0.3, 0.7, 0.9)
    g.shader(tone)
    g.rect(5, 5, 40, 40)
    g.blendMode(ADD)
    g.rect(55, 5, 40, 40)
    g.blendMode(MULTIPLY)
    g.rect(5, 55, 40, 40)
    g.blendMode(BLEND)
    g.resetShader()
    g.fill(250, 120, 30, 128)
    g.rect(55, 55, 40, 40)


@scene(P2D, runs_glsl=True)
def shader_reads_what_a_canvas_was_before(g: PGraphics) -> None:
    before = g.loadShader("before.frag")
    pg = createGraphics(g, 80, 80, P2D)
    for _ in range(2):
        pg.beginDraw()
        pg.background(30, 60, 90)
        pg.fill(230)
        pg.ellipse(30, 30, 40, 40)
        pg.shader(before)
        pg.rect(20, 20, 50, 50)
        pg.resetShader()
        pg.endDraw()
    g.background(230)
    g.image(pg, 10, 10)
