import os
from pathlib import Path

from sketchkit.runtime.reload import Watch


def touch(path: Path, text: str, time_s: int) -> None:
    path.write_text(text)
    os.utime(path, (time_s, time_s))


def test_changed_file_is_noticed_once_it_is_at_rest(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    touch(path, "1", 100)
    watch = Watch([path])
    touch(path, "2", 200)

    assert [watch.changed() for _ in range(4)] == [[], [path], [], []]


def test_file_that_is_gone_for_a_moment_is_noticed_when_it_is_back(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    touch(path, "1", 100)
    watch = Watch([path])

    path.unlink()
    without = [watch.changed() for _ in range(3)]
    touch(path, "2", 200)

    assert without == [[], [], []]
    assert [watch.changed(), watch.changed()] == [[], [path]]


def test_empty_file_is_still_being_written(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    touch(path, "1", 100)
    watch = Watch([path])

    touch(path, "", 200)

    assert [watch.changed() for _ in range(3)] == [[], [], []]


def test_files_that_are_saved_one_after_the_other_are_told_together(tmp_path: Path) -> None:
    paths = [tmp_path / "a.py", tmp_path / "b.py"]
    for path in paths:
        touch(path, "1", 100)
    watch = Watch(paths)

    touch(paths[0], "2", 200)
    first = watch.changed()
    touch(paths[1], "2", 200)

    assert [first, watch.changed(), watch.changed()] == [[], [], paths]


def test_file_is_watched_from_when_it_was_added(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    watch = Watch([])
    touch(path, "1", 100)
    watch.add([path])

    assert watch.changed() == []
