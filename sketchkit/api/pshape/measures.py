"""How large a shape is, what it contains, and which triangles, lines and points it is made of."""

from __future__ import annotations

from typing import Self

import numpy as np

from sketchkit.api.pshape.bulk import ShapeInBulk
from sketchkit.api.pshape.parts import Family, Placed
from sketchkit.core.errors import SketchError
from sketchkit.core.matrix import multiply
from sketchkit.draw.tessellation import BulkCorners, placed, tessellate_parts


class ShapeMeasures(ShapeInBulk):
    """Sizes are of everything that is drawn, transforms of the shape included."""

    @property
    def width(self) -> float:
        """The width: of a file's shape the one that the file names, else that of its vertices.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 30, 8).width > 0)
        True
        """
        return self._extent()[0] if self._document_size is None else self._document_size[0]

    @property
    def height(self) -> float:
        """The height: of a file's shape the one that the file names, else that of its vertices.

        Examples
        --------
        >>> print(createShape(RECT, 10, 10, 50, 30, 8).height > 0)
        True
        """
        return self._extent()[1] if self._document_size is None else self._document_size[1]

    @property
    def depth(self) -> float:
        """The size along z.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(createShape(BOX, 10, 20, 30).depth)
        30.0
        """
        return self._extent()[2]

    def getWidth(self) -> float:
        """Return the width of all vertices; it is the `width` of a file's shape from now on.

        Notes
        -----
        Drawing a shape in a given size, or centred, measures it too. As in Processing.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(createShape(BOX, 10, 20, 30).getWidth())
        10.0
        """
        width = self._extent()[0]
        if self._document_size is not None:
            self._document_size = width, self._document_size[1]
        return width

    def getHeight(self) -> float:
        """Return the height of all vertices; it is the `height` of a file's shape from now on.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(createShape(BOX, 10, 20, 30).getHeight())
        20.0
        """
        height = self._extent()[1]
        if self._document_size is not None:
            self._document_size = self._document_size[0], height
        return height

    def getDepth(self) -> float:
        """Return the size of all vertices along z.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> print(createShape(BOX, 10, 20, 30).getDepth())
        30.0
        """
        return self._extent()[2]

    def contains(self, x: float, y: float) -> bool:
        """Return whether a point of the plane lies inside of the outline.

        Raises
        ------
        SketchError
            If the shape is a group or a primitive: Processing does not know of those.

        Notes
        -----
        Transforms of the shape do not count. Source: Processing's reference, PShape.contains().

        Examples
        --------
        >>> s = createShape()
        >>> with s.beginClosedShape():
        ...     s.vertex(20, 20)
        ...     s.vertex(80, 40)
        ...     s.vertex(40, 80)
        >>> print(s.contains(45, 45), s.contains(5, 5))
        True False
        """
        if self._is_group or self._is_primitive:
            raise SketchError(
                "contains() is for shapes made with beginShape() or read from an SVG file.",
                hint="Ask the children of a group: for child in s.getChildren().",
            )
        places = self._recorder.corner_array()["place"][:, :2].astype(np.float64)
        if not len(places):
            return False
        (x1, y1), (x2, y2) = places.T, np.roll(places, 1, axis=0).T
        spans = (y1 > y) != (y2 > y)
        crossing = (x2 - x1) * (y - y1) / np.where(spans, y2 - y1, 1) + x1
        return bool((spans & (x < crossing)).sum() % 2)

    def getTessellation(self) -> Self:
        """Return a shape of the triangles, lines and points that this one is drawn with.

        Returns
        -------
        PShape
            Of triangles, if nothing else is drawn; else a group: triangles, lines, points.

        See Also
        --------
        getVertex, getVertexCount

        Notes
        -----
        Of a group all children are in it, where their transforms take them. Source: Processing's
        reference, PShape.getTessellation().

        Examples
        --------
        >>> noStroke()
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> print(s.getTessellation().getVertexCount())
        6
        """
        self._canvas._renderer.flush()
        made = [self._made_of(*part) for part in tessellate_parts(self._tree_parts())]
        if len(made) == 1:
            return made[0]
        whole = self._new(Family.GROUP if made else Family.GEOMETRY)
        for shape in made:
            shape._parent = whole
            whole._children.append(shape)
        return whole

    def _tree_parts(self) -> list[Placed]:
        """Return all parts of the tree, where they are drawn."""
        self._settle()
        around = self._surroundings()
        parts = self._gathered(self._canvas)
        return [(part, multiply(around, matrix)) for part, matrix in parts]

    def _made_of(self, kind: int, corners: BulkCorners) -> Self:
        shape = self._new(Family.GEOMETRY)
        shape._fill_in_bulk(kind, corners)
        return shape

    def _extent(self) -> tuple[float, float, float]:
        """Return the size of all vertices along x, y and z.

        In JAVA2D, everything in a file's shape has the size of the whole, as in Processing.
        """
        document = self._document()
        if document is not None and self._canvas._stage.is_java2d:
            return *document, 0.0
        low, high = self._bounds()
        return high[0] - low[0], high[1] - low[1], high[2] - low[2]

    def _bounds(self) -> tuple[list[float], list[float]]:
        """Return the least and the greatest x, y and z of all vertices; 0 if there are none."""
        boxes = []
        for part, matrix in self._tree_parts():
            block = part.mesh.blocks[part.layer]
            used = np.unique(block.indices[part.first : part.first + part.count])
            places = block.positions[used]
            boxes += [edge(placed(places, matrix), axis=0) for edge in (np.min, np.max)]
        if not boxes:
            return [0.0] * 3, [0.0] * 3
        return np.min(boxes, axis=0).tolist(), np.max(boxes, axis=0).tolist()

    def _document(self) -> tuple[float, float] | None:
        """Return the size that the file names of which the shape is a part."""
        if self._document_size is not None or self._parent is None:
            return self._document_size
        return self._parent._document()
