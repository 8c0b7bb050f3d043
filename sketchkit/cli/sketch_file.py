"""A sketch on the command line: a file, or the folder that it lies in."""

from __future__ import annotations

from pathlib import Path

import click

from sketchkit.core.errors import nearest
from sketchkit.runtime.source import PYTHON_MODE

ENDINGS = (".py", PYTHON_MODE)


def sketch_file(text: str) -> Path:
    """Return the file that is meant.

    Raises
    ------
    click.BadParameter
        If there is none, or more than one.
    """
    path = Path(text)
    if path.is_dir():
        return _file_in(path)
    if path.is_file():
        return path
    files = [file.name for file in _sketches(path.parent)]
    known = nearest(path.name, files)
    hint = f" Do you mean {path.parent / known}?" if known else ""
    raise click.BadParameter(f"there is no file {text}.{hint}")


def _file_in(folder: Path) -> Path:
    """Return `spinning/spinning.py`, or `spinning.pyde`, or the only such file there is."""
    name = folder.resolve().name
    files = _sketches(folder)
    for ending in ENDINGS:
        if (named := folder / f"{name}{ending}") in files:
            return named
    for ending in reversed(ENDINGS):  # beside a .pyde, a .py is a module of it
        if len(alike := [file for file in files if file.suffix == ending]) == 1:
            return alike[0]
    found = ", ".join(file.name for file in files) or "no Python file"
    raise click.BadParameter(f"the folder {folder} has no {name}.py, but {found}.")


def _sketches(folder: Path) -> list[Path]:
    return sorted(file for ending in ENDINGS for file in folder.glob(f"*{ending}"))
