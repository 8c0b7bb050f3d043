"""Expected numbers were measured with Processing; other forms are Python's."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.api import maths
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning

INF = math.inf
NAN = math.nan


@pytest.mark.parametrize(
    ("name", "args", "expected"),
    [
        ("abs", (-3,), 3),
        ("abs", (-2.5,), 2.5),
        ("map", (5, 0, 10, 0, 100), 50.0),
        ("map", (15, 0, 10, 100, 0), -50.0),
        ("max", (1, 2.5), 2.5),
        ("max", (3, 2, 1), 3),
        ("max", ([3, 1, 2],), 3),
        ("min", (1, 2.5), 1),
        ("min", ([3, 1, 2],), 1),
        ("pow", (2, 3), 8),
        ("pow", (2, -1), 0.5),
        ("pow", (2.0, 3), 8.0),
        ("pow", (0, -1), INF),
        ("pow", (-8, 1 / 3), NAN),
        ("pow", (-10.0, 401), -INF),
        ("round", (2.5,), 3),
        ("round", (-2.5,), -2),
        ("round", (0.49999997,), 0),
        ("round", (-3.7,), -4),
        ("round", (NAN,), 0),
    ],
)
def test_result_and_its_kind_are_processings(name, args, expected):
    result = getattr(maths, name)(*args)

    assert type(result) is type(expected)
    assert result == expected or (math.isnan(expected) and math.isnan(result))


@pytest.mark.parametrize(
    ("result", "expected"),
    [
        (maths.round(3.14159, 2), 3.14),
        (maths.pow(7, 2, 5), 4),
        (maths.max([], default=7), 7),
        (maths.min(["aa", "b"], key=len), "b"),
        (maths.max("ab"), "b"),
        (list(maths.map(str, [1, 2])), ["1", "2"]),
        (list(maths.map(pow, [2, 3], [2, 2])), [4, 9]),
    ],
    ids=["round", "pow", "default", "key", "text", "map", "map of two lists"],
)
def test_pythons_own_forms_work(result, expected):
    assert result == expected


@given(st.integers(-(2**50), 2**50))
def test_round_leaves_whole_numbers(n):
    assert maths.round(n) == n


@pytest.mark.parametrize(
    ("name", "args", "message"),
    [
        ("map", (1, 2, 3), "map() takes 5 numbers: value, start1, stop1, start2, stop2.\n"),
        ("map", ("a", 0, 1, 0, 1), "map() takes 5 numbers"),
        ("max", ([],), "max() takes two numbers or more, or a list.\n    Got max([])."),
        ("min", (1,), "min() takes two numbers or more, or a list.\n    Got min(1)."),
        ("abs", ("7",), "abs() takes 1 number: n.\n"),
        ("pow", ("7", 2), "pow() takes 2 numbers: n, exponent.\n"),
        ("round", ("7",), "round() takes 1 number: n.\n"),
    ],
)
def test_wrong_arguments_are_told(name, args, message):
    with pytest.raises(SketchError) as caught:
        getattr(maths, name)(*args)

    assert caught.value.message.startswith(message)


def test_an_error_in_the_key_function_is_its_own():
    with pytest.raises(TypeError, match="unsupported operand"):
        maths.max([1, 2], key=lambda n: n + "a")


@pytest.mark.parametrize(("value", "expected"), [(2, INF), (0, -INF), (1, NAN)])
def test_map_from_an_empty_range_is_remarked_on(value, expected):
    with pytest.warns(SketchWarning, match="a range from 1 to 1"):
        result = maths.map(value, 1, 1, 0, 10)

    assert result == expected or (math.isnan(expected) and math.isnan(result))
