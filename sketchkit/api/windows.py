"""The window around the canvas, and the pointer over it."""

from __future__ import annotations

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.host import PSurface, picture_of
from sketchkit.api.live import live
from sketchkit.api.pimage import PImage
from sketchkit.core.constants import ARROW, CROSS, HAND, MOVE, TEXT, WAIT
from sketchkit.core.errors import SketchError, shown, wrong_numbers

CURSORS = (ARROW, CROSS, HAND, MOVE, TEXT, WAIT)


class Windows(SketchParts):
    """Title, place and size of the window. `sketchkit render` has none: there they do nothing."""

    def windowTitle(self, title: str) -> None:
        """Write a text on the window's edge.

        Examples
        --------
        >>> windowTitle("Spinning")
        """
        self._host.set_title(str(title))

    def windowMove(self, x: float, y: float) -> None:
        """Move the window's left and top edge to a place on the screen.

        Examples
        --------
        >>> windowMove(100, 80)
        """
        self._host.set_position(int(x), int(y))

    def windowResizable(self, resizable: bool) -> None:
        """Let the user drag the window to another size, or not.

        Notes
        -----
        When that happens, `width` and `height` change and `windowResized()` is called.

        Examples
        --------
        >>> windowResizable(True)
        """
        self._host.set_resizable(bool(resizable))

    def windowResize(self, newWidth: float, newHeight: float) -> None:
        """Give the canvas and its window another size; what was drawn is lost.

        Parameters
        ----------
        newWidth, newHeight : float, pixels
            At least 1.

        Raises
        ------
        SketchError
            If one is no number or below 1.

        Examples
        --------
        >>> windowResize(400, 300)
        """
        try:
            columns, rows = int(newWidth), int(newHeight)
        except (TypeError, ValueError):
            raise wrong_numbers("windowResize", (newWidth, newHeight), "width, height") from None
        if columns < 1 or rows < 1:
            got = f"windowResize({columns}, {rows})"
            raise SketchError("A window has at least one pixel each way.", got=got)
        self.follow_window(columns, rows)
        self._host.set_size(columns, rows)

    def follow_window(self, width: int, height: int) -> None:
        """Give the canvas the size that its window has got."""
        self._format.width, self._format.height = width, height
        self._reformat()

    def setTitle(self, title: str) -> None:
        """Write a text on the window's edge: the older name of `windowTitle()`.

        Examples
        --------
        >>> setTitle("Spinning")
        """
        self.windowTitle(title)

    def setLocation(self, x: float, y: float) -> None:
        """Move the window: the older name of `windowMove()`.

        Examples
        --------
        >>> setLocation(100, 80)
        """
        self.windowMove(x, y)

    def setResizable(self, resizable: bool) -> None:
        """Let the user change the window's size: the older name of `windowResizable()`.

        Examples
        --------
        >>> setResizable(True)
        """
        self.windowResizable(resizable)

    def cursor(self, kind: int | PImage = ARROW, *hotspot: float) -> None:
        """Show the pointer, in one of its shapes or as an image.

        Parameters
        ----------
        kind : ARROW, CROSS, HAND, MOVE, TEXT, WAIT or PImage
            The shape; an image should have 16 by 16 or 32 by 32 pixels.
        *hotspot : 2 float, pixels
            Which place of the image it is that points: x and y. Without them, its middle.

        Raises
        ------
        SketchError
            If there is no such shape, or the hot spot is not in the image.

        See Also
        --------
        noCursor

        Examples
        --------
        >>> cursor(CROSS)
        """
        if isinstance(kind, PImage):
            self._show_image(kind, hotspot)
            return
        if kind not in CURSORS:
            raise SketchError(
                "cursor() takes ARROW, CROSS, HAND, MOVE, TEXT, WAIT or an image.",
                got=f"cursor({shown(kind)})",
            )
        self._host.set_cursor(kind)

    def noCursor(self) -> None:
        """Hide the pointer while it is over the window.

        Examples
        --------
        >>> noCursor()
        """
        self._host.set_cursor(None)

    def _show_image(self, image: PImage, hotspot: tuple[float, ...]) -> None:
        """Show the pointer as an image."""
        width, height = image.width, image.height
        usage = "image [, x, y]"
        try:
            x, y = map(int, hotspot or (width // 2, height // 2))
        except (TypeError, ValueError):
            raise wrong_numbers("cursor", (image, *hotspot), usage) from None
        if not (0 <= x < width and 0 <= y < height):
            raise SketchError(
                f"The place that points must be in the image: {width} by {height} pixels.",
                got=f"cursor(image, {x}, {y})",
            )
        self._host.set_cursor_image(picture_of("cursor", image), x, y)

    @property
    @live
    def windowX(self) -> int:
        """Where the window's left edge is on the screen, in pixels.

        Examples
        --------
        >>> println(windowX)
        """
        return self._host.position[0]

    @property
    @live
    def windowY(self) -> int:
        """Where the window's top edge is on the screen, in pixels.

        Examples
        --------
        >>> println(windowY)
        """
        return self._host.position[1]

    def setSize(self, width: float, height: float) -> None:
        """Give the window another size: an older name of `windowResize()`.

        Examples
        --------
        >>> setSize(400, 300)
        """
        self.windowResize(width, height)

    def getSurface(self) -> PSurface:
        """Return the window as an object: what `surface` is.

        Examples
        --------
        >>> getSurface().setTitle("Spinning")
        """
        return PSurface(self._host, self)

    @property
    def surface(self) -> PSurface:
        """The window as an object: `surface.setTitle("Spinning")`.

        Examples
        --------
        >>> surface.setTitle("Spinning")
        >>> surface.setResizable(True)
        """
        return PSurface(self._host, self)

    @property
    def frame(self) -> PSurface:
        """The window as an object, by its older name: see `surface`.

        Examples
        --------
        >>> frame.setTitle("Spinning")
        """
        return PSurface(self._host, self)
