"""Which file of a submission is the sketch.

It is decided by names, and by a search in the text: what someone has handed in is not parsed here.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Iterable
from pathlib import Path, PurePosixPath

from sketchkit.grading.intake.submission import RefusedError

USUAL_STEMS = ("sketch", "main")
DEPTH = 3  # a zip of a folder, which a learning platform puts into one more
HAS_DRAW = re.compile(rb"^(async\s+)?def\s+draw\s*\(", re.MULTILINE)
HAS_SETUP = re.compile(rb"^(async\s+)?def\s+setup\s*\(", re.MULTILINE)
# PEP 263: in one of the first two lines.
CODING = re.compile(rb"\A(?:[^\n]*\n)?[ \t\f]*#[^\n]*?coding[:=][ \t]*[-\w.]+")
WIDE = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE, codecs.BOM_UTF32_LE, codecs.BOM_UTF32_BE)
ARCHIVES = (".zip", ".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz")

Rule = Callable[[PurePosixPath], bool]


def find_sketch(folder: Path, paths: Iterable[PurePosixPath], name: str) -> PurePosixPath:
    """Return the file to run, relative to the folder.

    Parameters
    ----------
    folder : Path
        The staged copy.
    paths : iterable of PurePosixPath
        Its files.
    name : str
        Of the submission: a file of that name is the sketch.

    Raises
    ------
    RefusedError
        If there is none, or it cannot be told which, or it is no text.
    """
    paths = list(paths)
    candidates = _outermost_sources(paths)
    if not candidates:
        raise RefusedError(_why_none(paths))
    sketch = _chosen(folder, candidates, name)
    if sketch is None:
        listed = ", ".join(repr(str(path)) for path in candidates[:6])
        more = " and others" if len(candidates) > 6 else ""
        raise RefusedError(
            f"It is not clear which of its files is the sketch: {listed}{more}. "
            "Name that one sketch.py, or like its folder."
        )
    check_text(folder / sketch, sketch)
    return sketch


def _outermost_sources(paths: list[PurePosixPath]) -> list[PurePosixPath]:
    """Return the Python files that lie the least deep."""
    sources = [path for path in paths if path.suffix.lower() in (".py", ".pyde")]
    sources = [path for path in sources if len(path.parts) <= DEPTH]
    least = min((len(path.parts) for path in sources), default=0)
    return [path for path in sources if len(path.parts) == least]


def _chosen(folder: Path, candidates: list[PurePosixPath], name: str) -> PurePosixPath | None:
    """Return the only candidate that the first rule with any finds."""

    def has(pattern: re.Pattern[bytes]) -> Rule:
        return lambda path: pattern.search((folder / path).read_bytes()) is not None

    rules: tuple[Rule, ...] = (
        lambda path: len(candidates) == 1,
        lambda path: path.stem == (path.parent.name or name),
        lambda path: path.suffix.lower() == ".pyde",  # its other files are .py
        lambda path: path.stem.lower() == USUAL_STEMS[0],
        lambda path: path.stem.lower() == USUAL_STEMS[1],
        has(HAS_DRAW),
        has(HAS_SETUP),
    )
    for rule in rules:
        found = [path for path in candidates if rule(path)]
        if len(found) == 1:
            return found[0]
    return None


def _why_none(paths: list[PurePosixPath]) -> str:
    suffixes = {path.suffix.lower() for path in paths}
    if not paths:
        return "There is no file in it."
    if ".pde" in suffixes:
        return "It is a Processing sketch in Java (.pde). Hand in one in Python (.py)."
    if suffixes & set(ARCHIVES):
        return "Its files are in an archive within it. Hand in one zip, with the sketch in it."
    if ".ipynb" in suffixes:
        return "It is a notebook. Hand in a file of Python (.py)."
    return "There is no file of Python (.py) in it, or it lies too deep within folders."


def check_text(file: Path, name: PurePosixPath) -> None:
    """Make sure that a file is text that Python can read.

    Raises
    ------
    RefusedError
        If it is not: Python's own message would not say what to do.
    """
    data = file.read_bytes()
    if data.startswith(WIDE):
        raise RefusedError(f"{str(name)!r} is saved as UTF-16. Save it as UTF-8.")
    if b"\0" in data:
        raise RefusedError(f"{str(name)!r} is not text: it has zeros in it.")
    if not data.strip():
        raise RefusedError(f"{str(name)!r} is empty.")
    if CODING.match(data):
        return  # it says itself what it is
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as reason:
        line = data.count(b"\n", 0, reason.start) + 1
        raise RefusedError(
            f"{str(name)!r} is not saved as UTF-8: line {line} has a letter that is not. "
            "Save it as UTF-8."
        ) from None
