from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from PIL import Image

from sketchkit.cli.main import main
from tests.assets.movies.films import pictures
from tests.runtime.sketches import written

SKETCH = """
def setup():
    size(20, 10)
    frameRate(25)
def draw():
    background(frameCount, millis(), 0)
"""


def render(*args: object) -> Result:
    return CliRunner().invoke(main, ["render", "--renderer", "cpu", *map(str, args)])


def colours(path: Path) -> list[list[int]]:
    return [pixels[0, 0].tolist() for pixels, _ in pictures(path)]


def test_film_has_the_sketchs_rate_and_so_does_its_clock(tmp_path: Path) -> None:
    out = tmp_path / "film.png"

    result = render(written(tmp_path, SKETCH), "--frames", "1-4", "--out", out)

    assert result.exit_code == 0
    assert colours(out) == [[1, 0, 0], [2, 40, 0], [3, 80, 0], [4, 120, 0]]
    assert [lasts for _, lasts in pictures(out)] == [40] * 4
    assert "film.png: 4 frames of 20 x 10, 25 a second" in result.output


def test_rate_can_be_given(tmp_path: Path) -> None:
    out = tmp_path / "film.gif"

    render(written(tmp_path, SKETCH), "--frames", "1-3", "--out", out, "--fps", "10")

    assert colours(out) == [[1, 0, 0], [2, 100, 0], [3, 200, 0]]
    assert [lasts for _, lasts in pictures(out)] == [100] * 3


def test_frames_that_lie_apart_keep_time(tmp_path: Path) -> None:
    out = tmp_path / "film.gif"

    render(written(tmp_path, SKETCH), "--frames", "1-5:2", "--out", out)

    assert [lasts for _, lasts in pictures(out)] == [80] * 3


def test_film_ends_with_the_sketch(tmp_path: Path) -> None:
    sketch = written(tmp_path, SKETCH + "    if frameCount == 2: exit()\n")

    result = render(sketch, "--frames", "1-9", "--out", tmp_path / "film.gif")

    assert colours(tmp_path / "film.gif") == [[1, 0, 0], [2, 40, 0]]
    assert "draws no more after frame 2" in result.output


def test_film_of_one_frame_is_a_picture(tmp_path: Path) -> None:
    render(written(tmp_path, SKETCH), "--out", tmp_path / "still.png")

    with Image.open(tmp_path / "still.png") as picture:
        assert np.asarray(picture.convert("RGB"))[0, 0].tolist() == [1, 0, 0]


def test_mistake_leaves_no_film(tmp_path: Path) -> None:
    sketch = written(tmp_path, SKETCH + "    if frameCount == 2: elipse(1)\n")

    result = render(sketch, "--frames", "1-4", "--out", tmp_path / "film.gif")

    assert result.exit_code == 1
    assert "Do you mean ellipse?" in result.output
    assert [path.name for path in tmp_path.iterdir()] == ["sketch.py"]


def test_folder_with_a_films_name_takes_pictures(tmp_path: Path) -> None:
    (tmp_path / "out.gif").mkdir()

    render(written(tmp_path, SKETCH), "--out", tmp_path / "out.gif")

    assert [path.name for path in (tmp_path / "out.gif").iterdir()] == ["frame-0001.png"]


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (["--fps", "30"], "--fps is for a film"),
        (["--out", "notes.txt"], "notes.txt is a file; a film ends in .mp4"),
    ],
)
def test_wrong_call_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, args: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.txt").touch()

    result = render(written(tmp_path, SKETCH), *args)

    assert result.exit_code == 2
    assert said in " ".join(result.output.split())


def test_film_of_two_sketches_is_refused(tmp_path: Path) -> None:
    sketches = [written(tmp_path, SKETCH, f"{name}.py") for name in ("one", "two")]

    assert "A film shows one sketch" in render(*sketches, "--out", tmp_path / "a.gif").output
