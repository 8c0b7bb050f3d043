import builtins

import pytest

from sketchkit.api.names import TwinNamesError, groups_of, joined, live_values, names_of
from tests.api.sketches import new_sketch


def test_no_name_is_in_two_groups() -> None:
    joined(groups_of(new_sketch()))


def test_twins_are_told() -> None:
    with pytest.raises(TwinNamesError, match="b has names that another group has too: fill"):
        joined({"a": {"fill": 1, "rect": 2}, "b": {"fill": 3}})


def test_drawing_functions_are_the_canvas_own_methods() -> None:
    sketch = new_sketch()

    names = names_of(sketch)

    assert names["rect"] == sketch.canvas.rect
    assert names["g"] is sketch.canvas
    assert names["this"] is sketch


def test_inner_names_stay_inside() -> None:
    names = names_of(new_sketch())

    inner = {"canvas", "folder", "namespace", "progress", "target", "resize", "attach"}
    assert not inner & names.keys()
    assert not [name for name in names if name.startswith("_")]


def test_live_values_are_not_among_the_lasting_names() -> None:
    sketch = new_sketch()

    lasting = joined(groups_of(sketch))

    assert {"mouseX", "width", "frameCount", "frameRate", "keyPressed"} <= live_values(
        sketch
    ).keys()
    assert not live_values(sketch).keys() & lasting.keys()


@pytest.mark.parametrize(
    "name",
    [
        name
        for group in ("canvas", "sketch", "maths", "strings", "conversions", "arrays", "overlaps")
        for name in groups_of(new_sketch())[group]
    ],
)
def test_function_is_documented_with_an_example(name: str) -> None:
    value = names_of(new_sketch())[name]
    doc = value.__doc__ if callable(value) else getattr(type(new_sketch()), name).__doc__

    assert "Examples\n" in str(doc)


@pytest.mark.parametrize("name", sorted(live_values(new_sketch())))
def test_live_value_is_documented_with_an_example(name: str) -> None:
    sketch = new_sketch()
    owner = type(sketch) if hasattr(type(sketch), name) else type(sketch.canvas)

    assert ">>>" in str(getattr(owner, name).__doc__)


def test_python_names_that_are_hidden_are_known() -> None:
    hidden = {name for name in names_of(new_sketch()) if hasattr(builtins, name)}

    assert hidden <= {
        *("abs", "map", "max", "min", "pow", "round"),
        *("exit", "filter", "hex", "open", "print", "set"),
    }
