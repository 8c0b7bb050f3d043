"""Times a workload on sketchkit: `python -m benchmarks.sketchkit_frames W1 4 1.5 gl`.

The arguments are workload, samples for each pixel, the seconds to measure for (after as many to
warm up), and the renderer. For each frame it prints the milliseconds inside the sketch's own
`draw()`, and those until the renderer has finished.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter

import moderngl

from benchmarks.workloads import file_of
from sketchkit.core.clock import VirtualClock
from sketchkit.draw.renderer import Renderer
from sketchkit.runtime.backends import open_backend
from sketchkit.runtime.headless import Launch, opened

FEWEST_FRAMES = 8


def main() -> None:
    """Print the time of each frame."""
    workload, samples, seconds, renderer_name = sys.argv[1:]
    backend = open_backend(renderer_name).backend
    finish = partial(_finish, backend.context) if renderer_name == "gl" else _nothing
    launch = Launch(file_of(workload), tell=_complain)
    with opened(launch, Renderer(backend), VirtualClock()) as loop:
        if samples == "1":
            loop.program.sketch.start_without_smoothing()
        loop.begin()
        stopwatch = Stopwatch(loop.program.namespace["draw"])
        loop.program.namespace["draw"] = stopwatch
        _time_frames(loop.step, finish, stopwatch, float(seconds))


class Stopwatch:
    """Stands in for a function, and keeps how long its last call took."""

    def __init__(self, function: Callable[[], None]) -> None:
        self._function = function
        self.elapsed_s = 0.0

    def __call__(self) -> None:
        """Call the function."""
        start = perf_counter()
        self._function()
        self.elapsed_s = perf_counter() - start


def _time_frames(
    step: Callable[[], object], finish: Callable[[], None], draw: Stopwatch, seconds: float
) -> None:
    begun = perf_counter()
    frames = 0
    age = 0.0
    while age < 2 * seconds or frames < FEWEST_FRAMES:
        start = perf_counter()
        step()
        finish()
        total_s = perf_counter() - start
        age = start - begun
        frames += 1
        if age > seconds:
            print("frame", f"{draw.elapsed_s * 1000:.4f}", f"{total_s * 1000:.4f}")


def _finish(context: moderngl.Context) -> None:
    """Wait until OpenGL has drawn everything."""
    with context:
        context.finish()


def _nothing() -> None:
    """Stand in for waiting."""


def _complain(path: Path, line: int, text: str) -> None:
    print(f"{path}, line {line}: {text}", file=sys.stderr)


if __name__ == "__main__":
    main()
