"""Bezier curves and Catmull-Rom splines: points along a segment, and the measures of one."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

F64 = NDArray[np.float64]

_BEZIER = np.array([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 3, 0, 0], [1, 0, 0, 0]], np.float64)


def _catmull_rom(tightness: float) -> F64:
    """Return the basis of the spline; 0 is Catmull-Rom, 1 straight lines."""
    s = tightness
    return np.array(
        [
            [(s - 1) / 2, (s + 3) / 2, (-3 - s) / 2, (1 - s) / 2],
            [1 - s, (-5 - s) / 2, s + 2, (s - 1) / 2],
            [(s - 1) / 2, 0, (1 - s) / 2, 0],
            [0, 1, 0, 0],
        ]
    )


@cache
def _weights(tightness: float | None, detail: int) -> F64:
    """Return what each of four points gives to the `detail` points after the start, (detail, 4)."""
    basis = _BEZIER if tightness is None else _catmull_rom(tightness)
    t = np.arange(1, detail + 1) / detail
    weights: F64 = np.stack([t**3, t**2, t, np.ones_like(t)], axis=1) @ basis
    return weights


def bezier_points(control: F64, detail: int) -> F64:
    """Return the points of a cubic Bezier curve after its start.

    Parameters
    ----------
    control : (4, d)
        Start, two control points, end.
    detail : int
        How many points, the end included.
    """
    points: F64 = _weights(None, detail) @ control
    return points


def spline_points(control: F64, detail: int, tightness: float) -> F64:
    """Return the points of a spline from the second control point (left out) to the third.

    Parameters
    ----------
    control : (4, d)
    detail : int
        How many points, the end included.
    tightness : float
        `curveTightness()`.
    """
    points: F64 = _weights(tightness, detail) @ control
    return points


def quadratic_to_cubic(start: F64, control: F64, end: F64) -> F64:
    """Return the four points of the cubic curve that equals a quadratic one, (4, d)."""
    return np.stack([start, start + (control - start) * 2 / 3, end + (control - end) * 2 / 3, end])


def spline_to_bezier(control: F64, tightness: float) -> F64:
    """Return the four points of the Bezier curve that equals a segment of a spline, (4, d)."""
    points = np.linalg.solve(_BEZIER, _catmull_rom(tightness) @ control)
    return points.astype(np.float64)


def bezier_point(a: float, b: float, c: float, d: float, t: float) -> float:
    """Return one coordinate of a cubic Bezier curve at `t`."""
    s = 1 - t
    return a * s * s * s + 3 * b * t * s * s + 3 * c * t * t * s + d * t * t * t


def bezier_tangent(a: float, b: float, c: float, d: float, t: float) -> float:
    """Return one coordinate of the derivative of a cubic Bezier curve at `t`."""
    return 3 * t * t * (-a + 3 * b - 3 * c + d) + 6 * t * (a - 2 * b + c) + 3 * (b - a)


def spline_point(points: tuple[float, float, float, float], t: float, tightness: float) -> float:
    """Return one coordinate of a spline at `t`, between its second and third point."""
    return float(np.array([t**3, t**2, t, 1.0]) @ _catmull_rom(tightness) @ np.array(points))


def spline_tangent(points: tuple[float, float, float, float], t: float, tightness: float) -> float:
    """Return one coordinate of the derivative of a spline at `t`."""
    return float(
        np.array([3 * t * t, 2 * t, 1.0, 0.0]) @ _catmull_rom(tightness) @ np.array(points)
    )
