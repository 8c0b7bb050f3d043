"""The canvas's size and kind, and the screen it is on."""

from __future__ import annotations

from sketchkit.api._sketch_parts import Phase, SketchParts
from sketchkit.api.live import LiveInt, live
from sketchkit.api.page_files import WRITERS, begin_recording
from sketchkit.core.constants import FX2D, JAVA2D, P2D, P3D
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.core.notices import warn_once

RENDERERS = (P2D, P3D, JAVA2D, FX2D)
SIZE_USAGE = "width, height [, renderer]"
LARGEST_SIDE = 16384  # px; what OpenGL drivers take


class Environment(SketchParts):
    """`size()` and its relatives."""

    def size(
        self, width: float, height: float, renderer: str = JAVA2D, path: str | None = None
    ) -> None:
        """Set the size of the canvas, and whether it is drawn on in two or three dimensions.

        Parameters
        ----------
        width, height : float, pixels
            At least 1; a fraction is cut off.
        renderer : P2D, P3D, JAVA2D, FX2D, SVG or PDF
            `P3D` gives depth, camera and lights. The others draw flat shapes, all in the same way.
        path : str, optional
            With `SVG` or `PDF` for renderer: the file that all is drawn into as well. It is written
            when the sketch ends.

        Raises
        ------
        SketchError
            If a number is missing or below 1, if something has been drawn already, or in `draw()`.

        See Also
        --------
        fullScreen, smooth, noSmooth, windowResize

        Notes
        -----
        Write it first in `setup()`. Without it the canvas has 100 by 100 pixels.

        Examples
        --------
        >>> size(640, 360)
        >>> size(640, 480, P3D)
        """
        self._must_come_before_draw("size", "windowResize(width, height) changes the size later.")
        columns, rows = checked_size("size", width, height, SIZE_USAGE)
        if self.canvas.has_shapes:
            raise SketchError(
                "size() comes before anything is drawn: it begins a new, empty canvas.",
                hint="Write size() as the first line of setup().",
            )
        is_file = renderer in WRITERS
        self._format.renderer = JAVA2D if is_file else known_renderer("size", renderer)
        self._format.width, self._format.height = columns, rows
        self._reformat()
        self._host.set_size(columns, rows)
        if is_file:
            self._recordings["size"] = begin_recording(self.canvas, renderer, path)

    def fullScreen(self, *which: str | int) -> None:
        """Use the whole screen as the canvas.

        Parameters
        ----------
        *which : renderer, display
            `P2D` or `P3D`; the number of a screen, from 1, or `SPAN` for all of them together.

        Notes
        -----
        `sketchkit render` has no screen: there it is one of 1920 by 1080 pixels.

        Examples
        --------
        >>> fullScreen()
        >>> fullScreen(P3D, 2)
        """
        self._must_come_before_draw("fullScreen", None)
        renderers = [value for value in which if isinstance(value, str)]
        display = next((value for value in which if isinstance(value, int)), None)
        self._format.renderer = known_renderer("fullScreen", renderers[0]) if renderers else JAVA2D
        self._format.width, self._format.height = self._host.display_size(display)
        self._reformat()
        self._host.set_fullscreen(display)

    def smooth(self, level: int = 2) -> None:
        """Draw edges softly, as it is done without this call as well.

        Parameters
        ----------
        level : int
            0 is hard edges; all other levels are the same here: four samples for each pixel.

        See Also
        --------
        noSmooth

        Examples
        --------
        >>> size(200, 200)
        >>> smooth()
        """
        self._set_smoothing("smooth", int(level))

    def noSmooth(self) -> None:
        """Draw edges hard: every pixel belongs to a shape or does not.

        Notes
        -----
        It belongs in `setup()`, after `size()`.

        Examples
        --------
        >>> size(200, 200)
        >>> noSmooth()
        """
        self._set_smoothing("noSmooth", 0)

    @property
    @live
    def pixelDensity(self) -> LiveInt:
        """How many pixels there are for one of the sketch's units, each way: 1 or 2.

        On a screen of high density, as Apple's Retina, it is 2 by itself: all is drawn twice as
        finely. As a function, `pixelDensity(1)`, it asks for another density; 2 only holds on such
        a screen. `sketchkit render` has a screen of density 1, or what `--density` says.

        Examples
        --------
        >>> pixelDensity(1)
        >>> println(pixelDensity)
        """
        return LiveInt(self._format.density, self._set_density)

    def displayDensity(self, display: int = 1) -> int:
        """Return the highest density that `pixelDensity()` can set: 2 on fine screens, or 1.

        Examples
        --------
        >>> pixelDensity(displayDensity())
        """
        return self._host.density

    @property
    @live
    def width(self) -> int:
        """Width of the canvas, in pixels.

        Examples
        --------
        >>> line(0, 0, width, height)
        """
        return self.canvas.width

    @property
    @live
    def height(self) -> int:
        """Height of the canvas, in pixels.

        Examples
        --------
        >>> line(0, 0, width, height)
        """
        return self.canvas.height

    @property
    @live
    def pixelWidth(self) -> int:
        """Columns of the canvas's pixels: `width` times `pixelDensity`.

        Examples
        --------
        >>> println(pixelWidth)
        """
        return self.canvas.target.width

    @property
    @live
    def pixelHeight(self) -> int:
        """Rows of the canvas's pixels: `height` times `pixelDensity`.

        Examples
        --------
        >>> println(pixelHeight)
        """
        return self.canvas.target.height

    @property
    @live
    def displayWidth(self) -> int:
        """Width of the screen, in pixels.

        Examples
        --------
        >>> size(displayWidth // 2, displayHeight // 2)
        """
        return self._host.display_size()[0]

    @property
    @live
    def displayHeight(self) -> int:
        """Height of the screen, in pixels.

        Examples
        --------
        >>> size(displayWidth // 2, displayHeight // 2)
        """
        return self._host.display_size()[1]

    @property
    @live
    def focused(self) -> bool:
        """Whether the keys that are pressed go to the sketch's window.

        Examples
        --------
        >>> if not focused:
        ...     text("click me", 20, 20)
        """
        return self._host.is_focused

    def _set_smoothing(self, name: str, level: int) -> None:
        if bool(level) == bool(self._format.smoothing):
            return
        if self.progress.phase is Phase.DRAW:
            warn_once(f"{name}() has no effect in draw(): write it in setup(), after size().")
            return
        self._format.smoothing = level
        self._reformat()

    def _set_density(self, density: int) -> None:
        if density not in (1, 2):
            raise SketchError("pixelDensity() takes 1 or 2.", got=f"pixelDensity({shown(density)})")
        if density > self._host.density:
            warn_once("pixelDensity(2) has no effect: this screen has no finer pixels.")
        elif density != self._format.density:
            self._must_come_before_draw("pixelDensity", None)
            self._format.density = int(density)
            self._reformat()

    def _must_come_before_draw(self, name: str, hint: str | None) -> None:
        if self.progress.phase is Phase.DRAW:
            raise SketchError(f"{name}() belongs at the beginning of setup().", hint=hint)


def checked_size(name: str, width: float, height: float, usage: str) -> tuple[int, int]:
    """Return the columns and rows of a canvas.

    Raises
    ------
    SketchError
        If they are no numbers, or too small or too large.
    """
    try:
        columns, rows = int(width + 0), int(height + 0)
    except (TypeError, ValueError, OverflowError):
        raise wrong_numbers(name, (width, height), usage) from None
    if not (1 <= columns <= LARGEST_SIDE and 1 <= rows <= LARGEST_SIDE):
        raise SketchError(
            f"A canvas has at least 1 and at most {LARGEST_SIDE} pixels each way.",
            got=f"{name}({shown(width)}, {shown(height)})",
        )
    return columns, rows


def known_renderer(name: str, renderer: object) -> str:
    """Return the renderer that a function was given, or raise a SketchError."""
    if renderer not in RENDERERS:
        raise SketchError(
            f"The renderer of {name}() is P2D or P3D, without quotes.", got=shown(renderer)
        )
    return str(renderer)
