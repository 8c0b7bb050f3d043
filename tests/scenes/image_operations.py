"""Pixels: images filtered, blended, copied and masked, and the same with what was drawn."""

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.core.constants import (
    ADD,
    ARGB,
    BLUR,
    BURN,
    DARKEST,
    DIFFERENCE,
    DILATE,
    DODGE,
    ERODE,
    EXCLUSION,
    GRAY,
    HARD_LIGHT,
    INVERT,
    JAVA2D,
    LIGHTEST,
    MULTIPLY,
    OPAQUE,
    OVERLAY,
    P3D,
    POSTERIZE,
    RGB,
    SCREEN,
    SOFT_LIGHT,
    SUBTRACT,
    THRESHOLD,
)
from tests.scenes.registry import scene


def _leaf(g: PGraphics, image_format: int) -> PImage:
    """Return an image with soft and hard edges, in many colours and alphas."""
    leaf = g.createImage(30, 30, image_format)
    for y in range(30):
        for x in range(30):
            alpha = min(255, 40 + 13 * min(x, y, 29 - x, 29 - y) * 2)
            leaf.set(x, y, g.color(8 * x, 220 - 5 * y, 90, alpha))
            if x == 15 or (x + y) % 9 == 0:
                leaf.set(x, y, g.color(250, 240, 60, alpha))
    return leaf


def _light(g: PGraphics) -> PImage:
    """Return an image that goes from dark to light and from red to blue, half transparent."""
    light = g.createImage(30, 30, ARGB)
    for y in range(30):
        for x in range(30):
            light.set(x, y, g.color(255 - 8 * y, 8 * x, 8 * y, 100 + 5 * x))
    return light


@scene(is_smooth=False)
def image_filters(g: PGraphics) -> None:
    g.background(90, 110, 160)
    leaf = _leaf(g, ARGB)
    filters = (
        *((GRAY, None), (INVERT, None), (OPAQUE, None), (THRESHOLD, 0.7), (POSTERIZE, 3)),
        *((ERODE, None), (DILATE, None), (BLUR, 1.5), (BLUR, 40)),
    )
    for i in range(len(filters)):
        kind, number = filters[i]
        changed = leaf.copy()
        if number is None:
            changed.filter(kind)
        else:
            changed.filter(kind, number)
        g.image(changed, 2 + 33 * (i % 3), 2 + 33 * (i // 3))


@scene(is_smooth=False)
def image_blends(g: PGraphics) -> None:
    g.background(90, 110, 160)
    leaf = _leaf(g, RGB)
    light = _light(g)
    modes = (
        *(ADD, SUBTRACT, LIGHTEST, DARKEST, DIFFERENCE, EXCLUSION, MULTIPLY, SCREEN, OVERLAY),
        *(HARD_LIGHT, SOFT_LIGHT, DODGE, BURN),
    )
    for i in range(len(modes)):
        changed = leaf.copy()
        changed.blend(light, 0, 0, 30, 30, 0, 0, 30, 30, modes[i])
        g.image(changed, 1 + 25 * (i % 4), 1 + 25 * (i // 4), 23, 23)


@scene(is_smooth=False)
def image_copies_in_other_sizes(g: PGraphics) -> None:
    g.background(90, 110, 160)
    leaf = _leaf(g, ARGB)
    sheet = g.createImage(96, 96, ARGB)
    sheet.copy(leaf, 0, 0, 30, 30, 2, 2, 60, 44)
    sheet.copy(leaf, 5, 5, 10, 10, 66, 2, 27, 27)
    sheet.copy(leaf, -5, 0, 30, 30, 66, 32, 17, 11)
    sheet.copy(leaf, 0, 0, 30, 30, 80, 80, 30, 30)
    sheet.copy(2, 2, 40, 40, 20, 30, 50, 60)  # over itself
    g.image(sheet, 2, 2)


@scene(is_smooth=False)
def image_masks(g: PGraphics) -> None:
    g.background(90, 110, 160)
    shape = g.createImage(30, 30, RGB)
    for i in range(900):
        shape.pixels[i] = g.color(
            0, 0, 255 if (i % 30 - 15) ** 2 + (i // 30 - 15) ** 2 < 150 else 60
        )
    leaf = _leaf(g, RGB)
    leaf.mask(shape)
    g.image(leaf, 4, 4, 44, 44)
    light = _light(g)
    light.mask([i * 255 // 900 for i in range(900)])
    g.image(light, 52, 4, 44, 44)
    small = _leaf(g, RGB)
    small.resize(20, 0)
    g.image(small, 4, 56)
    g.image(leaf.get(-5, 5, 30, 30), 40, 56)


@scene(P3D, is_smooth=False)
def canvas_filters(g: PGraphics) -> None:
    g.background(250, 220, 120)
    g.noStroke()
    g.lights()
    g.translate(35, 40)
    g.rotateY(0.6)
    g.rotateX(0.5)
    g.fill(200, 30, 60)
    g.box(36)
    g.filter(POSTERIZE, 5)
    g.filter(BLUR, 1.5)
    g.fill(0, 90, 220)
    g.translate(10, 5, -6)  # behind: depths have stayed
    g.box(40)
    g.filter(ERODE)
    g.filter(INVERT)


@scene(is_smooth=False)
def canvas_pixels(g: PGraphics) -> None:
    g.background(20, 60, 100)
    g.noStroke()
    g.fill(255, 140, 0)
    g.ellipse(40, 40, 60, 50)
    g.loadPixels()
    for i in range(0, 100 * 100, 3):
        g.pixels[i] = g.color(i % 256, g.red(g.pixels[i]), 120)
    g.fill(255)
    g.rect(60, 10, 20, 20)  # lies over the pixels, though it was drawn before they are shown
    g.updatePixels()
    g.translate(30, 30)
    for i in range(40):
        g.set(i + 50, i + 50, g.color(255, 0, 0))
    g.fill(g.get(51, 51))
    g.rect(20, 0, 30, 12)


@scene(is_smooth=False)
def canvas_copies_and_blends(g: PGraphics) -> None:
    g.background(200, 180, 160)
    g.image(_leaf(g, RGB), 4, 4)
    g.fill(255, 0, 0, 120)
    g.ellipse(30, 30, 30, 30)
    g.copy(0, 0, 40, 40, 44, 2, 54, 46)
    g.copy(_light(g), 0, 0, 30, 30, 4, 50, 20, 46)
    g.set(28, 50, _light(g))
    g.rect(60, 60, 8, 8)
    g.blend(_light(g), 0, 0, 30, 30, 62, 52, 34, 20, OVERLAY)
    g.blend(4, 4, 20, 20, 62, 74, 34, 24, DIFFERENCE)


@scene(JAVA2D, is_smooth=False)
def canvas_pixels_in_java2d(g: PGraphics) -> None:
    g.background(200, 180, 160)
    g.noStroke()
    g.fill(0, 120, 200)
    g.rect(10, 10, 40, 30)
    part = g.get(5, 5, 30, 30)
    g.set(60, 8, part)
    g.copy(5, 5, 30, 30, 60, 44, 15, 30)
    for i in range(30):
        g.set(10 + i, 50 + i, g.color(255, 0, 0))
    g.blend(0, 0, 30, 30, 30, 60, 30, 30, MULTIPLY)
    g.filter(INVERT)
