import shutil
from pathlib import Path

import pytest

from sketchkit.assets.output import write_file


def test_folders_are_made(tmp_path: Path) -> None:
    write_file(tmp_path / "a" / "b.txt", b"hello")

    assert (tmp_path / "a" / "b.txt").read_bytes() == b"hello"


def test_nothing_else_is_left(tmp_path: Path) -> None:
    write_file(tmp_path / "b.txt", b"old")
    write_file(tmp_path / "b.txt", b"new")

    assert [path.name for path in tmp_path.iterdir()] == ["b.txt"]


def test_old_file_stays_if_the_new_one_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(source: object, file: object) -> None:
        raise OSError("disk full")

    write_file(tmp_path / "b.txt", b"old")
    monkeypatch.setattr(shutil, "copyfileobj", full)

    with pytest.raises(OSError, match="disk full"):
        write_file(tmp_path / "b.txt", b"new")

    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]
