import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from PIL import Image

from sketchkit.cli.main import main
from sketchkit.runtime.backends import MAKERS
from tests.runtime.sketches import written

SKETCH = """
def setup():
    size(20, 10)
def draw():
    background(frameCount, 0, 0)
    rect(2, 2, 5, 5)
"""


def render(*args: object) -> Result:
    return CliRunner().invoke(main, ["render", "--renderer", "cpu", *map(str, args)])


def names(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


def test_frames_become_files(tmp_path: Path) -> None:
    sketch = written(tmp_path, SKETCH)

    result = render(sketch, "--frames", "1,30", "--out", tmp_path / "out")

    assert result.exit_code == 0
    assert names(tmp_path / "out") == ["frame-0001.png", "frame-0030.png"]
    with Image.open(tmp_path / "out" / "frame-0030.png") as picture:
        assert (picture.mode, picture.size) == ("RGB", (20, 10))
        assert picture.getpixel((15, 8)) == (30, 0, 0)


def test_relative_folder_is_the_callers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written(tmp_path, SKETCH, "folder/sketch.py")
    monkeypatch.chdir(tmp_path)

    render("folder/sketch.py", "--json", "out/report.json")

    assert names(tmp_path / "out") == ["frame-0001.png", "report.json"]


def test_two_renders_are_the_same_bytes(tmp_path: Path) -> None:
    sketch = written(tmp_path, SKETCH)
    for out in ("a", "b"):
        render(sketch, "--out", tmp_path / out)

    one, other = (tmp_path / out / "frame-0001.png" for out in ("a", "b"))

    assert one.read_bytes() == other.read_bytes()


def test_several_sketches_have_folders_of_their_own(tmp_path: Path) -> None:
    sketches = [written(tmp_path, SKETCH, f"{name}.py") for name in ("one", "two")]

    render(*sketches, "--out", tmp_path / "out")

    assert names(tmp_path / "out") == ["one/frame-0001.png", "two/frame-0001.png"]


def test_sketches_of_the_same_name_are_refused(tmp_path: Path) -> None:
    sketches = [written(tmp_path, SKETCH, f"{name}/sketch.py") for name in ("one", "two")]

    result = render(*sketches)

    assert result.exit_code == 2
    assert "Two sketches are called sketch" in result.output


def test_folder_stands_for_its_sketch(tmp_path: Path) -> None:
    written(tmp_path, SKETCH, "spinning/spinning.py")
    written(tmp_path, "x = 1", "spinning/helpers.py")

    result = render(tmp_path / "spinning", "--out", tmp_path / "out")

    assert result.exit_code == 0


def test_report_has_all_figures(tmp_path: Path) -> None:
    sketch = written(tmp_path, SKETCH)

    render(sketch, "--seed", 5, "--json", tmp_path / "r.json", "--out", tmp_path / "out")

    report = json.loads((tmp_path / "r.json").read_text())
    assert (report["renderer"], report["seed"]) == ("cpu", 5)
    assert report["date"] == "2000-01-01T12:00:00"
    assert {"sketchkit", "python", "numpy"} <= report["versions"].keys()
    (frame,) = report["frames"]
    assert frame.items() >= {"frame": 1, "width": 20, "height": 10, "draw_calls": 1}.items()
    assert frame["vertices"] >= 4
    assert frame["ms"] > 0


def test_mistake_is_told_and_the_other_sketches_are_drawn(tmp_path: Path) -> None:
    broken = written(tmp_path, "elipse(1, 2, 3, 4)", "broken.py")
    good = written(tmp_path, SKETCH, "good.py")

    result = render(broken, good, "--out", tmp_path / "out", "--json", tmp_path / "r.json")

    assert result.exit_code == 1
    assert "broken.py, line 1: elipse is not defined." in result.stderr
    assert "Traceback" not in result.stderr
    assert names(tmp_path / "out") == ["good/frame-0001.png"]
    (mistake,) = json.loads((tmp_path / "r.json").read_text())["mistakes"]
    assert mistake["line"] == 1


def test_traceback_is_shown_on_request(tmp_path: Path) -> None:
    result = render(written(tmp_path, "1 / 0"), "--traceback", "--out", tmp_path / "out")

    assert "Traceback (most recent call last)" in result.stderr


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (["spining.py"], "there is no file"),
        (["spinning.py", "--frames", "x"], "none of 3, 1,30"),
        (["spinning.py", "--renderer", "java"], "'java'"),
        ([], "SKETCH"),
    ],
)
def test_wrong_call_is_exit_status_2(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, args: list[str], words: str
) -> None:
    written(tmp_path, SKETCH, "spinning.py")
    monkeypatch.chdir(tmp_path)

    result = render(*args)

    assert result.exit_code == 2
    assert words in result.output


def test_nearest_file_is_named(tmp_path: Path) -> None:
    written(tmp_path, SKETCH, "spinning.py")

    assert "spinning.py?" in render(tmp_path / "spining.py").output


def test_without_opengl_the_cpu_draws_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(MAKERS, "gl", ("no_such_module", "GlBackend"))
    sketch = str(written(tmp_path, SKETCH))

    by_itself = CliRunner().invoke(main, ["render", sketch, "--out", str(tmp_path / "out")])
    on_request = CliRunner().invoke(main, ["render", sketch, "--renderer", "gl"])

    assert by_itself.exit_code == 0
    assert by_itself.stderr.count("CPU renderer") == 1
    assert on_request.exit_code == 2


def test_output_of_the_sketch_comes_through(tmp_path: Path) -> None:
    result = render(written(tmp_path, "print('hello')"), "--out", tmp_path / "out")

    assert result.stdout == "hello\n"
