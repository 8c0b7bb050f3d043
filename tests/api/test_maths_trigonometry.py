"""Expected numbers were measured with Processing's functions, in 32 bits."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.api import maths
from sketchkit.core.errors import SketchError


@pytest.mark.parametrize(
    ("name", "args", "expected"),
    [
        ("sin", (2.5,), 0.5984721),
        ("cos", (2.5,), -0.8011436),
        ("tan", (2.5,), -0.7470223),
        ("asin", (0.5,), 0.5235988),
        ("acos", (-0.5,), 2.0943952),
        ("atan", (2.5,), 1.1902900),
        ("atan2", (1, 1), 0.7853982),
        ("atan2", (0, -1), 3.1415927),
        ("atan2", (0, 0), 0.0),
        ("degrees", (1,), 57.295776),
        ("radians", (2.5,), 0.0436332),
    ],
)
def test_result_is_processings(name, args, expected):
    assert getattr(maths, name)(*args) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "n"), [("asin", 2), ("acos", -1.5), ("sin", math.inf), ("tan", math.nan)]
)
def test_what_has_no_answer_is_nan(name, n):
    assert math.isnan(getattr(maths, name)(n))


@given(st.floats(-1000, 1000))
def test_degrees_undo_radians(angle):
    assert maths.degrees(maths.radians(angle)) == pytest.approx(angle, abs=1e-9)


def test_wrong_arguments_are_told():
    with pytest.raises(SketchError, match=r"^sin\(\) takes 1 number: angle\."):
        maths.sin("up")
