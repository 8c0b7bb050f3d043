"""What the sandbox runs to find out which of its walls hold: it tries to get through each.

It prints nothing; it writes what it found to its output, as JSON.
"""

from __future__ import annotations

import json
import os
import socket
import sys
from collections.abc import Callable
from pathlib import Path

from sketchkit.grading.sandbox import inside, rlimits


def main() -> None:
    """Try all walls."""
    found = {
        "seccomp": _is_refused(_fork) and _is_refused(socket.socket),
        "landlock": _is_refused(lambda: Path("/proc/self/comm").write_text("x")),
        "limits": _are_limited(),
        "bubblewrap": _is_walled(),
        "missing": inside.lock_down(),
    }
    os.write(inside.OUTPUT, json.dumps(found).encode())


def _is_refused(attempt: Callable[[], object]) -> bool:
    try:
        attempt()
    except PermissionError:
        return True
    except OSError:
        return False
    return False


def _fork() -> None:
    if os.fork() == 0:
        os._exit(0)


def _are_limited() -> bool:
    if sys.platform == "win32":
        return False
    import resource

    plan = inside.plan()
    wanted = rlimits.settings(plan.limits, is_walled=plan.is_walled)
    return all(
        resource.getrlimit(getattr(resource, name))[0] <= wanted[name]
        for name in ("RLIMIT_CPU", "RLIMIT_AS", "RLIMIT_FSIZE")
    )


def _is_walled() -> bool:
    """Return whether this is a user without privileges, alone with one process, and no network."""
    plan = inside.plan()
    if not plan.is_walled or os.getuid() == 0 or os.getpid() != 1:
        return False
    status = Path("/proc/self/status").read_text()
    has_none = "CapEff:\t0000000000000000" in status and "CapPrm:\t0000000000000000" in status
    networks = Path("/proc/self/net/dev").read_text().splitlines()[2:]
    files = [os.statvfs(folder).f_files for folder in plan.own]
    is_bounded = all(count <= plan.limits.scratch_files for count in files)
    return has_none and len(networks) <= 1 and is_bounded


if __name__ == "__main__":
    main()
