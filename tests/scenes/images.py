"""Images: where they lie, at which size, in which tint."""

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pimage import PImage
from sketchkit.core.constants import ARGB, CENTER, CORNER, CORNERS, RGB
from tests.scenes.registry import scene


def _photo(g: PGraphics, width: int, height: int) -> PImage:
    """Return an image in which every pixel differs from its neighbours."""
    picture = g.createImage(width, height, RGB)
    for y in range(height):
        for x in range(width):
            red = 255 * x // width
            picture.set(x, y, g.color(red, 255 * y // height, 200 if (x + y) % 2 else 40))
    return picture


@scene()
def image_in_its_own_size(g: PGraphics) -> None:
    g.background(250, 200, 60)
    picture = _photo(g, 31, 24)
    g.image(picture, 7, 9)
    g.image(picture, 52.4, 8.6)
    g.imageMode(CENTER)
    g.image(picture, 50, 68)


@scene()
def image_larger_and_smaller(g: PGraphics) -> None:
    g.background(30)
    picture = _photo(g, 24, 16)
    g.image(picture, 4, 4, 92, 50)
    g.image(picture, 4, 60, 12, 8)
    g.image(picture, 24, 60, 18, 34)
    g.image(picture, 52, 60, 5, 4)


@scene()
def image_mode_corners_and_center(g: PGraphics) -> None:
    g.background(220, 240, 230)
    picture = _photo(g, 16, 16)
    g.imageMode(CORNERS)
    g.image(picture, 90, 8, 55, 42)
    g.imageMode(CENTER)
    g.image(picture, 26, 26, 34, 30)
    g.imageMode(CORNER)
    g.image(picture, 8, 60, 84, 32, 4, 2, 12, 9)  # a part of it


@scene()
def image_in_a_tint(g: PGraphics) -> None:
    g.background(255)
    picture = _photo(g, 20, 20)
    g.tint(255, 140, 60)
    g.image(picture, 4, 4, 40, 40)
    g.tint(255, 110)
    g.image(picture, 54, 4, 40, 40)
    g.tint(90, 200, 255, 170)
    g.image(picture, 4, 54, 40, 40)
    g.noTint()
    g.fill(255, 0, 0)
    g.image(picture, 54, 54, 40, 40)


@scene()
def image_with_transparent_pixels(g: PGraphics) -> None:
    g.background(120, 180, 90)
    picture = g.createImage(10, 10, ARGB)
    for y in range(10):
        for x in range(10):
            picture.set(x, y, g.color(250, 40, 20 * x, 28 * y))
    g.image(picture, 6, 6, 40, 88)
    g.image(picture, 60, 20)
    g.image(picture, 60, 44, 32, 32)


@scene()
def clip_cuts_everything(g: PGraphics) -> None:
    g.background(240)
    g.strokeWeight(6)
    g.clip(12, 18, 50, 34)
    g.fill(230, 80, 50)
    g.circle(28, 28, 50)
    g.imageMode(CENTER)
    g.clip(70.6, 66.5, 41.3, 46.8)
    g.fill(50, 110, 230)
    g.rect(30, 40, 80, 40)
    g.noClip()
    g.line(4, 96, 96, 60)


@scene()
def background_keeps_to_the_clip(g: PGraphics) -> None:
    g.background(60, 120, 60)
    g.clip(14, 22, 60, 40)
    g.background(240, 200, 40)
    g.strokeWeight(3)
    g.circle(60, 50, 60)
