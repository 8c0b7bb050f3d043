"""Where the files of a sketch are: in its `data` folder, then beside it.

The folder is the running sketch's. There is one of it in a process at a time, so it is kept here:
images, fonts and models find their files without a canvas that knows of folders.
"""

from __future__ import annotations

from pathlib import Path

from sketchkit.core.errors import SketchError, nearest, shown

_sketch_folder = Path()
_read: set[Path] = set()
_written: set[Path] = set()


def set_sketch_folder(folder: Path) -> None:
    """Say where the running sketch lies."""
    global _sketch_folder
    _sketch_folder = folder
    _read.clear()
    _written.clear()


def sketch_folder() -> Path:
    """Return where the running sketch lies."""
    return _sketch_folder


def note_read(path: Path) -> None:
    """Take that the running sketch has read a file."""
    _read.add(path.absolute())


def note_written(path: Path) -> None:
    """Take that the running sketch has written a file."""
    _written.add(path.absolute())


def files_read() -> set[Path]:
    """Return the files that the running sketch has read and has not written itself."""
    return _read - _written


def search_folders() -> list[Path]:
    """Return the folders in which a sketch's files are looked for, the first one first."""
    return [_sketch_folder / "data", _sketch_folder]


def find_file(caller: str, filename: str) -> Path:
    """Return the path of a file that a sketch names.

    Parameters
    ----------
    caller : str
        The function that was called, for messages.
    filename : str
        As the sketch wrote it; with or without folders, or a full path.

    Raises
    ------
    SketchError
        If there is no such file; it names the nearest one that there is.
    """
    try:
        name = Path(filename)
    except TypeError:
        raise SketchError(
            f"{caller}() takes the name of a file.", got=f"{caller}({shown(filename)})"
        ) from None
    places = [folder / name for folder in search_folders()]
    for path in places:
        if path.is_file():
            note_read(path)
            return path
    folders = dict.fromkeys(path.parent for path in places)
    known = nearest(name.name, _names(list(folders)))
    raise SketchError(
        f"There is no file {name} in {' or '.join(map(str, folders))}.",
        got=f"{caller}({shown(filename)})",
        hint=f"Do you mean {known!r}?" if known else "Put it into the sketch's data folder.",
    )


def _names(folders: list[Path]) -> list[str]:
    """Return the names of the files in folders."""
    return [
        path.name
        for folder in folders
        if folder.is_dir()
        for path in sorted(folder.iterdir())
        if path.is_file()
    ]
