"""Flat shapes. A call packs one row of numbers; what they mean is worked out later, in bulk."""

from __future__ import annotations

from sketchkit.api.curve_vertices import CurveVertices
from sketchkit.core.constants import CLOSE, POLYGON
from sketchkit.core.errors import SketchError
from sketchkit.draw.recorder import (
    ROW,
    Kind,
    PackError,
    pack_row3,
    pack_row4,
    pack_row6,
    pack_row7,
    pack_row8,
)
from sketchkit.geometry.ellipses import wrap_angles
from sketchkit.geometry.rects import rect_edges

# Bound once: looking an enum's member up takes a third of the time that packing a row takes.
POINT, LINE, TRIANGLE, QUAD = (
    Kind.POINT.value,
    Kind.LINE.value,
    Kind.TRIANGLE.value,
    Kind.QUAD.value,
)
RECT, ELLIPSE, ARC = Kind.RECT.value, Kind.ELLIPSE.value, Kind.ARC.value

POINT_USAGE = "x, y [, z]"
LINE_USAGE = "x1, y1, x2, y2 | x1, y1, z1, x2, y2, z2"
TRIANGLE_USAGE = "x1, y1, x2, y2, x3, y3"
QUAD_USAGE = "x1, y1, x2, y2, x3, y3, x4, y4"
RECT_USAGE = "x, y, width, height [, radius] | x, y, width, height, tl, tr, br, bl"
SQUARE_USAGE = "x, y, side"
ELLIPSE_USAGE = "x, y, width [, height]"
CIRCLE_USAGE = "x, y, diameter"
ARC_USAGE = "x, y, width, height, start, stop [, mode]"


