from __future__ import annotations

from pathlib import Path

import pytest

from sketchkit.api.sketch import Sketch
from sketchkit.core.constants import P2D, PDF, SVG
from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch


def drawn_in(folder: Path) -> Sketch:
    """Return a sketch whose first frame has begun."""
    sketch = new_sketch(folder=folder)
    sketch.size(60, 40, P2D)
    sketch.progress.frame_count = 7
    return sketch


@pytest.mark.parametrize(
    ("kind", "name", "begin"), [(SVG, "a.svg", b"<?xml"), (PDF, "b.pdf", b"%PDF-")]
)
def test_file_is_written_beside_the_sketch(
    tmp_path: Path, kind: str, name: str, begin: bytes
) -> None:
    sketch = drawn_in(tmp_path)

    sketch.beginRecord(kind, name)
    sketch.canvas.rect(10, 10, 20, 20)  # type: ignore[attr-defined] # a PGraphics
    sketch.endRecord()

    assert (tmp_path / name).read_bytes().startswith(begin)


def test_number_signs_become_the_frame(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)

    sketch.beginRaw(SVG, "frames/page-####.svg")
    sketch.endRaw()

    assert [path.name for path in (tmp_path / "frames").iterdir()] == ["page-0007.svg"]


def test_only_what_is_drawn_in_between_is_in_the_file(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)
    canvas = sketch.canvas

    canvas.circle(5, 5, 3)  # type: ignore[attr-defined] # a PGraphics
    sketch.beginRecord(SVG, "a.svg")
    canvas.rect(10, 10, 20, 20)  # type: ignore[attr-defined] # a PGraphics
    sketch.endRecord()
    canvas.circle(9, 9, 3)  # type: ignore[attr-defined] # a PGraphics
    canvas.end_frame()

    text = (tmp_path / "a.svg").read_text()
    assert text.count("<rect") == 1
    assert "<ellipse" not in text
    assert 'width="60" height="40"' in text


def test_record_and_raw_may_go_on_together(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)

    sketch.beginRecord(SVG, "a.svg")
    sketch.beginRaw(SVG, "b.svg")
    sketch.canvas.rect(10, 10, 20, 20)  # type: ignore[attr-defined] # a PGraphics
    sketch.endRecord()
    sketch.endRaw()

    assert "<rect" in (tmp_path / "a.svg").read_text()
    assert "<path" in (tmp_path / "b.svg").read_text()


def test_end_without_begin_is_told() -> None:
    with pytest.raises(SketchError, match=r"endRecord\(\) without beginRecord\(\)"):
        new_sketch().endRecord()


def test_second_begin_is_told(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)
    sketch.beginRecord(SVG, "a.svg")

    with pytest.raises(SketchError, match=r"while a.svg is being recorded"):
        sketch.beginRecord(SVG, "b.svg")


def test_unknown_kind_is_told(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match="To draw into a file takes SVG or PDF"):
        drawn_in(tmp_path).beginRecord(P2D, "a.svg")


def test_file_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.svg").mkdir()
    sketch = drawn_in(tmp_path)
    sketch.beginRecord(SVG, "a.svg")

    with pytest.raises(SketchError, match=r"a.svg cannot be written: "):
        sketch.endRecord()


def test_canvas_out_of_sight_is_drawn_into_its_file(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)

    canvas = sketch.createGraphics(30, 20, SVG, "small.svg")
    with canvas.beginDraw():  # type: ignore[attr-defined] # a PGraphics
        canvas.rect(1, 2, 3, 4)  # type: ignore[attr-defined] # a PGraphics
    sketch.canvas.circle(9, 9, 3)  # type: ignore[attr-defined] # a PGraphics

    text = (tmp_path / "small.svg").read_text()
    assert 'width="30" height="20"' in text
    assert text.count("<rect") == 1


def test_file_of_size_is_written_at_the_end(tmp_path: Path) -> None:
    sketch = new_sketch(folder=tmp_path)

    sketch.size(60, 40, PDF, "all.pdf")
    sketch.canvas.rect(1, 2, 3, 4)  # type: ignore[attr-defined] # a PGraphics
    is_early = (tmp_path / "all.pdf").exists()
    sketch.write_files()

    assert not is_early
    assert (tmp_path / "all.pdf").read_bytes().startswith(b"%PDF-")


def test_file_without_a_name_is_told(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match="and the file's name"):
        new_sketch(folder=tmp_path).size(60, 40, PDF)


def test_file_that_is_still_open_at_the_end_is_written(tmp_path: Path) -> None:
    sketch = drawn_in(tmp_path)
    sketch.beginRecord(SVG, "a.svg")
    sketch.canvas.rect(1, 2, 3, 4)  # type: ignore[attr-defined] # a PGraphics

    sketch.write_files()

    assert "<rect" in (tmp_path / "a.svg").read_text()
