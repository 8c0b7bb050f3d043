import numpy as np
import pytest

from sketchkit.assets.fonts import LARGEST, Fonts, design_size, find_face, fonts_of
from sketchkit.core.errors import SketchError


def default(made_at, size=None):
    return Fonts().face("", made_at, made_at if size is None else size)


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


@pytest.mark.parametrize("character", ["\t", "\r", "\n", "\u2028"])
def test_control_characters_take_no_room_and_show_nothing(character):
    line = default(12).line(character)

    assert line.width == 0
    assert line.quads == ()


def test_a_space_takes_room_and_shows_nothing():
    line = default(12).line(" ")

    assert line.width == 2
    assert line.quads == ()


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

    quads = [*fonts.face("", 12, 12).line("abc").quads, *fonts.face("", 12, 30).line("xyz").quads]

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


def test_what_is_no_font_is_told(tmp_path):
    path = tmp_path / "letters.ttf"
    path.write_text("abc")

    with pytest.raises(SketchError, match=r"letters\.ttf cannot be read"):
        find_face("createFont", str(path))
