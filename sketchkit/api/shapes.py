"""Retained shapes on a canvas: making and drawing them."""

from __future__ import annotations

from sketchkit.api._parts import CanvasParts
from sketchkit.api.paint import chosen
from sketchkit.api.pshape.models import model_shape
from sketchkit.api.pshape.parts import Placed, ShapeParts, scaled
from sketchkit.api.pshape.shape import PShape, new_shape
from sketchkit.api.pshape.svg import svg_shape
from sketchkit.assets.paths import find_file
from sketchkit.core import constants as c
from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, kind_of, shown, wrong_numbers
from sketchkit.draw.baking import baked
from sketchkit.draw.recorder import ROW, Kind, pack_row0

MESH = Kind.MESH.value
SHAPE_MODES = {c.CORNER: "CORNER", c.CORNERS: "CORNERS", c.CENTER: "CENTER"}
SHAPE_USAGE = "shape | shape, x, y | shape, x, y, width, height"
SHAPEMODE_USAGE = " | ".join(SHAPE_MODES.values())


class RetainedShapes(CanvasParts):
    """Shapes that are made once and drawn often."""

    def createShape(self, *args: object) -> PShape:
        """Make a shape that is kept.

        Parameters
        ----------
        *args : nothing; GROUP; or a kind and its numbers
            Without anything, a shape to be given vertices, between its `beginShape()` and
            `endShape()`. GROUP makes one for other shapes, see `addChild()`. POINT, LINE, TRIANGLE,
            QUAD, RECT, ELLIPSE, ARC, BOX and SPHERE take the numbers of the function of that name,
            one by one or as a list.

        Returns
        -------
        PShape
            In the fill, stroke and modes that are in force now.

        Raises
        ------
        SketchError
            If the kind is unknown, or the numbers do not fit it.

        See Also
        --------
        shape, loadShape, PShape

        Notes
        -----
        Source: Processing's reference, createShape(); the course guide's section 4.9.

        Examples
        --------
        >>> fill(255, 204, 0)
        >>> sun = createShape(ELLIPSE, 0, 0, 40, 40)
        >>> shape(sun, 30, 30)
        >>> shape(sun, 70, 70)
        """
        return new_shape(self, args)

    def loadShape(self, filename: str, options: str | None = None) -> PShape:
        """Load a drawing or a model from a file.

        Parameters
        ----------
        filename : str
            An SVG drawing, or an OBJ, PLY, STL, GLTF or GLB model; beside the sketch or in its
            `data` folder.
        options : str, optional
            Not used here.

        Returns
        -------
        PShape
            A group: of the parts of the drawing, which have their names, or of the faces of the
            model.

        Raises
        ------
        SketchError
            If there is no such file, or it is broken: with the line, where it has lines.

        See Also
        --------
        shape, createShape, PShape

        Notes
        -----
        Models belong to P3D. Of an OBJ file's materials (MTL) the diffuse colour and texture show,
        as in Processing. Gradients of SVG show only where Processing draws them: without P2D or
        P3D. Source: Processing's reference, loadShape().

        Examples
        --------
        >>> house = loadShape("house.svg")
        >>> shape(house, 10, 10, 80, 80)
        """
        path = find_file("loadShape", filename)
        if path.suffix.lower() in (".svg", ".svgz"):
            return svg_shape(self, path)
        return model_shape(self, path)

    def shape(self, shape: PShape, *place: float) -> None:
        """Draw a shape that is kept.

        Parameters
        ----------
        shape : PShape
        *place : 0, 2 or 4 float, pixels, optional
            At first x and y of its origin; and the width and height to which it is stretched.
            `shapeMode()` gives them another meaning. In P3D also x, y, z, and with three sizes.

        Raises
        ------
        SketchError
            If it is no shape, or is still open, or the numbers do not fit.

        See Also
        --------
        createShape, loadShape, shapeMode

        Notes
        -----
        In P2D and P3D a child that is drawn alone stays where its groups have moved it, as in
        Processing. Source: Processing's reference, shape(); the course guide's section 4.9.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 20)
        >>> shape(s, 10, 10)
        >>> shape(s, 10, 40, 80, 50)
        """
        if not isinstance(shape, ShapeParts):
            raise SketchError(
                "shape() takes a shape first.",
                got=f"{kind_of(shape)}: {shown(shape)}",
                hint="createShape() and loadShape() make one.",
            )
        shape._must_be_ended("shape")
        if not shape._is_visible:
            return
        saved = self._modelview
        if place or self._shape_mode == c.CENTER:
            try:
                self._modelview = self._placed(shape, place)
            except TypeError:
                raise wrong_numbers("shape", (shape, *place), SHAPE_USAGE) from None
        shape._settle()
        around = shape._surroundings()
        for part, matrix in shape._drawn(self):
            self._pack_part((part, mat.multiply(around, matrix)))
        self._modelview = saved
        self._state = -1
        if any(reader.reads_shapes for reader in self._renderer.readers):  # before it is edited
            self._renderer.flush()

    def shapeMode(self, mode: int) -> None:
        """Set what the numbers of `shape()` mean.

        Parameters
        ----------
        mode : CORNER, CORNERS or CENTER
            CORNER (at first): x, y, width, height. CORNERS: two corners. CENTER: x and y are where
            the middle comes.

        See Also
        --------
        shape, rectMode

        Notes
        -----
        CENTER moves a shape by half its size, wherever it has its origin, as in Processing. Source:
        Processing's reference, shapeMode().

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 20)
        >>> shapeMode(CENTER)
        >>> shape(s, 50, 50)
        """
        self._shape_mode = chosen("shapeMode", mode, SHAPE_MODES, c.CORNER)

    def _placed(self, shape: PShape, place: tuple[float, ...]) -> mat.Affine:
        """Return the modelview for a shape that comes to a place, maybe in another size."""
        space = {0: 3, 2: 2, 3: 3, 4: 2, 6: 3}.get(len(place))
        if space is None:
            raise TypeError("a wrong number of numbers")
        numbers = [value + 0.0 for value in place] or [0.0, 0.0, 0.0]
        where, extent = numbers[:space], numbers[space:]
        if self._shape_mode == c.CORNERS:
            extent = [b - a for a, b in zip(where, extent, strict=False)]
        if not extent and self._shape_mode != c.CENTER:
            return mat.translate(self._modelview, *where)  # unmeasured: see getWidth()
        own = (shape.getWidth(), shape.getHeight(), shape.getDepth())[:space]
        if self._shape_mode == c.CENTER:
            sizes = extent or (own if place else (*own[:2], 0.0))
            where = [a - size / 2 for a, size in zip(where, sizes, strict=True)]
        moved = mat.translate(self._modelview, *where)
        if not extent:
            return moved
        factors = [size / mine if mine else 1.0 for size, mine in zip(extent, own, strict=True)]
        return mat.scale(moved, *factors)

    def _pack_part(self, placed: Placed) -> None:
        """Record a part of a shape."""
        self._follow_shaders()
        part, matrix = placed
        recorder = self._recorder
        recorder.meshes.add(part.mesh)
        part = scaled(part, matrix)
        if self._shaders and matrix != mat.IDENTITY:
            part, matrix = baked(part, matrix), mat.IDENTITY
        modelview = mat.multiply(self._modelview, matrix)
        state = recorder.keep_state(self._style, self._stage, modelview, self._nesting)
        recorder.parts.append(part)
        recorder.make_room()
        link = len(recorder.parts) - 1
        pack_row0(recorder.rows, recorder.row_end, MESH, state, 0, 0, 0.0, link)
        recorder.row_end += ROW
