"""What is expected here was printed by Processing's own dictionaries."""

from __future__ import annotations

from math import nan

import pytest

from sketchkit.api.data.dicts.float_dict import FloatDict
from sketchkit.api.data.dicts.int_dict import IntDict
from sketchkit.api.data.dicts.string_dict import StringDict
from sketchkit.api.data.streams import BufferedReader
from sketchkit.core.errors import SketchError


def counts() -> IntDict:
    made = IntDict()
    made.set("b", 3)
    made.set("a", 1)
    made.increment("c")
    made.add("b", 4)
    made.sub("z", 2)
    return made


@pytest.mark.parametrize(
    ("method", "printed"),
    [
        ("copy", '{ "b": 7, "a": 1, "c": 1, "z": -2 }'),
        ("sortValues", '{ "z": -2, "a": 1, "c": 1, "b": 7 }'),
        ("sortValuesReverse", '{ "b": 7, "c": 1, "a": 1, "z": -2 }'),
        ("sortKeys", '{ "a": 1, "b": 7, "c": 1, "z": -2 }'),
        ("sortKeysReverse", '{ "z": -2, "c": 1, "b": 7, "a": 1 }'),
    ],
)
def test_orders_are_those_of_processing(method: str, printed: str) -> None:
    numbers = counts()

    getattr(numbers, method)()

    assert str(numbers) == f"IntDict size=4 {printed}"


def test_extremes_and_sums() -> None:
    numbers = counts()

    assert (numbers.maxKey(), numbers.minKey(), numbers.maxValue(), numbers.sum()) == (
        *("b", "z", 7),
        7,
    )
    percent = numbers.getPercent()
    assert str(percent) == (
        'FloatDict size=4 { "b": 1.0, "a": 0.14285715, "c": 0.14285715, "z": -0.2857143 }'
    )


def test_empty_ones_have_no_extremes() -> None:
    assert (IntDict().maxKey(), IntDict().maxIndex()) == (None, -1)
    assert FloatDict().maxValue() != FloatDict().maxValue()  # NaN
    with pytest.raises(SketchError, match=r"maxValue\(\)"):
        IntDict().maxValue()


def test_what_is_no_number_comes_last() -> None:
    numbers = FloatDict({"n": nan, "x": 0.1, "y": 2})

    numbers.sortValuesReverse()
    assert str(numbers) == 'FloatDict size=3 { "y": 2.0, "x": 0.1, "n": NaN }'
    numbers.sortValues()
    assert numbers.keyArray() == ["x", "y", "n"]


def test_texts_sort_without_regard_to_capitals() -> None:
    texts = StringDict([("k", "v\t"), ("B", "b"), ("a", "Z")])

    texts.sortValues()
    assert str(texts) == 'StringDict size=3 { "B": "b", "k": "v\\t", "a": "Z" }'
    texts.sortKeys()
    assert texts.keys() == ["a", "B", "k"]
    assert texts.get("none") is None


def test_lines_of_a_file_are_keys_and_values() -> None:
    assert IntDict(BufferedReader("a\t3\nno tab\nb\t4\n")) == {"a": 3, "b": 4}


def test_dictionaries_are_pythons_too() -> None:
    numbers = IntDict(["a", "b"], [1, 2])

    numbers["c"] = 3
    del numbers["a"]

    assert list(numbers) == ["b", "c"]
    assert ("b" in numbers, len(numbers), numbers["c"]) == (True, 2, 3)
    assert [(entry.key, entry.value) for entry in numbers.entries()] == [("b", 2), ("c", 3)]


def test_missing_key_tells_the_nearest() -> None:
    with pytest.raises(KeyError) as caught:
        IntDict({"height": 3}).get("heigth")

    assert caught.value.hint == "Do you mean 'height'?"


def test_keys_without_values_are_told() -> None:
    with pytest.raises(SketchError, match="as many keys as values"):
        IntDict(["a", "b"], [1])
