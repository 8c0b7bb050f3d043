from pathlib import Path

import pytest

from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("b.png", "a.TXT", ".hidden", "sub/c.png", "sub/deep/d.jpg"):
        path = tmp_path / "things" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("12345")
    return tmp_path


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ((), ["a.TXT", "b.png", "sub"]),
        (("files",), ["a.TXT", "b.png"]),
        (("directories",), ["sub"]),
        (("files", "directories"), ["a.TXT", "b.png", "sub"]),
        (("hidden", "files"), [".hidden", "a.TXT", "b.png"]),
        (("files", "extension=png"), ["b.png"]),
        (("files", "extensions=png|txt"), ["a.TXT", "b.png"]),
        (("recursive", "files"), ["a.TXT", "b.png", "sub/c.png", "sub/deep/d.jpg"]),
        (("recursive", "files", "extension=jpg"), ["sub/deep/d.jpg"]),
    ],
)
def test_files_of_a_folder_are_listed(
    folder: Path, options: tuple[str, ...], expected: list[str]
) -> None:
    sketch = new_sketch(folder=folder)

    paths = sketch.listPaths("things", *options)
    relative = sketch.listPaths("things", "relative", *options)

    assert [Path(path).relative_to(folder / "things").as_posix() for path in paths] == expected
    assert [Path(path).as_posix() for path in relative] == expected


@pytest.mark.parametrize(
    ("path", "option", "words"),
    [("things", "recursiv", "Do you mean 'recursive'?"), ("thing", "files", "There is no folder")],
)
def test_listing_that_cannot_be_is_told(folder: Path, path: str, option: str, words: str) -> None:
    with pytest.raises(SketchError, match=words.replace("?", r"\?")):
        new_sketch(folder=folder).listFiles(path, option)


def test_path_of_a_file_answers_as_in_java(folder: Path) -> None:
    sketch = new_sketch(folder=folder)

    path = sketch.sketchFile("things/b.png")

    assert path == str(folder / "things" / "b.png") == path.getAbsolutePath() == path.getPath()
    assert (path.getName(), path.getParent()) == ("b.png", str(folder / "things"))
    assert (path.exists(), path.isFile(), path.isDirectory(), path.length()) == (
        True,
        True,
        False,
        5,
    )
    assert [p.getName() for p in sketch.sketchFile("things/sub").listFiles()] == ["c.png", "deep"]


def test_missing_file_has_no_length(folder: Path) -> None:
    assert new_sketch(folder=folder).dataFile("none.txt").length() == 0
    assert new_sketch(folder=folder).dataFile("none.txt") == str(folder / "data" / "none.txt")


def test_folders_of_a_file_to_be_written_are_made(folder: Path) -> None:
    path = new_sketch(folder=folder).savePath("new/deep/scores.txt")

    assert path == str(folder / "new" / "deep" / "scores.txt")
    assert (folder / "new" / "deep").is_dir()
    assert not new_sketch(folder=folder).saveFile("new/deep/scores.txt").exists()
