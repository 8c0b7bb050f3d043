import math

import pytest

from sketchkit.assets.svg.measures import Viewport, length, numbers, shortened, transform
from sketchkit.core.float32 import f32
from sketchkit.core.matrix import transform_point


def moved(text, x, y, remarks=None):
    whole = transform(text, (remarks if remarks is not None else []).append)
    return transform_point(whole, x, y, 0)[:2]


@pytest.mark.parametrize(
    ("text", "pixels"),
    [
        ("12", 12),
        (" 1.5px ", 1.5),
        ("-2e1", -20),
        (".5in", 45),
        ("2pt", 2.5),
        ("2pc", 30),
        ("1mm", f32(3.543307)),
        ("1cm", f32(35.43307)),
        ("25%", 50),
        ("1em", 16),
    ],
)
def test_lengths_are_pixels_at_90_to_the_inch(text, pixels):
    assert length(text, 200) == pixels


@pytest.mark.parametrize("text", ["", "px", "1 2", "3furlongs", "1e99", "--1", "0x10"])
def test_what_is_no_length_is_told(text):
    with pytest.raises(ValueError, match=r"is no length|too large"):
        length(text, 200)


def test_percentages_of_a_radius_are_of_the_mean_of_the_sides():
    viewport = Viewport(30, 40)

    wholes = [viewport.whole(name) for name in ("x", "height", "r")]
    assert wholes == [30, 40, f32(math.sqrt(1250))]


def test_numbers_need_no_blanks():
    assert numbers("1,2 -3-4 5.5.5,\n6") == [1, 2, -3, -4, 5.5, 0.5, 6]


def test_long_texts_are_shortened_in_messages():
    assert shortened("1\n  2 " * 20) == "1 2 " * 9 + "1..."


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("", (3, 4)),
        ("translate(10 20)", (13, 24)),
        ("scale(2)", (6, 8)),
        ("scale(2,3)", (6, 12)),
        ("matrix(1 2 3 4 5 6)", (20, 28)),
        ("translate(10,20), scale(2)", (16, 28)),
        ("scale(2)translate( 10 , 20 )", (26, 48)),
        ("skewX(45)", (7, 4)),
        ("skewY(45)", (3, 7)),
    ],
)
def test_transforms_are_the_standards(text, place):
    remarks = []

    assert moved(text, 3, 4, remarks) == pytest.approx(place)
    assert remarks == []


@pytest.mark.parametrize(
    ("text", "place", "remark"),
    [
        (
            "translate(10)",
            (13, 14),
            "translate(10) moves down as far as to the right, as in Processing.",
        ),
        (
            "rotate(1)",
            (3 * math.cos(1) - 4 * math.sin(1), 3 * math.sin(1) + 4 * math.cos(1)),
            "rotate(1) turns by radians, as in Processing.",
        ),
        (
            "rotate(1 2 4)",  # 1 to the right of its centre, which becomes (2, 4) + (sin 1, cos 1)
            (2 + math.sin(1), 4 + math.cos(1)),
            "rotate(1 2 4) turns by radians, with x and y exchanged, as in Processing.",
        ),
    ],
)
def test_some_are_processings_and_remarked_upon(text, place, remark):
    remarks = []

    assert moved(text, 3, 4, remarks) == pytest.approx(place)
    assert remarks == [remark]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("turn(30)", "'turn(30)' is no transform"),
        ("matrix(1 2)", "'matrix(1 2)' is no transform"),
        ("scale(2) nonsense", "'nonsense' is no transform"),
        ("scale(two)", "'two' is among the numbers 'two'"),
    ],
)
def test_what_is_no_transform_is_told(text, problem):
    with pytest.raises(ValueError, match=r"transform|numbers") as caught:
        moved(text, 0, 0)

    assert str(caught.value) == problem
