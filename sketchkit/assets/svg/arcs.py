"""Parts of ellipses in SVG paths: each becomes a few Bezier curves.

The way from end points to a centre is that of the SVG standard's implementation notes. Every
number is a 32-bit float: a quarter of a circle becomes one curve or two by the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

import numpy as np

Point: TypeAlias = tuple[float, float]
Float: TypeAlias = np.float32

f4 = np.float32
TURN = f4(2 * math.pi)
DEGREE = f4(math.pi) / f4(180)


class Arc(NamedTuple):
    """An arc as the `A` of a path has it: from where the pen is to `end`.

    `radii` are not 0; too small ones grow until the ellipse reaches both ends. `rotation` is that
    of the ellipse's first axis, in degrees. Clockwise is meant with y pointing down.
    """

    start: Point
    end: Point
    radii: Point
    rotation: float
    is_large: bool
    is_clockwise: bool


class _Ellipse(NamedTuple):
    """An ellipse about its centre, and the angles between which the arc lies."""

    x: Float
    y: Float
    rx: Float
    ry: Float
    cos: Float
    sin: Float
    first: Float
    sweep: Float

    def point(self, angle: Float) -> tuple[Float, Float]:
        sin, cos = _sin(angle), _cos(angle)
        return (
            self.x + self.rx * self.cos * cos - self.ry * self.sin * sin,
            self.y + self.rx * self.sin * cos + self.ry * self.cos * sin,
        )

    def direction(self, angle: Float) -> tuple[Float, Float]:
        sin, cos = _sin(angle), _cos(angle)
        return (
            -self.rx * self.cos * sin - self.ry * self.sin * cos,
            -self.rx * self.sin * sin + self.ry * self.cos * cos,
        )


def arc_curves(arc: Arc) -> Iterator[tuple[Point, Point, Point]]:
    """Yield the control points and the end of each Bezier curve of an arc."""
    ellipse = _ellipse(arc)
    count = math.ceil(abs(ellipse.sweep) / TURN * 4)
    step = ellipse.sweep / f4(count)
    reach = _sin(step) * (_root(4 + 3 * f4(math.tan(step / 2)) ** 2) - 1) / 3
    x, y = f4(arc.start[0]), f4(arc.start[1])
    out_x, out_y = ellipse.direction(ellipse.first)
    for piece in range(1, count + 1):
        angle = ellipse.first + f4(piece) * step
        end_x, end_y = ellipse.point(angle)
        if piece == count:
            end_x, end_y = f4(arc.end[0]), f4(arc.end[1])
        in_x, in_y = ellipse.direction(angle)
        yield (
            (float(x + reach * out_x), float(y + reach * out_y)),
            (float(end_x - reach * in_x), float(end_y - reach * in_y)),
            (float(end_x), float(end_y)),
        )
        x, y, out_x, out_y = end_x, end_y, in_x, in_y


def _ellipse(arc: Arc) -> _Ellipse:
    """Return the ellipse through both ends of an arc."""
    x1, y1, x2, y2 = map(f4, (*arc.start, *arc.end))
    rx, ry = map(f4, map(abs, arc.radii))
    tilt = np.fmod(np.fmod(f4(arc.rotation), f4(360)) + f4(360), f4(360)) * DEGREE
    cos, sin = _cos(tilt), _sin(tilt)

    # Half the way from the end to the start, along the ellipse's own axes
    x = (cos * (x1 - x2) + sin * (y1 - y2)) / 2
    y = (-sin * (x1 - x2) + cos * (y1 - y2)) / 2
    distance = (x * x) / (rx * rx) + (y * y) / (ry * ry)
    if distance > 1:
        rx, ry, centre_x, centre_y = rx * _root(distance), ry * _root(distance), f4(0), f4(0)
    else:
        ratio = (rx * rx * ry * ry) / ((rx * rx * y * y) + (ry * ry * x * x))
        side = f4(-1 if arc.is_large == arc.is_clockwise else 1) * _root(max(ratio - 1, f4(0)))
        centre_x, centre_y = side * rx * y / ry, -side * ry * x / rx

    first = _angle((x - centre_x) / rx, (y - centre_y) / ry)
    last = _angle((-x - centre_x) / rx, (-y - centre_y) / ry)
    sweep = np.fmod(np.fmod(last - first, TURN) + TURN, TURN)
    return _Ellipse(
        cos * centre_x - sin * centre_y + (x1 + x2) / 2,
        sin * centre_x + cos * centre_y + (y1 + y2) / 2,
        rx,
        ry,
        cos,
        sin,
        first,
        sweep if arc.is_clockwise else sweep - TURN,
    )


def _sin(angle: Float) -> Float:
    return f4(math.sin(angle))


def _cos(angle: Float) -> Float:
    return f4(math.cos(angle))


def _root(value: Float) -> Float:
    return f4(math.sqrt(value))


def _angle(x: Float, y: Float) -> Float:
    return f4(math.atan2(y, x))
