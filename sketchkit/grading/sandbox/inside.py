"""What a job finds inside of the sandbox: its paths, and the walls that it stands behind."""

from __future__ import annotations

import contextlib
import os
import signal
import stat
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NoReturn

from sketchkit.core.errors import SketchError
from sketchkit.grading.sandbox import kernel, landlock, rlimits, seccomp
from sketchkit.grading.sandbox.job import SandboxError
from sketchkit.grading.sandbox.plan import NOBODY, OUTPUT, VARIABLE, Plan

__all__ = ["OUTPUT", "copy_sketch", "leave", "lock_down", "path", "plan"]

DEVICES = tuple(Path("/dev", name) for name in ("null", "zero", "full", "random", "urandom"))
STREAMS = (sys.stdout, sys.stderr)  # our own, whatever a sketch puts in their place

_missing: list[str] | None = None  # the walls that are not up; None before lock_down()


def plan() -> Plan:
    """Return what the grader told this process.

    Raises
    ------
    SandboxError
        If this process was not started by `sandbox.run`.
    """
    try:
        return Plan.from_json(os.environ[VARIABLE])
    except KeyError:
        raise SandboxError("this module only runs in the sandbox: start it with run()") from None


def path(name: str) -> Path:
    """Return where something that the job knows as "/submission", "/sketch" or "/tape" is.

    Without bubblewrap the files are where they always were, and this is how to find them.
    """
    return Path(plan().paths[name])


def copy_sketch() -> Path:
    """Copy /submission to the sketch's own folder, where it may write; return that folder.

    Links and devices are not copied, nor followed.

    Raises
    ------
    SketchError
        If its files are more than its folder may hold.
    """
    source, target = path("/submission"), path("/sketch")
    try:
        for file in _plain_files(source):
            copy = target / file.relative_to(source if source.is_dir() else source.parent)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(file.read_bytes())
    except OSError as reason:
        raise SketchError(
            "The files of this sketch could not be copied to where it runs.",
            got=str(reason),
            hint=f"All together, they may have {plan().limits.scratch_mb} MB.",
        ) from None
    return target


def _plain_files(source: Path) -> Iterator[Path]:
    if source.is_file():
        yield source
        return
    for folder, _, names in os.walk(source):
        for name in names:
            file = Path(folder, name)
            if stat.S_ISREG(file.lstat().st_mode):
                yield file


def leave() -> NoReturn:
    """End this process now: a sketch's threads and last wishes (atexit) are not waited for."""
    for stream in STREAMS:
        with contextlib.suppress(Exception):  # a sketch may have closed them
            stream.flush()
    os._exit(0)


def lock_down() -> list[str]:
    """Put up the walls within this process, for good; return those that could not be had.

    It is called before the job's module is imported, and may be called again: then it only says
    again what is missing.

    Raises
    ------
    SandboxError
        If one is missing that the grader counts on.
    """
    global _missing
    if _missing is None:
        _missing = list(_put_up(plan()))
        if _missing and not plan().is_trial:
            raise SandboxError(f"A wall of the sandbox is not up: {', '.join(_missing)}.")
    return _missing


def _put_up(plan: Plan) -> Iterator[str]:
    """Put up all walls of a plan; yield what went wrong. The order matters."""
    if plan.is_walled:
        yield from _tried("number of files", lambda: _bound_files(plan))
        yield from _tried("user", _become_nobody)
    if sys.platform.startswith("linux"):
        yield from _tried("end with the grader", _end_with_parent)
    missing_limits = rlimits.impose(plan.limits, is_walled=plan.is_walled)
    if missing_limits and sys.platform.startswith("linux"):
        yield f"limits ({', '.join(missing_limits)})"
    if plan.has_landlock:
        yield from _tried("Landlock", lambda: _confine(plan))
    if plan.has_seccomp:
        yield from _tried("seccomp", seccomp.install)


def _tried(name: str, put_up: Callable[[], None]) -> Iterator[str]:
    try:
        put_up()
    except OSError as reason:
        yield f"{name} ({reason})"


def _bound_files(plan: Plan) -> None:
    """Bound the number of files in its own folders: bubblewrap has only bounded their size."""
    flags = kernel.MS_NOSUID | kernel.MS_NODEV | kernel.MS_NOEXEC
    for folder in plan.own:
        kernel.remount(folder, flags, f"nr_inodes={plan.limits.scratch_files}")


def _become_nobody() -> None:
    """Become a user who owns nothing, and who is not root outside of the namespace either."""
    if os.getuid() == 0:
        os.setgroups([])
        os.setresgid(NOBODY, NOBODY, NOBODY)
        os.setresuid(NOBODY, NOBODY, NOBODY)
    kernel.drop_capabilities()
    kernel.prctl(kernel.PR_SET_DUMPABLE, 1)  # or it could not read its own /proc/self


def _end_with_parent() -> None:
    kernel.prctl(kernel.PR_SET_PDEATHSIG, signal.SIGKILL)  # a change of user has cleared it


def _confine(plan: Plan) -> None:
    landlock.restrict(map(Path, plan.readable), map(Path, plan.own), DEVICES)
