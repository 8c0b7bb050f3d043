"""What PMatrix2D and PMatrix3D can both do: products, turning, slanting, undoing.

The arithmetic is that of `core/matrix.py`: row by row, for points that are columns. Both kinds
take part in it as Mat4, of which a PMatrix2D keeps the six numbers that the plane needs.
"""

from __future__ import annotations

from collections.abc import Iterator, MutableSequence
from typing import Any, Self, overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from sketchkit.core import matrix as mat
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.matrix import Affine, Mat4


class MatrixOperations:
    """The methods of both kinds. Each kind says how it stores its numbers: `_become`, `_mat4`."""

    __slots__ = ()

    def __init__(self, *source: object) -> None:
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

    def set(self, *source: object) -> None:
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
        numbers = self._numbers()
        if len(target) != len(numbers):
            return numbers
        target[:] = numbers
        return target

    def apply(self, *source: object) -> None:
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

    def preApply(self, *source: object) -> None:
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

    def __array__(
        self, dtype: DTypeLike | None = None, copy: bool | None = None
    ) -> NDArray[np.generic]:
        """Return the numbers as NumPy's array, one row each: `numpy.asarray(m)`."""
        if copy is False:
            raise ValueError("a matrix has no array of its own: NumPy gets a copy")
        width = 3 if len(self.__slots__) == 6 else 4
        return np.array(self._numbers(), dtype).reshape(-1, width)

    def __iter__(self) -> Iterator[float]:
        return iter(self._numbers())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return NotImplemented
        return self._numbers() == other._numbers()

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(map(str, self._numbers()))})"

    def __str__(self) -> str:
        texts = [f"{number: .4f}" for number in self._numbers()]
        width = 3 if len(texts) == 6 else 4
        return "\n".join(" ".join(texts[at : at + width]) for at in range(0, len(texts), width))

    def _become(self, numbers: Mat4) -> None:
        raise NotImplementedError

    def _mat4(self) -> Mat4:
        raise NotImplementedError

    def _numbers(self) -> list[float]:
        names: tuple[str, ...] = self.__slots__
        return [getattr(self, name) for name in names]

    def _apply(self, change: Affine) -> None:
        self._become(mat.multiply4(self._mat4(), mat.to_mat4(change)))

    def _read(self, name: str, source: tuple[object, ...]) -> Mat4:
        """Return the matrix that an argument list stands for, if this kind can take it in."""
        given: Any = source[0] if len(source) == 1 else source  # checked by use
        count = len(self.__slots__)
        try:
            if isinstance(given, MatrixOperations):
                given = given._numbers()
            a, b, c, d, e, f, *more = (value + 0.0 for value in given)
        except (TypeError, ValueError):
            raise self._wrong(name, source) from None
        if not more:
            return a, b, 0.0, c, d, e, 0.0, f, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0
        if len(more) != count - 6:
            raise self._wrong(name, source)
        return (a, b, c, d, e, f, *more)

    def _wrong(self, name: str, source: tuple[object, ...]) -> SketchError:
        kinds = "6 numbers or a PMatrix2D"
        if len(self.__slots__) == 16:
            kinds = "6 or 16 numbers or a matrix"
        call = ", ".join(map(shown, source))
        return SketchError(
            f"{type(self).__name__}'s {name}() takes {kinds}.", got=f"{name}({call})"
        )
