"""Transforms: moving, turning and stretching the coordinate system."""

from __future__ import annotations

from typing import Any, TypeVar, overload

from sketchkit.api._parts import Block, CanvasParts
from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, shown

Matrix = TypeVar("Matrix", PMatrix2D, PMatrix3D)

TRANSLATE_USAGE = "x, y [, z]"
ROTATE_USAGE = "angle | angle, x, y, z"
SCALE_USAGE = "factor | x, y [, z]"
MOST_MATRICES = 32  # Processing's own limit: it catches the pushMatrix() whose pop is missing


class Transforms(CanvasParts):
    """The current matrix; it is put back at the start of each frame."""

    def translate(self, x: float, y: float, z: float = 0.0) -> None:
        """Move the origin.

        Parameters
        ----------
        x, y, z : float, pixels
            In the current coordinate system; z toward the viewer.

        See Also
        --------
        rotate, scale, pushMatrix

        Notes
        -----
        Source: Processing's reference, translate(); the course guide's chapter on transforms.

        Examples
        --------
        >>> translate(30, 20)
        >>> rect(0, 0, 40, 40)
        """
        try:
            self._modelview = mat.translate(self._modelview, x, y, z)
        except TypeError:
            self._refuse("translate", (x, y, z), TRANSLATE_USAGE)
        self._state = -1

    def rotate(self, angle: float, x: float = 0.0, y: float = 0.0, z: float | None = None) -> None:
        """Turn the coordinate system, clockwise on the screen.

        Parameters
        ----------
        angle : float, radians
        x, y, z : float, optional
            An axis to turn about in P3D; of any length. At first the z axis.

        Examples
        --------
        >>> translate(50, 20)
        >>> rotate(PI / 6)
        >>> rect(0, 0, 40, 40)
        """
        try:
            if z is None:
                self._modelview = mat.rotate_z(self._modelview, angle)
            else:
                self._modelview = mat.rotate_axis(self._modelview, angle, x, y, z)
        except TypeError:
            args = (angle,) if z is None else (angle, x, y, z)
            self._refuse("rotate", args, ROTATE_USAGE)
        self._state = -1

    def rotateX(self, angle: float) -> None:
        """Turn about the x axis, `angle` in radians.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50)
        >>> rotateX(PI / 3)
        >>> rect(-30, -30, 60, 60)
        """
        try:
            self._modelview = mat.rotate_x(self._modelview, angle)
        except TypeError:
            self._refuse("rotateX", (angle,), "angle")
        self._state = -1

    def rotateY(self, angle: float) -> None:
        """Turn about the y axis, `angle` in radians.

        Examples
        --------
        >>> size(100, 100, P3D)
        >>> translate(50, 50)
        >>> rotateY(PI / 3)
        >>> rect(-30, -30, 60, 60)
        """
        try:
            self._modelview = mat.rotate_y(self._modelview, angle)
        except TypeError:
            self._refuse("rotateY", (angle,), "angle")
        self._state = -1

    def rotateZ(self, angle: float) -> None:
        """Turn about the z axis, `angle` in radians.

        Examples
        --------
        >>> translate(50, 20)
        >>> rotateZ(PI / 6)
        >>> rect(0, 0, 40, 40)
        """
        try:
            self._modelview = mat.rotate_z(self._modelview, angle)
        except TypeError:
            self._refuse("rotateZ", (angle,), "angle")
        self._state = -1

    def scale(self, x: float, y: float | None = None, z: float | None = None) -> None:
        """Stretch the coordinate system.

        Parameters
        ----------
        x : float
            Factor along x, or along all axes if it is alone.
        y, z : float, optional
            Factors along the other axes; z is left as it is where two are given.

        Examples
        --------
        >>> scale(2, 0.5)
        >>> rect(10, 40, 30, 60)
        """
        try:
            if y is None:
                self._modelview = mat.scale(self._modelview, x, x, x)
            else:
                self._modelview = mat.scale(self._modelview, x, y, 1.0 if z is None else z)
        except TypeError:
            args = tuple(value for value in (x, y, z) if value is not None)
            self._refuse("scale", args, SCALE_USAGE)
        self._state = -1

    def shearX(self, angle: float) -> None:
        """Slant the x axis' lines, `angle` in radians.

        Examples
        --------
        >>> shearX(PI / 8)
        >>> rect(10, 20, 50, 50)
        """
        try:
            self._modelview = mat.shear_x(self._modelview, angle)
        except TypeError:
            self._refuse("shearX", (angle,), "angle")
        self._state = -1

    def shearY(self, angle: float) -> None:
        """Slant the y axis' lines, `angle` in radians.

        Examples
        --------
        >>> shearY(PI / 8)
        >>> rect(20, 10, 50, 50)
        """
        try:
            self._modelview = mat.shear_y(self._modelview, angle)
        except TypeError:
            self._refuse("shearY", (angle,), "angle")
        self._state = -1

    def pushMatrix(self) -> Block:
        """Put the matrix aside until `popMatrix()`; `with pushMatrix():` takes it back by itself.

        Raises
        ------
        SketchError
            If 32 are put aside already: a `popMatrix()` is missing.

        See Also
        --------
        popMatrix, push, resetMatrix

        Examples
        --------
        >>> with pushMatrix():
        ...     translate(50, 50)
        ...     rect(0, 0, 30, 30)
        >>> rect(0, 0, 30, 30)
        """
        if len(self._matrices) >= MOST_MATRICES:
            raise SketchError(
                f"pushMatrix() was called {MOST_MATRICES} times without popMatrix().",
                hint="Write a popMatrix() for each pushMatrix().",
            )
        self._matrices.append((self._modelview, self._camera))
        self._state = -1
        return Block(self.popMatrix)

    def popMatrix(self) -> None:
        """Take back the matrix that `pushMatrix()` put aside.

        Raises
        ------
        SketchError
            If there is none.

        Examples
        --------
        >>> pushMatrix()
        >>> translate(50, 50)
        >>> popMatrix()
        >>> rect(0, 0, 30, 30)
        """
        if not self._matrices:
            raise SketchError(
                "popMatrix() without pushMatrix().",
                hint="Each popMatrix() takes back what one pushMatrix() before it put aside.",
            )
        self._modelview, self._camera = self._matrices.pop()
        self._state = -1

    def resetMatrix(self) -> None:
        """Drop all transforms; in P3D the camera's too, so that the origin is at the eye.

        Examples
        --------
        >>> translate(50, 50)
        >>> resetMatrix()
        >>> rect(0, 0, 30, 30)
        """
        self._modelview = self._camera = mat.IDENTITY
        self._state = -1

    def applyMatrix(self, *source: float | PMatrix2D | PMatrix3D) -> None:
        """Multiply the current matrix by another.

        Parameters
        ----------
        *source : 6 or 16 float, PMatrix2D or PMatrix3D
            Row by row.

        Raises
        ------
        SketchError
            If there are neither 6 nor 16 numbers.

        Examples
        --------
        >>> applyMatrix(0.8, -0.3, 40, 0.4, 0.9, 20)
        >>> rect(0, 0, 40, 40)
        """
        self._modelview = mat.multiply(self._modelview, affine_of("applyMatrix", source))
        self._state = -1

    def setMatrix(self, source: PMatrix2D | PMatrix3D) -> None:
        """Replace the current matrix.

        Examples
        --------
        >>> m = getMatrix()
        >>> translate(40, 40)
        >>> setMatrix(m)
        >>> rect(0, 0, 30, 30)
        """
        self._modelview, self._camera = affine_of("setMatrix", (source,)), mat.IDENTITY
        self._state = -1

    @overload
    def getMatrix(self, target: None = None) -> PMatrix2D | PMatrix3D: ...
    @overload
    def getMatrix(self, target: Matrix) -> Matrix: ...
    def getMatrix(self, target: Any = None) -> Any:
        """Return the current matrix.

        Parameters
        ----------
        target : PMatrix2D or PMatrix3D, optional
            Takes the numbers in place of a new matrix. A PMatrix2D has no room for those of P3D.

        Returns
        -------
        PMatrix3D
            Without P2D or P3D a PMatrix2D, as in Processing.

        Raises
        ------
        SketchError
            If it is given a PMatrix2D in P3D, or no matrix.

        See Also
        --------
        setMatrix, printMatrix, PMatrix2D, PMatrix3D

        Notes
        -----
        In P3D it begins with the camera. Source: Processing's PGraphics.getMatrix().

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> translate(40, 20)
        >>> println(getMatrix().m03)
        40.0
        """
        if target is None:
            target = PMatrix2D() if self._stage.is_java2d else PMatrix3D()
        if not isinstance(target, PMatrix3D if self._is_3d else PMatrix2D | PMatrix3D):
            raise SketchError(
                "getMatrix() fills a PMatrix3D; a PMatrix2D only where there is no depth.",
                got=f"getMatrix({shown(target)})",
            )
        numbers = mat.to_mat4(self._modelview)
        if isinstance(target, PMatrix2D):
            a, b, _, x, c, d, _, y, *_ = numbers
            numbers = a, b, x, c, d, y
        target.set(*numbers)
        return target

    def printMatrix(self) -> None:
        """Print the current matrix.

        Examples
        --------
        >>> printMatrix()  # doctest: +SKIP
        """
        self.getMatrix().print()


def affine_of(name: str, source: tuple[Any, ...]) -> mat.Affine:
    """Return a matrix given as numbers or as an object; a last row is dropped."""
    if len(source) == 1 and isinstance(source[0], PMatrix2D | PMatrix3D):
        matrix = PMatrix3D(source[0])
        source = tuple(matrix.get([0.0] * 16))
    try:
        numbers = tuple(value + 0.0 for value in source)
    except TypeError:
        numbers = ()
    if len(numbers) == 6:
        a, b, tx, c, d, ty = numbers
        return a, b, 0.0, tx, c, d, 0.0, ty, 0.0, 0.0, 1.0, 0.0
    if len(numbers) != 16:
        raise SketchError(
            f"{name}() takes a PMatrix, or 6 or 16 numbers, row by row.",
            got=f"{len(source)}: {name}({', '.join(map(shown, source))})",
        )
    return numbers[:12]
