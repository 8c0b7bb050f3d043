"""Blend modes: four strips of colour, opaque and not, over four others."""

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import (
    ADD,
    BLEND,
    DARKEST,
    EXCLUSION,
    LIGHTEST,
    MULTIPLY,
    REPLACE,
    SCREEN,
    SUBTRACT,
)
from tests.scenes.registry import scene


def _crossing_strips(g: PGraphics, mode: int) -> None:
    g.background(150, 140, 130)
    g.noStroke()
    for i in range(4):
        g.fill(80 * i, 240 - 60 * i, 40 + 30 * i)
        g.rect(6 + 24 * i, 4, 18, 92)
    g.blendMode(mode)
    for i, alpha in enumerate((255, 190, 128, 60)):
        g.fill(210, 110, 50 + 50 * i, alpha)
        g.rect(2, 8 + 23 * i, 96, 15)


@scene()
def blend_mode_blend(g: PGraphics) -> None:
    _crossing_strips(g, BLEND)


@scene()
def blend_mode_add(g: PGraphics) -> None:
    _crossing_strips(g, ADD)


@scene()
def blend_mode_subtract(g: PGraphics) -> None:
    _crossing_strips(g, SUBTRACT)


@scene()
def blend_mode_lightest(g: PGraphics) -> None:
    _crossing_strips(g, LIGHTEST)


@scene()
def blend_mode_darkest(g: PGraphics) -> None:
    _crossing_strips(g, DARKEST)


@scene()
def blend_mode_exclusion(g: PGraphics) -> None:
    _crossing_strips(g, EXCLUSION)


@scene()
def blend_mode_multiply(g: PGraphics) -> None:
    _crossing_strips(g, MULTIPLY)


@scene()
def blend_mode_screen(g: PGraphics) -> None:
    _crossing_strips(g, SCREEN)


@scene()
def blend_mode_replace(g: PGraphics) -> None:
    _crossing_strips(g, REPLACE)


@scene()
def strokes_that_add_up(g: PGraphics) -> None:
    g.background(20, 0, 40)
    g.blendMode(ADD)
    g.noFill()
    g.strokeWeight(14)
    g.stroke(90, 60, 20)
    g.rect(20, 20, 56, 50)
    g.line(10, 90, 90, 10)
    g.blendMode(BLEND)
    g.strokeWeight(3)
    g.line(8, 50, 92, 60)
