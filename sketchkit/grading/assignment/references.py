"""References: a sketch that does what is asked for, or a folder of frames that show it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sketchkit.grading.evidence import Evidence, RunEvidence
from sketchkit.grading.results import Status

FRAME_NAME = re.compile(r"frame-(\d+)\.png")  # as `sketchkit render` calls them


def sketch_of(reference: Path) -> Path | None:
    """Return the sketch of a reference: itself, `box/box.py`, or the folder's only Python file.

    None stands for a folder of frames, and for one that has neither.
    """
    if reference.is_file():
        return reference if reference.suffix == ".py" else None
    named = reference / f"{reference.name}.py"
    files = sorted(reference.glob("*.py"))
    if named in files:
        return named
    return files[0] if len(files) == 1 else None


def frames_of(reference: Path) -> dict[int, Path]:
    """Return the pictures of a folder of frames, by their numbers."""
    if not reference.is_dir():
        return {}
    found = ((FRAME_NAME.fullmatch(path.name), path) for path in sorted(reference.iterdir()))
    return {int(name[1]): path.absolute() for name, path in found if name}


def frames_evidence(reference: Path, events: Iterable[str]) -> Evidence:
    """Return what a folder of frames shows: the same pictures, whichever events were replayed."""
    run = RunEvidence(Status.GRADED, frames=frames_of(reference))
    return Evidence(dict.fromkeys(events, run))
