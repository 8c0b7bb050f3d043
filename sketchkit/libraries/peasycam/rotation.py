"""Rotations in space, as unit quaternions: they can be joined for ever and turned into each other.

They follow the right hand as seen in sketchkit's space, where y points down: a positive angle about
z turns x towards y.
"""

from __future__ import annotations

import math
from typing import NamedTuple, Self

Vector = tuple[float, float, float]

X_AXIS: Vector = (1.0, 0.0, 0.0)
Y_AXIS: Vector = (0.0, 1.0, 0.0)
Z_AXIS: Vector = (0.0, 0.0, 1.0)
NEARLY_ONE = 0.9999999999  # a sine above it: two of the three angles turn about the same axis
NEARLY_EQUAL = 0.001  # sine of half the angle between two rotations: below it, mixing is straight


class Rotation(NamedTuple):
    """A rotation: the cosine of half its angle, and the axis times the sine of it."""

    w: float = 1.0
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0

    @classmethod
    def about(cls, axis: Vector, angle_rad: float) -> Self:
        """Return the rotation about a unit axis."""
        sine = math.sin(angle_rad / 2)
        return cls(math.cos(angle_rad / 2), axis[0] * sine, axis[1] * sine, axis[2] * sine)

    @classmethod
    def of_angles(cls, x_rad: float, y_rad: float, z_rad: float) -> Rotation:
        """Return what `rotateX(x)`, `rotateY(y)` and `rotateZ(z)` do, in this order."""
        about_x, about_y = cls.about(X_AXIS, x_rad), cls.about(Y_AXIS, y_rad)
        return about_x.after(about_y.after(cls.about(Z_AXIS, z_rad)))

    def after(self, first: Rotation) -> Rotation:
        """Return the rotation that does `first`, then this one."""
        a, b = self, first
        return Rotation(
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
        )

    def turn(self, vector: Vector) -> Vector:
        """Return where a vector points when it has been turned."""
        x, y, z = vector
        along = self.x * x + self.y * y + self.z * z
        across = (self.y * z - self.z * y, self.z * x - self.x * z, self.x * y - self.y * x)
        return (
            2 * (self.w * (self.w * x + across[0]) + along * self.x) - x,
            2 * (self.w * (self.w * y + across[1]) + along * self.y) - y,
            2 * (self.w * (self.w * z + across[2]) + along * self.z) - z,
        )

    def angles(self) -> Vector:
        """Return the angles for `rotateX()`, `rotateY()`, `rotateZ()` that do the same.

        If y is a right angle, x and z turn about the same axis. Then the angles are those for y, x
        and z in this order, as in PeasyCam; each still has the place of its own axis.
        """
        (xx, yx, _), (xy, yy, _), (xz, yz, zz) = map(self.turn, (X_AXIS, Y_AXIS, Z_AXIS))
        if abs(xz) <= NEARLY_ONE:
            return math.atan2(-yz, zz), math.asin(xz), math.atan2(-xy, xx)
        return -math.asin(yz), math.atan2(xz, zz), math.atan2(yx, yy)


def between(start: Rotation, end: Rotation, part: float) -> Rotation:
    """Return the rotation after a part, 0..1, of the shorter way from one to another."""
    cosine = sum(a * b for a, b in zip(start, end, strict=True))
    if cosine < 0:  # the same rotation has two quaternions: take the nearer one
        cosine, end = -cosine, Rotation(*(-value for value in end))
    angle_rad = math.acos(min(cosine, 1.0))
    sine = math.sqrt(max(1.0 - cosine * cosine, 0.0))
    weights = (1.0 - part, part)
    if sine > NEARLY_EQUAL:
        weights = (
            math.sin((1.0 - part) * angle_rad) / sine,
            math.sin(part * angle_rad) / sine,
        )
    mixed = [weights[0] * a + weights[1] * b for a, b in zip(start, end, strict=True)]
    return Rotation(*(value / math.hypot(*mixed) for value in mixed))
