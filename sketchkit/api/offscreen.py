"""createGraphics(): canvases beside the window's."""

from __future__ import annotations

from sketchkit.api._sketch_parts import SMOOTH_SAMPLES, Canvas, SketchParts
from sketchkit.api.environment import SIZE_USAGE, checked_size, known_renderer
from sketchkit.api.page_files import WRITERS, begin_recording, write_recording
from sketchkit.core.constants import JAVA2D


class Offscreen(SketchParts):
    """Canvases that are drawn on out of sight."""

    def createGraphics(
        self, w: float, h: float, renderer: str = JAVA2D, path: str | None = None
    ) -> Canvas:
        """Make a canvas out of sight: to be shown with `image()`, or used as a texture.

        Parameters
        ----------
        w, h : float, pixels
            At least 1; a fraction is cut off.
        renderer : P2D or P3D, optional
            `P3D` gives depth, camera and lights. Without it the canvas is flat.
        path : str, optional
            With `SVG` or `PDF` for renderer: the file that is drawn into as well. `endDraw()`
            writes it.

        Returns
        -------
        PGraphics
            Transparent at first. It has a style, a matrix and lights of its own.

        Raises
        ------
        SketchError
            If a number is missing or below 1, or the renderer is unknown.

        See Also
        --------
        image, texture, PGraphics

        Notes
        -----
        Draw on it between its `beginDraw()` and `endDraw()`, or `with pg:`. Source:
        Processing's reference, createGraphics().

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> pg.beginDraw()
        >>> pg.background(0, 60, 90)
        >>> pg.circle(30, 30, 40)
        >>> pg.endDraw()
        >>> image(pg, 20, 20)
        """
        columns, rows = checked_size("createGraphics", w, h, SIZE_USAGE)
        samples = SMOOTH_SAMPLES if self._format.smoothing else 1
        if renderer not in WRITERS:
            kind = known_renderer("createGraphics", renderer)
            return self.canvas.offscreen(columns, rows, kind, samples)
        canvas = self.canvas.offscreen(columns, rows, JAVA2D, samples)
        recording = begin_recording(canvas, renderer, path)
        canvas.when_drawn(lambda: write_recording(recording, self.folder))
        return canvas

    def getGraphics(self) -> Canvas:
        """Return the canvas of the window: what `g` is.

        Examples
        --------
        >>> getGraphics().circle(50, 50, 40)
        """
        return self.canvas
