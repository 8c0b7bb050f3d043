"""What references show: sketches are run like submissions, frames are taken as they are."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.digest import digest_of
from sketchkit.grading.assignment.plan import runs
from sketchkit.grading.assignment.references import frames_evidence, sketch_of
from sketchkit.grading.batch.renders import Material, Setting, Shown, sha, show
from sketchkit.grading.evidence import Evidence


@dataclass(frozen=True)
class References:
    """What the references of an assignment show.

    Attributes
    ----------
    evidence : dict of str to Evidence
        By their names in the assignment.
    renderer : dict of str to str
        What has drawn them; empty if none had to be drawn.
    """

    evidence: Mapping[str, Evidence]
    renderer: Mapping[str, str]


def show_references(setting: Setting) -> References:
    """Run all references that are sketches.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    assignment = setting.assignment
    evidence: dict[str, Evidence] = {}
    renderer: dict[str, str] = {}
    needed = runs(assignment)
    for name in assignment.references:
        place = assignment.folder / name
        if sketch_of(place) is None:
            kept = _kept_frames(place, setting)
            evidence[name] = frames_evidence(kept, [run.events for run in needed])
            continue
        shown = show_sketch(name, setting)
        evidence[name] = shown.evidence
        renderer = renderer or shown.renderer
    return References(evidence, renderer)


def show_sketch(name: str, setting: Setting) -> Shown:
    """Run a reference that is a sketch."""
    assignment = setting.assignment
    sketch = sketch_of(assignment.folder / name)
    assert sketch is not None
    alone = sketch == assignment.folder / name
    source = sketch if alone else sketch.parent
    folder = setting.workplace.staging / "references" / sha(name)
    copy_files(source, folder)
    add_data(assignment, folder)
    material = Material(folder, sketch.name, digest_of(folder, ["."]), is_reference=True)
    return show(material, runs(assignment), setting)


def _kept_frames(place: Path, setting: Setting) -> Path:
    """Return a copy of a folder of frames beside the other pictures: reports refer to them."""
    folder = setting.workplace.renders / sha(["frames", digest_of(place, ["."])])
    if not folder.is_dir():
        copy_files(place, folder)
    return folder


def copy_files(source: Path, folder: Path) -> None:
    """Copy a file, or all files of a folder, to where a job may read them."""
    shutil.rmtree(folder, ignore_errors=True)
    if source.is_dir():
        shutil.copytree(source, folder, ignore=shutil.ignore_patterns("__pycache__"))
    else:
        folder.mkdir(parents=True)
        shutil.copy(source, folder)


def add_data(assignment: Assignment, folder: Path) -> None:
    """Lay the assignment's data beside a sketch; they win over its own files of these names."""
    if assignment.data is not None:
        lay_data(assignment.data, folder / "data")


def lay_data(source: Path, folder: Path) -> None:
    """Copy all files of a folder into another one; what is in their way is removed."""
    for file in sorted(path for path in source.rglob("*") if path.is_file()):
        path = file.relative_to(source)
        target = folder / path
        for place in (folder, *(folder / part for part in reversed(path.parents[:-1]))):
            if place.is_file():
                place.unlink()
        if target.is_dir():
            shutil.rmtree(target)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, target)
