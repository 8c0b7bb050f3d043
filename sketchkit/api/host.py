"""What a sketch may ask of the place where it is shown: a window, or none at all.

`Host` is what the runtime offers; `PSurface` is what the sketch sees of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from sketchkit.api.pimage import PImage
from sketchkit.core.constants import ARROW
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.notices import warn_once
from sketchkit.draw.vertex import U8


class Host(Protocol):
    """Where a sketch is shown. Lengths are in the sketch's own units."""

    @property
    def density(self) -> int:
        """How many pixels of the screen there may be for one of the sketch's, each way: 1 or 2."""
        ...

    @property
    def position(self) -> tuple[int, int]:
        """Left and top edge of the window on the screen."""
        ...

    @property
    def is_focused(self) -> bool:
        """Whether keys go to the window."""
        ...

    def display_size(self, display: int | None = None) -> tuple[int, int]:
        """Return width and height of a screen: by number from 1, of all for 0, of the main one."""
        ...

    def set_size(self, width: int, height: int) -> None:
        """Follow the canvas, which has got another size."""
        ...

    def set_fullscreen(self, display: int | None = None) -> None:
        """Cover a screen, or all of them, as `display_size` counts them."""
        ...

    def set_title(self, title: str) -> None:
        """Write on the window's edge."""
        ...

    def set_position(self, x: int, y: int) -> None:
        """Move the window."""
        ...

    def set_resizable(self, is_resizable: bool) -> None:
        """Let the user change the window's size, or not."""
        ...

    def set_visible(self, is_visible: bool) -> None:
        """Show the window, or hide it."""
        ...

    def set_always_on_top(self, is_on_top: bool) -> None:
        """Keep the window above all others, or not."""
        ...

    def set_icon(self, pixels: U8) -> None:
        """Give the window an icon, (h, w, 4) RGBA."""
        ...

    def set_cursor(self, kind: int | None) -> None:
        """Show the pointer as `ARROW`, `CROSS`, `HAND`, `MOVE`, `TEXT` or `WAIT`; None hides it."""
        ...

    def open_link(self, url: str) -> None:
        """Show a page in the browser."""
        ...

    def launch(self, arguments: Sequence[str]) -> None:
        """Open a file with its program, or start a program."""
        ...

    def choose_file(
        self, kind: str, prompt: str, start: str, then: Callable[[str | None], None]
    ) -> None:
        """Ask for a path of a kind, "input", "output" or "folder"; `then` gets it, or None."""
        ...

    def set_cursor_image(self, pixels: U8, x: int, y: int) -> None:
        """Show the pointer as an image, (h, w, 4) RGBA, of which (x, y) is where it points."""
        ...


class NoWindow:
    """A host that shows nothing: the screen is always the same, and what is set has no effect.

    What would leave the sketch does nothing either, and says so.

    Parameters
    ----------
    density : int
        1 or 2 pixels for each unit of the sketch, each way.
    """

    density = 1
    position = (0, 0)
    is_focused = False

    def __init__(self, density: int = 1) -> None:
        self.density = density

    def display_size(self, display: int | None = None) -> tuple[int, int]:
        """Return always the same."""
        return 1920, 1080

    def set_size(self, width: int, height: int) -> None:
        """Do nothing."""

    def set_fullscreen(self, display: int | None = None) -> None:
        """Do nothing."""

    def set_title(self, title: str) -> None:
        """Do nothing."""

    def set_position(self, x: int, y: int) -> None:
        """Do nothing."""

    def set_resizable(self, is_resizable: bool) -> None:
        """Do nothing."""

    def set_visible(self, is_visible: bool) -> None:
        """Do nothing."""

    def set_always_on_top(self, is_on_top: bool) -> None:
        """Do nothing."""

    def set_icon(self, pixels: U8) -> None:
        """Do nothing."""

    def set_cursor(self, kind: int | None) -> None:
        """Do nothing."""

    def open_link(self, url: str) -> None:
        """Say that nothing is shown."""
        warn_once("link() shows nothing where there is no window.")

    def launch(self, arguments: Sequence[str]) -> None:
        """Say that nothing is started."""
        warn_once("launch() starts nothing where there is no window.")

    def choose_file(
        self, kind: str, prompt: str, start: str, then: Callable[[str | None], None]
    ) -> None:
        """Say that nobody is asked."""
        warn_once(
            f"select{kind.capitalize()}() asks nobody where there is no window: its function is "
            "not called."
        )

    def set_cursor_image(self, pixels: U8, x: int, y: int) -> None:
        """Do nothing."""


