"""The submissions of a class: each is staged, or refused with a sentence; the others go on."""

from __future__ import annotations

import shutil
import stat
from collections.abc import Iterable
from pathlib import Path

from sketchkit.grading.intake.copying import copy_file, copy_folder
from sketchkit.grading.intake.entry import find_sketch
from sketchkit.grading.intake.naming import LITTER, shown, slugs
from sketchkit.grading.intake.staging import SOURCES, Stage
from sketchkit.grading.intake.submission import IntakeLimits, RefusedError, Submission
from sketchkit.grading.intake.unpack import unpack

OTHER_ARCHIVES = (".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz", ".dmg")
# Of an archive with a whole class in it. It comes from a learning platform, not from a student.
CLASS_LIMITS = IntakeLimits(files=50_000, file_mb=500, total_mb=20_000, source_kb=1 << 20, depth=24)
WHOLE_CLASS = ".whole-class"


class IntakeError(Exception):
    """There is nothing to grade, and why."""


def collect(
    submissions: Path, staging: Path, *, limits: IntakeLimits | None = None
) -> tuple[Submission, ...]:
    """Stage all submissions of a class.

    Parameters
    ----------
    submissions : Path
        A folder of folders, of zips, or of single files, in any mixture; or a zip of that.
    staging : Path
        A folder for the copies: each is in a folder with its slug as the name. What lies there
        from an earlier time is replaced.
    limits : IntakeLimits, optional

    Returns
    -------
    tuple of Submission
        Sorted by name. Those that cannot be run are among them, with their refusal.

    Raises
    ------
    IntakeError
        If there is no such folder, or nothing in it.
    """
    entries = sorted(_entries(submissions, staging), key=_name)
    if not entries:
        raise IntakeError(
            f"There are no submissions in {submissions}. "
            "It holds a folder, a zip file or a Python file for each student."
        )
    names = [_name(entry) for entry in entries]
    return tuple(
        _staged(entry, name, slug, staging, limits or IntakeLimits())
        for entry, name, slug in zip(entries, names, slugs(names), strict=True)
    )


def _entries(submissions: Path, staging: Path) -> Iterable[Path]:
    if submissions.is_dir():
        folder = submissions
    elif submissions.is_file() and submissions.suffix.lower() == ".zip":
        folder = _unpacked_class(submissions, staging / WHOLE_CLASS)
    else:
        raise IntakeError(
            f"{submissions} is neither a folder nor a zip. Give the folder with all submissions."
        )
    return [
        entry
        for entry in folder.iterdir()
        if entry.name not in LITTER and not entry.name.startswith(".")
    ]


def _unpacked_class(archive: Path, folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    try:
        unpack(archive, Stage(folder, CLASS_LIMITS), CLASS_LIMITS)
    except RefusedError as reason:
        raise IntakeError(f"{archive}: {reason}") from None
    return folder


def _name(entry: Path) -> str:
    """Return a submission's name: that of its folder or file, without the ending."""
    is_ours = entry.suffix.lower() in (".zip", *SOURCES) and not _is_folder(entry)
    return shown(entry.stem if is_ours else entry.name)


def _is_folder(entry: Path) -> bool:
    return entry.is_dir() and not entry.is_symlink()


def _staged(entry: Path, name: str, slug: str, staging: Path, limits: IntakeLimits) -> Submission:
    folder = staging / slug
    try:
        if folder.exists():
            shutil.rmtree(folder)
        stage = Stage(folder, limits)
        _fill(stage, entry, limits)
        sketch = find_sketch(folder, stage.paths, name)
    except RefusedError as reason:
        refusal = str(reason)
    except OSError as reason:
        refusal = f"Its files cannot be read: {reason.strerror or reason}."
    else:
        return Submission(name, slug, folder, sketch, digest=stage.digest())
    shutil.rmtree(folder, ignore_errors=True)
    return Submission(name, slug, refusal=refusal)


def _fill(stage: Stage, entry: Path, limits: IntakeLimits) -> None:
    """Put what was handed in on the stage, whatever form it has."""
    suffix = entry.suffix.lower()
    if entry.is_symlink():
        raise RefusedError("It is a link. Hand in the files themselves.")
    if entry.is_dir():
        archive = _only_archive(entry)
        if archive is None:
            copy_folder(entry, stage, limits)
        else:
            unpack(archive, stage, limits)
    elif not stat.S_ISREG(entry.lstat().st_mode):
        raise RefusedError("It is not a file but a device or a pipe.")
    elif suffix == ".zip":
        unpack(entry, stage, limits)
    elif suffix in SOURCES:
        copy_file(entry, stage)
    elif suffix in OTHER_ARCHIVES:
        raise RefusedError(
            f"It is a {suffix} archive. Hand in a zip, or the file of Python itself."
        )
    else:
        raise RefusedError(f"It is a {suffix or 'nameless kind of'} file, and no file of Python.")


def _only_archive(folder: Path) -> Path | None:
    """Return the zip in a folder that has nothing but it, as learning platforms make them."""
    files = [entry for entry in folder.iterdir() if entry.name not in LITTER]
    if len(files) == 1 and files[0].suffix.lower() == ".zip" and not files[0].is_symlink():
        return files[0] if files[0].is_file() else None
    return None
