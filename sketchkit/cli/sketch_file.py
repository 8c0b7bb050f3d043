"""A sketch on the command line: a file, or the folder that it lies in."""

from __future__ import annotations

from pathlib import Path

import click

from sketchkit.core.errors import nearest


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
    files = [file.name for file in path.parent.glob("*.py")]
    known = nearest(path.name, files)
    hint = f" Do you mean {path.parent / known}?" if known else ""
    raise click.BadParameter(f"there is no file {text}.{hint}")


def _file_in(folder: Path) -> Path:
    """Return `spinning/spinning.py`, or the only Python file there is."""
    named = folder / f"{folder.resolve().name}.py"
    files = sorted(folder.glob("*.py"))
    if named in files:
        return named
    if len(files) == 1:
        return files[0]
    found = ", ".join(file.name for file in files) or "no Python file"
    raise click.BadParameter(f"the folder {folder} has no {named.name}, but {found}.")
