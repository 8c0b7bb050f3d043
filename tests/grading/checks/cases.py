"""Cases for tests of checks, made by hand: small pictures, black and white, and tables."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from PIL import Image

from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.table import Document, Table
from sketchkit.grading.checks.judge import judge
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.grading.evidence import Evidence, RunEvidence, SourceFacts, Trace
from sketchkit.grading.results import CheckResult, Status

WIDTH, HEIGHT = 20, 10  # 200 pixels: one is half a percent


def table(text: str, folder: Path = Path(), noun: str = "a check") -> Table:
    """Return the table that a TOML text is."""
    return Table(tomllib.loads(text), Document(text, folder), noun=noun)


def check_of(  # noqa: PLR0913 # what a check is made of
    kind: str,
    text: str = "",
    *,
    frames: tuple[int, ...] = (1,),
    folder: Path = Path(),
    events: str = "",
    references: tuple[str, ...] = ("reference",),
    expect: str = "",
) -> Check:
    """Return a check of 6 points with the options that a TOML text has."""
    plain = Check(kind, f"1-{kind}", kind, 6, None, frames, events, references, expect)
    own = table(text, folder, f"a {kind} check")
    options = KINDS[kind].read(own, plain)
    own.finish()
    return Check(kind, f"1-{kind}", kind, 6, options, frames, events, references, expect)


def picture(path: Path, pixels: int, size: tuple[int, int] = (WIDTH, HEIGHT)) -> Path:
    """Write a white picture whose first pixels are black, row by row."""
    width, height = size
    data = np.full((height * width, 3), 255, np.uint8)
    data[:pixels] = 0
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(data.reshape(height, width, 3)).save(path)
    return path


def pictured(
    folder: Path,
    pixels: Mapping[int, int],
    status: Status = Status.GRADED,
    explanation: str = "",
) -> RunEvidence:
    """Return a run whose frames have so many black pixels."""
    frames = {n: picture(folder / f"{n}.png", count) for n, count in pixels.items()}
    return RunEvidence(status, explanation, frames=frames)


def traced(**traces: Trace) -> Evidence:
    """Return what one run shows: `traced(f1=Trace(...))`."""
    run = RunEvidence(Status.GRADED, traces={int(n[1:]): trace for n, trace in traces.items()})
    return Evidence({"": run})


def moved(**values: tuple[float, ...]) -> Evidence:
    """Return a run with values, from frame 1 on."""
    return Evidence({"": RunEvidence(Status.GRADED, values=dict(values))})


def written(facts: SourceFacts) -> Evidence:
    """Return a submission of which only the source is known."""
    return Evidence(source=facts)


def judged(
    check: Check, submission: Evidence, reference: Evidence | None = None, folder: Path = Path()
) -> CheckResult:
    """Return the result against one reference."""
    return judge(check, submission, {"reference": reference or Evidence()}, folder)
