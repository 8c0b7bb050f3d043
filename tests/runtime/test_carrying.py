from pathlib import Path
from types import ModuleType

import pytest

from sketchkit.runtime.carrying import adopt, begins_alike, carry
from sketchkit.runtime.source import Source
from tests.runtime.sketches import written


def source(folder: Path, text: str) -> Source:
    return Source.read(written(folder, text))


def run(text: Source) -> dict[str, object]:
    names = vars(ModuleType("__main__"))
    exec(text.code, names)
    return names


def carried(
    folder: Path, old: str, new: str, now: dict[str, object] | None = None
) -> dict[str, object]:
    """Return what the new text's variables are; `now` are values that the old ones had got."""
    before = source(folder, old)
    names = run(before) | (now or {})
    after = source(folder, new)
    fresh = run(after)
    carry(names, fresh, before, after)
    return fresh


@pytest.mark.parametrize(
    ("old", "new", "value"),
    [
        pytest.param("x = 1", "x = 1\ny = 2", 50, id="its line is the same"),
        pytest.param("x = 1", "x = 7", 7, id="its line was edited"),
        pytest.param("y = 1", "y = 1", 50, id="setup() has made it"),
        pytest.param("x = 1", "def x(): pass\nx = x.__name__", "x", id="it is another thing now"),
    ],
)
def test_variable_keeps_its_value_unless_its_line_was_edited(
    tmp_path: Path, old: str, new: str, value: object
) -> None:
    assert carried(tmp_path, old, new, {"x": 50})["x"] == value


def test_functions_are_the_new_ones(tmp_path: Path) -> None:
    names = carried(tmp_path, "def f(): return 1", "def f(): return 2")

    assert names["f"]() == 2  # type: ignore[operator]


def test_objects_belong_to_the_new_class_however_deep_they_lie(tmp_path: Path) -> None:
    old = "class Ball:\n    other = None\n    def size(self): return 1\nballs = [Ball()]\n"
    before, after = source(tmp_path, old), source(tmp_path, old.replace("1", "2"))
    names = run(before)
    ball = names["balls"][0]  # type: ignore[index]
    ball.other = {"next": (type(ball)(),)}
    fresh = run(after)

    carry(names, fresh, before, after)
    adopt([fresh])

    assert [one.size() for one in (ball, ball.other["next"][0])] == [2, 2]
    assert isinstance(ball, fresh["Ball"])  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("new", "is_alike"),
    [("def setup():\n    size(1, 2)  # small\n", True), ("def setup():\n    size(1, 3)\n", False)],
)
def test_begins_alike_while_setup_is_the_same(tmp_path: Path, new: str, is_alike: bool) -> None:
    old = source(tmp_path, "def setup():\n    size(1, 2)\n")

    assert begins_alike(old, source(tmp_path, new)) is is_alike
