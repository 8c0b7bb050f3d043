import pytest

from sketchkit.assets.svg.colors import opacity_byte, read_color


@pytest.mark.parametrize(
    ("text", "color"),
    [
        ("red", 0xFF0000),
        ("Rebecca" + "Purple", 0x663399),  # Processing knows 17 names alone
        (" #FC0 ", 0xFFCC00),
        ("#ff8800", 0xFF8800),
        ("rgb(1, 2, 3)", 0x010203),
        ("rgb(10%,50%,100%)", 0x197FFF),  # cut off: 25.5, 127.5
        ("rgba(1, 2, 3, 0.5)", 0x010203),
    ],
)
def test_colours(text, color):
    assert read_color(text, pytest.fail) == color


def test_an_unknown_name_is_black_and_remarked_upon():
    remarks = []

    assert read_color("blurple", remarks.append) == 0
    assert remarks == ["The colour 'blurple' is not known, and black."]


@pytest.mark.parametrize(
    ("text", "alpha"), [("0.5", 127), ("1", 255), ("7", 255), ("-1", 0), (" 20% ", 51)]
)
def test_opacities_are_cut_off(text, alpha):
    assert opacity_byte(text) == alpha
