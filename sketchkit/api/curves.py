"""Curves: Bezier curves and splines, drawn whole, and measured."""

from __future__ import annotations

from sketchkit.api.curve_vertices import CurveVertices
from sketchkit.geometry import curves

BEZIER_USAGE = "x1, y1, x2, y2, x3, y3, x4, y4"
COORDINATE_USAGE = "a, b, c, d, t"


class Curves(CurveVertices):
    """Curves of four points."""

    def bezier(self, *numbers: float) -> None:
        """Draw a Bezier curve; it is filled unless `noFill()` was called.

        Parameters
        ----------
        *numbers : 8 or 12 float, pixels
            Start, two control points, end: x, y each, or x, y, z each.

        Raises
        ------
        SketchError
            If there are not 8 or 12 numbers.

        See Also
        --------
        bezierVertex, bezierDetail, curve

        Notes
        -----
        Source: Processing's reference, bezier(); the course guide's chapter on curves.

        Examples
        --------
        >>> noFill()
        >>> bezier(20, 80, 20, 10, 80, 90, 80, 20)
        """
        points = self._points("bezier", numbers, 4, BEZIER_USAGE).tolist()
        self.beginShape()
        self.vertex(*points[0])
        self.bezierVertex(*(value for point in points[1:] for value in point))
        self.endShape()

    def curve(self, *numbers: float) -> None:
        """Draw a spline from its second point to its third; the others steer it.

        Parameters
        ----------
        *numbers : 8 or 12 float, pixels
            Four points: x, y each, or x, y, z each.

        See Also
        --------
        curveVertex, curveTightness, bezier

        Examples
        --------
        >>> noFill()
        >>> curve(5, 26, 20, 26, 73, 24, 73, 61)
        """
        points = self._points("curve", numbers, 4, BEZIER_USAGE).tolist()
        self.beginShape()
        for point in points:
            self.curveVertex(*point)
        self.endShape()

    def bezierPoint(self, a: float, b: float, c: float, d: float, t: float) -> float:
        """Return one coordinate of a Bezier curve.

        Parameters
        ----------
        a, b, c, d : float
            That coordinate of the four points.
        t : float
            0 at the start, 1 at the end.

        Examples
        --------
        >>> x = bezierPoint(20, 20, 80, 80, 0.5)
        >>> y = bezierPoint(80, 10, 90, 20, 0.5)
        >>> circle(x, y, 10)
        """
        try:
            return curves.bezier_point(a, b, c, d, t + 0.0)
        except TypeError:
            self._refuse("bezierPoint", (a, b, c, d, t), COORDINATE_USAGE)

    def bezierTangent(self, a: float, b: float, c: float, d: float, t: float) -> float:
        """Return one coordinate of a Bezier curve's direction; numbers as for `bezierPoint()`.

        Examples
        --------
        >>> angle = atan2(bezierTangent(80, 10, 90, 20, 0.5), bezierTangent(20, 20, 80, 80, 0.5))
        >>> line(50, 50, 50 + 30 * cos(angle), 50 + 30 * sin(angle))
        """
        try:
            return curves.bezier_tangent(a, b, c, d, t + 0.0)
        except TypeError:
            self._refuse("bezierTangent", (a, b, c, d, t), COORDINATE_USAGE)

    def curvePoint(self, a: float, b: float, c: float, d: float, t: float) -> float:
        """Return one coordinate of a spline, from its second point (t = 0) to its third (t = 1).

        Examples
        --------
        >>> circle(curvePoint(5, 20, 73, 73, 0.5), curvePoint(26, 26, 24, 61, 0.5), 10)
        """
        try:
            return curves.spline_point((a, b, c, d), t, self._curve_tightness)
        except (TypeError, ValueError):  # ValueError: NumPy's, of a list
            self._refuse("curvePoint", (a, b, c, d, t), COORDINATE_USAGE)

    def curveTangent(self, a: float, b: float, c: float, d: float, t: float) -> float:
        """Return one coordinate of a spline's direction; numbers as for `curvePoint()`.

        Examples
        --------
        >>> line(50, 50, 50 + curveTangent(5, 20, 73, 73, 0.5), 50)
        """
        try:
            return curves.spline_tangent((a, b, c, d), t, self._curve_tightness)
        except (TypeError, ValueError):
            self._refuse("curveTangent", (a, b, c, d, t), COORDINATE_USAGE)
