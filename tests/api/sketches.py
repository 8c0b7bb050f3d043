"""A sketch without a file, for tests of its methods."""

from __future__ import annotations

from pathlib import Path

from sketchkit.api.host import NoWindow
from sketchkit.api.sketch import Sketch
from tests.canvases import flat_canvas


class RecordingHost(NoWindow):
    """Remembers what it was asked for."""

    def __init__(self) -> None:
        self.asked: list[tuple[object, ...]] = []

    def set_size(self, width: int, height: int) -> None:
        self.asked.append(("size", width, height))

    def set_title(self, title: str) -> None:
        self.asked.append(("title", title))

    def set_position(self, x: int, y: int) -> None:
        self.asked.append(("position", x, y))

    def set_resizable(self, is_resizable: bool) -> None:
        self.asked.append(("resizable", is_resizable))

    def set_cursor(self, kind: int | None) -> None:
        self.asked.append(("cursor", kind))

    def set_fullscreen(self, display: int | None = None) -> None:
        self.asked.append(("fullscreen", display))


def new_sketch(host: NoWindow | None = None, folder: Path | None = None) -> Sketch:
    return Sketch(flat_canvas(), host=host, folder=folder)
