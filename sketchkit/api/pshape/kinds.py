"""The kinds of shapes, by the name of their class."""

from __future__ import annotations

from typing import Final

from sketchkit.core import constants as c


class ShapeKinds:
    """`createShape(PShape.GROUP)` is `createShape(GROUP)`, as in Processing."""

    GROUP: Final = c.GROUP
    POINT: Final = c.POINT
    LINE: Final = c.LINE
    TRIANGLE: Final = c.TRIANGLE
    QUAD: Final = c.QUAD
    RECT: Final = c.RECT
    ELLIPSE: Final = c.ELLIPSE
    ARC: Final = c.ARC
    SPHERE: Final = c.SPHERE
    BOX: Final = c.BOX

    POINTS: Final = c.POINTS
    LINES: Final = c.LINES
    TRIANGLES: Final = c.TRIANGLES
    TRIANGLE_STRIP: Final = c.TRIANGLE_STRIP
    TRIANGLE_FAN: Final = c.TRIANGLE_FAN
    QUADS: Final = c.QUADS
    QUAD_STRIP: Final = c.QUAD_STRIP
