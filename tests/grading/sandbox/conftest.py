"""What the tests of the sandbox share: a way to attack it."""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from sketchkit.grading.sandbox.job import Ending, Job, Limits
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.run import run

# `timeit` runs a statement: so a test needs no module of its own within the package.
STATEMENT = """\
from sketchkit.grading.sandbox import inside
source = inside.path("/submission").read_text()
exec(compile(source, "attack.py", "exec"), {"__name__": "attack"})
"""
SHORT = Limits(cpu_s=10, wall_s=20, output_mb=2, scratch_mb=4, scratch_files=200, threads=16)


@dataclass(frozen=True)
class Attacked:
    """How an attack ended, and what it wrote to its output."""

    ending: Ending
    output: bytes
    output_file: Path

    @property
    def said(self) -> Any:  # JSON may be anything
        return json.loads(self.output)


Attack = Callable[..., Attacked]


@pytest.fixture
def attack(walled: Level, tmp_path: Path) -> Attack:
    """Return a function that runs code in the sandbox, and looks for what it left behind."""
    return lambda code, limits=SHORT, **given: attacked(tmp_path, walled, code, limits, **given)


def attacked(
    folder: Path, level: Level, code: str, limits: Limits = SHORT, **given: Path
) -> Attacked:
    """Run code in the sandbox; `given` are further files for it, by name."""
    source = folder / "attack.py"
    source.write_text(code, "utf-8")
    source.chmod(0o644)
    mark = f"attack-{secrets.token_hex(8)}"
    readable = {"/submission": source, **{f"/{name}": path for name, path in given.items()}}
    arguments = ("-n", "1", "-r", "1", f"{STATEMENT}# {mark}")
    output = folder / "output"

    ending = run(Job("timeit", arguments, readable, output, limits=limits), level)

    assert running(mark) == []
    return Attacked(ending, output.read_bytes(), output)


def running(mark: str) -> list[str]:
    """Return the processes on this computer with a word in their command."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (process / "cmdline").read_bytes():
                found.append(process.name)
        except OSError:
            continue  # it has just ended
    return [pid for pid in found if int(pid) != os.getpid()]
