"""From eye space to clip space, as a shader does it: in float32, a column after the other."""

from __future__ import annotations

import numpy as np

from sketchkit.core.matrix import Mat4
from sketchkit.draw.vertex import F32


def project(positions: F32, projection: Mat4) -> F32:
    """Return positions, (n, 3), in clip space, (n, 4)."""
    matrix = np.array(projection, np.float32).reshape(4, 4)
    x, y, z = positions.T
    clip = np.empty((len(positions), 4), np.float32)
    for row, column in zip(matrix, clip.T, strict=True):
        column[:] = row[0] * x + row[1] * y + row[2] * z + row[3]
    return clip
