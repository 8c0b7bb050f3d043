"""Folders and single files as they were handed in: copied, if they are plain files."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from sketchkit.grading.intake.naming import is_litter, shown
from sketchkit.grading.intake.staging import Stage
from sketchkit.grading.intake.submission import IntakeLimits, RefusedError

CHUNK = 1 << 16


def copy_folder(folder: Path, stage: Stage, limits: IntakeLimits) -> None:
    """Put the files of a folder on a stage.

    Raises
    ------
    RefusedError
        If there is a link or a device among them, or they are more than a submission may be.
    """
    seen = 0
    for place, folders, names in os.walk(folder, onerror=_raise):
        inner = Path(place).relative_to(folder)
        folders[:] = sorted(name for name in folders if not is_litter(PurePosixPath(name)))
        seen += len(folders) + len(names)
        if seen > limits.files or len(inner.parts) > limits.depth:
            raise RefusedError(
                f"It has more than {limits.files} files, or folders deeper than {limits.depth}."
            )
        for name in folders:
            if os.path.islink(os.path.join(place, name)):
                raise RefusedError(f"The folder {shown(name)!r} is a link. Hand in the folder.")
        for name in sorted(names):
            if not is_litter(PurePosixPath(name)):
                stage.add((inner / name).as_posix(), _chunks(Path(place, name)))


def copy_file(file: Path, stage: Stage) -> None:
    """Put a single file on a stage.

    Raises
    ------
    RefusedError
        If it is a link or a device.
    """
    stage.add(file.name, _chunks(file))


def _chunks(file: Path) -> Iterator[bytes]:
    """Yield a plain file's content; nothing else is read, nor waited for."""
    if file.is_symlink():
        raise RefusedError(f"{shown(file.name)!r} is a link. Hand in the file itself.")
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    if not stat.S_ISREG(file.lstat().st_mode):
        raise RefusedError(f"{shown(file.name)!r} is not a file but a device, a pipe or a folder.")
    with os.fdopen(os.open(file, flags | getattr(os, "O_BINARY", 0)), "rb") as stream:
        while chunk := stream.read(CHUNK):
            yield chunk


def _raise(reason: OSError) -> None:
    raise reason
