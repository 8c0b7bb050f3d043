"""Outlines of letters as rings of points: for text that is drawn as shapes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.fonts.outlines import letter_outline

F64 = NDArray[np.float64]

TAKES = {"M": 1, "L": 1, "C": 3, "Z": 0}  # points that a step takes


@lru_cache(maxsize=4096)
def rings(path: str, character: str, parts: tuple[float, ...]) -> tuple[F64, ...]:
    """Return a letter's outline, for a size of 1, as closed rings of points, (n, 2) each.

    `parts` says where each curve has points: 0 is its beginning, 1 its end.
    """
    steps, points = letter_outline(path, character)
    found: list[list[F64]] = []
    at = 0
    last = np.zeros(2)
    for step in steps:
        given = points[at : at + TAKES[step]]
        at += TAKES[step]
        if step == "M":
            found.append([given])
        elif step == "L":
            found[-1].append(given)
        elif step == "C":
            found[-1].append(_on_curve(last, given, np.array(parts)[:, None]))
        last = given[-1] if len(given) else last
    return tuple(_open(np.concatenate(pieces)) for pieces in found)


def whole_parts(count: int) -> tuple[float, ...]:
    """Return the ends of so many equal parts."""
    return tuple((i + 1) / count for i in range(count))


def spaced(ring: F64, spacing: float) -> F64:
    """Return points along a closed ring of points, equally far from one another, (n, 2).

    They are as far apart as comes out even, `spacing` being what is wished for.
    """
    closed = np.vstack([ring, ring[:1]])
    so_far = np.concatenate([[0.0], np.hypot(*np.diff(closed, axis=0).T).cumsum()])
    count = max(1, round(so_far[-1] / spacing))
    places = np.arange(count) * (so_far[-1] / count)
    return np.stack([np.interp(places, so_far, column) for column in closed.T], axis=1)


def _open(ring: F64) -> F64:
    """Return a ring without its first point at its end."""
    return ring[:-1] if len(ring) > 1 and np.array_equal(ring[0], ring[-1]) else ring


def _on_curve(start: F64, controls: F64, t: F64) -> F64:
    """Return points of a cubic curve."""
    first, second, end = controls
    s = 1 - t
    points: F64 = s**3 * start + 3 * s * s * t * first + 3 * s * t * t * second + t**3 * end
    return points
