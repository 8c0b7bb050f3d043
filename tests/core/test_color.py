"""Expected colours and parts were measured with Processing's color(), red() ... and lerpColor()."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core import color
from sketchkit.core import constants as c
from sketchkit.core.color import ColorMode, pack, parse
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning

PLAIN = ColorMode()
UNIT = ColorMode(c.RGB, 1.0, 1.0, 1.0, 1.0)
HUNDRED = ColorMode(c.RGB, 100, 100, 100, 100)
HSB = ColorMode(c.HSB, 360, 100, 100, 255)
HSB_255 = ColorMode(c.HSB)

colors = st.integers(0, 0xFFFFFFFF)


@pytest.mark.parametrize(
    ("mode", "args", "expected"),
    [
        (PLAIN, (204,), 0xFFCCCCCC),
        (PLAIN, (204.0,), 0xFFCCCCCC),
        (PLAIN, (127.5,), 0xFF7F7F7F),
        (PLAIN, (127.999999999,), 0xFF808080),
        (PLAIN, (300.5,), 0xFFFFFFFF),
        (PLAIN, (-3.5,), 0xFF000000),
        (PLAIN, (float("nan"),), 0xFF000000),
        (PLAIN, (float("inf"),), 0xFFFFFFFF),
        (PLAIN, (204, 100), 0x64CCCCCC),
        (PLAIN, (204, 300), 0xFFCCCCCC),
        (PLAIN, (10, 20, 30), 0xFF0A141E),
        (PLAIN, (300, -5, 12.9), 0xFFFF000C),
        (PLAIN, (10, 20, 30, 40), 0x280A141E),
        (UNIT, (0.5,), 0xFF7F7F7F),
        (UNIT, (1,), 0xFFFFFFFF),
        (UNIT, (0.2, 0.4, 0.6, 0.8), 0xCC336699),
        (HUNDRED, (50,), 0xFF7F7F7F),
        (HSB, (30, 50, 80), 0xFFCC9966),
        (HSB, (360, 100, 100), 0xFFFF0000),
        (HSB, (200, 0, 50), 0xFF7F7F7F),
        (HSB_255, (85, 255, 255), 0xFF00FF00),
    ],
)
def test_numbers_are_read_in_the_mode_and_cut_off(mode, args, expected):
    assert pack(mode, *args) == expected


@pytest.mark.parametrize(
    ("mode", "args", "expected"),
    [
        (PLAIN, (255,), 0xFFFFFFFF),
        (PLAIN, (256,), 0x00000100),
        (PLAIN, (0xFFAA0000,), 0xFFAA0000),
        (PLAIN, (-65536,), 0xFFFF0000),
        (PLAIN, (-1,), 0xFFFFFFFF),
        (PLAIN, (0xFFAA0000, 100), 0x64AA0000),
        (PLAIN, (0x80AA0000, 128), 0x40AA0000),
        (PLAIN, (0x80AA0000, 255), 0x80AA0000),
        (UNIT, (2,), 0x00000002),
        (HUNDRED, (100,), 0xFFFFFFFF),
        (HUNDRED, (101,), 0x00000065),
        (HSB, (300,), 0xFFD4D4D4),
    ],
)
def test_one_int_is_packed_when_it_is_no_gray_of_the_mode(mode, args, expected):
    assert pack(mode, *args) == expected


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        (("#AA0000",), 0xFFAA0000),
        (("#80aa0000",), 0x80AA0000),
        (("#A05",), 0xFFAA0055),
        (("orange",), 0xFFFFA500),
        (("Light Blue",), 0xFFADD8E6),
        (("#AA0000", 100), 0x64AA0000),
    ],
)
def test_strings_are_colours(args, expected):
    assert pack(PLAIN, *args) == expected


def test_unknown_name_is_told_with_the_nearest():
    with pytest.raises(SketchError) as caught:
        pack(PLAIN, "gren")

    assert caught.value.hint == 'Did you mean "green"?'


@pytest.mark.parametrize("args", [(), (1, 2, 3, 4, 5), (None,), ([1],), ("red", 2, 3)], ids=str)
def test_wrong_arguments_name_the_function_that_was_called(args):
    with pytest.raises(SketchError, match=r"^stroke\(\) takes 1, 2, 3 or 4 numbers"):
        pack(PLAIN, *args, name="stroke")


@pytest.mark.parametrize(
    ("number", "expected"),
    [(0x1FF00FF00, 0xFF00FF00), ((1 << 32) + 255, 0xFFFFFFFF), (-(1 << 32) - 1, 0xFFFFFFFF)],
    ids=hex,
)
def test_of_an_int_of_more_than_32_bits_the_last_are_taken(number, expected):
    with pytest.warns(SketchWarning, match="32 bits"):
        assert pack(PLAIN, number) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("552200", 0xFF086D08),  # decimal: 8 * 65536 + 109 * 256 + 8
        ("255", 0xFF0000FF),
        ("010", 0xFF000008),
        ("#FFFFFFF", 0xFFFFFFFF),
        ("#95ee0f5", 0xFF5EE0F5),
        ("0xCC66", 0xFF00CC66),
    ],
)
def test_a_number_in_quotes_is_read_as_in_python_mode(text, expected):
    with pytest.warns(SketchWarning, match="As in Processing"):
        assert parse(text) == expected


def test_hexadecimal_as_in_python_needs_no_remark():
    assert parse("0xCC6600") == 0xFFCC6600


@pytest.mark.parametrize("text", ["#", "12CC", "#FFCC66001", "99999999999", "0x"])
def test_what_is_no_number_in_quotes_is_no_colour(text):
    with pytest.raises(SketchError, match="no colour of this name"):
        parse(text)


def test_a_range_of_zero_is_refused():
    with pytest.raises(SketchError, match="greater than 0"):
        ColorMode(c.RGB, 0, 255, 255)


@pytest.mark.parametrize(
    ("mode", "packed", "parts"),
    [
        (PLAIN, 0x80123456, (18, 52, 86, 128, 148.75, 201.627914, 86)),
        (UNIT, 0xFF804020, (0.50196081, 0.25098041, 0.1254902, 1, 0.0555555522, 0.75, 0.50196081)),
        (HSB, 0xFFCC9966, (288, 60, 40, 255, 30, 50, 80)),
        (HSB, 0xFF808080, (180.705887, 50.1960793, 50.1960793, 255, 0, 0, 50.1960793)),
    ],
    ids=["plain", "unit", "hsb", "gray in hsb"],
)
def test_parts_are_on_the_scales_of_the_mode(mode, packed, parts):
    readers = (color.red, color.green, color.blue, color.alpha)
    readers += (color.hue, color.saturation, color.brightness)

    assert [read(mode, packed) for read in readers] == pytest.approx(parts, rel=1e-7)


@given(colors)
def test_parts_of_a_signed_colour_are_those_of_the_unsigned(packed):
    signed = packed - (1 << 32) if packed >> 31 else packed

    assert color.to_packed(signed) == packed
    assert color.hue(PLAIN, signed) == color.hue(PLAIN, packed)


@given(colors)
def test_components_make_the_colour_again(packed):
    r, g, b, a = (read(PLAIN, packed) for read in (color.red, color.green, color.blue, color.alpha))

    assert pack(PLAIN, r, g, b, a) == packed


@given(colors)
def test_hex_text_makes_the_colour_again(packed):
    assert color.parse(f"#{packed:08X}") == packed


@given(st.floats(0, 255), st.floats(0, 255), st.floats(0, 255))
def test_short_way_and_general_way_agree(r, g, b):
    almost_plain = ColorMode(c.RGB, 255, 255, 255, 1.0)

    assert pack(PLAIN, r, g, b) == pack(almost_plain, r, g, b)


@pytest.mark.parametrize(
    ("start", "stop", "amount", "model", "expected"),
    [
        (0, 255, 0.5, c.RGB, 0x00000080),
        (0xFF000000, 0xFFFFFFFF, 0.25, c.RGB, 0xFF404040),
        (0xFFFF0000, 0xFF0000FF, 0.5, c.RGB, 0xFF800080),
        (0xFFFF0000, 0xFF0000FF, 0.5, c.HSB, 0xFF00FF00),
        (0x00FF0000, 0xFF00FF00, 0.5, c.HSB, 0x80FFFF00),
        (0xFF102030, 0xFF405060, -1, c.RGB, 0xFF102030),
        (0xFF102030, 0xFF405060, 2, c.RGB, 0xFF405060),
    ],
)
def test_lerp_color_rounds_each_part(start, stop, amount, model, expected):
    assert color.lerp_color(start, stop, amount, model) == expected
