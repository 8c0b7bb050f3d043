"""PShape: a drawing that is kept, the groups of methods joined; and the shapes of one call."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar, Protocol, Self, cast

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import Block, OpenShape
from sketchkit.api.attribs import Attribs
from sketchkit.api.color import Color
from sketchkit.api.curve_vertices import CurveVertices
from sketchkit.api.materials import Materials
from sketchkit.api.paint import check_choice
from sketchkit.api.pconstants import PConstants
from sketchkit.api.pshape.attribs import ShapeAttribs
from sketchkit.api.pshape.codes import ShapeCodes
from sketchkit.api.pshape.display import ShapeDisplay
from sketchkit.api.pshape.looks import ShapeLooks
from sketchkit.api.pshape.parts import Family
from sketchkit.api.pshape.transforms import ShapeTransforms
from sketchkit.api.pshape.tree import ShapeTree
from sketchkit.api.pshape.vertices import ShapeVertices
from sketchkit.api.shapes2d import Shapes2D
from sketchkit.api.shapes3d import Shapes3D
from sketchkit.api.textures import Textures, begin_uvs
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, either, shown, wrong_numbers
from sketchkit.draw.recorder import CORNER


class Draws(Protocol):
    """A canvas."""

    def shape(self, shape: PShape, *place: float) -> None:
        """Draw a shape."""
        ...


class PShape(
    ShapeTree,
    ShapeTransforms,
    ShapeLooks,
    ShapeVertices,
    ShapeCodes,
    ShapeDisplay,
    ShapeAttribs,
    Color,
    Materials,
    CurveVertices,
    Textures,
    Attribs,
    PConstants,
):
    """A drawing that is kept: made once, drawn often, with `shape()`.

    `createShape()` and `loadShape()` make one. Between `beginShape()` and `endShape()` it takes
    the calls that a canvas takes: `vertex()`, `fill()`, `normal()`, `texture()` ... Afterwards it
    is changed with `setFill()`, `setVertex()` and their like.

    Notes
    -----
    Its vertices stay on the graphics card, and only what changes is sent again; a shape that is
    moved or turned sends nothing. Source: Processing's reference, PShape; the course guide's
    section 4.9.

    Examples
    --------
    >>> star = createShape()
    >>> star.beginShape()
    >>> star.fill(255, 204, 0)
    >>> for i in range(10):
    ...     r = 40 if i % 2 == 0 else 16
    ...     star.vertex(r * sin(i * PI / 5), -r * cos(i * PI / 5))
    >>> star.endShape(CLOSE)
    >>> shape(star, 50, 50)
    """

    PRIMITIVE: ClassVar[int] = int(Family.PRIMITIVE)
    PATH: ClassVar[int] = int(Family.PATH)
    GEOMETRY: ClassVar[int] = int(Family.GEOMETRY)

    def beginShape(self, kind: int = c.POLYGON) -> Block:
        """Begin to give the shape its vertices; `with s.beginShape():` ends it by itself.

        Parameters
        ----------
        kind : POINTS, LINES, TRIANGLES, ..., optional
            As for the sketch's own `beginShape()`.

        Examples
        --------
        >>> s = createShape()
        >>> with s.beginShape(TRIANGLES):
        ...     s.vertex(20, 80)
        ...     s.vertex(50, 15)
        ...     s.vertex(80, 80)
        >>> shape(s)
        """
        if self._is_group:
            raise SketchError(
                "beginShape() belongs to a shape of createShape() without a kind.",
                hint="Of a group, make the children one by one and use addChild().",
            )
        block = super().beginShape(kind)
        assert self._shape is not None
        self._kind = self._shape.kind
        return block

    def endShape(self, mode: int | None = None) -> None:
        """End the shape: from now on it can be drawn.

        Parameters
        ----------
        mode : CLOSE, optional
            Draw the outline back to the first vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.endShape(CLOSE)
        >>> shape(s)
        """
        super().endShape(mode)
        self._unweigh_bare_corners()
        self._expand_anew()

    def texture(self, image: object) -> None:
        """Cover the shape with an image; `vertex()` says with u and v where it goes.

        Examples
        --------
        >>> img = loadImage("photo.png")
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.texture(img)
        >>> s.vertex(10, 10, 0, 0)
        >>> s.vertex(90, 10, 60, 0)
        >>> s.vertex(90, 90, 60, 40)
        >>> s.endShape()
        >>> shape(s)
        """
        super().texture(image)
        self._texture_source = image

    def noTexture(self) -> None:
        """Leave the shape without an image.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.noTexture()
        >>> s.endShape()
        """
        super().noTexture()
        self._texture_source = None

    def end(self, mode: int | None = None) -> None:
        """End the shape: the older name of `endShape()`.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(20, 80)
        >>> s.vertex(50, 15)
        >>> s.vertex(80, 80)
        >>> s.end(CLOSE)
        >>> shape(s)
        """
        self.endShape(mode)

    def draw(self, canvas: Draws) -> None:
        """Draw the shape on a canvas: the same as `canvas.shape(s)`.

        Examples
        --------
        >>> s = createShape(RECT, 20, 20, 60, 60)
        >>> s.draw(g)
        """
        canvas.shape(self)

    def getParams(self) -> list[float]:
        """Return the numbers that `createShape()` was given with the kind.

        Examples
        --------
        >>> print(createShape(RECT, 20, 20, 60, 60).getParams())
        [20, 20, 60, 60]
        """
        return []

    def getParam(self, index: int) -> float:
        """Return one of the numbers that `createShape()` was given with the kind.

        Examples
        --------
        >>> print(createShape(RECT, 20, 20, 60, 40).getParam(3))
        40
        """
        params = self.getParams()
        if not 0 <= index < len(params):
            raise SketchError(f"The shape was made of {len(params)} numbers.", got=str(index))
        return params[index]

    def beginTessellation(self, kind: int = c.TRIANGLES) -> None:
        """Turn the shape into the triangles that it is drawn with, to be changed one by one.

        Parameters
        ----------
        kind : TRIANGLES
            Of what is changed; outlines are dropped.

        Examples
        --------
        >>> noStroke()
        >>> s = createShape(ELLIPSE, 50, 50, 60, 60)
        >>> s.beginTessellation()
        >>> for i in range(0, s.getVertexCount(), 3):
        ...     s.setFill(i, color(255, i % 255, 0))
        >>> s.endTessellation()
        >>> shape(s)
        """
        check_choice("beginTessellation", kind, {c.TRIANGLES: "TRIANGLES"})
        for leaf in self._leaves():
            leaf._become_triangles()

    def endTessellation(self) -> None:
        """End the changes that `beginTessellation()` began.

        Examples
        --------
        See `beginTessellation()`.
        """

    def isClosed(self) -> bool:
        """Return whether the outline leads back to the first vertex.

        Examples
        --------
        >>> s = createShape()
        >>> s.beginShape()
        >>> s.vertex(20, 20)
        >>> s.vertex(80, 40)
        >>> s.vertex(40, 80)
        >>> s.endShape(CLOSE)
        >>> print(s.isClosed())
        True
        """
        return any(run.is_closed for run in self._recorder.shapes)

    def _new(self, family: Family) -> Self:
        """Return another shape of the same canvas, in which nothing is yet: no primitive."""
        return cast("Self", PShape(self._canvas, family))

    def _begin_uvs(self, shape: OpenShape) -> None:
        """Keep texture coordinates in any case: a texture may come later."""
        if shape.first_uv is None:
            begin_uvs(self._recorder, shape)

    def __repr__(self) -> str:
        if self._is_group:
            return f"<PShape: a group of {self.getChildCount()}>"
        return f"<PShape: {self._recorder.corner_end // CORNER} vertices>"


class PrimitiveShape(PShape, Shapes2D, Shapes3D):
    """A shape of one call of a canvas: what that records is what the shape consists of."""

    def __init__(
        self,
        canvas: CanvasParts,
        kind: int,
        params: Sequence[float],
        prepare: Callable[[PShape], None] | None = None,
    ) -> None:
        super().__init__(canvas, Family.PRIMITIVE)
        self._params = list(params)
        if prepare is not None:
            prepare(self)
        call, counts, usage = PRIMITIVES[kind]
        if len(params) not in counts:
            raise wrong_numbers(f"createShape: {call.__name__}", params, usage, counts)
        call(self, *params)
        self._kind = kind  # a rounded rectangle is a polygon to begin with

    def getParams(self) -> list[float]:
        """Return the numbers that it was made of."""
        return list(self._params)

    def __repr__(self) -> str:
        return f"<PShape: {PRIMITIVES[self._kind][0].__name__}>"


# Of each kind: the call of a canvas, how many numbers it takes, and their names.
PRIMITIVES: dict[int, tuple[Callable[..., None], tuple[int, ...], str]] = {
    c.POINT: (Shapes2D.point, (2, 3), "x, y [, z]"),
    c.LINE: (Shapes2D.line, (4, 6), "x1, y1, x2, y2 | x1, y1, z1, x2, y2, z2"),
    c.TRIANGLE: (Shapes2D.triangle, (6,), "x1, y1, x2, y2, x3, y3"),
    c.QUAD: (Shapes2D.quad, (8,), "x1, y1, x2, y2, x3, y3, x4, y4"),
    c.RECT: (Shapes2D.rect, (4, 5, 8), "x, y, width, height [, radii]"),
    c.ELLIPSE: (Shapes2D.ellipse, (4,), "x, y, width, height"),
    c.ARC: (Shapes2D.arc, (6, 7), "x, y, width, height, start, stop [, mode]"),
    c.BOX: (Shapes3D.box, (1, 3), "size | width, height, depth"),
    c.SPHERE: (Shapes3D.sphere, (1,), "radius"),
}
KIND_NAMES = ("POINT", "LINE", "TRIANGLE", "QUAD", "RECT", "ELLIPSE", "ARC", "BOX", "SPHERE")


def new_shape(canvas: CanvasParts, args: Sequence[object]) -> PShape:
    """Return the shape that `createShape()` makes of its arguments."""
    if not args:
        return PShape(canvas, Family.GEOMETRY)
    kind, *params = args
    if len(params) == 1 and isinstance(params[0], list | tuple):
        params = list(params[0])
    if not params and kind in (PShape.GEOMETRY, PShape.PATH, c.GROUP, c.PATH):
        families = {PShape.GEOMETRY: Family.GEOMETRY, c.GROUP: Family.GROUP}
        return PShape(canvas, families.get(kind, Family.PATH))
    if kind not in tuple(PRIMITIVES):  # it may be anything, and then it has no hash
        raise SketchError(
            f"createShape() takes nothing, GROUP, or {either(KIND_NAMES)} and its numbers.",
            got=shown(kind),
            hint="For vertices: s = createShape(), s.beginShape(QUADS), ..., s.endShape().",
        )
    return PrimitiveShape(canvas, kind, params)  # type: ignore[arg-type] # the call checks the numbers
