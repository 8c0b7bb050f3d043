"""Limits of resources, which each Unix has: the innermost wall."""

from __future__ import annotations

import math
import os
import sys
from pathlib import Path

from sketchkit.grading.sandbox.job import MEGABYTE, Limits

OPEN_FILES = 256
SPARE_THREADS = 4  # the first one, and room for what bubblewrap itself needs


def settings(limits: Limits, *, is_walled: bool) -> dict[str, int]:
    """Return what to set, by the names in the module `resource`."""
    return {
        "RLIMIT_CPU": math.ceil(limits.cpu_s),
        "RLIMIT_AS": limits.memory_mb * MEGABYTE,
        "RLIMIT_FSIZE": limits.output_mb * MEGABYTE,
        "RLIMIT_NOFILE": OPEN_FILES,
        "RLIMIT_NPROC": _processes(limits, is_walled=is_walled),
        "RLIMIT_CORE": 0,
        "RLIMIT_MEMLOCK": 64 << 10,
        "RLIMIT_MSGQUEUE": 0,
        "RLIMIT_SIGPENDING": 256,
        "RLIMIT_NICE": 0,
        "RLIMIT_RTPRIO": 0,
    }


def impose(limits: Limits, *, is_walled: bool) -> list[str]:
    """Limit this process, for good; return the limits that are not to be had here."""
    if sys.platform == "win32":
        return ["all"]
    import resource

    missing = []
    for name, value in settings(limits, is_walled=is_walled).items():
        try:
            resource.setrlimit(getattr(resource, name), (value, value))
        except (AttributeError, ValueError, OSError):
            missing.append(name)
    return missing


def _processes(limits: Limits, *, is_walled: bool) -> int:
    """Return for how many threads of this user there may be.

    In a user namespace of its own they are counted from nothing. Elsewhere the user's other
    programs count as well; and only Linux counts threads: elsewhere 0 means that no process can
    be started.
    """
    if not sys.platform.startswith("linux"):
        return 0
    others = 0 if is_walled else _threads_of_this_user()
    return others + limits.threads + SPARE_THREADS


def _threads_of_this_user() -> int:
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if process.stat().st_uid == os.getuid():
                count += sum(1 for _ in (process / "task").iterdir())
        except OSError:
            continue  # it has ended in the meantime
    return count
