"""Times a workload on py5: `py5's python py5_frames.py FILE 4 1.5`.

It is run by the Python that has py5, and so imports nothing of sketchkit. The arguments are the
workload's file, samples for each pixel, and the seconds to measure for, after as many to warm up.
The workload finds py5's functions under Processing's names. For each frame the milliseconds inside
the workload's `draw()`, and those until OpenGL has finished, are printed.
"""

from __future__ import annotations

import os
import re
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from types import CodeType

import py5

FEWEST_FRAMES = 8
METHOD = re.compile(r"\.\w+\(")
SIZE = re.compile(r"size\((\d+), (\d+), (P2D|P3D)\)")


def main() -> None:
    """Run the workload in a window."""
    path, samples, seconds = Path(sys.argv[1]), sys.argv[2], float(sys.argv[3])
    text = path.read_text(encoding="utf-8")
    width, height, renderer = SIZE.findall(text)[0]
    code = compile(METHOD.sub(lambda found: _py5_name(found[0]), text), str(path), "exec")
    names = _names_for(code) | {"width": int(width), "height": int(height)}
    names["size"] = lambda *_: None  # called in settings(), as py5 wants it
    if "np_pixels" in text:
        _give_array(names)
    exec(code, names)
    clock = FrameClock(seconds)

    def settings() -> None:
        py5.size(int(width), int(height), getattr(py5, renderer))
        if samples == "1":
            py5.no_smooth()

    def setup() -> None:
        py5.frame_rate(2000)
        _or_exit(names["setup"])

    def draw() -> None:
        names["frameCount"] = py5.frame_count
        _or_exit(lambda: clock.time(names["draw"]))

    py5.run_sketch(sketch_functions={"settings": settings, "setup": setup, "draw": draw})


def _or_exit(call: Callable[[], None]) -> None:
    """Call something; after an error py5 itself would stay, and show nothing for ever."""
    try:
        call()
    except Exception:
        traceback.print_exc()
        os._exit(1)


def _names_for(code: CodeType) -> dict[str, object]:
    """Return what py5 has of the names that the workload's functions use."""
    functions = [value for value in code.co_consts if isinstance(value, CodeType)]
    used = {name for function in functions for name in function.co_names}
    return {name: getattr(py5, _py5_name(name)) for name in used if hasattr(py5, _py5_name(name))}


def _give_array(names: dict[str, object]) -> None:
    """Let `loadPixels()` give `np_pixels`; py5 has its channels in another order."""

    def load() -> None:
        py5.load_np_pixels()
        names["np_pixels"] = py5.np_pixels

    names["loadPixels"], names["updatePixels"] = load, py5.update_np_pixels


def _py5_name(name: str) -> str:
    """Return py5's form of a name of Processing's: begin_shape for beginShape."""
    return name if name.isupper() else re.sub(r"([A-Z])", r"_\1", name).lower()


class FrameClock:
    """Times frames until there are enough, and ends the program then."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._begun: float | None = None
        self._frames = 0

    def time(self, draw: Callable[[], None]) -> None:
        """Draw a frame and print its times."""
        start = perf_counter()
        self._begun = self._begun or start
        draw()
        called = perf_counter()
        _finish()
        finished = perf_counter()
        age = start - self._begun
        self._frames += 1
        if age > self._seconds:
            print("frame", f"{(called - start) * 1000:.4f}", f"{(finished - start) * 1000:.4f}")
        if age > 2 * self._seconds and self._frames >= FEWEST_FRAMES:
            sys.stdout.flush()
            os._exit(0)  # py5's own way out takes seconds


def _finish() -> None:
    """Wait until everything is drawn."""
    py5.flush()
    sketch = py5.get_current_sketch()._instance  # py5 itself offers no glFinish()
    sketch.beginPGL().finish()
    sketch.endPGL()


if __name__ == "__main__":
    main()
