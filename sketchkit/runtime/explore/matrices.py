"""Matrices in words: what a student has written, as far as the numbers still show it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Affine, inverse, multiply

F64 = NDArray[np.float64]
TOLERANCE = 1e-4


def rows_of(matrix: Affine) -> list[list[float]]:
    """Return the four rows of a matrix."""
    return [list(map(float, matrix[row : row + 4])) for row in (0, 4, 8)] + [[0.0, 0.0, 0.0, 1.0]]


def in_words(matrix: Affine) -> str:
    """Return what a matrix does to what is drawn: `moved by (10, 20), turned by 30 degrees`.

    Parameters
    ----------
    matrix : Affine
        Without the camera.
    """
    m = np.array(matrix, np.float64).reshape(3, 4)
    if not np.isfinite(m).all():
        return "holds numbers that are none (NaN or infinite)"
    parts = [*_moved(m[:, 3]), *_linear(m[:, :3])]
    return ", ".join(parts) or "nothing: as at the beginning of draw()"


def without_camera(matrix: Affine, camera: Affine) -> Affine:
    """Return what the sketch has done to the matrix after the camera was placed."""
    seen = inverse(camera)
    return matrix if seen is None else multiply(seen, matrix)


def _moved(by: F64) -> list[str]:
    if np.abs(by).max() < TOLERANCE * 10:
        return []
    places = by if abs(by[2]) >= TOLERANCE * 10 else by[:2]
    return [f"moved by ({', '.join(number(value) for value in places)})"]


def _linear(linear: F64) -> list[str]:
    """Return turning and scaling in words."""
    sizes = np.linalg.norm(linear, axis=0)
    if (sizes < 1e-9).any():
        return ["squeezed to nothing (a scale of 0)"]
    if np.linalg.det(linear) < 0:  # a mirror: take it out of the axis that is least turned
        axis = int(np.argmin(np.diag(linear) / sizes))
        sizes[axis] = -sizes[axis]
    turned = linear / sizes
    if np.abs(turned.T @ turned - np.eye(3)).max() > TOLERANCE * 10:
        return ["sheared, or turned after an uneven scale"]
    return [*_turned(turned), *_scaled(sizes)]


def _turned(rotation: F64) -> list[str]:
    angle = math.acos(min(max((np.trace(rotation) - 1) / 2, -1.0), 1.0))
    if angle < TOLERANCE:
        return []
    if math.pi - angle < 1e-3:
        axis = np.sqrt(np.maximum((np.diag(rotation) + 1) / 2, 0))
        if (largest := int(np.argmax(axis))) or axis[0]:
            axis = rotation[:, largest] + np.eye(3)[:, largest]
            axis /= np.linalg.norm(axis)
    else:
        skew = np.array(
            [
                rotation[2, 1] - rotation[1, 2],
                rotation[0, 2] - rotation[2, 0],
                rotation[1, 0] - rotation[0, 1],
            ]
        )
        axis = skew / (2 * math.sin(angle))
    degrees = math.degrees(angle)
    for name, unit in zip("xyz", np.eye(3), strict=True):
        along = float(axis @ unit)
        if abs(along) > 1 - TOLERANCE:
            turn = f"turned by {number(math.copysign(degrees, along))} degrees"
            return [turn + ("" if name == "z" else f" about {name}")]
    about = ", ".join(number(value) for value in axis)
    return [f"turned by {number(degrees)} degrees about ({about})"]


def _scaled(sizes: F64) -> list[str]:
    if np.abs(sizes - 1).max() < TOLERANCE:
        return []
    if np.abs(sizes - sizes[0]).max() < TOLERANCE * abs(sizes[0]):
        return [f"scaled by {number(sizes[0])}"]
    flat = sizes[:2] if abs(sizes[2] - 1) < TOLERANCE else sizes
    return [f"scaled by ({', '.join(number(value) for value in flat)})"]


def number(value: float) -> str:
    """Return a number with at most two decimals."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
