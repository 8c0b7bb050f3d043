import os
from pathlib import Path

from sketchkit.runtime.reload import Watch


def touch(path: Path, text: str, time_s: int) -> None:
    path.write_text(text)
    os.utime(path, (time_s, time_s))


def test_changed_file_is_noticed_once(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    touch(path, "1", 100)
    watch = Watch([path])
    touch(path, "2", 200)

    assert [watch.changed(), watch.changed()] == [[path], []]


def test_file_that_is_gone_for_a_moment_is_noticed_when_it_is_back(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    touch(path, "1", 100)
    watch = Watch([path])

    path.unlink()
    without = watch.changed()
    touch(path, "2", 200)

    assert [without, watch.changed()] == [[], [path]]


def test_file_is_watched_from_when_it_was_added(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    watch = Watch([])
    touch(path, "1", 100)
    watch.add([path])

    assert watch.changed() == []
