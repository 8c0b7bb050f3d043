"""A shape displays itself in a notebook: as large as fits, in the middle of a small canvas."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sketchkit.api.pshape.measures import ShapeMeasures
from sketchkit.assets.output import picture_bytes
from sketchkit.core.constants import P2D, P3D

if TYPE_CHECKING:
    from sketchkit.api.graphics import PGraphics
    from sketchkit.api.pshape.shape import PShape

SIDE = 240  # px
FILLED = 0.85  # of the canvas, so that strokes have room
TILT, TURN = -0.4, 0.6  # radians: a solid is seen from above and from the side
SAMPLES = 4


class ShapeDisplay(ShapeMeasures):
    """For notebooks alone: a sketch does not see it."""

    def _repr_png_(self) -> bytes:
        """Return a picture of the shape, as Jupyter asks for it."""
        (left, top, near), (right, bottom, far) = self._bounds()
        is_3d = self._canvas._is_3d
        sizes = (right - left, bottom - top, far - near)
        length = sum(size * size for size in sizes) ** 0.5 if is_3d else max(sizes[:2])
        canvas = cast("PGraphics", self._canvas).offscreen(
            SIDE, SIDE, P3D if is_3d else P2D, SAMPLES
        )
        with canvas:
            canvas.background(255)
            canvas.translate(SIDE / 2, SIDE / 2)
            if is_3d:
                canvas.lights()
                canvas.rotateX(TILT)
                canvas.rotateY(TURN)
            canvas.scale(SIDE * FILLED / length if length else 1.0)
            middle = [-(a + b) / 2 for a, b in ((left, right), (top, bottom), (near, far))]
            canvas.translate(*middle if is_3d else middle[:2])
            canvas.shape(cast("PShape", self))
        return picture_bytes(canvas.image_data()[..., :3], ".png")
