"""Colours: how numbers become colours, and what a style keeps of them."""

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import HSB, RGB
from tests.scenes.registry import scene


@scene()
def hue_saturation_brightness(g: PGraphics) -> None:
    g.background(0)
    g.noStroke()
    g.colorMode(HSB, 12, 5, 4)
    for i in range(12):
        for j in range(5):
            g.fill(i, j + 1, 4)
            g.rect(2 + 8 * i, 2 + 9 * j, 8, 9)
            g.fill(i, 4, j)
            g.rect(2 + 8 * i, 50 + 9 * j, 8, 9)


@scene()
def components_are_cut_off_not_rounded(g: PGraphics) -> None:
    g.background(255)
    g.noStroke()
    for i, value in enumerate((127.4, 127.5, 127.9, 128.0, 300.0, -20.0)):
        g.fill(value, 255 - value, value / 2)
        g.rect(2 + 16 * i, 4, 16, 44)
    g.colorMode(RGB, 1)
    for i in range(6):
        g.fill(i / 5, 0.5, 1 - i / 7, 0.75)
        g.rect(2 + 16 * i, 52, 16, 44)


@scene()
def translucent_colors_over_each_other(g: PGraphics) -> None:
    g.background(255, 255, 240)
    g.noStroke()
    g.fill(255, 0, 0, 127)
    g.rect(8, 8, 60, 50)
    g.fill(0, 200, 0, 128)
    g.rect(30, 28, 60, 50)
    g.fill(0, 0, 255, 25)
    for i in range(5):
        g.rect(14 + 4 * i, 44 + 4 * i, 50, 30)


@scene()
def halfway_between_two_colors(g: PGraphics) -> None:
    g.background(128)
    g.noStroke()
    start, stop = g.color(250, 90, 0), g.color(0, 120, 240, 100)
    for i in range(8):
        g.fill(g.lerpColor(start, stop, i / 7))
        g.rect(2 + 12 * i, 6, 12, 40)
    g.colorMode(HSB, 255)
    for i in range(8):
        g.fill(g.lerpColor(start, stop, i / 7))
        g.rect(2 + 12 * i, 54, 12, 40)


@scene()
def colors_as_packed_numbers(g: PGraphics) -> None:
    g.background(0xFFF4E8D0)
    g.fill(0xFF208060)
    g.stroke(0x80C00060)
    g.strokeWeight(8)
    g.rect(14, 14, 32, 72)
    g.fill(g.color(200, 40), 180)
    g.rect(58, 14, 32, 72)


@scene()
def style_comes_back_from_the_stack(g: PGraphics) -> None:
    g.background(235)
    g.fill(255, 170, 0)
    g.stroke(0, 80, 0)
    g.strokeWeight(5)
    g.rect(8, 8, 34, 34)
    with g.pushStyle():
        g.fill(0, 160, 200)
        g.noStroke()
        g.rect(56, 8, 34, 34)
        with g.push():
            g.translate(0, 50)
            g.stroke(200, 0, 0)
            g.strokeWeight(1)
            g.rect(8, 8, 34, 34)
    g.rect(56, 58, 34, 34)
