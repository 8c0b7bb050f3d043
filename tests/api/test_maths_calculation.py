"""Expected numbers were measured with Processing's functions."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.api import maths
from sketchkit.core.errors import SketchError

INF = math.inf
NAN = math.nan

number = st.floats(-1e6, 1e6)


@pytest.mark.parametrize(
    ("name", "args", "expected"),
    [
        ("ceil", (-2.5,), -2),
        ("ceil", (2.1,), 3),
        ("ceil", (NAN,), 0),
        ("floor", (-2.5,), -3),
        ("floor", (3,), 3),
        ("floor", (INF,), 2147483647),
        ("floor", (-INF,), -2147483648),
        ("constrain", (5, 0, 3), 3),
        ("constrain", (-1, 0, 3), 0),
        ("constrain", (2, 0, 3), 2),
        ("constrain", (5, 10, 0), 10),
        ("dist", (0, 0, 3, 4), 5.0),
        ("dist", (0, 0, 0, 1, 2, 2), 3.0),
        ("mag", (3, 4), 5.0),
        ("mag", (1, 2, 2), 3.0),
        ("lerp", (0, 10, 1), 10.0),
        ("lerp", (0, 10, 2), 20.0),
        ("norm", (5, 0, 10), 0.5),
        ("norm", (2, 1, 1), INF),
        ("norm", (1, 1, 1), NAN),
        ("sq", (3,), 9.0),
        ("sqrt", (16,), 4.0),
        ("sqrt", (-1,), NAN),
        ("log", (0,), -INF),
        ("log", (-1,), NAN),
        ("exp", (0,), 1.0),
        ("exp", (1e10,), INF),
    ],
)
def test_result_and_its_kind_are_processings(name, args, expected):
    result = getattr(maths, name)(*args)

    assert type(result) is type(expected)
    assert result == expected or (math.isnan(expected) and math.isnan(result))


@given(number, number)
def test_lerp_starts_and_stops_at_its_ends(start, stop):
    assert maths.lerp(start, stop, 0) == start
    assert maths.lerp(start, stop, 1) == pytest.approx(stop, abs=1e-6)


@given(number, number, number, number)
def test_dist_is_the_same_both_ways(x1, y1, x2, y2):
    assert maths.dist(x1, y1, x2, y2) == maths.dist(x2, y2, x1, y1)


@pytest.mark.parametrize(
    ("name", "args", "message"),
    [
        ("sqrt", ("9",), "sqrt() takes 1 number: n.\n    Got text for n: sqrt('9')."),
        ("floor", (None,), "floor() takes 1 number: n.\n    Got None for n: floor(None)."),
        (
            *("dist", (1, 2, 3, 4, 5)),
            "dist() takes 4 or 6 numbers: x1, y1, x2, y2, or x1, y1, z1, x2, y2, z2.\n"
            "    Got 5: dist(1, 2, 3, 4, 5).",
        ),
        ("dist", (1, 2), "dist() takes 4 or 6 numbers: "),
        ("lerp", (1, [2], 3), "lerp() takes 3 numbers: start, stop, amount.\n    Got a list"),
        ("constrain", ("a", 2, 3), "constrain() takes 3 numbers: amount, low, high."),
        ("mag", ("a", 2), "mag() takes 2 or 3 numbers: a, b [, c]."),
    ],
)
def test_wrong_arguments_are_told(name, args, message):
    with pytest.raises(SketchError) as caught:
        getattr(maths, name)(*args)

    assert caught.value.message.startswith(message)
