import numpy as np
import pytest

from sketchkit.api.pimage import PImage
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError

RED, HALF = 0xFFFF0000, 0x80FF0000


def image_of(*colors, image_format=c.ARGB):
    image = PImage(len(colors), 1, image_format)
    image.pixels[:] = colors
    return image


def test_copy_from_another_image_replaces_alpha_too():
    image = image_of(1, 2, 3)

    assert image.copy(image_of(HALF, RED), 0, 0, 2, 1, 1, 0, 2, 1) is None

    assert list(image.pixels) == [1, HALF, RED]


def test_copy_within_an_image():
    image = image_of(1, 2, 3)

    image.copy(0, 0, 1, 1, 2, 0, 1, 1)

    assert list(image.pixels) == [1, 2, 1]


def test_copy_without_arguments_is_another_image():
    image = image_of(1, 2, 3, image_format=c.ALPHA)

    other = image.copy()
    other.pixels[0] = 9

    assert (image.pixels[0], other.format) == (1, c.ALPHA)


def test_blend_mixes_by_alpha():
    image = image_of(0xFF000000)

    image.blend(image_of(HALF), 0, 0, 1, 1, 0, 0, 1, 1, c.BLEND)

    assert image.pixels[0] == 0xFF800000


def test_blendColor_belongs_to_no_image():
    assert PImage.blendColor(0xFF6496C8, 0x80C86432, c.ADD) == 0xFFC8C8E1  # from Processing
    assert PImage.blendColor("#000000", -1, c.BLEND) == 0xFFFFFFFF


@pytest.mark.parametrize(
    ("kind", "number", "expected"),
    [
        (c.GRAY, None, 0x80646464),
        (c.INVERT, None, 0x809BFFFF),
        (c.OPAQUE, None, 0xFF640000),
        (c.THRESHOLD, None, 0x80000000),
        (c.THRESHOLD, 0.3, 0x80FFFFFF),
        (c.POSTERIZE, 2, 0x80000000),
        (c.ERODE, None, 0x80640000),
        (c.DILATE, None, 0x80640000),
        (c.BLUR, None, 0x80640000),
        (c.BLUR, 4, 0x80640000),
    ],
)
def test_filter_of_one_plain_colour(kind, number, expected):
    image = PImage(3, 3, c.ARGB)
    image.pixels[:] = 0x80640000
    if kind == c.GRAY:
        image.pixels[:] = 0x80646464

    image.filter(kind, number)

    assert set(image.pixels) == {expected}


def test_opaque_has_no_alpha_any_more():
    image = image_of(HALF)

    image.filter(c.OPAQUE)

    assert image.format == c.RGB


def test_gray_makes_a_picture_of_a_mask():
    image = image_of(0, 100, 255, image_format=c.ALPHA)

    image.filter(c.GRAY)

    assert image.format == c.RGB
    assert list(image.pixels) == [0xFFFFFFFF, 0xFF9B9B9B, 0xFF000000]


def test_an_opaque_image_blurs_without_alpha():
    image = image_of(0x10FF0000, 0x20FF0000, image_format=c.RGB)

    image.filter(c.BLUR, 1)

    assert set(image.pixels) == {RED}


@pytest.mark.parametrize(
    "mask",
    [
        pytest.param(image_of(0x00000080, 0xFFFFFF00, 0xFF0000FF), id="image"),
        pytest.param([0x80, 0, 255], id="list"),
        pytest.param(np.array([0x80, 0, 255]), id="array"),
        pytest.param(image_of(0x80, 0, 255).pixels, id="pixels"),
    ],
)
def test_mask_takes_the_lowest_byte(mask):
    image = image_of(RED, RED, RED, image_format=c.RGB)

    image.mask(mask)

    assert image.format == c.ARGB
    assert list(image.pixels) == [HALF, 0x00FF0000, RED]


@pytest.mark.parametrize(
    "change",
    [
        lambda image: image.copy(0, 0, 1, 1, 1, 0, 1, 1),
        lambda image: image.blend(0, 0, 1, 1, 1, 0, 1, 1, c.ADD),
        lambda image: image.filter(c.INVERT),
        lambda image: image.mask([0, 0]),
    ],
    ids=["copy", "blend", "filter", "mask"],
)
def test_every_change_is_drawn_next_time(change):
    image = image_of(RED, 0xFF00FF00)
    drawn = image._texture()

    change(image)

    assert image._texture() is not drawn


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda image: image.copy(1), "takes 0, 8 or 9"),
        (lambda image: image.copy(1, 2, 3, 4, 5, 6, 7, 8, 9), "copy()"),
        (lambda image: image.copy(1, 2, 3, 4, 5, 6, 7, "8"), "Got text for dh"),
        (lambda image: image.blend(1, 2, 3, 4, 5, 6, 7, 8, 77), "a mode last"),
        (lambda image: image.blend(1, 2, 3, 4, 5, 6, 7, 8, "ADD"), "Write ADD without quotes"),
        (lambda image: image.blend(1, 2, 3), "takes 9 or 10"),
        (lambda image: image.blend(), "takes 9 or 10"),
        (lambda image: image.blendColor(1, 2, 77), "a mode last"),
        (lambda image: image.filter("BLUR"), "Write BLUR without quotes"),
        (lambda image: image.filter(99), "BLUR, POSTERIZE or THRESHOLD"),
        (lambda image: image.filter(c.POSTERIZE), r"filter\(POSTERIZE, 4\)"),
        (lambda image: image.filter(c.POSTERIZE, 1), "2 to 255 levels"),
        (lambda image: image.filter(c.GRAY, 3), "GRAY takes no number"),
        (lambda image: image.filter(c.BLUR, "3"), "Got text for number"),
        (lambda image: image.mask([1]), "as large as what it masks"),
        (lambda image: image.mask(PImage(9, 9)), "9 x 9 pixels for 2 x 1"),
        (lambda image: image.mask("cat.png"), "an image or a list"),
    ],
)
def test_mistakes_are_told(call, message):
    with pytest.raises(SketchError, match=message):
        call(image_of(RED, RED))
