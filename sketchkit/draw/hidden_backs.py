"""Which solids hide their own back faces.

A closed opaque solid that lies wholly before the camera shows its front alone: leaving its back out
changes no pixel, and half of the triangles need not be drawn.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.pipeline import Blend
from sketchkit.draw.rows import Rows
from sketchkit.draw.stage import Stage

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]

OPAQUE = 0xFF


def hides_back(rows: Rows, at: I64, extents: F32) -> Bool:
    """Return which of the solids of the rows `at` hide their back faces, (n,).

    `extents` is (n, 3): how far each reaches from its origin along its axes.
    """
    states = rows.states[at]
    used = np.unique(states)
    is_solid = np.zeros(len(rows.stages), np.bool_)
    is_solid[used] = [_is_solid(rows.stages[state]) for state in used]
    fits: Bool = is_solid[states] & (rows.fills[at] >> 24 == OPAQUE) & (extents > 0).all(axis=1)
    if not fits.any():
        return fits
    linear = rows.matrices.reshape(-1, 3, 4)[:, :, :3]
    is_upright = np.linalg.det(linear[used]) > 0  # a mirror turns the faces round
    mirrored = np.zeros(len(rows.stages), np.bool_)
    mirrored[used] = ~is_upright
    stretch = np.sqrt((linear**2).sum(axis=(1, 2)))[states]
    nearest = rows.matrices[states, 11] + stretch * np.sqrt((extents**2).sum(axis=1))
    hidden: Bool = fits & ~mirrored[states] & (_depth_inside(rows, states, nearest) > 0)
    return hidden


def _is_solid(stage: Stage) -> bool:
    """Return whether a stage draws nearer things over farther ones, whatever their order."""
    return stage.depth_test and stage.depth_write and stage.blend is Blend.BLEND


def _depth_inside(rows: Rows, states: I64, z: F32) -> F32:
    """Return how far eye-space depths are behind the near plane, (n,): below 0 is cut off."""
    planes = np.array([_near_plane(stage) for stage in rows.stages], np.float32)[states]
    inside: F32 = planes[:, 0] * z + planes[:, 1]
    return inside


def _near_plane(stage: Stage) -> tuple[float, float]:
    """Return a and b: a * z + b is 0 on the near plane, and above 0 behind it."""
    p = stage.projection
    return p[10] + p[14], p[11] + p[15]
