"""RawReader: turns draw lists into a page, triangle by triangle; what is far comes first."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import ClassVar

from sketchkit.draw.commands import Clear, Command, Draw, DrawList, DrawMesh, Settle, Upload
from sketchkit.draw.resources import Target
from sketchkit.draw.rows import Rows
from sketchkit.draw.vertex import U8
from sketchkit.vector.canvas_pages import CanvasPages
from sketchkit.vector.faces import Batch, Unit, batch_of, in_depth, units_of
from sketchkit.vector.page import Page
from sketchkit.vector.pictures import upload_picture


class RawReader:
    """Writes what is drawn on a target onto a page.

    What is drawn with the depth test on waits until it is known what lies before what. Other
    canvases have pages as well, for when they are drawn like images.

    Parameters
    ----------
    target : Target
    look : callable
        Returns what was drawn on a canvas so far, (h, w, 4).
    """

    reads_shapes: ClassVar = True

    def __init__(self, target: Target, look: Callable[[Target], U8]) -> None:
        self._pages = CanvasPages(look)
        self._pages.begin(target)
        self._target = target
        self._waiting: dict[Target, list[Unit]] = defaultdict(list)

    def read_rows(self, rows: Rows) -> None:
        """Wait until they are triangles."""

    def read_commands(self, commands: DrawList) -> None:
        """Add what a draw list draws."""
        for command in commands.commands:
            self._add(command, commands)

    def finish(self) -> Page:
        """Return the page."""
        return self._page(self._target)

    def _page(self, target: Target) -> Page:
        """Return the page of a canvas, with all that has waited."""
        page = self._pages.page(target)
        page.items += in_depth(self._waiting.pop(target, []))
        return page

    def _add(self, command: Command, commands: DrawList) -> None:
        match command:
            case Clear(target, (red, green, blue, alpha), _, clip):
                self._page(target).clear(alpha << 24 | red << 16 | green << 8 | blue, clip)
            case Upload(target):
                self._page(target).items.append(upload_picture(command))
            case Draw() | DrawMesh():
                self._draw(batch_of(command, commands))
            case Settle():
                pass

    def _draw(self, batch: Batch) -> None:
        target, units = batch.pipeline.target, units_of(batch, self._page)
        if batch.pipeline.depth_test:
            self._waiting[target] += units
        else:
            self._page(target).items += [unit.item for unit in units]