class WindowFunctions(Protocol):
    """The sketch, as the surface sees it."""

    def windowResize(self, newWidth: float, newHeight: float) -> None:
        """Give canvas and window another size."""
        ...

    def cursor(self, kind: int | PImage = ARROW, *hotspot: float) -> None:
        """Show the pointer."""
        ...

    def noCursor(self) -> None:
        """Hide the pointer."""
        ...


class PSurface:
    """The window, as `surface.setTitle("Spinning")`; also known as `frame`.

    Examples
    --------
    >>> isinstance(surface, PSurface)
    True
    """

    def __init__(self, host: Host, sketch: WindowFunctions) -> None:
        self._host = host
        self._sketch = sketch

    def setTitle(self, title: str) -> None:
        """Write a text on the window's edge.

        Examples
        --------
        >>> surface.setTitle("Spinning")
        """
        self._host.set_title(str(title))

    def setSize(self, width: float, height: float) -> None:
        """Give the window another size.

        Examples
        --------
        >>> surface.setSize(400, 300)
        """
        self._sketch.windowResize(width, height)

    def setLocation(self, x: float, y: float) -> None:
        """Move the window's left and top edge to a place on the screen.

        Examples
        --------
        >>> surface.setLocation(100, 80)
        """
        self._host.set_position(int(x), int(y))

    def setResizable(self, resizable: bool) -> None:
        """Let the user drag the window to another size, or not.

        Examples
        --------
        >>> surface.setResizable(True)
        """
        self._host.set_resizable(bool(resizable))

    def setVisible(self, visible: bool) -> None:
        """Show the window, or hide it.

        Examples
        --------
        >>> surface.setVisible(True)
        """
        self._host.set_visible(bool(visible))

    def setAlwaysOnTop(self, always: bool) -> None:
        """Keep the window above all others, or not.

        Examples
        --------
        >>> surface.setAlwaysOnTop(True)
        """
        self._host.set_always_on_top(bool(always))

    def setIcon(self, icon: PImage) -> None:
        """Give the window an icon, for the list of windows and, on some systems, its edge.

        Examples
        --------
        >>> surface.setIcon(createImage(32, 32, ARGB))
        """
        self._host.set_icon(picture_of("setIcon", icon))

    def setCursor(self, kind: int | PImage, *hotspot: float) -> None:
        """Show the pointer in one of its shapes, or as an image: as `cursor()`.

        Examples
        --------
        >>> surface.setCursor(CROSS)
        """
        self._sketch.cursor(kind, *hotspot)

    def showCursor(self) -> None:
        """Show the pointer again, as an arrow.

        Examples
        --------
        >>> surface.showCursor()
        """
        self._sketch.cursor()

    def hideCursor(self) -> None:
        """Hide the pointer while it is over the window.

        Examples
        --------
        >>> surface.hideCursor()
        """
        self._sketch.noCursor()


def picture_of(caller: str, image: object) -> U8:
    """Return the pixels of an image, (h, w, 4) RGBA.

    Raises
    ------
    SketchError
        If it is none.
    """
    if not isinstance(image, PImage):
        raise SketchError(
            f"{caller}() takes an image.",
            got=f"{caller}({shown(image)})",
            hint="loadImage() and createImage() make one.",
        )
    return image._texture().data
