"""PMatrix2D and PMatrix3D: transforms as objects, whose numbers a sketch can read and set."""

from __future__ import annotations

from typing import NoReturn

from sketchkit.api.pmatrix_operations import MatrixOperations
from sketchkit.api.pvector import PVector
from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.matrix import Mat4


class PMatrix2D(MatrixOperations):
    """A transform of the plane: two rows of three numbers, m00 to m12.

    Parameters
    ----------
    *source : 6 float, a list of them, or a PMatrix2D
        Row by row. With none it is the matrix that changes nothing.

    See Also
    --------
    PMatrix3D, applyMatrix

    Examples
    --------
    >>> m = PMatrix2D()
    >>> m.translate(10, 20)
    >>> m.scale(2)
    >>> m.multX(1, 1), m.multY(1, 1)
    (12.0, 22.0)
    """

    __slots__ = ("m00", "m01", "m02", "m10", "m11", "m12")
    m00: float
    m01: float
    m02: float
    m10: float
    m11: float
    m12: float

    def translate(self, x: float, y: float) -> None:
        """Move the origin.

        Parameters
        ----------
        x, y : float
            In the matrix's own units.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.translate(10, 20)
        >>> m
        PMatrix2D(1.0, 0.0, 10.0, 0.0, 1.0, 20.0)
        """
        self._apply(mat.translate(mat.IDENTITY, x, y))

    def scale(self, x: float, y: float | None = None) -> None:
        """Stretch the axes.

        Parameters
        ----------
        x, y : float
            The factors; with one, both are stretched by it.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.scale(2, 3)
        >>> m
        PMatrix2D(2.0, 0.0, 0.0, 0.0, 3.0, 0.0)
        """
        self._apply(mat.scale(mat.IDENTITY, x, x if y is None else y))

    def transpose(self) -> None:
        """Do nothing, as in Processing: mirrored at its diagonal, this has no place for m02, m12.

        Examples
        --------
        >>> m = PMatrix2D(1, 2, 3, 4, 5, 6)
        >>> m.transpose()
        >>> m
        PMatrix2D(1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
        """

    def rotateX(self, angle: float) -> NoReturn:
        """Say that it takes a PMatrix3D to turn about the x axis.

        Raises
        ------
        SketchError
            Always.

        Examples
        --------
        >>> PMatrix3D().rotateX(0.5)
        """
        raise _no_turn("rotateX", angle)

    def rotateY(self, angle: float) -> NoReturn:
        """Say that it takes a PMatrix3D to turn about the y axis.

        Raises
        ------
        SketchError
            Always.

        Examples
        --------
        >>> PMatrix3D().rotateY(0.5)
        """
        raise _no_turn("rotateY", angle)

    def mult(self, source: PVector, target: PVector | None = None) -> PVector:
        """Return where a point goes. z does not count.

        Parameters
        ----------
        source : PVector
            The point.
        target : PVector, optional
            Takes the result in place of a new vector.

        Examples
        --------
        >>> PMatrix2D(1, 0, 10, 0, 1, 20).mult(PVector(1, 2))
        PVector(11.0, 22.0, 0.0)
        """
        result = PVector() if target is None else target
        x, y = source.x, source.y
        return result.set(self.multX(x, y), self.multY(x, y), result.z)

    def multX(self, x: float, y: float) -> float:
        """Return the x of where the point (x, y) goes.

        Examples
        --------
        >>> PMatrix2D(1, 0, 10, 0, 1, 20).multX(1, 2)
        11.0
        """
        return self.m00 * x + self.m01 * y + self.m02

    def multY(self, x: float, y: float) -> float:
        """Return the y of where the point (x, y) goes.

        Examples
        --------
        >>> PMatrix2D(1, 0, 10, 0, 1, 20).multY(1, 2)
        22.0
        """
        return self.m10 * x + self.m11 * y + self.m12

    def _become(self, numbers: Mat4) -> None:
        self.m00, self.m01, _, self.m02, self.m10, self.m11, _, self.m12 = numbers[:8]

    def _mat4(self) -> Mat4:
        a, b, c, d, e, f = self.m00, self.m01, self.m02, self.m10, self.m11, self.m12
        return a, b, 0.0, c, d, e, 0.0, f, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0


