"""Finding out which walls this computer has: a trial in the sandbox tries to get through them."""

from __future__ import annotations

import functools
import json
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

from sketchkit.grading.sandbox import bare, bubblewrap
from sketchkit.grading.sandbox.job import Job, Limits, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.run import run

TRIAL = "sketchkit.grading.sandbox.trial"


@functools.cache
def probe() -> Level:
    """Return the walls that this computer has, by trying them; it takes a second, once."""
    linux = sys.platform.startswith("linux")
    seen = "Bubblewrap is not installed."
    if linux and bubblewrap.program() is not None:
        walled = _tried(Level(bubblewrap=True, seccomp=True, landlock=True, is_trial=True))
        if walled.bubblewrap:
            return walled
        seen = f"Bubblewrap was tried: {' '.join(walled.missing) or 'it does not hold.'}"
    if bare.is_root():
        return Level(refusal=f"{bare.AS_ROOT} {seen}", missing=(seen,))
    found = _tried(Level(seccomp=linux, landlock=linux, is_trial=True))
    return replace(found, missing=(*found.missing, seen))


def _tried(candidate: Level) -> Level:
    """Return those walls of a candidate that hold."""
    with tempfile.TemporaryDirectory(prefix="sketchkit-") as folder:
        output = Path(folder, "found.json")
        try:
            ending = run(Job(TRIAL, output=output, limits=Limits(cpu_s=10, wall_s=20)), candidate)
        except SandboxError as reason:
            return Level(missing=(str(reason),))
        if not ending.went_well:
            return Level(missing=(ending.sentence(), ending.console))
        found = json.loads(output.read_text("utf-8"))
    missing = tuple(found.pop("missing"))
    return Level(**found, missing=missing)
