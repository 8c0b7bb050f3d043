"""PMatrix2D and PMatrix3D: transforms as objects, whose numbers a sketch can read and set.

The arithmetic is that of `core/matrix.py`: row by row, for points that are columns. Both classes
take part in it as Mat4; a PMatrix2D keeps the six numbers that the plane needs.
"""

from __future__ import annotations

from collections.abc import MutableSequence, Sequence
from typing import Any, Self, overload

from sketchkit.api.pvector import PVector
from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.matrix import Mat4


class Matrix:
    """What the two kinds of matrix have in common; each says how it stores its numbers."""

    __slots__ = ()

    def __init__(self, *source: Any) -> None:  # Any: numbers or a matrix, checked by use
        if source:
            self.set(*source)
        else:
            self.reset()

    def reset(self) -> None:
        """Make this the matrix that changes nothing.

        Examples
        --------
        >>> m = PMatrix2D(2, 0, 0, 0, 2, 0)
        >>> m.reset()
        >>> m
        PMatrix2D(1.0, 0.0, 0.0, 0.0, 1.0, 0.0)
        """
        self._become(mat.IDENTITY4)

    def set(self, *source: Any) -> None:  # Any: numbers or a matrix, checked by use
        """Take over other numbers.

        Parameters
        ----------
        *source : 6 or 16 float, a list of them, or a matrix
            Row by row.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.set(2, 0, 10, 0, 2, 20)
        >>> m.m02
        10.0
        """
        self._become(self._read("set", source))

    @overload
    def get(self) -> Self: ...
    @overload
    def get(self, target: MutableSequence[float]) -> MutableSequence[float]: ...
    def get(self, target: Any = None) -> Any:
        """Return a copy; or put the numbers into a list.

        Parameters
        ----------
        target : list, optional
            Is filled if it is as long as there are numbers; if not, a new list is returned.

        Examples
        --------
        >>> PMatrix2D().get([])
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        """
        if target is None:
            return type(self)(self)
        numbers = [getattr(self, name) for name in self.__slots__]
        if len(target) != len(numbers):
            return numbers
        target[:] = numbers
        return target

    def apply(self, *source: Any) -> None:  # Any: numbers or a matrix, checked by use
        """Multiply by another matrix, which acts on a point before this one.

        Parameters
        ----------
        *source : 6 or 16 float, or a matrix
            Row by row.

        See Also
        --------
        preApply

        Examples
        --------
        >>> m = PMatrix2D(2, 0, 0, 0, 2, 0)
        >>> m.apply(1, 0, 10, 0, 1, 20)
        >>> m.m02, m.m12
        (20.0, 40.0)
        """
        self._become(mat.multiply4(self._mat4(), self._read("apply", source)))

    def preApply(self, *source: Any) -> None:  # Any: numbers or a matrix, checked by use
        """Multiply by another matrix, which acts on a point after this one.

        Parameters
        ----------
        *source : 6 or 16 float, or a matrix
            Row by row.

        See Also
        --------
        apply

        Examples
        --------
        >>> m = PMatrix2D(2, 0, 0, 0, 2, 0)
        >>> m.preApply(1, 0, 10, 0, 1, 20)
        >>> m.m02, m.m12
        (10.0, 20.0)
        """
        self._become(mat.multiply4(self._read("preApply", source), self._mat4()))

    def rotate(self, angle: float) -> None:
        """Turn about the z axis.

        Parameters
        ----------
        angle : float, radians
            Positive is clockwise on the screen.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.rotate(HALF_PI)
        >>> round(m.multY(1, 0), 6)
        1.0
        """
        self._apply(mat.rotate_z(mat.IDENTITY, angle))

    def rotateZ(self, angle: float) -> None:
        """Turn about the z axis, as `rotate()` does.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.rotateZ(HALF_PI)
        >>> round(m.multY(1, 0), 6)
        1.0
        """
        self._apply(mat.rotate_z(mat.IDENTITY, angle))

    def shearX(self, angle: float) -> None:
        """Slant, so that x grows with y.

        Parameters
        ----------
        angle : float, radians
            Between the y axis and its slanted image.

        Notes
        -----
        Processing's PMatrix2D gets this wrong (it also moves and flattens); this one does not.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.shearX(QUARTER_PI)
        >>> round(m.multX(0, 10), 6)
        10.0
        """
        self._apply(mat.shear_x(mat.IDENTITY, angle))

    def shearY(self, angle: float) -> None:
        """Slant, so that y grows with x.

        Parameters
        ----------
        angle : float, radians
            Between the x axis and its slanted image.

        Examples
        --------
        >>> m = PMatrix2D()
        >>> m.shearY(QUARTER_PI)
        >>> round(m.multY(10, 0), 6)
        10.0
        """
        self._apply(mat.shear_y(mat.IDENTITY, angle))

    def invert(self) -> bool:
        """Become the matrix that undoes this one, and return True; or False if there is none.

        Examples
        --------
        >>> m = PMatrix2D(2, 0, 10, 0, 2, 20)
        >>> m.invert()
        True
        >>> m
        PMatrix2D(0.5, 0.0, -5.0, 0.0, 0.5, -10.0)
        """
        inverse = mat.inverse4(self._mat4())
        if inverse is not None:
            self._become(inverse)
        return inverse is not None

    def determinant(self) -> float:
        """Return the factor by which areas, or in space volumes, grow.

        Examples
        --------
        >>> PMatrix2D(2, 0, 10, 0, 3, 20).determinant()
        6.0
        """
        return mat.determinant4(self._mat4())

    def print(self) -> None:
        """Print the numbers, row by row.

        Examples
        --------
        >>> PMatrix2D(1, 0, 10, 0, 1, 20).print()
         1.0000  0.0000  10.0000
         0.0000  1.0000  20.0000
        """
        print(self)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self.get([]) == other.get([])  # type: ignore[attr-defined]
