"""Corners that tessellation adds: what they take from the corners around them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.geometry.polygons import Tessellation, interpolate

I64 = NDArray[np.int64]

CHANNEL_SHIFTS = np.array([24, 16, 8, 0])


def main_sources(found: Tessellation, count: int) -> I64:
    """Return for each of `count` corners itself, for each added one which gives most to it."""
    sources = np.arange(count + len(found.sources))
    for i in range(len(found.sources)):
        heaviest = found.sources[i, found.weights[i].argmax()]
        sources[count + i] = sources[heaviest]
    return sources


def mix_colors(found: Tessellation, colors: I64) -> I64:
    """Return packed colours, (v,), with those of the added corners."""
    if not len(found.sources):
        return colors
    channels = (colors[:, None] >> CHANNEL_SHIFTS) & 255
    mixed = interpolate(found, channels.astype(np.float64)).astype(np.int64)
    packed: I64 = (mixed << CHANNEL_SHIFTS).sum(axis=1)
    return packed
