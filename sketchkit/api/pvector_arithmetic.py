"""The half of PVector that calculates: each method changes the vector, and returns it."""

from __future__ import annotations

from math import copysign, inf
from typing import Any, Self, overload

from sketchkit.api.pvector_measures import Point, VectorMeasures, wrong_vector


class VectorArithmetic(VectorMeasures):
    """Sums, products and the way between, of a vector that is changed by them."""

    __slots__ = ()

    @overload
    def add(self, x: Point, /) -> Self: ...
    @overload
    def add(self, x: float, y: float, z: float = 0.0) -> Self: ...
    def add(self, x: Any, y: float | None = None, z: float = 0.0) -> Self:
        """Add another vector to this one, and return it.

        Parameters
        ----------
        x : PVector or float
            The other vector, or its x.
        y, z : float
            The rest of 2 or 3 numbers.

        See Also
        --------
        sub, mult, div

        Notes
        -----
        `PVector.add(a, b)` returns a new vector and leaves `a` alone; a third vector, if there is
        one, takes the result. The same holds for `sub`, `mult` and `div`.

        Examples
        --------
        >>> PVector(1, 2).add(PVector(10, 20))
        PVector(11.0, 22.0, 0.0)
        >>> PVector(1, 2).add(10, 20)
        PVector(11.0, 22.0, 0.0)
        """
        try:
            if y is None:
                self.x += x.x
                self.y += x.y
                self.z += x.z
            else:
                self.x += x
                self.y += y
                self.z += z
        except (AttributeError, TypeError):
            raise wrong_vector("add", "a PVector, or 2 or 3 numbers", x, y, z) from None
        return self

    @overload
    def sub(self, x: Point, /) -> Self: ...
    @overload
    def sub(self, x: float, y: float, z: float = 0.0) -> Self: ...
    def sub(self, x: Any, y: float | None = None, z: float = 0.0) -> Self:
        """Take another vector away from this one, and return it.

        Parameters
        ----------
        x : PVector or float
            The other vector, or its x.
        y, z : float
            The rest of 2 or 3 numbers.

        Examples
        --------
        >>> PVector(11, 22).sub(PVector(10, 20))
        PVector(1.0, 2.0, 0.0)
        >>> PVector.sub(PVector(11, 22), PVector(10, 20))
        PVector(1.0, 2.0, 0.0)
        """
        try:
            if y is None:
                self.x -= x.x
                self.y -= x.y
                self.z -= x.z
            else:
                self.x -= x
                self.y -= y
                self.z -= z
        except (AttributeError, TypeError):
            raise wrong_vector("sub", "a PVector, or 2 or 3 numbers", x, y, z) from None
        return self

    def mult(self, n: float) -> Self:
        """Make the vector `n` times as long, and return it.

        Parameters
        ----------
        n : float
            The factor; a negative one turns it round.

        Examples
        --------
        >>> PVector(1, 2).mult(3)
        PVector(3.0, 6.0, 0.0)
        >>> PVector.mult(PVector(1, 2), 3)
        PVector(3.0, 6.0, 0.0)
        """
        try:
            n = n + 0.0  # a PVector times a number is a PVector: it must not become our x
        except TypeError:
            raise wrong_vector("mult", "a number", n) from None
        self.x *= n
        self.y *= n
        self.z *= n
        return self

    def div(self, n: float) -> Self:
        """Make the vector `n` times shorter, and return it.

        Parameters
        ----------
        n : float
            The divisor. By 0, components become infinite, and those that are 0 NaN.

        Examples
        --------
        >>> PVector(3, 6).div(3)
        PVector(1.0, 2.0, 0.0)
        >>> PVector.div(PVector(3, 6), 3)
        PVector(1.0, 2.0, 0.0)
        """
        try:
            n = n + 0.0
            self.x /= n
            self.y /= n
            self.z /= n
        except ZeroDivisionError:
            return self.mult(copysign(inf, n))
        except TypeError:
            raise wrong_vector("div", "a number", n) from None
        return self

    @overload
    def lerp(self, x: Point, y: float, /) -> Self: ...
    @overload
    def lerp(self, x: float, y: float, z: float, amount: float) -> Self: ...
    def lerp(self, x: Any, y: float, z: float | None = None, amount: Any = None) -> Self:
        """Move the vector towards another one, and return it.

        Parameters
        ----------
        x, y, z : float
            Where to; or a PVector in their place, followed by the amount.
        amount : float
            How much of the way: 0 is none, 1 is all of it.

        Notes
        -----
        `PVector.lerp(a, b, amount)` returns a new vector and leaves `a` alone.

        Examples
        --------
        >>> PVector(0, 0).lerp(PVector(10, 20), 0.5)
        PVector(5.0, 10.0, 0.0)
        >>> PVector(0, 0).lerp(10, 20, 0, 0.5)
        PVector(5.0, 10.0, 0.0)
        """
        try:
            if z is None:
                x, y, z, amount = x.x, x.y, x.z, y
            self.x += (x - self.x) * amount
            self.y += (y - self.y) * amount
            self.z += (z - self.z) * amount
        except (AttributeError, TypeError):
            takes = "a PVector or 3 numbers, and an amount"
            raise wrong_vector("lerp", takes, x, y, z, amount) from None
        return self
