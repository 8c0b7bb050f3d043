"""Sketches for tests: a text becomes a file, is run without a renderer, and can be looked at."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from textwrap import dedent

from sketchkit.backends.listing import ListingBackend
from sketchkit.core.clock import VirtualClock
from sketchkit.draw.renderer import Renderer
from sketchkit.runtime.headless import Launch, opened
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.report import StoppedError


class Remarks(list[tuple[str, int, str]]):
    """What a sketch's author was told: file, line, text."""

    def tell(self, path: Path, line: int, text: str) -> None:
        self.append((path.name, line, text))


def written(folder: Path, text: str, name: str = "sketch.py") -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(dedent(text), encoding="utf-8")
    return path


@contextmanager
def begun(path: Path, remarks: Remarks | None = None) -> Iterator[Loop]:
    """Run a sketch up to its picture of frame 0; the block can take it further."""
    tell = (remarks if remarks is not None else Remarks()).tell
    with opened(Launch(path, tell), Renderer(ListingBackend()), VirtualClock()) as loop:
        loop.begin()
        yield loop


def play(path: Path, frames: int = 0, remarks: Remarks | None = None) -> dict[str, object]:
    """Run a sketch for some frames; return what its file has defined."""
    with begun(path, remarks) as loop:
        for _ in range(frames):
            loop.step()
        return loop.program.namespace


def mistake(path: Path, frames: int = 1) -> str:
    """Return what is told about the mistake that stops a sketch."""
    try:
        play(path, frames)
    except StoppedError as stopped:
        return str(stopped)
    raise AssertionError("the sketch has not stopped")
