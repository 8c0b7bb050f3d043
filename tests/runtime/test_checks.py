from pathlib import Path

import pytest

from sketchkit.runtime.checks import (
    EarlyError,
    begins_without_smoothing,
    refuse_drawing_before_size,
)
from sketchkit.runtime.source import Source
from tests.runtime.sketches import mistake, written


def source(folder: Path, text: str) -> Source:
    return Source.read(written(folder, text))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        pytest.param("size(9, 9)\nnoSmooth()", True, id="no functions"),
        pytest.param("def setup():\n    size(9, 9)\n    noSmooth()\n", True, id="setup"),
        pytest.param("def setup():\n    noSmooth()\n    smooth()\n", False, id="the last one"),
        pytest.param("def setup():\n    size(9, 9)\n", False, id="neither"),
        pytest.param("def draw():\n    noSmooth()\n", False, id="draw"),
    ],
)
def test_sketch_that_begins_without_smoothing(tmp_path: Path, text: str, expected: bool) -> None:
    assert begins_without_smoothing(source(tmp_path, text)) is expected


@pytest.mark.parametrize(
    ("text", "line"),
    [
        pytest.param("background(0)\nsize(9, 9)", 1, id="no functions"),
        pytest.param("def setup():\n    background(0)\n    size(9, 9)\n", 2, id="setup"),
        pytest.param("x = 3\nfor i in range(3):\n    rect(i, i, 1, 1)\nsize(9, 9)", 3, id="loop"),
    ],
)
def test_drawing_before_size_is_refused(tmp_path: Path, text: str, line: int) -> None:
    with pytest.raises(EarlyError, match=r"before size\(\)") as caught:
        refuse_drawing_before_size(source(tmp_path, text))

    assert caught.value.line == line


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("background(0)\nrect(1, 2, 3, 4)", id="no size"),
        pytest.param("size(9, 9)\nbackground(0)\nsize(5, 5)", id="a second size"),
        pytest.param("def tree():\n    rect(1, 2, 3, 4)\nsize(9, 9)\ntree()", id="only defined"),
        pytest.param("colorMode(HSB)\nfill(3)\nsize(9, 9)", id="no drawing"),
    ],
)
def test_drawing_that_is_not_lost_is_let_be(tmp_path: Path, text: str) -> None:
    refuse_drawing_before_size(source(tmp_path, text))


def test_drawing_before_size_is_told_with_its_line(tmp_path: Path) -> None:
    told = mistake(written(tmp_path, "def setup():\n    background(0)\n    size(9, 9)\n"))

    assert told.startswith("sketch.py, line 2: background() draws before size()")
    assert "Write size() first." in told
    assert "2 | background(0)" in told
