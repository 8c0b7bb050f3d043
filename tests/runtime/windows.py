"""Real windows for tests: a sketch in its own process, keys and mouse pressed by xdotool.

Nothing here waits for a time: the sketch says on its output what it has seen, or the screen shows
it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from PIL import Image, ImageGrab

ROOT = Path(__file__).parents[2]
TOOLS = ("Xvfb", "xdotool")

needs_a_display = [
    pytest.mark.skipif(
        not all(map(shutil.which, TOOLS)), reason=f"{' and '.join(TOOLS)} are not installed"
    ),
    pytest.mark.timeout(60),
]


@contextmanager
def x_server() -> Iterator[str]:
    """Start an X server; the number of its display is the server's choice."""
    read, write = os.pipe()
    command = [
        "Xvfb",
        "-displayfd",
        str(write),
        "-screen",
        "0",
        "800x600x24",
        "-nolisten",
        "tcp",
        "-noreset",
    ]
    with subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL) as server:
        os.close(write)
        with os.fdopen(read) as answer:
            yield f":{answer.readline().strip()}"
        server.terminate()


class Running:
    """A sketch in its window."""

    def __init__(self, process: subprocess.Popen[str], environment: dict[str, str]) -> None:
        self.process = process
        self._environment = environment

    def says(self, words: str) -> str:
        """Read the sketch's output up to a line with these words in it, and return that."""
        assert self.process.stdout
        for line in self.process.stdout:
            if words in line:
                return line.strip()
        raise AssertionError(f"the sketch ended without saying {words!r}")

    def xdotool(self, *args: str) -> None:
        subprocess.run(["xdotool", *args], env=self._environment, check=True, timeout=30)

    def shows(self, is_so: Callable[[Image.Image], bool]) -> Image.Image:
        """Look at the screen until it is so, and return it."""
        while self.process.poll() is None:
            with suppress(OSError):  # the server has no time yet
                screen = ImageGrab.grab(xdisplay=self._environment["DISPLAY"])
                if is_so(screen):
                    return screen
        raise AssertionError("the sketch has ended")

    def ends(self) -> int:
        return self.process.wait(timeout=30)


@contextmanager
def shown(sketch: Path, display: str, *options: str) -> Iterator[Running]:
    environment = {**os.environ, "DISPLAY": display, "PYTHONPATH": str(ROOT)}
    environment.pop("WAYLAND_DISPLAY", None)
    with subprocess.Popen(
        [sys.executable, "-u", "-m", "sketchkit", "run", *options, str(sketch)],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        running = Running(process, environment)
        try:
            yield running
        finally:
            process.kill()
