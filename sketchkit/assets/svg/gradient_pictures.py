"""Gradients as pictures, to be laid over shapes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.svg.gradients import Gradient

SIDE = 256  # px of the picture, each way
Box = tuple[float, float, float, float]


def gradient_picture(gradient: Gradient, box: Box) -> NDArray[np.uint8]:
    """Return what a gradient shows within left, top, width, height of a drawing.

    Returns
    -------
    (256, 256, 4) uint8, straight RGBA
    """
    left, top, width, height = box
    middles = (np.arange(SIDE) + 0.5) / SIDE
    x, y = np.meshgrid(left + middles * width, top + middles * height)
    if gradient.is_radial:
        centre_x, centre_y, radius = gradient.geometry
        places = np.hypot(x - centre_x, y - centre_y) / (abs(radius) or 1)
    else:
        x1, y1, x2, y2 = gradient.geometry
        along_x, along_y = x2 - x1, y2 - y1
        square = along_x**2 + along_y**2
        places = ((x - x1) * along_x + (y - y1) * along_y) / (square or 1)
    stops = sorted(gradient.stops) or [(0.0, 0)]
    offsets = [offset for offset, _ in stops]
    channels = [
        np.interp(places, offsets, [color >> shift & 255 for _, color in stops])
        for shift in (16, 8, 0, 24)
    ]
    return np.rint(np.stack(channels, axis=2)).astype(np.uint8)
