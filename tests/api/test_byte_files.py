from __future__ import annotations

import gzip
from pathlib import Path

import pytest

from sketchkit.api.sketch import Sketch
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import new_sketch


@pytest.fixture
def sketch(tmp_path: Path) -> Sketch:
    made = new_sketch(folder=tmp_path)
    made.take_over()
    return made


def test_bytes_come_back_as_they_were_saved(sketch: Sketch) -> None:
    sketch.saveBytes("out/a.dat", [0, 127, -1, 255])

    assert list(sketch.loadBytes("out/a.dat")) == [0, 127, 255, 255]


def test_packed_files_are_packed_and_unpacked(sketch: Sketch, tmp_path: Path) -> None:
    sketch.saveStrings("a.txt.gz", ["one", "two"])

    assert gzip.decompress((tmp_path / "a.txt.gz").read_bytes()) == b"one\ntwo\n"
    assert sketch.loadStrings("a.txt.gz") == ["one", "two"]


def test_file_that_is_not_packed_is_told(sketch: Sketch, tmp_path: Path) -> None:
    (tmp_path / "a.gz").write_bytes(b"plain")

    with pytest.raises(SketchError, match="no file that gzip has packed"):
        sketch.loadBytes("a.gz")


def test_writer_shows_nothing_before_it_is_closed(sketch: Sketch, tmp_path: Path) -> None:
    output = sketch.createWriter("a.txt")
    output.println("x", 1)
    output.print(2)

    assert not (tmp_path / "a.txt").exists()
    output.close()

    assert (tmp_path / "a.txt").read_text() == "x 1\n2"
    with pytest.raises(SketchError, match="is closed"):
        output.println("more")


def test_writer_whose_block_fails_leaves_the_old_file(sketch: Sketch, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("old")

    with pytest.raises(ZeroDivisionError), sketch.createWriter("a.txt") as output:
        output.println(1 / 0)

    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a.txt", "old")]


@pytest.mark.parametrize("create", ["createWriter", "createOutput"])
def test_file_that_is_never_closed_is_remarked_on_at_the_end(sketch: Sketch, create: str) -> None:
    lost = getattr(sketch, create)("lost.txt")
    flushed = getattr(sketch, create)("flushed.txt")
    closed = getattr(sketch, create)("closed.txt")
    for file in (lost, flushed, closed):
        file.write("abc" if create == "createWriter" else b"abc")
    flushed.flush()
    closed.close()

    with pytest.warns(SketchWarning) as remarks:
        sketch.remark_on_lost_files()

    assert [str(remark.message) for remark in remarks] == [
        "lost.txt is not written in full: close() it at the end."
    ]


def test_reader_gives_line_by_line(sketch: Sketch) -> None:
    sketch.saveStrings("a.txt", ["one", "two", "three"])
    reader = sketch.createReader("a.txt")

    assert (reader.readLine(), list(reader), reader.readLine()) == ("one", ["two", "three"], None)


def test_streams_copy(sketch: Sketch) -> None:
    with sketch.createOutput("a.dat") as output:
        output.write(b"ab")
        output.write(99)

    assert sketch.saveStream("b.dat", sketch.createInput("a.dat"))
    assert sketch.loadBytes("b.dat") == b"abc"


@pytest.mark.parametrize("data", [[256], ["a"], 3.5, None])
def test_what_is_no_byte_is_told(sketch: Sketch, data: object) -> None:
    with pytest.raises(SketchError, match="from -128 to 255"):
        sketch.saveBytes("a.dat", data)


def test_folder_in_the_way_is_told(sketch: Sketch, tmp_path: Path) -> None:
    (tmp_path / "a.txt").mkdir()

    with pytest.raises(SketchError, match=r"a\.txt cannot be written"):
        sketch.saveStrings("a.txt", ["x"])


def test_internet_is_not_read_where_time_is_virtual(sketch: Sketch) -> None:
    with pytest.raises(SketchError, match="every run must give the same"):
        sketch.loadStrings("https://example.org/a.txt")
