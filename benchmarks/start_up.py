"""How long a whole process takes that does next to nothing."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Sequence
from time import perf_counter

from benchmarks.workloads import file_of

EMPTY_SKETCH = str(file_of("W0"))


def start_up(rounds: int) -> dict[str, list[float]]:
    """Return the seconds of each round, of Python alone, an import, and a render of one frame."""
    with tempfile.TemporaryDirectory() as folder:
        render = ["-m", "sketchkit", "render", EMPTY_SKETCH, "--out", folder, "--renderer"]
        processes = {
            "Python alone": ["-c", "pass"],
            "import sketchkit": ["-c", "import sketchkit"],
            "sketchkit render, an empty sketch, OpenGL": [*render, "gl"],
            "the same, CPU": [*render, "cpu"],
        }
        seconds: dict[str, list[float]] = {name: [] for name in processes}
        for _ in range(rounds + 1):
            for name, arguments in processes.items():
                seconds[name].append(_process_s(arguments))
    return {name: times[1:] for name, times in seconds.items()}  # the first fills the disk's cache


def _process_s(arguments: Sequence[str]) -> float:
    start = perf_counter()
    subprocess.run([sys.executable, *arguments], check=True, capture_output=True)
    return perf_counter() - start
