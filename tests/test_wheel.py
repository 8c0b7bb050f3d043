"""What is installed from a wheel has all that it needs, and nothing else."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest
from hatchling.builders.wheel import WheelBuilder

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def names(tmp_path_factory: pytest.TempPathFactory) -> set[str]:
    """The names of the files in the wheel."""
    folder = tmp_path_factory.mktemp("wheel")
    (path,) = WheelBuilder(str(ROOT)).build(directory=str(folder), versions=["standard"])
    with ZipFile(path) as wheel:
        return set(wheel.namelist())


def test_every_module_is_in_it(names: set[str]) -> None:
    modules = {path.relative_to(ROOT).as_posix() for path in (ROOT / "sketchkit").rglob("*.py")}

    assert modules - names == set()


def test_every_shader_is_in_it(names: set[str]) -> None:
    shaders = [path for path in (ROOT / "shaders").rglob("*") if path.is_file()]

    assert shaders
    assert {f"sketchkit/{path.relative_to(ROOT).as_posix()}" for path in shaders} - names == set()


def test_templates_of_pages_are_in_it(names: set[str]) -> None:
    pages = ROOT / "sketchkit" / "grading" / "pages"
    files = {path.relative_to(ROOT).as_posix() for path in pages.iterdir() if path.is_file()}

    assert "sketchkit/grading/pages/comparison.html.j2" in files
    assert files - names == set()


def test_licence_is_in_it(names: set[str]) -> None:
    assert any(name.endswith("/licenses/LICENSE") for name in names)


def test_nothing_else_is_in_it(names: set[str]) -> None:
    tops = {name.partition("/")[0].partition("-")[0] for name in names}

    assert tops == {"sketchkit"}
