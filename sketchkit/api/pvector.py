"""PVector: a direction, a place or a velocity, with Processing's methods and Python's operators.

Five methods have two forms, as in Java: `a.add(b)` changes `a`, `PVector.add(a, b)` makes a new
vector and leaves `a` alone. The second is found on the metaclass, so that the first, called
100,000 times a frame, stays an ordinary method.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, MutableSequence, Sequence
from math import cos, sin, sqrt, tau
from typing import Any, Self, overload

from sketchkit.api.chance import chance
from sketchkit.api.pvector_arithmetic import VectorArithmetic
from sketchkit.api.pvector_measures import Point, wrong_vector
from sketchkit.core.errors import SketchError, wrong_numbers
from sketchkit.core.float32 import f32


class _TwoForms(type):
    """What `PVector.add` and its sisters are when they are called on the class."""

    @property
    def add(cls) -> Callable[..., PVector]:
        return _sum

    @property
    def sub(cls) -> Callable[..., PVector]:
        return _difference

    @property
    def mult(cls) -> Callable[..., PVector]:
        return _product

    @property
    def div(cls) -> Callable[..., PVector]:
        return _quotient

    @property
    def lerp(cls) -> Callable[..., PVector]:
        return _between


class PVector(VectorArithmetic, metaclass=_TwoForms):
    """A vector of two or three numbers.

    Parameters
    ----------
    x, y, z : float
        The components, 0 if left out. They can be read and changed: `v.x += 1`.

    Notes
    -----
    `a + b`, `a - b`, `a * 2`, `a / 2` and `-a` make new vectors, `a += b` changes `a`. As in
    Python Mode `*` is for numbers alone: two vectors have `a.dot(b)` and `a.cross(b)`.
    `x, y, z = v` takes a vector apart.

    Examples
    --------
    >>> place, velocity = PVector(10, 20), PVector(1, 0.5)
    >>> place.add(velocity)
    PVector(11.0, 20.5, 0.0)
    >>> place * 2 - velocity
    PVector(21.0, 40.5, 0.0)
    """

    __slots__ = ("__dict__",)  # sketches of Python Mode give vectors attributes of their own

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        try:
            self.x = x + 0.0
            self.y = y + 0.0
            self.z = z + 0.0
        except TypeError:
            given = (x, y) if z.__class__ is float and not z else (x, y, z)
            raise wrong_numbers("PVector", given, "x, y [, z]") from None

    @overload
    def set(self, x: Point | Sequence[float], /) -> PVector: ...
    @overload
    def set(self, x: float, y: float, z: float = 0.0) -> PVector: ...
    def set(self, x: Any, y: float | None = None, z: float = 0.0) -> PVector:
        """Give the vector other components, and return it.

        Parameters
        ----------
        x : float, PVector or list of numbers
            The first component, or all of them.
        y, z : float
            The others; z is 0 if left out.

        Examples
        --------
        >>> PVector().set(3, 4)
        PVector(3.0, 4.0, 0.0)
        """
        PVector.__init__(self, *(x if y is None else (x, y, z)))
        return self

    def copy(self) -> PVector:
        """Return another vector with the same components.

        Examples
        --------
        >>> a = PVector(1, 2)
        >>> b = a.copy().mult(10)
        >>> a
        PVector(1.0, 2.0, 0.0)
        """
        return PVector(self.x, self.y, self.z)

    @overload
    def get(self) -> PVector: ...
    @overload
    def get(self, target: MutableSequence[float]) -> MutableSequence[float]: ...
    def get(self, target: Any = None) -> Any:
        """Return a copy; or put the components into a list of 2 or 3 numbers, and return that.

        Examples
        --------
        >>> PVector(1, 2, 3).get()
        PVector(1.0, 2.0, 3.0)
        """
        if target is None:
            return self.copy()
        target[:] = self.array()[: len(target)]
        return target

    def array(self) -> list[float]:
        """Return the three components as a list.

        Examples
        --------
        >>> PVector(1, 2).array()
        [1.0, 2.0, 0.0]
        """
        return [self.x, self.y, self.z]

    def cross(self, v: Point, target: PVector | None = None) -> PVector:
        """Return the cross product: a new vector at right angles to both.

        Parameters
        ----------
        v : PVector
            The other vector. `PVector.cross(a, b)` is the same as `a.cross(b)`.
        target : PVector, optional
            Takes the result in place of a new vector.

        Examples
        --------
        >>> PVector(1, 0, 0).cross(PVector(0, 1, 0))
        PVector(0.0, 0.0, 1.0)
        """
        try:
            x = self.y * v.z - v.y * self.z
            y = self.z * v.x - v.z * self.x
            z = self.x * v.y - v.x * self.y
        except AttributeError:
            raise wrong_vector("cross", "a PVector", v) from None
        return PVector(x, y, z) if target is None else target.set(x, y, z)

    @staticmethod
    def fromAngle(angle: float, target: PVector | None = None) -> PVector:
        """Return a vector one unit long that points at an angle.

        Parameters
        ----------
        angle : float, radians
            From the x axis, clockwise on the screen.
        target : PVector, optional
            Takes the result in place of a new vector.

        Examples
        --------
        >>> PVector.fromAngle(0).mult(5)
        PVector(5.0, 0.0, 0.0)
        """
        return (target or PVector()).set(cos(angle), sin(angle), 0.0)

    @staticmethod
    def random2D(target: object = None, parent: object = None) -> PVector:
        """Return a vector one unit long in a random direction of the plane.

        Parameters
        ----------
        target : PVector, optional
            Takes the result in place of a new vector.
        parent : optional
            `this`, in sketches written for Java: the sketch's own random numbers, as always here.

        Examples
        --------
        >>> round(PVector.random2D().mag(), 6)
        1.0
        """
        return PVector.fromAngle(
            chance().below(tau), target if isinstance(target, PVector) else None
        )

    @staticmethod
    def random3D(target: object = None, parent: object = None) -> PVector:
        """Return a vector one unit long in a random direction of space.

        Parameters
        ----------
        target, parent : optional
            As those of `random2D()`.

        Examples
        --------
        >>> round(PVector.random3D().mag(), 6)
        1.0
        """
        angle = chance().below(tau)
        z = chance().between(-1, 1)
        radius = sqrt(f32(1 - f32(z * z)))  # rounded where Java does it: the digits are the same
        result = target if isinstance(target, PVector) else PVector()
        return result.set(f32(radius * cos(angle)), f32(radius * sin(angle)), z)

    def __add__(self, other: Point) -> PVector:
        try:
            return PVector(self.x + other.x, self.y + other.y, self.z + other.z)
        except AttributeError:
            return NotImplemented

    def __sub__(self, other: Point) -> PVector:
        try:
            return PVector(self.x - other.x, self.y - other.y, self.z - other.z)
        except AttributeError:
            return NotImplemented

    def __mul__(self, other: float) -> PVector:
        if isinstance(other, PVector):
            raise _two_vectors(self, other)
        try:
            return PVector(self.x * other, self.y * other, self.z * other)
        except TypeError:
            return NotImplemented

    def __rmul__(self, other: float) -> PVector:
        return self * other

    def __truediv__(self, other: float) -> PVector:
        return self.copy().div(other)

    def __neg__(self) -> PVector:
        return PVector(-self.x, -self.y, -self.z)

    def __iadd__(self, other: Point) -> Self:
        return self.add(other)

    def __isub__(self, other: Point) -> Self:
        return self.sub(other)

    def __imul__(self, other: float) -> Self:
        if isinstance(other, PVector):
            raise _two_vectors(self, other)
        return self.mult(other)

    def __itruediv__(self, other: float) -> Self:
        return self.div(other)

    def __abs__(self) -> float:
        return self.mag()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, PVector):
            return NotImplemented
        return self.x == other.x and self.y == other.y and self.z == other.z

    def __iter__(self) -> Iterator[float]:
        return iter((self.x, self.y, self.z))

    def __len__(self) -> int:
        return 3

    def __getitem__(self, place: int) -> float:
        return (self.x, self.y, self.z)[place]

    def __repr__(self) -> str:
        return f"PVector({self.x}, {self.y}, {self.z})"

    def __str__(self) -> str:
        return f"[ {self.x}, {self.y}, {self.z} ]"  # as Processing prints it


def _sum(v1: Point, v2: Point, target: PVector | None = None) -> PVector:
    """Return v1 + v2, as a new vector or in `target`."""
    try:
        x, y, z = v1.x + v2.x, v1.y + v2.y, v1.z + v2.z
    except AttributeError:
        raise wrong_vector("PVector.add", "two PVectors", v1, v2) from None
    return PVector(x, y, z) if target is None else target.set(x, y, z)


def _difference(v1: Point, v2: Point, target: PVector | None = None) -> PVector:
    """Return v1 - v2, as a new vector or in `target`."""
    try:
        x, y, z = v1.x - v2.x, v1.y - v2.y, v1.z - v2.z
    except AttributeError:
        raise wrong_vector("PVector.sub", "two PVectors", v1, v2) from None
    return PVector(x, y, z) if target is None else target.set(x, y, z)


def _product(v: Point, n: float, target: PVector | None = None) -> PVector:
    """Return v * n, as a new vector or in `target`."""
    return _copy("mult", v, n, target).mult(n)


def _quotient(v: Point, n: float, target: PVector | None = None) -> PVector:
    """Return v / n, as a new vector or in `target`."""
    return _copy("div", v, n, target).div(n)


def _between(v1: Point, v2: Point, amount: float) -> PVector:
    """Return a new vector, `amount` of the way from v1 to v2."""
    return _copy("lerp", v1, v2).lerp(v2, amount)


def _copy(name: str, v: Point, other: object, target: PVector | None = None) -> PVector:
    """Return `v` as a new vector or in `target`, for a method of the class called `name`."""
    try:
        return PVector(v.x, v.y, v.z) if target is None else target.set(v.x, v.y, v.z)
    except AttributeError:
        raise wrong_vector(f"PVector.{name}", "a PVector first", v, other) from None


def _two_vectors(a: PVector, b: PVector) -> SketchError:
    return SketchError(
        "* multiplies a PVector by a number, not by another PVector.",
        got=f"{a} * {b}",
        hint="a.dot(b) is the dot product, a.cross(b) the cross product.",
    )
