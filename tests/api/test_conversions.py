"""What Processing itself gives for `parse...()` is in `tests/values`; here are the other names."""

import math

import pytest

from sketchkit.api import conversions
from sketchkit.core.constants import MAX_INT
from sketchkit.core.errors import SketchError


@pytest.mark.parametrize(
    ("name", "value", "expected"),
    [
        ("boolean", "True", True),
        ("boolean", "no", False),
        ("boolean", 0.0, False),
        ("boolean", [1, "true", ""], [True, True, False]),
        ("byte", "A", 65),
        ("byte", 200, -56),
        ("byte", -129.9, 127),
        ("byte", [1, "B"], [1, 66]),
        ("char", 65, "A"),
        ("char", "x", "x"),
        ("char", 65536 + 65, "A"),
        ("char", (72, 105), ["H", "i"]),
        ("parseInt", "3000000000", 3_000_000_000),  # Python's ints have no end
        ("parseInt", "1_000", 0),
        ("parseInt", math.inf, MAX_INT),
        ("parseInt", math.nan, 0),
        ("parseFloat", " 2.5 ", 2.5),
        ("parseFloat", [True, "7"], [1.0, 7.0]),
    ],
)
def test_value_is_converted(name, value, expected):
    result = getattr(conversions, name)(value)

    assert result == expected
    assert type(result) is type(expected)


def test_underscore_in_text_is_no_number():
    assert math.isnan(conversions.parseFloat("1_000"))


@pytest.mark.parametrize("name", ["byte", "char", "parseInt", "parseFloat"])
def test_what_is_no_number_is_told(name):
    with pytest.raises(SketchError, match="takes a number, or a list of them"):
        getattr(conversions, name)({"a": 1})


@pytest.mark.parametrize("name", ["byte", "char"])
def test_text_of_several_characters_is_no_code(name):
    with pytest.raises(SketchError, match="takes a number"):
        getattr(conversions, name)("ab")
