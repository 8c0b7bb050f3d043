import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from PIL import Image

from sketchkit.cli.main import main
from sketchkit.grading.pages import writing


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a.png, the same as same.png, and what is turned upside down."""
    pixels = np.full((40, 60, 3), 255, np.uint8)
    pixels[5:15, 8:30] = (200, 30, 0)
    for name, picture in (("a", pixels), ("same", pixels), ("turned", pixels[::-1])):
        Image.fromarray(picture).save(tmp_path / f"{name}.png")
    return tmp_path


def diff(folder: Path, *arguments: str) -> Result:
    paths = [
        argument if argument.startswith("-") else str(folder / argument) for argument in arguments
    ]
    return CliRunner().invoke(main, ["diff", *paths])


def test_alike_is_exit_status_0(folder: Path) -> None:
    result = diff(folder, "a.png", "same.png")

    assert result.exit_code == 0
    assert result.stdout.splitlines()[0] == "alike"


def test_different_is_exit_status_1_with_the_reason(folder: Path) -> None:
    result = diff(folder, "turned.png", "a.png")

    assert result.exit_code == 1
    assert result.stdout.startswith(
        "different\nTurned upside down, your picture is the expected one.\n"
    )
    assert "FLIP  mean" in result.stdout
    assert "largest region  220 pixels (of 12), 22 x 10 from (8, " in result.stdout


@pytest.mark.parametrize(
    ("name", "words"), [("none.png", "There is no file"), ("text.png", "is no picture")]
)
def test_wrong_call_is_exit_status_2_with_a_sentence(folder: Path, name: str, words: str) -> None:
    (folder / "text.png").write_text("hello")

    result = diff(folder, name, "a.png")

    assert result.exit_code == 2
    assert words in result.stderr
    assert result.stdout == ""


def test_page_holds_everything_itself(folder: Path) -> None:
    result = diff(folder, "turned.png", "a.png", "--page", "out.html")

    page = (folder / "out.html").read_text(encoding="utf-8")
    assert result.exit_code == 1
    assert page.count('src="data:image/png;base64,') == 3  # drawn, expected, difference
    assert "Turned upside down, your picture is the expected one." in page
    assert "http" not in page.replace('http-equiv="', "")


def test_page_without_jinja_is_a_sentence(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    writing._renderer.cache_clear()

    result = diff(folder, "turned.png", "a.png", "--page", "out.html")

    assert result.exit_code == 2
    assert 'pip install "sketchkit[grade]"' in result.stderr
    assert not (folder / "out.html").exists()


def test_without_scipy_it_says_what_to_install(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    monkeypatch.setitem(sys.modules, "scipy.ndimage", None)
    for name in [name for name in sys.modules if name.startswith("sketchkit.grading.images")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delitem(sys.modules, "sketchkit.cli.diff", raising=False)
    monkeypatch.delitem(sys.modules, "sketchkit.grading.pages.diff", raising=False)

    result = diff(folder, "a.png", "same.png")

    assert result.exit_code == 2
    assert 'pip install "sketchkit[grade]"' in result.stderr
