"""The machine that is measured on, in words, and how busy it is."""

from __future__ import annotations

import os
import platform
import re
from pathlib import Path

import numpy as np

import sketchkit
from sketchkit.runtime.backends import open_backend

QUIET = 0.3  # load average of the last minute, for each core


def machine() -> str:
    """Return processor, memory, system, versions and OpenGL driver, one to a line."""
    driver = open_backend().backend.describe()
    lines = [
        f"{_processor()}, {os.cpu_count()} cores",
        f"{platform.system()} {platform.release()}",
        f"Python {platform.python_version()}, NumPy {np.__version__}, "
        f"sketchkit {sketchkit.__version__}",
        ", ".join(driver.values()),
    ]
    return "\n".join(f"- {line}" for line in lines)


def load() -> float:
    """Return the load average of the last minute; 0 where there is none."""
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0


def remark_on_load(average: float) -> str:
    """Return whether the figures can be trusted."""
    busy = average > QUIET * (os.cpu_count() or 1)
    verdict = "others are busy on this machine: do not trust the figures" if busy else "quiet"
    return f"Load average before the start: {average:.2f} ({verdict})."


def _processor() -> str:
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor() or platform.machine()
    found = re.search(r"model name\s*:\s*(.*)", text)
    return found[1] if found else platform.machine()