class Shapes2D(CurveVertices):
    """Points, lines, and shapes in the plane z = 0 of the current matrix."""

    def point(self, x: float, y: float, z: float = 0.0) -> None:
        """Draw a point: a disc as wide as `strokeWeight()`, a square if the cap is not ROUND.

        Parameters
        ----------
        x, y, z : float, pixels

        See Also
        --------
        strokeWeight, stroke, line

        Notes
        -----
        Source: Processing's reference, point().

        Examples
        --------
        >>> strokeWeight(10)
        >>> point(50, 50)
        """
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        try:
            pack_row3(
                recorder.rows, end, POINT, state, self._fill, self._stroke, self._weight, 0, x, y, z
            )
        except PackError:
            self._again(self.point, (x, y, z), POINT_USAGE)
        else:
            recorder.row_end = end + ROW

    def line(
        self,
        x1: float,
        y1: float,
        x2: float,
        y2: float,
        x3: float | None = None,
        y3: float | None = None,
    ) -> None:
        """Draw a line.

        Parameters
        ----------
        x1, y1, x2, y2 : float, pixels
            From and to.
        x3, y3 : float, optional
            With six numbers they are x1, y1, z1, x2, y2, z2.

        See Also
        --------
        strokeWeight, strokeCap, beginShape

        Notes
        -----
        Source: Processing's reference, line().

        Examples
        --------
        >>> line(10, 10, 90, 60)
        """
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        ends = (x1, y1, 0.0, x2, y2, 0.0) if x3 is None else (x1, y1, x2, y2, x3, y3)
        try:
            pack_row6(
                recorder.rows, end, LINE, state, self._fill, self._stroke, self._weight, 0, *ends
            )
        except PackError:
            args = (x1, y1, x2, y2) if x3 is None else (x1, y1, x2, y2, x3, y3)
            self._again(self.line, args, LINE_USAGE)
        else:
            recorder.row_end = end + ROW

    def triangle(self, x1: float, y1: float, x2: float, y2: float, x3: float, y3: float) -> None:
        """Draw a triangle.

        Parameters
        ----------
        x1, y1, x2, y2, x3, y3 : float, pixels
            Its corners.

        Examples
        --------
        >>> triangle(20, 80, 50, 15, 80, 80)
        """
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        fill, stroke, weight = self._fill, self._stroke, self._weight
        try:
            pack_row6(
                recorder.rows, end, TRIANGLE, state, fill, stroke, weight, 0, x1, y1, x2, y2, x3, y3
            )
        except PackError:
            self._again(self.triangle, (x1, y1, x2, y2, x3, y3), TRIANGLE_USAGE)
        else:
            recorder.row_end = end + ROW

    def quad(
        self,
        x1: float,
        y1: float,
        x2: float,
        y2: float,
        x3: float,
        y3: float,
        x4: float,
        y4: float,
    ) -> None:
        """Draw a shape of four corners.

        Parameters
        ----------
        x1, y1, x2, y2, x3, y3, x4, y4 : float, pixels
            Its corners, in order around it.

        Examples
        --------
        >>> quad(20, 30, 80, 20, 70, 75, 30, 80)
        """
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        corners = (x1, y1, x2, y2, x3, y3, x4, y4)
        try:
            pack_row8(
                recorder.rows, end, QUAD, state, self._fill, self._stroke, self._weight, 0, *corners
            )
        except PackError:
            self._again(self.quad, corners, QUAD_USAGE)
        else:
            recorder.row_end = end + ROW

    def rect(self, a: float, b: float, c: float, d: float, *radii: float) -> None:
        """Draw a rectangle; `rectMode()` gives the four numbers their meaning.

        Parameters
        ----------
        a, b, c, d : float, pixels
            At first: x and y of a corner, width and height.
        *radii : float, optional
            One radius for all corners, or four: top left, top right, bottom right, bottom left.

        Raises
        ------
        SketchError
            If there are not 4, 5 or 8 numbers.

        See Also
        --------
        square, rectMode, quad

        Notes
        -----
        In P2D a rectangle that is not turned is moved to whole pixels, up to the next ones.
        Source: Processing's reference, rect().

        Examples
        --------
        >>> fill(200, 80, 40)
        >>> rect(20, 20, 60, 40)
        """
        if radii:
            return self._rounded_rect(a, b, c, d, *radii)
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        try:
            pack_row4(
                recorder.rows,
                end,
                RECT,
                state,
                self._fill,
                self._stroke,
                self._weight,
                0,
                a,
                b,
                c,
                d,
            )
        except PackError:
            return self._again(self.rect, (a, b, c, d), RECT_USAGE)
        recorder.row_end = end + ROW
        return None

    def square(self, x: float, y: float, extent: float) -> None:
        """Draw a square; `rectMode()` gives the numbers their meaning.

        Parameters
        ----------
        x, y : float, pixels
            At first: a corner.
        extent : float, pixels
            Length of a side.

        Examples
        --------
        >>> square(20, 20, 60)
        """
        try:
            self.rect(x, y, extent, extent)
        except SketchError:
            self._refuse("square", (x, y, extent), SQUARE_USAGE)

    def ellipse(self, a: float, b: float, c: float, d: float | None = None) -> None:
        """Draw an ellipse; `ellipseMode()` gives the four numbers their meaning.

        Parameters
        ----------
        a, b, c, d : float, pixels
            At first: x and y of the centre, width and height. Without `d` it is as high as wide.

        See Also
        --------
        circle, ellipseMode, arc

        Notes
        -----
        It is a polygon of 20 to 200 sides, about one for 10 pixels. Source: Processing's
        reference, ellipse().

        Examples
        --------
        >>> ellipse(50, 50, 80, 40)
        """
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        height = c if d is None else d
        try:
            pack_row4(
                recorder.rows,
                end,
                ELLIPSE,
                state,
                self._fill,
                self._stroke,
                self._weight,
                0,
                a,
                b,
                c,
                height,
            )
        except PackError:
            self._again(self.ellipse, (a, b, c) if d is None else (a, b, c, d), ELLIPSE_USAGE)
        else:
            recorder.row_end = end + ROW

    def circle(self, x: float, y: float, extent: float) -> None:
        """Draw a circle; `ellipseMode()` gives the numbers their meaning.

        Parameters
        ----------
        x, y : float, pixels
            At first: the centre.
        extent : float, pixels
            The diameter.

        Examples
        --------
        >>> circle(50, 50, 60)
        """
        try:
            self.ellipse(x, y, extent, extent)
        except SketchError:
            self._refuse("circle", (x, y, extent), CIRCLE_USAGE)

    def arc(
        self, a: float, b: float, c: float, d: float, start: float, stop: float, mode: int = 0
    ) -> None:
        """Draw a part of an ellipse.

        Parameters
        ----------
        a, b, c, d : float, pixels
            The ellipse, as for `ellipse()`.
        start, stop : float, radians
            Clockwise from the right; nothing is drawn unless stop is larger.
        mode : OPEN, CHORD or PIE, optional
            How it is closed: not at all, by a line, or through the centre. Without it the fill is
            a pie and the outline open.

        Examples
        --------
        >>> arc(50, 50, 80, 80, 0, PI + QUARTER_PI, PIE)
        """
        try:
            angles = wrap_angles(start, stop)
        except TypeError:
            self._refuse("arc", (a, b, c, d, start, stop), ARC_USAGE)
        if angles is None:
            return
        recorder, end = self._recorder, self._recorder.row_end
        state = self._state if self._state >= 0 else self._note_state()
        fill, stroke, weight = self._fill, self._stroke, self._weight
        try:
            pack_row7(
                recorder.rows, end, ARC, state, fill, stroke, weight, 0, a, b, c, d, *angles, mode
            )
        except PackError:
            args = (a, b, c, d, start, stop, mode) if mode else (a, b, c, d, start, stop)
            self._again(self.arc, args, ARC_USAGE)
        else:
            recorder.row_end = end + ROW

    def _rounded_rect(self, a: float, b: float, c: float, d: float, *radii: float) -> None:
        """Draw a rectangle with round corners, as a polygon from the top right corner on."""
        if len(radii) not in (1, 4):
            self._refuse("rect", (a, b, c, d, *radii), RECT_USAGE)
        numbers = self._row_of_numbers("rect", (a, b, c, d), RECT_USAGE)
        edges = rect_edges(self._style.rect_mode, numbers)
        left, top, right, bottom = (float(edge[0]) for edge in edges)
        most = min((right - left) / 2, (bottom - top) / 2)
        every = radii * 4 if len(radii) == 1 else radii
        try:
            tl, tr, br, bl = (min(radius + 0.0, most) for radius in every)
        except TypeError:
            self._refuse("rect", (a, b, c, d, *radii), RECT_USAGE)
        self.beginShape(POLYGON)
        for x, y, dx, dy, radius in (  # corner, direction towards it, radius
            (right, top, 1, 0, tr),
            (right, bottom, 0, 1, br),
            (left, bottom, -1, 0, bl),
            (left, top, 0, -1, tl),
        ):
            self.vertex(x - dx * radius, y - dy * radius)
            if radius:  # the path turns right by a right angle
                self.quadraticVertex(x, y, x - dy * radius, y + dx * radius)
        self.endShape(CLOSE)
