import pytest

from sketchkit.assets.models.json_place import JsonPlace
from sketchkit.core.errors import SketchError
from tests.assets.models.model_files import DATA

PATH = DATA / "triangle.gltf"


def parsed(text):
    return JsonPlace.parsed(PATH, text)


def test_values_know_how_one_gets_to_them():
    document = parsed(b'{"a": {"b": [1, {"c": 2}]}}')

    place = list(document["a"]["b"])[1]["c"]

    assert place.trail == "a.b[1].c"
    assert place.whole() == 2


def test_what_is_missing_takes_the_default():
    nothing = parsed(b"{}")["a"]

    assert nothing.whole(3) == 3
    assert nothing.text("x") == "x"
    assert nothing.numbers((1.0, 2.0)) == (1.0, 2.0)
    assert list(nothing) == []


@pytest.mark.parametrize(
    ("text", "read"),
    [
        pytest.param(b'{"a": -1}', lambda place: place.whole(), id="below 0"),
        pytest.param(b'{"a": 1.5}', lambda place: place.whole(), id="fraction"),
        pytest.param(b'{"a": true}', lambda place: place.whole(), id="truth value"),
        pytest.param(b"{}", lambda place: place.whole(), id="missing number"),
        pytest.param(b'{"a": 1}', lambda place: place.text(), id="no text"),
        pytest.param(b'{"a": [1]}', lambda place: place.numbers((0.0, 0.0)), id="one of two"),
        pytest.param(b'{"a": [NaN]}', lambda place: place.numbers((0.0,)), id="nan"),
        pytest.param(b'{"a": 1}', lambda place: list(place), id="no list"),
        pytest.param(b'{"a": 1}', lambda place: place["b"], id="no object"),
        pytest.param(b'{"a": 1}', lambda place: place.of([], "nodes"), id="of none"),
    ],
)
def test_a_value_of_another_kind_is_told_with_its_place(text, read):
    place = parsed(text)["a"]

    with pytest.raises(SketchError, match=r"triangle\.gltf, a(\[0\])?: there has to be a"):
        read(place)
