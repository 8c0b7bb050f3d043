"""What a job is surrounded by: its environment, the command that starts it, and Python's places."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from pathlib import Path

from sketchkit.grading.sandbox.job import Job
from sketchkit.grading.sandbox.plan import VARIABLE, Plan

PACKAGE = Path(__file__).parents[2]  # sketchkit itself
_SITE_NAMES = ("site-packages", "dist-packages")

# The same for everyone: what a sketch draws must not depend on who grades it.
ENVIRONMENT = {
    "PATH": "/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "PYTHONHASHSEED": "0",
    "PYTHONDONTWRITEBYTECODE": "1",
    "PYTHONUTF8": "1",
    "MESA_SHADER_CACHE_DISABLE": "true",
    # One thread each: else a sketch's time depends on the number of processors.
    "LP_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "NUMBA_NUM_THREADS": "1",
}
# Which machine this is, and where it keeps its libraries: passed on if they are set.
PASSED_ON = ("OPENBLAS_CORETYPE", "LD_LIBRARY_PATH", "GALLIUM_DRIVER", "SYSTEMROOT")

SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/nix/store")
# What the loader, fontconfig and OpenGL's dispatcher read; nothing that names users or machines.
SETTINGS = (
    *("ld.so.cache", "ld.so.conf", "ld.so.conf.d", "alternatives", "localtime"),
    *("fonts", "glvnd", "drirc"),
)


def environment(plan: Plan) -> dict[str, str]:
    """Return all that a job finds in its environment."""
    passed_on = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
    found = [str(place) for place in _not_found_by_itself()]
    return {
        **ENVIRONMENT,
        **passed_on,
        "HOME": plan.paths["/tmp"],
        "TMPDIR": plan.paths["/tmp"],
        "PYTHONPATH": os.pathsep.join(found),
        VARIABLE: plan.to_json(),
    }


def command(job: Job) -> list[str]:
    """Return the command that starts a job's Python."""
    start = "sketchkit.grading.sandbox.start"
    return [sys.executable, "-P", "-s", "-B", "-m", start, job.module, *job.args]


def python_places() -> list[Path]:
    """Return the folders that Python and sketchkit are in, beyond the system's own."""
    prefixes = (sys.base_prefix, sys.base_exec_prefix, sys.prefix, sys.exec_prefix)
    shaders = PACKAGE.parent / "shaders"  # beside the package, in a checkout
    wanted = [*map(Path, prefixes), *_links_to(Path(sys.executable)), *_site_folders()]
    ours = [PACKAGE, *([shaders] if shaders.is_dir() else [])]
    return _outermost(place.absolute() for place in (*wanted, *ours))


def _links_to(executable: Path) -> list[Path]:
    """Return the folders in which the links lie that lead to a file, and where it really lies."""
    folders = []
    while executable.is_symlink():
        executable = executable.parent / executable.readlink()
        folders.append(Path(os.path.normpath(executable.parent)))
    return folders


def _site_folders() -> list[Path]:
    return [Path(entry) for entry in sys.path if Path(entry).name in _SITE_NAMES]


def _not_found_by_itself() -> list[Path]:
    """Return the folders that Python has to be told of: those outside of its own places."""
    told = [] if PACKAGE.parent.name in _SITE_NAMES else [PACKAGE.parent]
    own = (sys.prefix, sys.base_prefix, "/usr")
    others = (
        entry for entry in _site_folders() if not any(entry.is_relative_to(place) for place in own)
    )
    return [*told, *others]


def _outermost(places: Iterable[Path]) -> list[Path]:
    """Leave out what lies within the system's folders, or within another one."""
    found: list[Path] = []
    for place in sorted(set(places), key=lambda place: len(place.parts)):
        if place.exists() and not any(
            place.is_relative_to(other) for other in (*map(Path, SYSTEM), *found)
        ):
            found.append(place)
    return found
