"""How the vertices of a finished shape are to be read: which of them belong to curves."""

from __future__ import annotations

from sketchkit.api.pshape.corners import ShapeCorners
from sketchkit.core import constants as c
from sketchkit.draw.given_vertices import vertex_codes


class ShapeCodes(ShapeCorners):
    """Codes are there of shapes with curves or holes."""

    def getVertexCodeCount(self) -> int:
        """Return how many codes `getVertexCodes()` returns.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 50).getVertexCodeCount())
        0
        """
        return len(self.getVertexCodes())

    def getVertexCode(self, index: int) -> int:
        """Return one of the codes of `getVertexCodes()`.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(30, 20)
        >>> s.bezierVertex(80, 0, 80, 75, 30, 75)
        >>> s.endShape()
        >>> print(s.getVertexCode(1) == BEZIER_VERTEX)
        True
        """
        codes = self.getVertexCodes()
        return codes[self._checked("getVertexCode", index, len(codes))]

    def getVertexCodes(self) -> list[int]:
        """Return how the vertices of a shape with curves or holes are to be read.

        Returns
        -------
        list of int
            VERTEX and CURVE_VERTEX stand for one vertex, QUADRATIC_VERTEX for two, BEZIER_VERTEX
            for three. BREAK, after which another contour begins, stands for none. Empty if all
            vertices are corners of one outline.

        See Also
        --------
        getVertex, getVertexCount

        Notes
        -----
        Of a path in an SVG file BREAK is the first. Source: Processing's PShape.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(30, 20)
        >>> s.bezierVertex(80, 0, 80, 75, 30, 75)
        >>> s.endShape()
        >>> print(s.getVertexCodes(), s.getVertexCount())
        [0, 1] 4
        """
        runs = self._recorder.shapes
        if self._is_primitive or len(runs) != 1:
            return []
        if self._is_read_path:
            return [c.BREAK, *vertex_codes(runs[0], self._corner_places())]
        if not runs[0].curves and not runs[0].contours:
            return []
        return vertex_codes(runs[0], self._corner_places())
