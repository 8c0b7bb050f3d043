"""Shapes vertex by vertex: beginShape() to endShape()."""

from __future__ import annotations

from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from sketchkit.api._pen import FACING, WHITE, Block, OpenShape, Pen
from sketchkit.api.paint import check_choice, chosen
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.draw.recorder import (
    CORNER,
    NO_CUSTOM,
    ROW,
    UV,
    Kind,
    PackError,
    ShapeRun,
    pack_corner,
    pack_row0,
    pack_uv,
)
from sketchkit.draw.resources import Pixels, Target, Texture

SHAPE = Kind.SHAPE.value
KINDS = {
    c.POINTS: "POINTS",
    c.LINES: "LINES",
    c.TRIANGLES: "TRIANGLES",
    c.TRIANGLE_STRIP: "TRIANGLE_STRIP",
    c.TRIANGLE_FAN: "TRIANGLE_FAN",
    c.QUADS: "QUADS",
    c.QUAD_STRIP: "QUAD_STRIP",
    c.LINE_STRIP: "LINE_STRIP",
    c.LINE_LOOP: "LINE_LOOP",
    c.POLYGON: "nothing",
}
# The names of single shapes stand for those of many, as in Processing.
KIND_OF = {c.TRIANGLE: c.TRIANGLES, c.QUAD: c.QUADS, c.LINE: c.LINES, c.POINT: c.POINTS}
FEWEST_CORNERS = 3  # of a polygon; Processing counts a curve's control points as well
CLOSE_MODES = {c.CLOSE: "CLOSE", c.OPEN: "nothing"}
VERTEX_USAGE = "x, y [, z] | x, y, u, v | x, y, z, u, v"


