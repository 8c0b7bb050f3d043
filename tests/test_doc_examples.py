"""The examples in the docstrings of `api/` and `libraries/` run as sketches do, without a window.

Where one shows what is printed, that is compared. A remark of sketchkit's is a failure as well:
what the documentation shows gives none.
"""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sketchkit.api._sketch_parts import Phase
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.clock import VirtualClock
from sketchkit.draw.renderer import Renderer
from sketchkit.runtime.headless import Launch, opened

PACKAGE = Path(__file__).parents[1] / "sketchkit"
DOCUMENTED = (PACKAGE / "api", PACKAGE / "libraries")
WAVE = """
uniform float time = 0.5;
uniform vec3 tone = vec3(0.2, 0.5, 0.9);
varying vec4 vertColor;

void main() {
    float height = 0.5 + 0.5 * sin(gl_FragCoord.x * 0.2 + time);
    gl_FragColor = vec4(tone * height, 1.0) * vertColor;
}
"""
WITH_DOCSTRING = (ast.FunctionDef, ast.ClassDef)


def every_example() -> Iterator[doctest.DocTest]:
    parser = doctest.DocTestParser()
    for path in sorted(path for folder in DOCUMENTED for path in folder.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for name, text, line in _docstrings(tree, path.stem):
            test = parser.get_doctest(text, {}, name, str(path), line)
            if test.examples:
                yield test


def _docstrings(node: ast.AST, prefix: str) -> Iterator[tuple[str, str, int]]:
    """Yield name, text and line of the docstrings of all that is public."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, WITH_DOCSTRING) and not child.name.startswith("_"):
            name = f"{prefix}.{child.name}"
            if text := ast.get_docstring(child):
                yield name, text, child.body[0].lineno - 1
            if isinstance(child, ast.ClassDef):
                yield from _docstrings(child, name)


class _WhereGiven(doctest.OutputChecker):
    """Compares what is printed with what is shown, if anything is shown."""

    def check_output(self, want: str, got: str, optionflags: int) -> bool:
        return not want or super().check_output(want, got, optionflags)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A sketch's folder, with the files that examples use."""
    (tmp_path / "example.py").touch()
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "poem.txt").write_text("A rose\nis a rose\n", encoding="utf-8")
    (tmp_path / "data" / "ages.csv").write_text("name,age\nIda,12\nBen,9\n")
    (tmp_path / "data" / "lion.json").write_text('{"species": "Panthera leo", "id": 1}')
    (tmp_path / "data" / "zoo.xml").write_text('<zoo><animal id="1">Lion</animal></zoo>')
    (tmp_path / "data" / "house.svg").write_text(
        '<svg width="80" height="80"><rect x="9" y="30" width="60" height="50"/></svg>'
    )
    (tmp_path / "data" / "wave.glsl").write_text(WAVE, encoding="utf-8")
    photo = np.indices((40, 60, 3)).sum(axis=0).astype(np.uint8)
    Image.fromarray(photo).save(tmp_path / "data" / "photo.png")
    return tmp_path


@pytest.mark.parametrize("example", [pytest.param(e, id=e.name) for e in every_example()])
def test_example_runs(example: doctest.DocTest, folder: Path, gl_backend: GlBackend) -> None:
    remarks: list[str] = []
    launch = Launch(folder / "example.py", tell=lambda _path, _line, text: remarks.append(text))
    runner = doctest.DocTestRunner(_WhereGiven(), verbose=False)
    report: list[str] = []

    with opened(launch, Renderer(gl_backend), VirtualClock()) as loop:
        loop.begin()
        loop.program.sketch.progress.phase = Phase.SETUP
        example.globs = loop.program.namespace  # itself: functions that it defines are found there
        example.globs |= _inner_function(example, loop.program.names)
        runner.run(example, out=report.append, clear_globs=False)
        loop.program.sketch.progress.phase = Phase.DRAW
        loop.step()  # calls draw(), if the example defines one
        loop.end()

    if report or remarks:
        pytest.fail("\n".join(report + remarks), pytrace=False)


def _inner_function(example: doctest.DocTest, names: dict[str, object]) -> dict[str, object]:
    """Return the function that an example is of, if it is one of ours that sketches do not see."""
    assert example.filename is not None
    file = Path(example.filename)
    module = ".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts)
    name = example.name.removeprefix(f"{file.stem}.")
    value = getattr(importlib.import_module(module), name, None)
    is_inner = inspect.isfunction(value) and name not in names
    return {name: value} if is_inner else {}
