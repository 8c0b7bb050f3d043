"""Heat maps: differences as colours, from black (equal) to a pale yellow (as different as can be).

Lightness grows evenly along the ramp, so that it can be read in print and by whoever sees fewer
colours.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]

RAMP = (  # the page's style has the same
    (0, 0, 4),
    (59, 15, 112),
    (140, 41, 129),
    (222, 73, 104),
    (254, 159, 109),
    (252, 253, 191),
)


def heat_map(errors: F32) -> U8:
    """Return a picture, (h, w, 3), of differences, (h, w) of 0..1."""
    colors: U8 = _COLORS[(errors * 255 + 0.5).astype(np.uint8)]
    return colors


def flat_heat(height: int, width: int, error: float) -> U8:
    """Return the heat map of one difference everywhere."""
    return np.full((height, width, 3), _COLORS[round(error * 255)], np.uint8)


def _colors() -> U8:
    places = np.linspace(0, 255, len(RAMP))
    channels = [np.interp(np.arange(256), places, values) for values in np.transpose(RAMP)]
    colors: U8 = np.rint(np.transpose(channels)).astype(np.uint8)
    return colors


_COLORS = _colors()
