"""The half of PVector that measures: lengths, angles, distances, and setting them."""

from __future__ import annotations

from itertools import takewhile
from math import acos, atan2, cos, sin, sqrt
from typing import Protocol, Self

from sketchkit.core.errors import SketchError, shown


class Point(Protocol):
    """Whatever has an x, a y and a z."""

    x: float
    y: float
    z: float


class VectorMeasures:
    """Methods that need no vector but this one, and perhaps another to compare it with."""

    __slots__ = ("x", "y", "z")
    x: float
    y: float
    z: float

    def mag(self) -> float:
        """Return the length of the vector.

        See Also
        --------
        magSq, setMag, normalize, limit

        Examples
        --------
        >>> PVector(3, 4).mag()
        5.0
        """
        x, y, z = self.x, self.y, self.z
        return sqrt(x * x + y * y + z * z)

    def magSq(self) -> float:
        """Return the square of the length: quicker than `mag()`, and enough to compare.

        Examples
        --------
        >>> PVector(3, 4).magSq()
        25.0
        """
        x, y, z = self.x, self.y, self.z
        return x * x + y * y + z * z

    def dist(self, v: Point) -> float:
        """Return the distance between the ends of two vectors.

        Parameters
        ----------
        v : PVector
            The other one. `PVector.dist(a, b)` is the same as `a.dist(b)`.

        Examples
        --------
        >>> PVector(1, 1).dist(PVector(4, 5))
        5.0
        """
        try:
            x, y, z = self.x - v.x, self.y - v.y, self.z - v.z
        except AttributeError:
            raise wrong_vector("dist", "a PVector", v) from None
        return sqrt(x * x + y * y + z * z)

    def dot(self, x: Point | float, y: float | None = None, z: float = 0.0) -> float:
        """Return the dot product: how far one vector goes along the other.

        Parameters
        ----------
        x : PVector or float
            The other vector, or its x. `PVector.dot(a, b)` is the same as `a.dot(b)`.
        y, z : float
            The rest of three numbers.

        Examples
        --------
        >>> PVector(1, 2, 3).dot(PVector(4, -5, 6))
        12.0
        """
        try:
            if y is None:
                return self.x * x.x + self.y * x.y + self.z * x.z  # type: ignore[union-attr]
            return self.x * x + self.y * y + self.z * z  # type: ignore[operator]
        except (AttributeError, TypeError):
            raise wrong_vector("dot", "a PVector or 3 numbers", x, y, z) from None

    def heading(self) -> float:
        """Return the angle between the x axis and the vector, in radians, -PI to PI.

        Notes
        -----
        y points down, so a positive angle is clockwise on the screen. z does not count.

        Examples
        --------
        >>> degrees(PVector(0, 5).heading())
        90.0
        """
        return atan2(self.y, self.x)

    def heading2D(self) -> float:
        """Return what `heading()` does: its name in old sketches.

        Examples
        --------
        >>> degrees(PVector(0, 5).heading2D())
        90.0
        """
        return self.heading()

    def setHeading(self, angle: float) -> Self:
        """Turn the vector to point at an angle, and return it.

        Parameters
        ----------
        angle : float, radians
            From the x axis, clockwise on the screen.

        Notes
        -----
        z is left as it is, though it counts for the length: so Processing does it.

        Examples
        --------
        >>> PVector(0, 5).setHeading(0)
        PVector(5.0, 0.0, 0.0)
        """
        length = self.mag()
        self.x = length * cos(angle)
        self.y = length * sin(angle)
        return self

    def rotate(self, theta: float) -> Self:
        """Turn the vector about the z axis, and return it.

        Parameters
        ----------
        theta : float, radians
            By how much; positive is clockwise on the screen.

        Examples
        --------
        >>> degrees(PVector(5, 0).rotate(HALF_PI).heading())
        90.0
        """
        c, s = cos(theta), sin(theta)
        self.x, self.y = self.x * c - self.y * s, self.x * s + self.y * c
        return self

    def normalize(self, target: Self | None = None) -> Self:
        """Make the vector one unit long, and return it. A vector of length 0 stays as it is.

        Parameters
        ----------
        target : PVector, optional
            Takes the result in place of this vector.

        Examples
        --------
        >>> PVector(0, 5).normalize()
        PVector(0.0, 1.0, 0.0)
        """
        result = self if target is None else target
        x, y, z = self.x, self.y, self.z
        length = sqrt(x * x + y * y + z * z) or 1.0
        result.x = x / length
        result.y = y / length
        result.z = z / length
        return result

    def setMag(self, target: Self | float, length: float | None = None) -> Self:
        """Make the vector this long, and return it. A vector of length 0 stays as it is.

        Parameters
        ----------
        target : float, or PVector
            The new length, of this vector; or a vector that takes the result in its place.
        length : float
            The new length, if there is a target.

        Examples
        --------
        >>> PVector(3, 4).setMag(10)
        PVector(6.0, 8.0, 0.0)
        """
        if isinstance(target, VectorMeasures):
            return self._stretch(target, length)
        return self._stretch(self, target)

    def limit(self, maximum: float) -> Self:
        """Shorten the vector to a length if it is longer, and return it.

        Parameters
        ----------
        maximum : float
            The greatest length that it may have.

        Examples
        --------
        >>> PVector(30, 40).limit(5)
        PVector(3.0, 4.0, 0.0)
        """
        x, y, z = self.x, self.y, self.z
        if x * x + y * y + z * z > maximum * maximum:
            self._stretch(self, maximum)
        return self

    @staticmethod
    def angleBetween(v1: Point, v2: Point) -> float:
        """Return the angle between two vectors, in radians, 0 to PI; 0 if one has no length.

        Parameters
        ----------
        v1, v2 : PVector
            Their order does not matter.

        Examples
        --------
        >>> degrees(PVector.angleBetween(PVector(1, 0), PVector(0, 7)))
        90.0
        """
        try:
            x1, y1, z1, x2, y2, z2 = v1.x, v1.y, v1.z, v2.x, v2.y, v2.z
        except AttributeError:
            raise wrong_vector("angleBetween", "two PVectors", v1, v2) from None
        lengths = sqrt((x1 * x1 + y1 * y1 + z1 * z1) * (x2 * x2 + y2 * y2 + z2 * z2))
        if lengths == 0:
            return 0.0
        cosine = (x1 * x2 + y1 * y2 + z1 * z2) / lengths
        return acos(min(max(cosine, -1.0), 1.0))  # rounding can lead a little beyond

    def _stretch(self, result: Self, length: float | None) -> Self:
        """Give `result` this vector's direction and another length, and return it."""
        x, y, z = self.x, self.y, self.z
        try:
            factor = length / (sqrt(x * x + y * y + z * z) or 1.0)  # type: ignore[operator]
        except TypeError:
            raise wrong_vector("setMag", "a length", length) from None
        result.x = x * factor
        result.y = y * factor
        result.z = z * factor
        return result


def wrong_vector(name: str, takes: str, *args: object) -> SketchError:
    """Return the error for a method of PVector that got something else than it takes."""
    given = [*args[:1], *takewhile(lambda arg: arg is not None, args[1:])]
    call = ", ".join(map(shown, given))
    return SketchError(f"{name}() takes {takes}.", got=f"{name}({call})")
