"""Text in the default face."""

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    BASELINE,
    BOTTOM,
    CENTER,
    JAVA2D,
    LEFT,
    P3D,
    RIGHT,
    SHAPE,
    TOP,
)
from tests.scenes.registry import scene


@scene()
def text_in_several_sizes(g: PGraphics) -> None:
    g.background(255)
    g.fill(160, 0, 60)
    g.text("twelve", 5, 15)
    g.textSize(20)
    g.fill(0, 90, 60)
    g.text("Twenty", 5, 40)
    g.textSize(38)
    g.fill(20, 40, 140)
    g.text("gRey", 4, 82)


@scene()
def text_aligned_at_its_point(g: PGraphics) -> None:
    g.background(30)
    g.stroke(200, 60, 60)
    g.line(50, 0, 50, 100)
    for i, (across, down) in enumerate(
        ((LEFT, TOP), (CENTER, CENTER), (RIGHT, BASELINE), (CENTER, BOTTOM))
    ):
        g.line(0, 14 + 24 * i, 100, 14 + 24 * i)
        g.textAlign(across, down)
        g.text("Hop", 50, 14 + 24 * i)


@scene()
def text_whose_capitals_are_ten_pixels_high(g: PGraphics) -> None:
    g.background(255)
    g.fill(0)
    g.textSize(16)
    g.text("AHEFTZ 08", 4.3, 20)
    g.text("Hxdgp %&@", 4, 45.5)
    g.fill(200, 0, 0, 120)
    g.text("QWJK 35", 4, 75)


@scene()
def text_wrapped_in_boxes(g: PGraphics) -> None:
    g.background(255)
    for x, y, across, down in ((3, 3, LEFT, TOP), (53, 3, RIGHT, CENTER), (3, 53, CENTER, BOTTOM)):
        g.fill(230, 220, 120)
        g.rect(x, y, 44, 44)
        g.fill(0)
        g.textSize(10)
        g.textAlign(across, down)
        g.text("one two\nthreefourfive six seven eight", x, y, 44, 44)
    g.textLeading(8)
    g.textAlign(LEFT)
    g.text("negative, of narrow lines", 98, 98, -44, -44)


@scene()
def text_of_many_scripts(g: PGraphics) -> None:
    g.background(255)
    g.fill(0, 60, 120)
    g.textSize(14)
    g.text("\u00e9\u00e0\u00fc\u00df \u0391\u03b2\u03b3 \u0416\u044f", 4, 18)
    g.text("a\u0301b e\u0308 \u20ac\u2026", 4, 38)
    g.text("[\u4e2d] [\u05e9] [\U0001f600]", 4, 58)
    g.text("a\tb\rc\u00a0d", 4, 78)
    g.text(3.14159, 4, 96)


@scene(JAVA2D)
def text_of_many_scripts_in_java2d(g: PGraphics) -> None:
    g.background(255)
    g.fill(0, 60, 120)
    g.textSize(14)
    g.text("\u00e9\u00e0\u00fc\u00df \u0391\u03b2\u03b3 \u0416\u044f", 4, 18)
    g.text("a\u0301b e\u0308 \u20ac\u2026", 4, 38)
    g.text("[\u4e2d] [\u05e9]", 4, 58)
    g.text("a\tb\rc\u00a0d", 4, 78)


@scene(JAVA2D)
def text_at_every_size_in_java2d(g: PGraphics) -> None:
    g.background(255)
    g.fill(0)
    g.text("Twelve to To", 4, 15)
    g.textSize(21)
    g.text("Type later", 3.4, 36.6)
    g.fill(160, 0, 60)
    g.scale(4)
    g.textSize(9)
    g.textAlign(CENTER)
    g.text("large", 12.5, 18)


ANEW = "letters that a transform enlarges are made anew, where Processing's are blurred"


@scene(processing_share=0.86, why=ANEW)
def text_enlarged_by_a_transform(g: PGraphics) -> None:
    g.background(255)
    g.fill(0)
    g.text("as it is", 4, 14)
    g.scale(2)
    g.text("twice", 2, 21)
    g.rotate(0.3)
    g.text("turn", 12, 34)


@scene(P3D)
def text_turned_in_space(g: PGraphics) -> None:
    g.background(255)
    g.fill(0, 90, 60)
    g.textSize(18)
    g.text("near", 10, 20, 20)
    g.text("deep", 10, 40, -60)
    g.translate(50, 70)
    g.rotateY(0.7)
    g.textAlign(CENTER)
    g.text("turned", 0, 0)


@scene()
def text_as_shapes(g: PGraphics) -> None:
    g.background(255)
    g.textMode(SHAPE)
    g.fill(140, 20, 120)
    g.textSize(36)
    g.text("Rag&8", 2, 36)
    g.fill(0)
    g.textSize(10)
    g.translate(4, 60)
    g.rotate(0.2)
    g.scale(3)
    g.text("oval", 0, 0)
