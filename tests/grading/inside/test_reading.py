from pathlib import Path

import pytest

from sketchkit.grading.inside.reading import read_sources

SOURCE = "def draw():\n    circle(1, 2, 3)\n"


@pytest.mark.parametrize("name", ["sketch.py", "SKETCH.PY", "sketch.pyde"])
def test_every_ending_of_a_sketch_is_read(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text(SOURCE)

    facts = read_sources(tmp_path)

    assert facts.calls == {"circle": 1}
    assert facts.functions == ("draw",)


def test_python_2_is_read_beside_a_sketch_of_python_mode(tmp_path: Path) -> None:
    (tmp_path / "sketch.pyde").write_text("from ball import move\n" + SOURCE)
    (tmp_path / "ball.py").write_text("def move():\n    print 'moved'\n    rect(1, 2, 3, 4)\n")

    facts = read_sources(tmp_path)

    assert {"circle", "rect", "print"} == set(facts.calls)
    assert facts.functions == ("draw", "move")


def test_a_file_that_can_only_be_python_2_is_read_as_that(tmp_path: Path) -> None:
    (tmp_path / "sketch.py").write_text("print 'begun'\nprint 'moved'\n" + SOURCE)

    assert set(read_sources(tmp_path).calls) == {"circle", "print"}


def test_a_slip_into_python_2_is_no_python(tmp_path: Path) -> None:
    (tmp_path / "sketch.py").write_text("print 'moved'\n" + SOURCE)

    assert read_sources(tmp_path).calls == {}


def test_what_is_neither_shows_nothing(tmp_path: Path) -> None:
    (tmp_path / "sketch.pyde").write_text("void draw() { circle(1, 2, 3); }\n")

    assert read_sources(tmp_path).calls == {}
