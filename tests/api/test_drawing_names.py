"""Every name of Processing's that draws, and is in common use, is here, documented and tried.

`drawing_names.csv` lists them: the names of Processing's reference and source, of tier 1 (in the
reference, or used by coursework) and 2 (used by other sketches), in the categories of drawing.
Make it anew from a table of owner, name, kind and tier of all of Processing's public names.
"""

from __future__ import annotations

import csv
import inspect
import re
from functools import cache
from pathlib import Path

import pytest

from sketchkit.api.names import groups_of, joined, live_values
from sketchkit.api.sketch import Sketch
from tests.canvases import flat_canvas

TESTS = Path(__file__).parents[1]
LIST = Path(__file__).with_name("drawing_names.csv")

# What a sketch in Python has no use for.
JAVA_ALONE = {
    *((("PImage", name)) for name in ("checkAlpha", "getImage", "getNative", "init", "loadTGA")),
    *(("PImage", f"getModified{edge}") for edge in ("X1", "X2", "Y1", "Y2")),
    *(("PImage", name) for name in ("isLoaded", "isModified", "setLoaded", "setModified")),
    *(("PShader", name) for name in ("init", "setFragmentShader", "setVertexShader")),
    *(("PShape", name) for name in ("set3D", "setFamily", "setKind", "setPath")),
    ("", "PGraphicsOpenGL"),
    ("PShader", "glProgram"),  # a number for the calls of OpenGL in beginPGL()
}


KIND_OF_MATRIX = {"PMatrix": "PMatrix3D"}  # what PMatrix is in Java: what all matrices can do


def every_name() -> list[tuple[str, str, str]]:
    with LIST.open(encoding="utf-8") as file:
        rows = [(row["owner"], row["name"], row["kind"]) for row in csv.DictReader(file)]
    return [row for row in rows if row[:2] not in JAVA_ALONE]


@cache
def names() -> dict[str, object]:
    sketch = Sketch(flat_canvas())
    return joined(groups_of(sketch)) | live_values(sketch)


@cache
def words_of_tests() -> frozenset[str]:
    files = [path for path in TESTS.rglob("*.py") if path != Path(__file__)]
    texts = [path.read_text(encoding="utf-8") for path in files]
    return frozenset(word for text in texts for word in re.findall(r"\w+", text))


@cache
def words_of_examples() -> frozenset[str]:
    """Return the words in the examples of all docstrings: they are run as tests."""
    api = TESTS.parent / "sketchkit" / "api"
    lines = [line for path in api.rglob("*.py") for line in path.read_text("utf-8").splitlines()]
    code = [line for line in lines if line.strip().startswith((">>>", "..."))]
    return frozenset(word for line in code for word in re.findall(r"\w+", line))


def found(owner: str, name: str) -> object:
    """Return what a name stands for; as it is defined, where it is a part of a class."""
    if not owner:
        return names()[name]
    return inspect.getattr_static(names()[KIND_OF_MATRIX.get(owner, owner)], name)


parametrized = pytest.mark.parametrize(
    ("owner", "name", "kind"),
    [pytest.param(*row, id=".".join(filter(None, row[:2]))) for row in every_name()],
)


@parametrized
def test_name_is_there(owner: str, name: str, kind: str) -> None:
    found(owner, name)


@parametrized
def test_name_is_documented_with_an_example(owner: str, name: str, kind: str) -> None:
    if kind in ("constant", "variable"):
        return

    text = found(owner, name).__doc__ or ""

    assert "Examples\n" in text


@parametrized
def test_name_is_tried(owner: str, name: str, kind: str) -> None:
    if kind != "constant":
        assert name in words_of_tests() | words_of_examples()
