"""CanvasPages: what was drawn on each canvas, as a page."""

from __future__ import annotations

from collections.abc import Callable

from sketchkit.draw.commands import Upload
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8
from sketchkit.vector.page import Page
from sketchkit.vector.pictures import upload_picture


class CanvasPages:
    """The pages of canvases."""

    def __init__(self, look: Callable[[Target], U8]) -> None:
        self._look = look
        self._pages: dict[Target, Page] = {}

    def begin(self, target: Target) -> Page:
        """Return an empty page for a canvas."""
        page = self._pages[target] = Page(target.across, target.down)
        return page

    def page(self, target: Target) -> Page:
        """Return the page of a canvas; a new one begins with what is on the canvas already."""
        page = self._pages.get(target)
        if page is None:
            page = self.begin(target)
            page.items.append(upload_picture(Upload(target, self._look(target))))
        return page
