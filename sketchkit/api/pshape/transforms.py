"""Moving, turning and stretching a shape for good: it stays so until `resetMatrix()`.

In P2D and P3D Processing makes a tree of shapes into triangles when it is first drawn, and later
transforms move these triangles: a late step of a child is done after those of the groups around it,
until a change of vertices has the tree made anew. Only in a group that was moved itself it shows.
"""

from __future__ import annotations

from collections.abc import Sequence

from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.api.pshape.parts import ShapeParts
from sketchkit.api.transforms import ROTATE_USAGE, SCALE_USAGE, TRANSLATE_USAGE, affine_of
from sketchkit.core import matrix as mat
from sketchkit.core.errors import wrong_numbers


class ShapeTransforms(ShapeParts):
    """Transforms add up: each is done after those before it; in JAVA2D, before them."""

    def translate(self, x: float, y: float, z: float = 0.0) -> None:
        """Move the shape, in pixels.

        See Also
        --------
        rotate, scale, resetMatrix

        Notes
        -----
        It moves along the axes of its parent, whatever way it was turned before. Source:
        Processing's reference, PShape.translate().

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.translate(30, 20)
        >>> shape(s)
        """
        self._transform("translate", mat.translate, (x, y, z), TRANSLATE_USAGE)

    def rotate(self, angle: float, x: float = 0.0, y: float = 0.0, z: float | None = None) -> None:
        """Turn the shape by `angle` radians; about the axis (x, y, z), if it is given.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.rotate(PI / 6)
        >>> shape(s, 40, 20)
        """
        if z is None:
            self._transform("rotate", mat.rotate_z, (angle,), ROTATE_USAGE)
        else:
            self._transform("rotate", mat.rotate_axis, (angle, x, y, z), ROTATE_USAGE)

    def rotateX(self, angle: float) -> None:
        """Turn the shape about the x axis, by `angle` radians.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> s = createShape(BOX, 40)
        >>> s.rotateX(0.6)
        >>> shape(s, 50, 50)
        """
        self._transform("rotateX", mat.rotate_x, (angle,), "angle")

    def rotateY(self, angle: float) -> None:
        """Turn the shape about the y axis, by `angle` radians.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> s = createShape(BOX, 40)
        >>> s.rotateY(0.6)
        >>> shape(s, 50, 50)
        """
        self._transform("rotateY", mat.rotate_y, (angle,), "angle")

    def rotateZ(self, angle: float) -> None:
        """Turn the shape about the z axis, by `angle` radians.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.rotateZ(0.6)
        >>> shape(s, 50, 20)
        """
        self._transform("rotateZ", mat.rotate_z, (angle,), "angle")

    def scale(self, x: float, y: float | None = None, z: float | None = None) -> None:
        """Stretch the shape: by one factor, or by one along each axis.

        Notes
        -----
        Lines and points of a 3D shape become thicker with it.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.scale(2, 0.5)
        >>> shape(s, 10, 10)
        """
        factors = (x, x, x) if y is None else (x, y, 1.0 if z is None else z)
        self._transform("scale", mat.scale, factors, SCALE_USAGE)

    def applyMatrix(self, *source: float | PMatrix2D | PMatrix3D) -> None:
        """Transform the shape by a matrix: 6 or 16 numbers, row by row, or a PMatrix.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.applyMatrix(0.8, -0.3, 40, 0.4, 0.9, 20)
        >>> shape(s)
        """
        self._step(affine_of("applyMatrix", source))

    def resetMatrix(self) -> None:
        """Put the shape back to where and how it was made.

        Examples
        --------
        >>> s = createShape(RECT, 0, 0, 40, 40)
        >>> s.translate(500, 0)
        >>> s.resetMatrix()
        >>> shape(s, 20, 20)
        """
        undo = mat.inverse(self._own_steps)
        is_late = undo is not None and (
            self._matrix != self._own_steps or self._within_groups(undo) is not undo
        )
        if undo is not None and is_late:
            self._matrix = mat.multiply(self._within_groups(undo), self._matrix)
        else:
            self._matrix = mat.IDENTITY
        self._own_steps = mat.IDENTITY

    def _transform(
        self, name: str, operation: object, numbers: Sequence[float], usage: str
    ) -> None:
        """Do a transform after those so far."""
        try:
            step = operation(mat.IDENTITY, *numbers)  # type: ignore[operator] # one of core.matrix
        except TypeError:
            raise wrong_numbers(name, numbers, usage) from None
        self._step(step)

    def _step(self, step: mat.Affine) -> None:
        """Do a transform after those so far."""
        if self._canvas._stage.is_java2d:
            self._matrix = self._own_steps = mat.multiply(self._matrix, step)
            return
        self._own_steps = mat.multiply(step, self._own_steps)
        self._matrix = mat.multiply(self._within_groups(step), self._matrix)

    def _within_groups(self, step: mat.Affine) -> mat.Affine:
        """Return what, done within the groups around, is as `step` done after all of them."""
        around = self._surroundings()
        back = mat.inverse(around)
        if not self._root()._is_settled or around == mat.IDENTITY or back is None:
            return step
        return mat.multiply(back, mat.multiply(step, around))
