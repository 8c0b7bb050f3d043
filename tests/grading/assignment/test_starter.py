from pathlib import Path

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.load import load
from sketchkit.grading.assignment.starter import ASSIGNMENT, FILES, write_starter
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.runtime.headless import Launch, render


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path.name}, line {line}: {text}")


def test_it_can_be_read_and_has_each_kind(tmp_path: Path) -> None:
    write_starter(tmp_path / "new")

    assert {check.kind for check in load(tmp_path / "new").checks} == set(KINDS)


@pytest.mark.parametrize("line", ['# data = "data"', '# input = "events.json"', '# uses = ["for"]'])
def test_what_is_commented_out_can_be_used(tmp_path: Path, line: str) -> None:
    write_starter(tmp_path)
    (tmp_path / "data").mkdir()
    assert line in ASSIGNMENT
    text = ASSIGNMENT.replace(line, line.removeprefix("# "))
    (tmp_path / "assignment.toml").write_text(text)

    assert load(tmp_path).checks


def test_its_reference_draws_without_a_remark(tmp_path: Path) -> None:
    write_starter(tmp_path)

    sketch = tmp_path / "reference" / "reference.py"
    (frame,) = render(Launch(sketch, refuse), (30,), CpuBackend())

    assert frame.pixels[100, 20 + 3 * 30].tolist() == [40, 80, 200]
    assert frame.pixels[5, 5].tolist() == [255, 255, 255]


@pytest.mark.parametrize("name", FILES)
def test_nothing_is_overwritten(tmp_path: Path, name: str) -> None:
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text("mine")

    with pytest.raises(AssignmentError, match=f"There is a {name} already"):
        write_starter(tmp_path)

    assert (tmp_path / name).read_text() == "mine"
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == [Path(name).name]


def test_file_is_no_place_for_it(tmp_path: Path) -> None:
    (tmp_path / "new").write_text("mine")

    with pytest.raises(AssignmentError, match="It is a file"):
        write_starter(tmp_path / "new")
