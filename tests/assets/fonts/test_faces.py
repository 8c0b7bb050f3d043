import numpy as np
import pytest

from sketchkit.assets.fonts.faces import (
    LARGEST,
    MOST_FACES,
    MOST_IMAGES,
    Fonts,
    Setting,
    design_size,
    enlarged_size,
    fonts_of,
)
from sketchkit.core.style import Typeface


def default(made_at, size=None):
    return Fonts().face(Typeface(), made_at, made_at if size is None else size)


@pytest.mark.parametrize(
    ("size", "hello", "avavav"), [(12, 27, 39), (20, 44, 63), (32, 70, 99), (64, 141, 204)]
)
def test_widths_are_processings(size, hello, avavav):
    assert default(size).width("Hello") == hello
    assert default(size).width("AVAVAV") == avavav


def test_widths_are_those_of_the_size_and_not_of_the_design():
    assert default(12, 64).width("Hello") == 141


@pytest.mark.parametrize(
    ("size", "ascent", "descent"),
    [(12, 9, 2), (14, 10, 3), (16, 11, 3), (20, 14, 4), (24, 17, 5), (32, 23, 7), (48, 34, 10)],
)
def test_ascent_and_descent_are_processings(size, ascent, descent):
    assert (default(size).ascent, default(size).descent) == (ascent, descent)


def test_ascent_and_descent_scale_with_the_size():
    face = default(12, 64)

    assert face.ascent == 48
    assert face.descent == pytest.approx(10.6667, abs=1e-4)


def test_a_letter_is_where_and_what_processing_draws():
    # "d" at 12 pixels, from a frame of Processing's: coverage in 255ths.
    expected = [
        [0, 0, 0, 0, 80, 172],
        [0, 0, 0, 0, 80, 172],
        [0, 0, 0, 0, 79, 172],
        [0, 76, 219, 234, 178, 172],
        [27, 237, 71, 17, 153, 172],
        [91, 169, 0, 0, 80, 172],
        [96, 164, 0, 0, 80, 172],
        [40, 238, 52, 23, 172, 172],
        [0, 109, 232, 223, 135, 172],
    ]

    (quad,) = default(12).line("d").quads

    image = quad.pixels
    rows = slice(round(quad.v1 * image.height), round(quad.v2 * image.height))
    columns = slice(round(quad.u1 * image.width), round(quad.u2 * image.width))
    drawn = image.data[rows, columns, 3]
    assert (quad.left, quad.top, quad.width, quad.height) == (0, -9, 6, 9)
    assert drawn.tolist() == expected


def test_letters_are_enlarged_from_the_design():
    (small,), (large,) = default(12).line("d").quads, default(12, 24).line("d").quads

    assert (large.width, large.height) == (2 * small.width, 2 * small.height) == (12, 18)
    assert large.top == -18
    assert large.u2 - large.u1 == small.u2 - small.u1


def test_a_line_follows_the_pen():
    first, second = default(12).line("dd").quads

    assert second.left - first.left == default(12).width("d") == 7


def test_letters_of_one_design_share_an_image():
    fonts = Fonts()

    quads = [
        *fonts.face(Typeface(), 12, 12).line("abc").quads,
        *fonts.face(Typeface(), 12, 30).line("xyz").quads,
    ]

    assert len({id(quad.pixels) for quad in quads}) == 1


def test_a_line_is_laid_out_once_until_the_image_grows():
    face = default(400)
    line = face.line("a")

    assert face.line("a") is line

    face.line("bcdefghij")
    again = face.line("a")
    assert again is not line
    assert (again.quads[0].pixels.data[..., 3] > 0).any()
    assert np.isclose(again.quads[0].v2 * 2, line.quads[0].v2)


def test_each_sketch_has_its_own_letters():
    class Owner:
        pass

    one, other = Owner(), Owner()

    assert fonts_of(one) is fonts_of(one)
    assert fonts_of(one) is not fonts_of(other)


@pytest.mark.parametrize(
    ("size", "expected"), [(12, 12), (12.4, 12), (12.5, 13), (0.2, 1), (9999, LARGEST)]
)
def test_design_sizes_are_whole(size, expected):
    assert design_size(size) == expected


def test_a_letter_of_two_units_takes_the_room_of_two():
    first, second = default(20).line("x\U0001f600x").quads

    assert second.left - first.left == default(20).width("x") + 2 * 13


def test_letters_that_a_transform_enlarges_are_drawn_anew_where_it_shows():
    assert [enlarged_size(12, times) for times in (0.1, 1, 1.49, 1.5, 2, 3, 4)] == [
        *(12, 12, 12, 17, 24, 34, 48),
    ]
    assert enlarged_size(12, 1e9) == LARGEST


def test_letters_drawn_anew_lie_where_the_enlarged_ones_do():
    (small,) = default(12).line("d").quads
    (large,) = Fonts().set(Setting(Typeface(), 12, 12, 48)).line("d").quads

    assert large.top == pytest.approx(small.top, abs=0.5)
    assert large.height == pytest.approx(small.height, abs=0.5)
    assert (large.v2 - large.v1) * large.pixels.height == 34  # its ascent at 48


def test_without_hints_letters_begin_at_whole_pixels():
    face = Fonts().set(Setting(Typeface(), 20, 20, 20, is_hinted=False))

    assert face.width("aa") == pytest.approx(2 * 10.08, abs=1e-3)
    assert all(quad.left == int(quad.left) for quad in face.line("aaaa").quads)


@pytest.mark.parametrize("size", [13, 21, 23])
def test_without_hints_letters_end_at_whole_pixels(size):
    face = Fonts().set(Setting(Typeface(), size, size, size, is_hinted=False))

    for quad in face.line("amp").quads:
        assert all(number == int(number) for number in quad[1:5])


def test_kerning_brings_letters_together():
    plain = Fonts().set(Setting(Typeface(), 20, 40, 40, is_hinted=False))
    kerned = Fonts().set(Setting(Typeface(), 20, 40, 40, is_hinted=False, is_kerned=True))

    assert kerned.width("ToTo") < plain.width("ToTo") - 5
    assert kerned.line("ToTo").quads[1].left < plain.line("ToTo").quads[1].left


def test_without_hints_accents_join_their_letters():
    face = Fonts().set(Setting(Typeface(), 20, 20, 20, is_hinted=False))

    assert len(face.line("a\u0301").quads) == 1
    assert len(default(20).line("a\u0301").quads) == 2


def test_letters_of_all_other_sizes_share_an_image():
    fonts = Fonts()

    quads = [
        quad
        for size in (17, 24, 34, 48)
        for quad in fonts.set(Setting(Typeface(), 12, 12, size)).line("abc").quads
    ]

    assert len({id(quad.pixels) for quad in quads}) == 1


def test_text_that_grows_for_ever_does_not_fill_the_memory():
    fonts = Fonts()

    for i in range(600):
        size = 30 + i / 7
        fonts.set(Setting(Typeface(), 30, size, size, is_hinted=False)).line("large letters")

    assert fonts._shared.image_count <= MOST_IMAGES + 1
    assert len(fonts._faces) <= MOST_FACES + 1
