"""What is expected here was printed by Processing's own lists."""

from __future__ import annotations

import re
from math import nan
from pathlib import Path

import pytest

from sketchkit.api.chance import use_random
from sketchkit.api.data.dicts.int_dict import IntDict
from sketchkit.api.data.lists.float_list import DoubleList, FloatList
from sketchkit.api.data.lists.int_list import IntList
from sketchkit.api.data.lists.string_list import StringList
from sketchkit.assets.paths import set_sketch_folder
from sketchkit.core.errors import SketchError
from sketchkit.core.rng import JavaRandom


def test_whole_numbers_are_changed_as_in_processing() -> None:
    numbers = IntList(3, 1, 2)
    numbers.append(7)
    numbers.insert(1, 9)
    numbers.set(8, 4)
    assert str(numbers) == "IntList size=9 [ 3, 9, 1, 2, 7, 0, 0, 0, 4 ]"

    numbers.sortReverse()
    assert str(numbers) == "IntList size=9 [ 9, 7, 4, 3, 2, 1, 0, 0, 0 ]"

    numbers.reverse()
    assert (numbers.removeValue(9), numbers.removeValues(0)) == (8, 3)
    assert str(numbers) == "IntList size=5 [ 1, 2, 3, 4, 7 ]"


def test_arithmetic_is_that_of_processing() -> None:
    numbers = IntList([3, 9, 5, 8])

    numbers.div(0, 3)
    numbers.mult(1, 3)
    numbers.sub(2, 100)
    numbers.increment(3)

    assert numbers == [1, 27, -95, 9]
    numbers.div(2, 10)
    assert numbers[2] == -9  # cut off towards 0


def test_shuffle_is_processings_for_the_same_seed() -> None:
    use_random(JavaRandom(5))
    numbers = IntList.fromRange(10)

    numbers.shuffle()

    assert numbers == [3, 9, 5, 8, 6, 2, 4, 0, 1, 7]


def test_percent_is_printed_as_floats_are() -> None:
    percent = IntList.fromRange(3).getPercent()

    assert str(percent) == "FloatList size=3 [ 0.0, 0.33333334, 0.6666667 ]"


def test_what_is_no_number_comes_last() -> None:
    numbers = FloatList(1.5, nan, -2, 0.1)

    numbers.sort()
    assert str(numbers) == "FloatList size=4 [ -2.0, 0.1, 1.5, NaN ]"
    numbers.sortReverse()
    assert str(numbers) == "FloatList size=4 [ 1.5, 0.1, -2.0, NaN ]"

    assert (numbers.min(), numbers.max(), numbers.maxIndex()) == (-2, 1.5, 0)
    assert numbers.hasValue(nan)


def test_texts_of_numbers_are_read() -> None:
    assert str(FloatList("1.5", None, "x")) == "FloatList size=3 [ 1.5, NaN, NaN ]"
    assert str(IntList("7.9", None, "x")) == "IntList size=3 [ 7, 0, 0 ]"


def test_equal_texts_are_ordered_as_processing_leaves_them() -> None:
    words = StringList("banana", "Apple", "cherry", "apple")

    words.sort()
    assert words == ["apple", "Apple", "banana", "cherry"]
    words.sortReverse()
    assert words == ["cherry", "banana", "Apple", "apple"]


def test_tally_and_order() -> None:
    words = StringList("b", "a", "b")

    assert words.getTally() == IntDict({"b": 2, "a": 1})
    assert words.getOrder() == IntDict({"b": 2, "a": 1})
    assert words.getUnique() == ["b", "a"]


def test_texts_are_quoted_as_json() -> None:
    assert StringList('qu"ote\n/</').toJSON() == '[ "qu\\"ote\\n/<\\/" ]'


def test_doubles_have_all_digits() -> None:
    assert str(DoubleList(0.1, 1e10, 1 / 3)) == (
        "DoubleList size=3 [ 0.1, 1.0E10, 0.3333333333333333 ]"
    )


def test_lists_are_pythons_too() -> None:
    numbers = IntList(4, 5, 6)

    assert (len(numbers), numbers[-1], numbers[1:], list(numbers)) == (3, 6, [5, 6], [4, 5, 6])
    numbers[0] = 9
    del numbers[1]
    assert numbers == [9, 6]
    assert 9 in numbers
    assert numbers == IntList(9, 6)


def test_number_alone_is_the_room_that_there_is() -> None:
    assert IntList(7).size() == 0


@pytest.mark.parametrize(
    ("call", "problem"),
    [
        (lambda: IntList(1, 2).get(2), "a number from 0 to 1: there are 2 values"),
        (lambda: IntList().max(), "there is no value"),
        (lambda: IntList(1, 2).append("7"), r"int\('7'\) makes a number"),
        (lambda: FloatList().append("a"), "takes a number"),
        (lambda: StringList("a").set(0, 4), r"str\(4\)"),
        (lambda: IntList(1, 2).div(0, 0), "by 0"),
        (lambda: IntList(1, 2).getSubset(1, 9), "beyond the list"),
    ],
)
def test_mistakes_are_told(call, problem: str) -> None:
    with pytest.raises(SketchError) as caught:
        call()

    assert re.search(problem, caught.value.message)


def test_place_beyond_the_end_is_an_index_error() -> None:
    with pytest.raises(IndexError):
        IntList(1, 2)[5]


def test_file_has_a_value_in_each_line(tmp_path: Path) -> None:
    set_sketch_folder(tmp_path)

    FloatList(1.5, nan).save("out/list.txt")

    assert (tmp_path / "out" / "list.txt").read_text() == "1.5\nNaN\n"