class PMatrix3D(MatrixOperations):
    """A transform of space: four rows of four numbers, m00 to m33.

    Parameters
    ----------
    *source : 6 or 16 float, a list of them, or a matrix
        Row by row; six numbers are a transform of the plane. With none it is the matrix that
        changes nothing.

    See Also
    --------
    PMatrix2D, applyMatrix, getMatrix

    Notes
    -----
    Processing's constructor puts the third and the sixth of six numbers into the wrong column
    (its `set()` does not); here they move the origin, in both.

    Examples
    --------
    >>> m = PMatrix3D()
    >>> m.translate(10, 20, 30)
    >>> m.mult(PVector(1, 2, 3))
    PVector(11.0, 22.0, 33.0)
    """

    __slots__ = (
        "m00",
        "m01",
        "m02",
        "m03",
        "m10",
        "m11",
        "m12",
        "m13",
        "m20",
        "m21",
        "m22",
        "m23",
        "m30",
        "m31",
        "m32",
        "m33",
    )
    m00: float
    m01: float
    m02: float
    m03: float
    m10: float
    m11: float
    m12: float
    m13: float
    m20: float
    m21: float
    m22: float
    m23: float
    m30: float
    m31: float
    m32: float
    m33: float

    def translate(self, x: float, y: float, z: float = 0.0) -> None:
        """Move the origin.

        Parameters
        ----------
        x, y, z : float
            In the matrix's own units.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20, 30)
        >>> m.m03, m.m13, m.m23
        (10.0, 20.0, 30.0)
        """
        self._apply(mat.translate(mat.IDENTITY, x, y, z))

    def scale(self, x: float, y: float | None = None, z: float | None = None) -> None:
        """Stretch the axes.

        Parameters
        ----------
        x, y, z : float
            The factors: one for all, two for x and y, or three.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.scale(2, 3, 4)
        >>> m.m00, m.m11, m.m22
        (2.0, 3.0, 4.0)
        """
        if y is None:
            y = z = x
        self._apply(mat.scale(mat.IDENTITY, x, y, 1.0 if z is None else z))

    def rotate(self, angle: float, x: float = 0.0, y: float = 0.0, z: float | None = None) -> None:
        """Turn about an axis.

        Parameters
        ----------
        angle : float, radians
            Positive is clockwise as seen along the axis.
        x, y, z : float, optional
            The axis, of any length; the z axis if left out.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.rotate(HALF_PI, 0, 0, 1)
        >>> round(m.multY(1, 0), 6)
        1.0
        """
        axis = (0.0, 0.0, 1.0) if z is None else (x, y, z)
        self._apply(mat.rotate_axis(mat.IDENTITY, angle, *axis))

    def rotateX(self, angle: float) -> None:
        """Turn about the x axis.

        Parameters
        ----------
        angle : float, radians
            From y towards z.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.rotateX(HALF_PI)
        >>> round(m.multZ(0, 1, 0), 6)
        1.0
        """
        self._apply(mat.rotate_x(mat.IDENTITY, angle))

    def rotateY(self, angle: float) -> None:
        """Turn about the y axis.

        Parameters
        ----------
        angle : float, radians
            From z towards x.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.rotateY(HALF_PI)
        >>> round(m.multX(0, 0, 1), 6)
        1.0
        """
        self._apply(mat.rotate_y(mat.IDENTITY, angle))

    def transpose(self) -> None:
        """Exchange rows and columns.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20)
        >>> m.transpose()
        >>> m.m03, m.m30
        (0.0, 10.0)
        """
        self._become(mat.transpose4(self._mat4()))

    def mult(self, source: PVector, target: PVector | None = None) -> PVector:
        """Return where a point goes, without division by its fourth number.

        Parameters
        ----------
        source : PVector
            The point.
        target : PVector, optional
            Takes the result in place of a new vector.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20)
        >>> m.mult(PVector(1, 2, 3))
        PVector(11.0, 22.0, 3.0)
        """
        x, y, z, _ = mat.transform4(self._mat4(), source.x, source.y, source.z)
        return (PVector() if target is None else target).set(x, y, z)

    def multX(self, x: float, y: float, z: float = 0.0, w: float = 1.0) -> float:
        """Return the x of where the point (x, y, z) goes.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20, 30)
        >>> m.multX(1, 2, 3)
        11.0
        """
        return self.m00 * x + self.m01 * y + self.m02 * z + self.m03 * w

    def multY(self, x: float, y: float, z: float = 0.0, w: float = 1.0) -> float:
        """Return the y of where the point (x, y, z) goes.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20, 30)
        >>> m.multY(1, 2, 3)
        22.0
        """
        return self.m10 * x + self.m11 * y + self.m12 * z + self.m13 * w

    def multZ(self, x: float, y: float, z: float = 0.0, w: float = 1.0) -> float:
        """Return the z of where the point (x, y, z) goes.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20, 30)
        >>> m.multZ(1, 2, 3)
        33.0
        """
        return self.m20 * x + self.m21 * y + self.m22 * z + self.m23 * w

    def multW(self, x: float, y: float, z: float = 0.0, w: float = 1.0) -> float:
        """Return the fourth number of where the point (x, y, z) goes.

        Examples
        --------
        >>> m = PMatrix3D()
        >>> m.translate(10, 20, 30)
        >>> m.multW(1, 2, 3)
        1.0
        """
        return self.m30 * x + self.m31 * y + self.m32 * z + self.m33 * w

    def _become(self, numbers: Mat4) -> None:
        for name, number in zip(self.__slots__, numbers, strict=True):
            setattr(self, name, number)

    def _mat4(self) -> Mat4:
        return tuple(self._numbers())


def _no_turn(name: str, angle: object) -> SketchError:
    return SketchError(
        f"A PMatrix2D stays in the plane: it has no {name}().",
        got=f"{name}({shown(angle)})",
        hint=f"rotate() turns it; PMatrix3D().{name}({shown(angle)}) turns in space.",
    )
