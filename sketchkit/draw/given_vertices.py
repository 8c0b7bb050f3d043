"""The vertices of a shape as the sketch gave them, with the control points of its curves.

The recorder has steps along each curve instead, and with them what the curve was made from.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.draw.recorder import CurveRun, ShapeRun
from sketchkit.geometry.curves import (
    bezier_points,
    quadratic_to_cubic,
    spline_points,
    spline_to_bezier,
)

F32 = NDArray[np.float32]
F64 = NDArray[np.float64]


class Stretch(NamedTuple):
    """What one call added to a shape; a spline's first corner stands for three calls.

    Attributes
    ----------
    code : int
        VERTEX, BEZIER_VERTEX, QUADRATIC_VERTEX or CURVE_VERTEX.
    places : (k, 3) float64
        The vertices that were given.
    corner, count : int
        The corners that they made, counted from the shape's first.
    curve : int or None
        The entry of the shape's curves.
    """

    code: int
    places: F64
    corner: int
    count: int  # type: ignore[assignment] # hides tuple.count, which nobody asks of a stretch
    curve: int | None = None


def stretches(run: ShapeRun, places: F32) -> Iterator[Stretch]:
    """Yield what a shape was made of; `places` are those of its corners, (n, 3)."""
    curves = {curve.first: index for index, curve in enumerate(run.curves)}
    corner = 0
    while corner < run.count:
        index, following = curves.get(corner), curves.get(corner + 1)
        if index is not None:
            made = _of_curve(run.curves[index], index)
        elif following is not None and run.curves[following].tightness is not None:
            made = Stretch(c.CURVE_VERTEX, run.curves[following].control[:3], corner, 1)
        else:
            made = Stretch(c.VERTEX, places[corner : corner + 1].astype(np.float64), corner, 1)
        yield made
        corner += made.count


def _of_curve(curve: CurveRun, index: int) -> Stretch:
    if curve.tightness is not None:
        code, places = c.CURVE_VERTEX, curve.control[3:]
    elif _is_quadratic(curve):
        code, places = c.QUADRATIC_VERTEX, curve.control[1:]
    else:
        code, places = c.BEZIER_VERTEX, curve.control[1:]
    return Stretch(code, places, curve.first, curve.count, index)


def vertex_codes(run: ShapeRun, places: F32) -> list[int]:
    """Return how the given vertices are to be read: BREAK begins another contour."""
    codes, breaks = [], set(run.contours)
    for stretch in stretches(run, places):
        if stretch.corner in breaks:
            codes.append(c.BREAK)
        is_spline = stretch.code == c.CURVE_VERTEX
        codes += [stretch.code] * (len(stretch.places) if is_spline else 1)
    return codes


def given_places(run: ShapeRun, places: F32) -> F64:
    """Return the vertices as they were given, (g, 3)."""
    return np.vstack([np.zeros((0, 3)), *(part.places for part in stretches(run, places))])


def corner_of(run: ShapeRun, places: F32, given: int) -> int:
    """Return the corner that a given vertex has its colour and all else from, or gives it to.

    For a control point it is where the curve ends.
    """
    passed = 0
    for stretch in stretches(run, places):
        passed += len(stretch.places)
        if given < passed:
            return stretch.corner + stretch.count - 1
    raise IndexError(given)


def with_given(run: ShapeRun, places: F32, given: F64) -> tuple[ShapeRun, F32]:
    """Return a shape whose vertices lie elsewhere, and the places of its corners.

    `given` is (g, 3), as from `given_places`.
    """
    moved, curves, first = places.copy(), list(run.curves), 0
    for stretch in stretches(run, places):
        last = first + len(stretch.places)
        if stretch.curve is None:
            moved[stretch.corner] = given[first + (stretch.code == c.CURVE_VERTEX)]
        else:
            is_spline = stretch.code == c.CURVE_VERTEX
            start = given[first - 3 : first] if is_spline else moved[stretch.corner - 1][None]
            curve = curves[stretch.curve]
            curve = curve._replace(control=np.vstack([start, given[first:last]]))
            curves[stretch.curve] = curve
            moved[stretch.corner : stretch.corner + stretch.count] = steps(curve)
        first = last
    return run._replace(curves=tuple(curves)), moved


def steps(curve: CurveRun) -> F64:
    """Return the corners along a curve, without its start, (count, 3)."""
    if curve.tightness is not None:
        return spline_points(curve.control, curve.count, curve.tightness)
    return bezier_points(as_bezier(curve), curve.count)


def as_bezier(curve: CurveRun) -> F64:
    """Return the cubic Bezier curve that a curve equals, (4, 3)."""
    if curve.tightness is not None:
        return spline_to_bezier(curve.control, curve.tightness)
    return quadratic_to_cubic(*curve.control) if _is_quadratic(curve) else curve.control


def _is_quadratic(curve: CurveRun) -> bool:
    return len(curve.control) == 3
