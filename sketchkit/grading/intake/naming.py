"""Names: of submissions, as they were handed in and as files; and of files within submissions."""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterable
from pathlib import PurePosixPath

from sketchkit.grading.intake.submission import RefusedError

SLUG_LENGTH = 60
NAME_BYTES = 255  # what a file's name may have on nearly every system
# What computers put into folders by themselves.
LITTER = frozenset(
    {"__MACOSX", "__pycache__", ".git", ".svn", ".idea", ".vscode", ".venv", ".DS_Store"}
    | {".ipynb_checkpoints", "Thumbs.db", "desktop.ini", "$RECYCLE.BIN", "Icon\r"}
)
# Names that mean a device on Windows, whatever follows their dot.
WINDOWS_DEVICES = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\.|$)")


def shown(name: str) -> str:
    """Return a name such that it can be written in any report.

    Python keeps bytes of a file name that are no Unicode in a way that cannot be encoded again.
    """
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def slugs(names: Iterable[str]) -> list[str]:
    """Return a file name for each name; all are different, also where case does not count."""
    taken: set[str] = set()
    found = []
    for name in names:
        slug, marked = _slug(name), name
        while slug.lower() in taken:  # more than once, if someone has guessed the mark of another
            marked += "."
            mark = hashlib.sha256(marked.encode("utf-8", "surrogateescape")).hexdigest()[:8]
            slug = f"{slug[: SLUG_LENGTH - 9]}-{mark}"
        taken.add(slug.lower())
        found.append(slug)
    return found


def _slug(name: str) -> str:
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    slug = re.sub(r"[^A-Za-z0-9_.]+", "-", plain).strip("-.")[:SLUG_LENGTH].strip("-.")
    if not slug or WINDOWS_DEVICES.match(slug):
        mark = hashlib.sha256(name.encode("utf-8", "surrogateescape")).hexdigest()[:8]
        slug = f"submission-{mark}"
    return slug


def is_litter(path: PurePosixPath) -> bool:
    """Return whether a file within a submission is none of its author's."""
    return any(part in LITTER or part.startswith("._") for part in path.parts)


def safe_path(name: str, depth: int) -> PurePosixPath:
    """Return the path that a name in an archive or a folder stands for.

    Raises
    ------
    RefusedError
        If it leads elsewhere, or cannot be the name of a file.
    """
    quoted = repr(shown(name))[:120]
    if "\0" in name or any(ord(letter) < 32 for letter in name):
        raise RefusedError(f"A file's name has control characters in it: {quoted}.")
    if not name.strip("./\\ "):
        raise RefusedError(f"A file has no name: {quoted}.")
    path = PurePosixPath(name.replace("\\", "/"))  # some programs on Windows write it so
    if path.is_absolute() or re.match(r"[A-Za-z]:", name) or ".." in path.parts:
        raise RefusedError(f"A file's name leads out of the folder: {quoted}.")
    if len(path.parts) > depth:
        raise RefusedError(f"Its folders lie deeper than {depth} within each other: {quoted}.")
    if any(len(part.encode("utf-8", "surrogateescape")) > NAME_BYTES for part in path.parts):
        raise RefusedError(f"A file's name is longer than {NAME_BYTES} bytes: {quoted}.")
    return path
