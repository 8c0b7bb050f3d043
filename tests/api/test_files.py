from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sketchkit.api.files import numbered
from sketchkit.api.sketch import Sketch
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import P2D
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import new_sketch
from tests.canvases import new_canvas


def sketch_in(folder: Path) -> Sketch:
    sketch = new_sketch(folder=folder)
    sketch.take_over()
    return sketch


def test_lines_come_back_as_they_were_saved(tmp_path: Path) -> None:
    sketch = sketch_in(tmp_path)

    sketch.saveStrings("out/scores.txt", ["anna 12", 3, "\u00fc"])

    assert sketch.loadStrings("out/scores.txt") == ["anna 12", "3", "\u00fc"]


def test_data_folder_comes_first(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "a.txt").write_text("data\r\nfolder")
    (tmp_path / "a.txt").write_text("beside")

    assert sketch_in(tmp_path).loadStrings("a.txt") == ["data", "folder"]


def test_text_in_latin_1_is_read_and_remarked_on(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes("K\u00f6ln\r\nBonn".encode("latin-1"))

    with pytest.warns(SketchWarning, match="a.txt is no text in UTF-8"):
        assert sketch_in(tmp_path).loadStrings("a.txt") == ["K\u00f6ln", "Bonn"]


def test_paths_are_the_sketchs(tmp_path: Path) -> None:
    sketch = sketch_in(tmp_path)

    assert sketch.sketchPath() == str(tmp_path)
    assert sketch.sketchPath("a.txt") == str(tmp_path / "a.txt")
    assert sketch.dataPath("a.txt") == str(tmp_path / "data" / "a.txt")


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("spin-####.png", "spin-0007.png"),
        ("frames/##.tif", "frames/07.tif"),
        ("#-#.png", "007.png"),
        ("take-#.png", "take-#.png"),
        ("still.png", "still.png"),
    ],
)
def test_numbers_of_frames(name: str, file: str) -> None:
    assert numbered(name, 7) == file


@pytest.mark.parametrize("ending", ["png", "tif", "tga", "bmp"])
def test_picture_holds_what_was_drawn(tmp_path: Path, ending: str) -> None:
    canvas = new_canvas(P2D, CpuBackend(), (8, 6))
    sketch = Sketch(canvas, folder=tmp_path)
    sketch.size(8, 6)
    canvas.background(200, 100, 50)

    sketch.save(f"out/picture.{ending}")

    with Image.open(tmp_path / "out" / f"picture.{ending}") as picture:
        assert picture.mode == "RGB"
        assert (np.asarray(picture) == (200, 100, 50)).all()


def test_picture_without_ending_is_a_tif(tmp_path: Path) -> None:
    sketch_in(tmp_path).saveFrame("shot-##")

    assert [path.name for path in tmp_path.iterdir()] == ["shot-00.tif"]


def test_unknown_kind_of_picture_is_told(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match=r"ends in one of .*\.png"):
        sketch_in(tmp_path).save("a.docx")
