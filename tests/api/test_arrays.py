from __future__ import annotations

from math import nan

import numpy as np
import pytest

from sketchkit.api import arrays
from sketchkit.api.data.lists.int_list import IntList
from sketchkit.core.errors import SketchError


@pytest.mark.parametrize(
    ("call", "result"),
    [
        (lambda a: arrays.append(a, 4), [1, 2, 3, 4]),
        (lambda a: arrays.concat(a, [9]), [1, 2, 3, 9]),
        (lambda a: arrays.reverse(a), [3, 2, 1]),
        (lambda a: arrays.shorten(a), [1, 2]),
        (lambda a: arrays.expand(a), [1, 2, 3, 0, 0, 0]),
        (lambda a: arrays.expand(a, 2), [1, 2]),
        (lambda a: arrays.subset(a, 1), [2, 3]),
        (lambda a: arrays.subset(a, 0, 2), [1, 2]),
        (lambda a: arrays.splice(a, 9, 1), [1, 9, 2, 3]),
        (lambda a: arrays.splice(a, (8, 9), 3), [1, 2, 3, 8, 9]),
    ],
)
@pytest.mark.parametrize("kind", [list, tuple, np.array, IntList])
def test_another_of_the_same_kind_is_returned(call, result: list[int], kind) -> None:
    given = kind([1, 2, 3])

    returned = call(given)

    assert (list(returned), list(given)) == (result, [1, 2, 3])
    assert isinstance(returned, type(given))


def test_new_places_are_blank_for_their_kind() -> None:
    assert arrays.expand([1.5], 2) == [1.5, 0.0]
    assert arrays.expand([True], 2) == [True, False]
    assert arrays.expand(["a"], 2) == ["a", None]
    assert arrays.expand([]) == [None]


def test_sorting() -> None:
    assert arrays.sort([3, 1, 2]) == [1, 2, 3]
    assert arrays.sort([3, 1, 2], 2) == [1, 3, 2]
    assert arrays.sort(["b", "C", "a"]) == ["C", "a", "b"]
    assert str(arrays.sort([nan, 1.0, nan, -1.0])) == "[-1.0, 1.0, nan, nan]"


def test_copying_changes_the_second_list() -> None:
    target = [0, 0, 0, 0]

    arrays.arrayCopy([1, 2, 3], target, 2)
    assert target == [1, 2, 0, 0]
    arrays.arrayCopy([7, 8, 9], 1, target, 2, 2)
    assert target == [1, 2, 8, 9]


def test_texts_and_bytes_are_values_in_a_row_too() -> None:
    assert arrays.reverse("abc") == "cba"
    assert arrays.append(b"ab", 99) == b"abc"


@pytest.mark.parametrize(
    ("call", "problem"),
    [
        (lambda: arrays.subset([1, 2], 1, 2), "beyond the list, which has 2 values"),
        (lambda: arrays.splice([1], 2, 5), "beyond the list"),
        (lambda: arrays.shorten([]), "at least one value"),
        (lambda: arrays.sort([1, "a"]), "numbers alone, or text alone"),
        (lambda: arrays.append(3, 4), "takes a list"),
        (lambda: arrays.arrayCopy([1, 2], [0]), "beyond the list, which has 1 value"),
        (lambda: arrays.arrayCopy([1], (0,)), "that it can change"),
        (lambda: arrays.arrayCopy([1]), "takes two lists"),
    ],
)
def test_mistakes_are_told(call, problem: str) -> None:
    with pytest.raises(SketchError, match=problem):
        call()
