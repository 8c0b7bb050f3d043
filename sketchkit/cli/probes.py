"""Trying out what may not work here, each in a process of its own.

A bad graphics driver does not raise an error: it ends the process.
"""

from __future__ import annotations

import ctypes.util
import subprocess
import sys
from collections.abc import Callable

from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.grading.sandbox.level import Strength
from sketchkit.grading.sandbox.probe import probe as probe_sandbox
from sketchkit.pymode.syntax import convert
from sketchkit.runtime.backends import RendererError, open_backend
from sketchkit.runtime.window import Window, WindowError
from sketchkit.stubs import blank_canvas

TIMEOUT_S = 30


class ProbeError(Exception):
    """Something does not work here; the message says why."""


def probed(name: str) -> tuple[bool, str]:
    """Try something out; return whether it works, and what was seen or what is wrong."""
    command = f"from sketchkit.cli.probes import probe; probe({name!r})"
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-c", command],
            capture_output=True,
            text=True,
            timeout=TIMEOUT_S,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False, f"no answer in {TIMEOUT_S} seconds"
    lines = (done.stdout or done.stderr).strip().splitlines()
    return done.returncode == 0, lines[-1] if lines else f"ended by signal {-done.returncode}"


def probe(name: str) -> None:
    """Try something out in this process, and print what was seen; exit status 1 if it fails."""
    try:
        print(PROBES[name]())
    except (ProbeError, RendererError, WindowError) as reason:
        print(reason)
        sys.exit(1)


def _gl() -> str:
    return _described(open_backend("gl").backend)


def _cpu() -> str:
    return _described(open_backend("cpu").backend)


def _described(backend: Backend) -> str:
    return ", ".join(backend.describe().values())


def _osmesa() -> str:
    library = ctypes.util.find_library("OSMesa")
    if library is None:
        raise ProbeError("not installed")
    return library


def _window() -> str:
    with Window("sketchkit doctor") as window:
        return _described(window.backend)


def _font() -> str:
    return f"'Hello' is {blank_canvas().textWidth('Hello'):g} pixels wide"


def _sandbox() -> str:
    level = probe_sandbox()
    if level.refusal or level.strength < Strength.FULL:
        raise ProbeError(level.refusal or level.in_words)
    return level.in_words


def _python_mode() -> str:
    try:
        return f"print 1 becomes {convert('print 1', 'old.pyde').text}"
    except SketchError:
        raise ProbeError("not installed") from None


PROBES: dict[str, Callable[[], str]] = {
    "gl": _gl,
    "osmesa": _osmesa,
    "window": _window,
    "cpu": _cpu,
    "font": _font,
    "sandbox": _sandbox,
    "python_mode": _python_mode,
}