class Vertices(Pen):
    """Shapes vertex by vertex. Colours, normals and weights set in between hold from then on."""

    def beginShape(self, kind: int = c.POLYGON) -> Block:
        """Begin a shape; `with beginShape():` ends it by itself.

        Parameters
        ----------
        kind : POINTS, LINES, TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN, QUADS or QUAD_STRIP, optional
            What the vertices make. Without it, one polygon, which may be concave, cross itself and
            have holes.

        Raises
        ------
        SketchError
            If a shape is open already, or the kind is unknown.

        See Also
        --------
        endShape, vertex, beginContour

        Notes
        -----
        Source: Processing's reference, beginShape(); the course guide's chapter on vertex shapes.

        Examples
        --------
        >>> beginShape(TRIANGLES)
        >>> vertex(20, 80)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        kind = KIND_OF.get(kind, kind)
        check_choice("beginShape", kind, KINDS)
        if self._shape is not None:
            raise SketchError(
                "beginShape() inside of a shape that has not ended.",
                hint="Write endShape() before the next beginShape().",
            )
        self._shape = OpenShape(kind, self._recorder.corner_end)
        self._normal = FACING
        self._custom = NO_CUSTOM
        self._attributes = -1
        return Block(self.endShape)

    def beginClosedShape(self, kind: int = c.POLYGON) -> Block:
        """Begin a shape that is closed at its end: for `with beginClosedShape():`.

        Examples
        --------
        >>> with beginClosedShape():
        ...     vertex(20, 80)
        ...     vertex(50, 15)
        ...     vertex(80, 80)
        """
        self.beginShape(kind)
        return Block(lambda: self.endShape(c.CLOSE))

    def vertex(self, x: float, y: float, z: float = 0.0, *uv: float) -> None:
        """Add a vertex to the shape that is open.

        Parameters
        ----------
        x, y, z : float, pixels
        *uv : float, optional
            A place on the texture, u and v, in the units of `textureMode()`. With four numbers
            they are x, y, u, v.

        Raises
        ------
        SketchError
            If no shape is open.

        See Also
        --------
        beginShape, texture, normal

        Notes
        -----
        Source: Processing's reference, vertex().

        Examples
        --------
        >>> beginShape()
        >>> vertex(20, 20)
        >>> vertex(80, 40)
        >>> vertex(40, 80)
        >>> endShape(CLOSE)
        """
        if self._attributes < 0:
            self._note_attributes("vertex")
        if uv or self._shape.first_uv is not None:  # type: ignore[union-attr] # open: see above
            return self._textured_vertex(x, y, z, uv)
        recorder, end = self._recorder, self._recorder.corner_end
        try:
            pack_corner(recorder.corners, end, x, y, z, self._attributes, self._fill, self._stroke)
        except PackError:
            return self._again(self.vertex, (x, y, z), VERTEX_USAGE)
        recorder.corner_end = end + CORNER
        return None

    def _textured_vertex(self, x: float, y: float, z: float, uv: tuple[float, ...]) -> None:
        """Add a vertex that has texture coordinates, or whose shape has a texture."""
        given = (x, y, z, *uv)
        if len(uv) == 1:
            z, u, v = 0.0, z, uv[0]
        elif len(uv) in (0, 2):
            u, v = uv or (0.0, 0.0)
        else:
            self._refuse("vertex", given, VERTEX_USAGE)
        shape, recorder = self._open("vertex"), self._recorder
        self._begin_uvs(shape)
        try:
            if shape.first_uv is not None:
                if shape.texture is not None and self._texture_mode == c.IMAGE:
                    u, v = u / shape.texture.across, v / shape.texture.down
                pack_uv(recorder.uvs, recorder.uv_end, u, v)
            color = self._corner_fill(shape)
            pack_corner(
                recorder.corners,
                recorder.corner_end,
                x,
                y,
                z,
                self._attributes,
                color,
                self._stroke,
            )
        except (*PackError, TypeError):
            self._again(self.vertex, given, VERTEX_USAGE)
            return
        if shape.first_uv is not None:
            recorder.uv_end += UV
        recorder.corner_end += CORNER

    def _begin_uvs(self, shape: OpenShape) -> None:
        """Prepare for texture coordinates; without a texture they are left out."""

    def _corner_fill(self, shape: OpenShape) -> int:
        """Return the colour of a corner: the tint of a textured shape."""
        if shape.texture is None:
            return self._fill
        return WHITE if self._tint < 0 else self._tint

    def _open(self, caller: str) -> OpenShape:
        """Return the shape that is open."""
        if self._attributes < 0 or self._shape is None:
            self._note_attributes(caller)
        assert self._shape is not None
        return self._shape

    def endShape(self, mode: int | None = None) -> None:
        """End the shape and draw it.

        Parameters
        ----------
        mode : CLOSE, optional
            Draw the outline back to the first vertex.

        Raises
        ------
        SketchError
            If no shape is open.

        Examples
        --------
        >>> beginShape()
        >>> vertex(20, 20)
        >>> vertex(80, 40)
        >>> vertex(40, 80)
        >>> endShape(CLOSE)
        """
        shape = self._shape
        if shape is None:
            raise SketchError(
                "endShape() without beginShape().", hint="Write beginShape() before the vertices."
            )
        if mode is not None:
            mode = chosen("endShape", mode, CLOSE_MODES, c.OPEN)
        self._shape = None
        self._attributes = -1
        recorder = self._recorder
        count = (recorder.corner_end - shape.first) // CORNER
        needed = FEWEST_CORNERS if shape.kind == c.POLYGON and not shape.has_curves else 1
        if count < needed:
            return
        recorder.shapes.append(
            ShapeRun(
                shape.kind,
                shape.first // CORNER,
                count,
                mode == c.CLOSE,
                tuple(contour for contour in shape.contours if 0 < contour < count),
                None if shape.first_uv is None else shape.first_uv // UV,
                shape.texture,
                shape.has_normals,
                tuple(shape.curves),
            )
        )
        fill = self._fill if shape.texture is None else max(self._fill, 0)
        self._pack_shape(len(recorder.shapes) - 1, fill)

    def _pack_shape(self, link: int, fill: int) -> None:
        state = self._state if self._state >= 0 else self._note_state()
        recorder, end = self._recorder, self._recorder.row_end
        try:
            pack_row0(recorder.rows, end, SHAPE, state, fill, self._stroke, self._weight, link)
        except PackError:
            self._again(self._pack_shape, (link, fill), "link, fill")
        else:
            recorder.row_end = end + ROW

    def beginContour(self) -> Block:
        """Begin a hole of the polygon; go round it the other way than round the outline.

        Examples
        --------
        >>> beginShape()
        >>> for x, y in ((10, 10), (90, 10), (90, 90), (10, 90)):
        ...     vertex(x, y)
        >>> beginContour()
        >>> for x, y in ((30, 30), (30, 70), (70, 70), (70, 30)):
        ...     vertex(x, y)
        >>> endContour()
        >>> endShape(CLOSE)
        """
        shape = self._open("beginContour")
        if shape.in_contour:
            raise SketchError(
                "beginContour() inside of a contour.", hint="Write endContour() before it."
            )
        shape.contours.append((self._recorder.corner_end - shape.first) // CORNER)
        shape.in_contour = True
        shape.spline.clear()
        return Block(self.endContour)

    def endContour(self) -> None:
        """End a hole of the polygon.

        Raises
        ------
        SketchError
            If no hole is open.

        Examples
        --------
        See `beginContour()`.
        """
        shape = self._open("endContour")
        if not shape.in_contour:
            raise SketchError("endContour() without beginContour().")
        shape.in_contour = False
        shape.spline.clear()

    def normal(self, nx: float, ny: float, nz: float) -> None:
        """Set the normal of the vertices, or flat shapes, that follow.

        Parameters
        ----------
        nx, ny, nz : float
            A direction away from the surface; of length 1, for right lighting.

        Notes
        -----
        A shape without any normal gets one for each face. Source: Processing's reference,
        normal(); the course guide's chapter on lights.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> lights()
        >>> beginShape(TRIANGLES)
        >>> normal(0, 0.6, 0.8)
        >>> vertex(20, 80)
        >>> vertex(50, 15)
        >>> vertex(80, 80)
        >>> endShape()
        """
        try:
            self._normal = (nx + 0.0, ny + 0.0, nz + 0.0)
        except TypeError:
            self._refuse("normal", (nx, ny, nz), "nx, ny, nz")
        self._state = self._attributes = -1
        if self._shape is not None:
            self._shape.has_normals = True

    def _points(
        self, name: str, numbers: tuple[float, ...], count: int, usage: str
    ) -> NDArray[np.float64]:
        """Return so many points, (count, 3), of numbers in the plane or in space."""
        if len(numbers) not in (2 * count, 3 * count):
            self._refuse_points(name, numbers, usage)
        try:
            points = np.array([value + 0.0 for value in numbers]).reshape(count, -1)
        except (TypeError, ValueError):
            self._refuse_points(name, numbers, usage)
        if points.shape[1] == 2:
            points = np.hstack([points, np.zeros((count, 1))])
        return points

    def _refuse_points(self, name: str, numbers: tuple[float, ...], usage: str) -> NoReturn:
        in_space = ", ".join(
            f"{x}, {x.replace('y', 'z')}" if "y" in x else x for x in usage.split(", ")
        )
        self._refuse(name, numbers, f"{usage} | {in_space}")

    def _row_of_numbers(
        self, name: str, numbers: tuple[float, ...], usage: str
    ) -> NDArray[np.float32]:
        """Return numbers as an array of one row, (1, n)."""
        try:
            return np.array([[value + 0.0 for value in numbers]], np.float32)
        except TypeError:
            self._refuse(name, numbers, usage)


def pixels_of(caller: str, image: object) -> Texture:
    """Return the pixels that an image has.

    Raises
    ------
    SketchError
        If it is no image.
    """
    pixels = getattr(image, "_texture", None)
    found = pixels() if callable(pixels) else image
    if not isinstance(found, Pixels | Target):
        hint = "loadImage() and createImage() make one."
        if isinstance(image, str):
            hint = f"In setup() write img = loadImage({image!r}), and here img."
        got = f"{kind_of(image)}: {shown(image)}" if image is not None else "None"
        raise SketchError(f"{caller}() takes an image.", got=got, hint=hint)
    return found
