"""Where there is no bubblewrap: a job in an ordinary process, with what walls that allows.

Seccomp and Landlock, where Linux has them, leave little open: no network, no other process, and
of the files only the system's, Python's and the job's. Limits alone leave everything open.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from sketchkit.grading.sandbox.channels import Channels, plan_of
from sketchkit.grading.sandbox.job import Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.plan import Plan
from sketchkit.grading.sandbox.surroundings import (
    SETTINGS,
    SYSTEM,
    command,
    environment,
    python_places,
)
from sketchkit.grading.sandbox.watch import Running

AS_ROOT = (
    "Submissions are not run as root without a user namespace: they could change this computer. "
    "Grade as an ordinary user, or allow bubblewrap to make such a namespace."
)


def is_root() -> bool:
    """Return whether this process may do everything."""
    return sys.platform != "win32" and os.getuid() == 0


@contextlib.contextmanager
def started(job: Job, level: Level, channels: Channels) -> Iterator[Running]:
    """Start a job, and see to it that none of it is left at the end.

    Raises
    ------
    SandboxError
        If this is root, whom no limit binds.
    """
    if is_root():
        raise SandboxError(AS_ROOT)
    scratch = Path(tempfile.mkdtemp(prefix="sketchkit-")).resolve()
    try:
        plan = _plan(job, level, channels, scratch)
        process = subprocess.Popen(
            command(job),
            stdin=subprocess.DEVNULL,
            stdout=channels.console,
            stderr=channels.console,
            pass_fds=() if sys.platform == "win32" else channels.passed(),
            env=environment(plan),
            cwd=plan.paths["/sketch"],
            start_new_session=True,
        )
        running = Running(process, lambda: _kill_group(process))
        try:
            yield running
        finally:
            running.end()
            running.reap()
    finally:
        _remove(scratch)


def _plan(job: Job, level: Level, channels: Channels, scratch: Path) -> Plan:
    own = {"/sketch": scratch / "sketch", "/tmp": scratch / "tmp"}
    for folder in own.values():
        folder.mkdir()
    given = {name: place.resolve() for name, place in job.readable.items()}
    settings = [Path("/etc", name) for name in SETTINGS]
    system = [*map(Path, SYSTEM), *settings, Path("/proc/self")]
    places = {**given, **own}
    return replace(
        plan_of(job, channels),
        paths={name: str(place) for name, place in places.items()},
        readable=tuple(str(place) for place in (*system, *python_places(), *given.values())),
        own=tuple(str(folder) for folder in own.values()),
        has_seccomp=level.seccomp,
        has_landlock=level.landlock,
        is_trial=level.is_trial,
    )


def _kill_group(process: subprocess.Popen[bytes]) -> None:
    """End a job and what it has started, unless that has run away from its group."""
    if sys.platform == "win32":
        process.kill()
        return
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)


def _remove(folder: Path) -> None:
    """Remove a folder, even if its owner has locked himself out of parts of it."""
    for place, folders, _ in os.walk(folder):
        for name in folders:
            inner = Path(place, name)
            if not inner.is_symlink():
                inner.chmod(0o700)
    shutil.rmtree(folder, ignore_errors=True)
