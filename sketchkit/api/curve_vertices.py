"""Curves as parts of a shape: bezierVertex(), quadraticVertex(), curveVertex()."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.api._pen import OpenShape
from sketchkit.api.vertices import Vertices
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError
from sketchkit.draw.given_vertices import steps
from sketchkit.draw.recorder import (
    CORNER,
    CORNER_DTYPE,
    UV,
    CurveRun,
    pack_uv,
    unpack_place,
)


class CurveVertices(Vertices):
    """Curves become straight pieces at once: `bezierDetail()`, `curveDetail()` say how many."""

    def bezierVertex(self, *numbers: float) -> None:
        """Add a Bezier curve from the last vertex on.

        Parameters
        ----------
        *numbers : 6 or 9 float, pixels
            Two control points and the end: x, y each, or x, y, z each.

        Raises
        ------
        SketchError
            If no vertex came before it, or there are not 6 or 9 numbers.

        See Also
        --------
        quadraticVertex, curveVertex, bezier, bezierDetail

        Examples
        --------
        >>> beginShape()
        >>> vertex(30, 20)
        >>> bezierVertex(80, 0, 80, 75, 30, 75)
        >>> endShape()
        """
        shape = self._curved("bezierVertex")
        points = self._points("bezierVertex", numbers, 3, "x2, y2, x3, y3, x4, y4")
        start = self._last_place(shape, "bezierVertex")
        self._add_curve(np.vstack([start, points]), self._bezier_detail)

    def quadraticVertex(self, *numbers: float) -> None:
        """Add a quadratic Bezier curve from the last vertex on.

        Parameters
        ----------
        *numbers : 4 or 6 float, pixels
            A control point and the end: x, y each, or x, y, z each.

        Examples
        --------
        >>> beginShape()
        >>> vertex(20, 20)
        >>> quadraticVertex(80, 20, 50, 50)
        >>> quadraticVertex(20, 80, 80, 80)
        >>> endShape()
        """
        shape = self._curved("quadraticVertex")
        points = self._points("quadraticVertex", numbers, 2, "cx, cy, x3, y3")
        start = self._last_place(shape, "quadraticVertex")
        self._add_curve(np.vstack([start, points]), self._bezier_detail)

    def curveVertex(self, *numbers: float) -> None:
        """Add a point of a spline; the first and the last only steer it.

        Parameters
        ----------
        *numbers : 2 or 3 float, pixels

        See Also
        --------
        curve, curveTightness, curveDetail

        Examples
        --------
        >>> noFill()
        >>> beginShape()
        >>> for x, y in ((20, 80), (20, 80), (40, 20), (70, 60), (90, 20), (90, 20)):
        ...     curveVertex(x, y)
        >>> endShape()
        """
        shape = self._open("curveVertex")
        (point,) = self._points("curveVertex", numbers, 1, "x, y")
        if not shape.spline and shape.kind != c.POLYGON:
            raise SketchError("curveVertex() belongs into a beginShape() without a kind.")
        shape.spline.append(tuple(point))
        if len(shape.spline) == 3:
            self._add_corners(np.array(shape.spline[1:2]))
        if len(shape.spline) > 3:
            control = np.array(shape.spline[-4:])
            self._add_curve(control, self._curve_detail, self._curve_tightness)

    def bezierDetail(self, detail: int) -> None:
        """Set how many lines a Bezier curve is made of; at first 20.

        Examples
        --------
        >>> bezierDetail(4)
        >>> bezier(20, 80, 20, 10, 80, 90, 80, 20)
        """
        self._bezier_detail = self._detail("bezierDetail", detail)

    def curveDetail(self, detail: int) -> None:
        """Set how many lines a segment of a spline is made of; at first 20.

        Examples
        --------
        >>> curveDetail(4)
        >>> curve(5, 26, 20, 26, 73, 24, 73, 61)
        """
        self._curve_detail = self._detail("curveDetail", detail)

    def curveTightness(self, tightness: float) -> None:
        """Set how tightly splines turn: 0 (at first) is smooth, 1 makes straight lines.

        Examples
        --------
        >>> curveTightness(0.5)
        >>> curve(5, 26, 20, 26, 73, 24, 73, 61)
        """
        try:
            self._curve_tightness = tightness + 0.0
        except TypeError:
            self._refuse("curveTightness", (tightness,), "tightness")

    def _curved(self, name: str) -> OpenShape:
        shape = self._open(name)
        if shape.kind != c.POLYGON:
            raise SketchError(f"{name}() belongs into a beginShape() without a kind.")
        shape.spline.clear()
        return shape

    def _last_place(self, shape: OpenShape, caller: str) -> NDArray[np.float64]:
        recorder = self._recorder
        if recorder.corner_end <= shape.first:
            raise SketchError(
                f"{caller}() needs a vertex to start from.", hint="Write vertex(x, y) before it."
            )
        return np.array(unpack_place(recorder.corners, recorder.corner_end - CORNER))

    def _add_curve(
        self, control: NDArray[np.float64], count: int, tightness: float | None = None
    ) -> None:
        """Add the steps of a curve after its start, and remember what they were made from."""
        shape = self._open("vertex")
        first = (self._recorder.corner_end - shape.first) // CORNER
        shape.curves.append(CurveRun(first, count, control, tightness))
        self._add_corners(steps(shape.curves[-1]))

    def _add_corners(self, points: NDArray[np.float64]) -> None:
        """Add many corners, (n, 3), in the current colours."""
        shape, recorder = self._open("vertex"), self._recorder
        shape.has_curves = True
        table = np.zeros(len(points), CORNER_DTYPE)
        table["place"] = points
        table["attributes"] = self._attributes
        table["fill"], table["stroke"] = self._corner_fill(shape), self._stroke
        data = table.tobytes()
        while recorder.corner_end + len(data) > len(recorder.corners):
            recorder.corners.extend(bytes(len(recorder.corners)))
        recorder.corners[recorder.corner_end : recorder.corner_end + len(data)] = data
        recorder.corner_end += len(data)
        if shape.first_uv is not None:
            for _ in points:
                recorder.make_room()
                pack_uv(recorder.uvs, recorder.uv_end, 0.0, 0.0)
                recorder.uv_end += UV

    def _detail(self, name: str, detail: int) -> int:
        try:
            steps = int(detail)
        except (TypeError, ValueError):
            self._refuse(name, (detail,), "detail")
        if steps < 1:
            raise SketchError(f"{name}() takes a whole number above 0.", got=str(detail))
        return steps
