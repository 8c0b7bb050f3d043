"""Renders kept by content: the same sketch, asked for the same things, is run once."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from sketchkit import __version__
from sketchkit.assets.output import write_file
from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.run import Run
from sketchkit.grading.batch.workplace import Workplace
from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import from_json, to_json
from sketchkit.grading.runs import Outcome, Request, carry_out
from sketchkit.grading.sandbox.job import Limits
from sketchkit.grading.sandbox.level import Level

PACKAGE = Path(__file__).parents[2]


@dataclass(frozen=True)
class Material:
    """A sketch as it lies, ready to be run.

    Attributes
    ----------
    folder : Path
    sketch : str
        Its file, relative to the folder.
    digest : str
        Stands for all files of the folder.
    is_reference : bool
        Whether it is one: more is wanted of it.
    """

    folder: Path
    sketch: str
    digest: str
    is_reference: bool = False


@dataclass(frozen=True)
class Setting:
    """In what circumstances sketches are run.

    Attributes
    ----------
    assignment : Assignment
    workplace : Workplace
    level : Level
    is_fresh : bool
        Whether what was kept is not used.
    """

    assignment: Assignment
    workplace: Workplace
    level: Level
    is_fresh: bool = False


@dataclass(frozen=True)
class Shown:
    """What a sketch has shown in all of its runs, and what has drawn it."""

    evidence: Evidence
    renderer: dict[str, str]


def show(material: Material, runs: Sequence[Run], setting: Setting) -> Shown:
    """Run a sketch as often as an assignment needs it.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    outcomes = {run.events: _outcome(material, run, setting) for run in runs or (Run(""),)}
    first = next(iter(outcomes.values()))
    evidence = {events: outcome.evidence for events, outcome in outcomes.items()}
    return Shown(Evidence(evidence, first.source), first.renderer)


def _outcome(material: Material, run: Run, setting: Setting) -> Outcome:
    """Return a run's outcome, the kept one if there is one."""
    request = _request(material, run, setting.assignment)
    folder = setting.workplace.renders / _key(material, request)
    record = folder / "outcome.json"
    if not setting.is_fresh and (kept := _read(record)) is not None:
        return kept
    with setting.workplace.workshop() as workshop:
        outcome = carry_out(request, folder, workshop, setting.level)
    evidence = outcome.evidence
    inside = replace(
        outcome,
        evidence=replace(
            evidence,
            frames=_named(evidence.frames),
            variants={name: _named(frames) for name, frames in evidence.variants.items()},
        ),
    )
    write_file(record, json.dumps(to_json(inside)).encode())
    return outcome


def _named(frames: dict[int, Path]) -> dict[int, Path]:
    return {number: Path(path.name) for number, path in frames.items()}


def _read(record: Path) -> Outcome | None:
    """Return the outcome that was written; None if there is none, or an older form of it."""
    try:
        outcome = from_json(Outcome, json.loads(record.read_bytes()))
    except (OSError, ValueError, KeyError, TypeError):
        return None
    evidence = outcome.evidence
    folder = record.parent
    frames = _placed(evidence.frames, folder)
    variants = {name: _placed(own, folder) for name, own in evidence.variants.items()}
    return replace(outcome, evidence=replace(evidence, frames=frames, variants=variants))


def _placed(frames: dict[int, Path], folder: Path) -> dict[int, Path]:
    return {number: folder / path for number, path in frames.items()}


def _request(material: Material, run: Run, assignment: Assignment) -> Request:
    frames, limits = run.frames, assignment.limits
    if material.is_reference:
        frames = tuple(sorted({*frames, *run.reference_frames}))
    return Request(
        material.folder,
        material.sketch,
        assignment.renderer,
        assignment.seed,
        frames,
        max([run.last_frame, *frames]),
        run.traced,
        run.varied if material.is_reference else (),
        run.watched,
        assignment.folder / run.events if run.events else None,
        limits=Limits(
            cpu_s=limits.cpu_s,
            wall_s=limits.wall_s,
            memory_mb=limits.memory_mb,
            output_mb=limits.output_mb,
        ),
    )


def _key(material: Material, request: Request) -> str:
    """Return the name under which an outcome is kept: all that it hangs on."""
    events = hashlib.sha256(request.events.read_bytes()).hexdigest() if request.events else ""
    asked = to_json(replace(request, folder=Path(), events=None))
    return sha([material.digest, asked, events, code_digest()])


def sha(content: object) -> str:
    """Return a name for what JSON can write."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:40]


@cache
def code_digest() -> str:
    """Return what stands for the version of everything that draws."""
    whole = hashlib.sha256(f"{__version__} {platform.platform()} {np.__version__}".encode())
    for file in sorted(PACKAGE.rglob("*.py")):
        whole.update(file.read_bytes())
    return whole.hexdigest()
