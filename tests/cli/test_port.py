from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from PIL import Image

from sketchkit.cli.main import main
from tests.runtime.sketches import written

SKETCH = """
from bars import height_of

def setup():
    size(90, 60)
    noStroke()
    print "ready", width / 4

def draw():
    background(255)
    for i in xrange(5):
        fill(40 * i, 0, 0)
        rect(i * (width / 4), 0, width / 4, height_of(i))
"""
MODULE = "def height_of(i):\n    return height / (i + 2)\n"


def call(*args: object) -> Result:
    return CliRunner().invoke(main, [*map(str, args)])


def picture(sketch: Path, out: Path) -> np.ndarray:
    result = call("render", sketch, "--renderer", "cpu", "--frames", "2", "--out", out)
    assert result.exit_code == 0, result.output
    with Image.open(out / "frame-0002.png") as image:
        return np.array(image)


def test_ported_sketch_draws_the_same_picture(tmp_path: Path) -> None:
    old = written(tmp_path, SKETCH, "bars_sketch/bars_sketch.pyde")
    written(tmp_path, MODULE, "bars_sketch/bars.py")
    written(tmp_path, "data", "bars_sketch/data/notes.txt")

    result = call("port", old)

    folder = old.parent / "bars_sketch-python3"
    assert result.exit_code == 0, result.output
    assert "There is nothing to check by hand." in result.output
    assert (folder / "data" / "notes.txt").is_file()
    new = picture(folder / "bars_sketch.py", tmp_path / "new")
    assert np.array_equal(new, picture(old.parent, tmp_path / "old"))
    assert (folder / "bars.py").read_text() == MODULE.replace("height / (", "height // (")


def test_sketch_without_modules_goes_beside_itself(tmp_path: Path) -> None:
    old = written(tmp_path, "print 1\n", "old.pyde")

    result = call("port", old)

    assert result.output.splitlines()[0] == f"Written: {tmp_path / 'old.py'}"
    assert (tmp_path / "old.py").read_text() == "print(1)\n"


def test_checks_are_listed_with_file_and_line(tmp_path: Path) -> None:
    old = written(tmp_path, "x = 1\ny = cmp(x, 2)\n", "old.pyde")

    assert "  old.py, line 2: Python 3 has no cmp()" in call("port", old).output


def test_nothing_is_written_over_without_force(tmp_path: Path) -> None:
    old = written(tmp_path, "print 1\n", "old.pyde")
    new = written(tmp_path, "mine\n", "old.py")

    refused = call("port", old)

    assert refused.exit_code == 2
    assert "--force" in refused.output
    assert new.read_text() == "mine\n"
    assert call("port", old, "--force").exit_code == 0
    assert new.read_text() == "print(1)\n"


def test_out_names_the_folder(tmp_path: Path) -> None:
    old = written(tmp_path, "print 1\n", "old.pyde")

    call("port", old, "--out", tmp_path / "new")

    assert (tmp_path / "new" / "old.py").read_text() == "print(1)\n"


def test_what_is_no_python_is_told_with_its_line(tmp_path: Path) -> None:
    old = written(tmp_path, "x = 1\nif x\n    y = 2\n", "old.pyde")

    result = call("port", old)

    assert result.exit_code == 1
    assert "old.pyde, line 2: This line ends with a colon" in result.output


@pytest.mark.parametrize("command", ["render", "trace"])
def test_python_2_in_a_py_file_is_read_on_demand(tmp_path: Path, command: str) -> None:
    sketch = written(tmp_path, "print 7 / 2\n", "old.py")

    result = call(command, sketch, "--python-mode", *(["--out", tmp_path] * (command == "render")))

    assert result.exit_code == 0, result.output
    assert result.output.startswith("3\n")


def test_folder_with_a_pyde_file_is_that_sketch(tmp_path: Path) -> None:
    written(tmp_path, "print 'mine'\n", "old/old.pyde")
    written(tmp_path, "", "old/helper.py")

    assert call("trace", tmp_path / "old").output.startswith("mine\n")


def test_only_pyde_file_of_a_folder_is_the_sketch(tmp_path: Path) -> None:
    written(tmp_path, "print 'mine'\n", "folder/old.pyde")
    written(tmp_path, "", "folder/helper.py")

    assert call("trace", tmp_path / "folder").output.startswith("mine\n")
