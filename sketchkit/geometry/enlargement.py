"""How large things are on the screen."""

from __future__ import annotations

from functools import lru_cache
from math import hypot

from sketchkit.core.matrix import Affine, Mat4

Screen = tuple[int, int]  # width and height in pixels
Vector = tuple[float, float, float]


def enlargement(modelview: Affine, projection: Mat4, screen: Screen, x: float, y: float) -> float:
    """Return how many pixels of the screen a unit in the plane z = 0 is long, at (x, y).

    Of the plane's two axes the longer one counts. Behind the eye the answer is 1.

    Examples
    --------
    >>> from sketchkit.core.matrix import IDENTITY, ortho, scale
    >>> pixels = ortho(0, 128, 0, 64, -1, 1)
    >>> enlargement(scale(IDENTITY, 3, 2), pixels, (128, 64), 7, 8)
    3.0
    """
    everywhere = _everywhere(modelview, projection, screen)
    return _at(modelview, projection, screen, x, y) if everywhere is None else everywhere


@lru_cache(maxsize=256)
def _everywhere(modelview: Affine, projection: Mat4, screen: Screen) -> float | None:
    """Return the enlargement in a plane that faces the screen; None in one that does not."""
    a, b, _, _, d, e, _, _, g, h, *_ = modelview
    if any(_row(projection, 12, axis) for axis in ((a, d, g), (b, e, h))):
        return None
    return _at(modelview, projection, screen, 0.0, 0.0)


def _at(modelview: Affine, projection: Mat4, screen: Screen, x: float, y: float) -> float:
    a, b, _, tx, d, e, _, ty, g, h, _, tz = modelview
    place = (a * x + b * y + tx, d * x + e * y + ty, g * x + h * y + tz)
    depth = _row(projection, 12, place) + projection[15]
    if depth <= 0:
        return 1.0
    lengths = [_speed(projection, screen, place, depth, axis) for axis in ((a, d, g), (b, e, h))]
    return max(lengths)


def _speed(projection: Mat4, screen: Screen, place: Vector, depth: float, axis: Vector) -> float:
    """Return how far a point moves on the screen as it moves by one step along an axis.

    The derivative of the quotient clip / depth, across and down; clip space is 2 wide and high.
    """
    recession = _row(projection, 12, axis)
    steps = []
    for i, pixels in enumerate(screen):
        clip = _row(projection, 4 * i, place) + projection[4 * i + 3]
        moved = (_row(projection, 4 * i, axis) - clip / depth * recession) / depth
        steps.append(moved * pixels / 2)
    return hypot(*steps)


def _row(matrix: Mat4, first: int, v: Vector) -> float:
    return matrix[first] * v[0] + matrix[first + 1] * v[1] + matrix[first + 2] * v[2]
