"""What is shown over a sketch's picture, drawn on a canvas of its own just before it is shown.

The sketch has no part in it: `get()` and `saveFrame()` find its own pixels alone.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P2D
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target

SAMPLES = 4

Draw = Callable[[PGraphics], None]


@dataclass(frozen=True)
class Picture:
    """What is on a target, as an image that `image()` takes."""

    target: Target

    @property
    def width(self) -> int:
        """Width in the sketch's units."""
        return self.target.across

    @property
    def height(self) -> int:
        """Height in the sketch's units."""
        return self.target.down

    def _texture(self) -> Target:
        return self.target


class Overlay:
    """A canvas on which a picture lies and something is drawn over it.

    Parameters
    ----------
    backend : Backend
        What draws the picture too.
    """

    def __init__(self, backend: Backend) -> None:
        self._renderer = Renderer(backend)  # its own: nothing of it is counted as the sketch's
        self._blank = PGraphics(self._renderer, Target(1, 1))
        self._canvas: PGraphics | None = None

    def over(self, picture: Target, size: tuple[int, int], draw: Draw) -> Target:
        """Return a picture with something drawn over it.

        Parameters
        ----------
        picture : Target
            It lies at the top left, at its own size.
        size : (width, height)
            Of what is shown, in the sketch's units.
        draw : callable
            Takes the canvas; the picture lies on it already.
        """
        canvas = self._canvas_of(size, picture.density)
        with canvas:
            canvas.background(0)
            canvas.image(Picture(picture), 0, 0, picture.across, picture.down)
            canvas.push()
            draw(canvas)
            canvas.pop()
        self._renderer.flush()
        return canvas.target

    def _canvas_of(self, size: tuple[int, int], density: int) -> PGraphics:
        if self._canvas is None:
            self._canvas = self._blank.offscreen(*size, P2D, SAMPLES)
        canvas = self._canvas
        if (canvas.width, canvas.height, canvas.target.density) != (*size, density):
            canvas.resize(*size, P2D, SAMPLES, density)
        return canvas
