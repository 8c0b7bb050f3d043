from __future__ import annotations

import re
from math import inf
from pathlib import Path

import numpy as np
import pytest

from sketchkit.api.data.json.json_array import JSONArray
from sketchkit.api.data.json.json_object import JSONObject
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import new_sketch

TEXT = '{"a": 1, "b": 2.50, "c": [1, 2, {"d": null}], "e": "12", "t": true, "big": 12345678901}'


def test_values_are_read_as_in_processing() -> None:
    json = JSONObject.parse(TEXT)

    assert (json.getInt("b"), json.getFloat("b"), json.getInt("e"), json.getFloat("e")) == (
        *(2, 2.5, 12),
        12.0,
    )
    assert (json.getLong("big"), json.getBoolean("t")) == (12345678901, True)
    inner = json.getJSONArray("c").getJSONObject(2)
    assert (inner.isNull("d"), inner.hasKey("d"), inner.hasKey("x")) == (True, True, False)


def test_second_values_take_the_place_of_what_is_missing() -> None:
    json = JSONObject.parse('{"f": 2}')

    assert (json.getInt("no", 3), json.getString("no", "d"), json.getString("f", "d")) == (
        *(3, "d"),
        "2",
    )
    assert json.getBoolean("f", False) is False
    assert JSONArray([5, "x"]).getInt(1, 7) == 7
    assert JSONArray([5]).getInt(9, 7) == 7


def test_floats_are_kept_in_32_bits_and_doubles_whole() -> None:
    json = JSONObject()
    json.setFloat("f", 0.1)
    json.setDouble("d", 0.1)

    assert json.format(-1) == '{"f":0.10000000149011612,"d":0.1}'


def test_array_grows_with_null() -> None:
    array = JSONArray().append(1).append("x").append(True).append(0.5)
    array.setInt(6, 9)

    assert array.format(-1) == '[1,"x",true,0.5,null,null,9]'
    assert array.format(0).startswith('[\n1,\n"x",')
    assert array.remove(0) == 1
    assert array.join(", ") == '"x", true, 0.5, null, null, 9'


def test_parts_are_set_as_in_processing() -> None:
    numbers = JSONArray([1, 2, 3])
    member = JSONObject().setBoolean("w", False).setJSONArray("a", numbers)
    member.setJSONObject("o", {"x": 1})
    array = JSONArray().setBoolean(1, True).setJSONArray(0, numbers).setJSONObject(3, member)

    assert array.format(-1) == '[[1,2,3],true,null,{"w":false,"a":[1,2,3],"o":{"x":1}}]'
    assert array.setString(2, "z").getString(2) == "z"


def test_part_that_was_set_is_the_same_and_no_copy() -> None:
    scores = JSONArray()
    game = JSONObject().setJSONArray("scores", scores)

    scores.append(5)

    assert game.getJSONArray("scores").getInt(0) == 5


def test_arrays_are_given_as_lists_of_one_kind() -> None:
    assert JSONArray([3, 2.5, "7"]).toIntArray() == [3, 2, 7]
    assert JSONArray([3, 2.5, "7"]).getIntArray() == [3, 2, 7]
    assert JSONArray(["a", "b"]).toStringArray() == ["a", "b"]
    assert JSONArray(["a", "b"]).getStringArray() == ["a", "b"]


def test_they_are_pythons_too() -> None:
    json = JSONObject({"name": "Ida", "scores": [1, 2], "at": {"x": np.float64(3)}})

    json["age"] = 12

    assert (json["name"], json["scores"][1], json["at"]["x"], len(json)) == ("Ida", 2, 3, 4)
    assert list(json) == ["name", "scores", "at", "age"]
    assert json == {"name": "Ida", "scores": [1, 2], "at": {"x": 3}, "age": 12}
    assert str(json.keys()) == "dict_keys(['name', 'scores', 'at', 'age'])"
    assert [*JSONArray(np.arange(3))] == [0, 1, 2]


@pytest.mark.parametrize(
    ("call", "problem"),
    [
        (lambda j: j.getInt("heigth"), "Do you mean 'height'"),
        (lambda j: j["heigth"], "Do you mean 'height'"),
        (lambda j: j.getInt("name"), r"Got text: 'Ida'.  Write getString"),
        (lambda j: j.getString("height"), r"finds no text there"),
        (lambda j: j.getJSONObject("list"), r"Write getJSONArray"),
        (lambda j: j.getJSONArray("list").getInt(4), "takes 0 alone: there is 1 value"),
        (lambda j: j.setString("name", 4), r"str\(4\)"),
        (lambda j: j.setJSONArray("name", {"a": 1}), "takes a JSONArray or a list"),
        (lambda j: j.setJSONObject("name", [1]), "takes a JSONObject or a dictionary"),
        (lambda j: j["list"].setJSONObject(0, [1]), "takes a JSONObject or a dictionary"),
        (lambda j: j["list"].setJSONArray(-1, [1]), "takes 0 alone"),
        (lambda j: JSONArray(["a", 1]).toStringArray(), r"getString\(1\) finds no text"),
        (lambda j: j.setFloat("name", inf), "finite"),
        (lambda j: j.put("name", object()), "what JSON can hold"),
        (lambda j: j.save("a.json", "tiny"), "compact"),
    ],
)
def test_mistakes_are_told(call, problem: str) -> None:
    with pytest.raises(SketchError) as caught:
        call(JSONObject({"name": "Ida", "height": 3, "list": [1]}))

    assert re.search(problem, caught.value.message)


def test_misspelt_key_is_remarked_on_where_processing_gives_null() -> None:
    with pytest.warns(SketchWarning, match="Do you mean 'name'"):
        assert JSONObject({"name": "Ida"}).getString("nmae") is None


def test_text_that_is_no_json_gives_none_and_a_remark() -> None:
    with pytest.warns(SketchWarning, match="line 1, column 6"):
        assert new_sketch().parseJSONArray("[1, 2") is None
    with pytest.warns(SketchWarning, match=r"holds an array"):
        assert new_sketch().parseJSONObject("[1]") is None


def test_files_are_saved_and_loaded(tmp_path: Path) -> None:
    sketch = new_sketch(folder=tmp_path)
    sketch.take_over()

    assert sketch.saveJSONObject(JSONObject({"f": 2, "g": "\u00e4"}), "o.json")
    assert sketch.saveJSONArray([1, [2]], "a.json", "compact")

    assert (tmp_path / "o.json").read_bytes() == '{\n  "f": 2,\n  "g": "\u00e4"\n}'.encode()
    assert (tmp_path / "a.json").read_text() == "[1,[2]]"
    assert sketch.loadJSONObject("o.json") == {"f": 2, "g": "\u00e4"}


def test_broken_file_is_told_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "o.json").write_text('{\n"a": 1,\n"b" 2}')
    sketch = new_sketch(folder=tmp_path)
    sketch.take_over()

    with pytest.raises(SketchError, match=r"o\.json, line 3, column 5: A colon"):
        sketch.loadJSONObject("o.json")


def test_file_of_the_other_kind_is_told(tmp_path: Path) -> None:
    (tmp_path / "o.json").write_text("[1]")
    sketch = new_sketch(folder=tmp_path)
    sketch.take_over()

    with pytest.raises(SketchError, match="holds an array") as caught:
        sketch.loadJSONObject("o.json")

    assert "loadJSONArray()" in str(caught.value.hint)
