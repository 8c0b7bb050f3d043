import io

import pytest
from PIL import Image

import sketchkit
from sketchkit.core.errors import SketchError
from sketchkit.notebooks.magic import sketch
from sketchkit.runtime.report import StoppedError

CELL = "def setup(): size(20, 10)\ndef draw(): background(frameCount, 0, 0)\n"


class Shell:
    """Remembers what was registered."""

    def __init__(self) -> None:
        self.magics: list[tuple[object, str, str]] = []

    def register_magic_function(self, func: object, magic_kind: str, magic_name: str) -> None:
        self.magics.append((func, magic_kind, magic_name))


def test_extension_brings_the_magic() -> None:
    shell = Shell()

    sketchkit.load_ipython_extension(shell)

    assert shell.magics == [(sketch, "cell", "sketch")]


def test_cell_shows_its_first_frame() -> None:
    png = sketch("--renderer cpu", CELL)._repr_png_()

    with Image.open(io.BytesIO(png)) as image:
        assert (image.size, getattr(image, "n_frames", 1)) == ((20, 10), 1)
        assert image.convert("RGB").getpixel((0, 0)) == (1, 0, 0)


def test_several_frames_move() -> None:
    png = sketch("--renderer cpu --frames 1-4 --fps 10", CELL)._repr_png_()

    with Image.open(io.BytesIO(png)) as image:
        image.seek(3)
        assert (image.n_frames, image.info["duration"]) == (4, 100)
        assert image.convert("RGB").getpixel((0, 0)) == (4, 0, 0)


def test_mistake_names_the_cells_line() -> None:
    with pytest.raises(StoppedError, match=r"cell\.py, line 1: elipse is not defined"):
        sketch("--renderer cpu", "elipse(1, 2, 3, 4)")


def test_wrong_option_is_told() -> None:
    with pytest.raises(SketchError, match="--frame"):
        sketch("--renderers cpu --frame", CELL)
