"""Text in the default face."""

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import BASELINE, BOTTOM, CENTER, LEFT, RIGHT, TOP
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
