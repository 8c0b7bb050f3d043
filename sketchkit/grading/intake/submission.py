"""A submission as it is staged, the bounds it must keep, and why one is refused: plain data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath


class RefusedError(Exception):
    """A submission cannot be run; the message is a sentence for its author."""


@dataclass(frozen=True)
class IntakeLimits:
    """What a submission may consist of.

    Attributes
    ----------
    files : int
        Files and folders together.
    file_mb, total_mb : int
        Unpacked.
    source_kb : int
        Of each file of Python.
    depth : int
        Folders within folders.
    """

    files: int = 2000
    file_mb: int = 64
    total_mb: int = 100
    source_kb: int = 1024
    depth: int = 16


@dataclass(frozen=True)
class Submission:
    """What someone has handed in.

    Attributes
    ----------
    name : str
        As it is in the folder of submissions, without `.zip` or `.py`.
    slug : str
        A file name that stands for it, of ASCII letters, digits, `-`, `_` and `.`; unique.
    folder : Path or None
        The staged copy: plain files and folders, and nothing else. Only to be read.
    sketch : PurePosixPath or None
        The file to run, relative to `folder`.
    refusal : str
        Why it cannot be run, in a sentence; "" if it can. Then folder and sketch are None.
    digest : str
        Of the names and contents of all its files; "" if it is refused.
    """

    name: str
    slug: str
    folder: Path | None = None
    sketch: PurePosixPath | None = None
    refusal: str = ""
    digest: str = ""
