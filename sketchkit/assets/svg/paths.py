"""The outlines of an SVG file as Processing's PShape has them: points, and codes that read them.

svgelements reads the letters and numbers; what becomes of them is Processing's. It is 32-bit
arithmetic all through: the number of pieces of an arc hangs on the last bit.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.svg.arcs import Arc, arc_curves
from sketchkit.assets.svg.measures import finite, numbers, shortened
from sketchkit.core.constants import BEZIER_VERTEX, BREAK, QUADRATIC_VERTEX, VERTEX
from sketchkit.core.float32 import f32

F32 = NDArray[np.float32]
Place: TypeAlias = tuple[float, float]

POINTS_OF = {VERTEX: 1, BEZIER_VERTEX: 3, QUADRATIC_VERTEX: 2, BREAK: 0}
START: Place = (0.0, 0.0)
CONTROL = 0.4476  # of a corner's radius: where Processing has the control points of round corners


@dataclass(frozen=True, slots=True)
class Outline:
    """What `beginShape()` to `endShape()` would draw.

    `vertices` is (n, 2). Each code takes some of them: VERTEX 1, QUADRATIC_VERTEX 2, BEZIER_VERTEX
    3, and BREAK, which begins another contour, none. Without codes each vertex is a corner.
    """

    vertices: F32
    codes: tuple[int, ...] = ()
    is_closed: bool = False


def read_path(data: str) -> Outline:
    """Return the outline of the `d` of a path.

    All contours are filled together, by the nonzero rule, and all are closed if one is.

    Raises
    ------
    ValueError
        If a command is unknown, or has not the numbers it needs.
    """
    from svgelements import SVGLexicalParser  # 25 ms, and few sketches load an SVG file

    pen, lexer = _Pen(), SVGLexicalParser()
    try:
        with np.errstate(all="ignore"):  # too large numbers are told below
            lexer.parse(pen, data)
    except (ArithmeticError, LookupError, TypeError, ValueError):  # it has no error of its own
        raise _wrong(data, lexer.pos) from None
    if data[lexer.pos :].strip(" \t\r\n\f,"):  # there the library stops without a word
        raise _wrong(data, lexer.pos)
    vertices = np.array(pen.vertices, np.float64).reshape(-1, 2)
    finite(float(np.abs(vertices).max(initial=0.0)))
    return Outline(vertices.astype(np.float32), tuple(pen.codes), pen.is_closed)


def read_points(text: str, *, is_closed: bool) -> Outline:
    """Return the outline of the `points` of a polygon or polyline.

    Raises
    ------
    ValueError
        If there is something else than numbers in it.
    """
    values = numbers(text)
    pairs = len(values) // 2 * 2  # a number without a partner is left out
    return Outline(np.array(values[:pairs], np.float32).reshape(-1, 2), (), is_closed)


def rounded_rect(rect: tuple[float, ...], rx: float, ry: float) -> Outline:
    """Return a rectangle (left, top, width, height) whose corners are parts of ellipses."""
    left, top, width, height = rect
    right, bottom = left + width, top + height
    corners = [  # each: the corner, then the way in and out of it, in radii
        (left, top, (0, 1), (1, 0)),
        (right, top, (-1, 0), (0, 1)),
        (right, bottom, (0, -1), (-1, 0)),
        (left, bottom, (1, 0), (0, -1)),
    ]
    vertices = [
        (x + along * rx * share, y + down * ry * share)
        for x, y, enter, leave in corners
        for (along, down), share in ((enter, 1), (enter, CONTROL), (leave, CONTROL), (leave, 1))
    ]
    return Outline(np.array(vertices, np.float32), (VERTEX, BEZIER_VERTEX) * 4, True)


def _wrong(data: str, place: int) -> ValueError:
    before = shortened(data[max(place - 20, 0) : place])
    return ValueError(
        f"its path cannot be read after {before!r}" if before else "its path cannot be read"
    )


@dataclass(slots=True)
class _Pen:
    """Draws what svgelements reads; the names of its methods are that library's."""

    vertices: list[Place] = field(default_factory=list)
    codes: list[int] = field(default_factory=list)
    is_closed: bool = False
    place: Place = START
    contour_start: Place = START
    has_curves: bool = False
    current_point: None = None  # or the library would add it, in 64 bits

    def start(self) -> None:
        """Begin: nothing is drawn yet."""

    def end(self) -> None:
        """End: nothing is left to do."""

    def move(self, end: Place, *, relative: bool) -> None:
        """Begin a contour."""
        if self.vertices:
            self.codes.append(BREAK)
        self._add(VERTEX, self._placed(end, relative))
        self.contour_start = self.place

    def closed(self, *, relative: bool) -> None:
        """Close the outline; what follows starts where the contour did, without a new one."""
        self.is_closed = True
        self.place = self.contour_start

    def line(self, end: Place, *, relative: bool) -> None:
        """Go straight."""
        self._add(VERTEX, self._placed(end, relative))

    def horizontal(self, x: float, *, relative: bool) -> None:
        """Go straight along x."""
        self._add(VERTEX, (self._placed((x, 0.0), relative)[0], self.place[1]))

    def vertical(self, y: float, *, relative: bool) -> None:
        """Go straight along y."""
        self._add(VERTEX, (self.place[0], self._placed((0.0, y), relative)[1]))

    def cubic(self, first: Place, second: Place, end: Place, *, relative: bool) -> None:
        """Go along a Bezier curve."""
        points = (self._placed(point, relative) for point in (first, second, end))
        self._add(BEZIER_VERTEX, *points)

    def smooth_cubic(self, second: Place, end: Place, *, relative: bool) -> None:
        """Go on along a Bezier curve."""
        points = self._placed(second, relative), self._placed(end, relative)
        self._add(BEZIER_VERTEX, self._mirrored(), *points)

    def quad(self, control: Place, end: Place, *, relative: bool) -> None:
        """Go along a quadratic curve."""
        points = self._placed(control, relative), self._placed(end, relative)
        self._add(QUADRATIC_VERTEX, *points)

    def smooth_quad(self, end: Place, *, relative: bool) -> None:
        """Go on along a quadratic curve."""
        self._add(QUADRATIC_VERTEX, self._mirrored(), self._placed(end, relative))

    def arc(  # noqa: PLR0913  svgelements' signature
        self,
        rx: float,
        ry: float,
        rotation: float,
        is_large: bool | None,
        is_clockwise: bool | None,
        end: Place,
        *,
        relative: bool,
    ) -> None:
        """Go along a part of an ellipse; a flag that is neither 0 nor 1 comes as None."""
        if is_large is None or is_clockwise is None:
            raise ValueError("a flag is 0 or 1")
        self.has_curves = True
        start, place = self.place, self._placed(end, relative)
        if place == start:
            return
        if rx == 0 or ry == 0:
            self._add(VERTEX, place)
        else:
            arc = Arc(start, place, (rx, ry), rotation, is_large, is_clockwise)
            for curve in arc_curves(arc):
                self._add(BEZIER_VERTEX, *curve)

    def _placed(self, point: Place, relative: bool) -> Place:
        """Return a point of the file in the drawing's coordinates, rounded as Processing does."""
        x, y = f32(point[0]), f32(point[1])
        return (f32(x + self.place[0]), f32(y + self.place[1])) if relative else (x, y)

    def _add(self, code: int, *points: Place) -> None:
        if code != VERTEX:
            if not self.vertices:
                raise ValueError("a curve needs a place to start from")
            self.has_curves = True
        self.codes.append(code)
        self.vertices += points
        self.place = points[-1]

    def _mirrored(self) -> Place:
        """Return the control point opposite to the last one, seen from where the pen is.

        Once there was a curve, Processing takes the last two points, be they of a line.
        """
        if not self.has_curves:
            return self.place
        (x, y), (from_x, from_y) = self.vertices[-1], self.vertices[-2]
        return f32(x + f32(x - from_x)), f32(y + f32(y - from_y))
