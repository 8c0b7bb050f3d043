"""Corners that tessellation adds: what they take from the corners around them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketchkit.geometry.polygons import Tessellation

F64 = NDArray[np.float64]
I64 = NDArray[np.int64]

CHANNEL_SHIFTS = np.array([24, 16, 8, 0])


class AddedCorners:
    """Continues columns of a polygon's corners for the corners that were added."""

    def __init__(self, found: Tessellation) -> None:
        self.sources = np.maximum(found.sources, 0).astype(np.int64)
        self.weights: F64 = np.where(found.sources >= 0, found.weights, 0.0)

    def nearest(self, count: int) -> I64:
        """Return for each of `count` corners itself, for each added one what it mostly consists of."""
        nearest = np.arange(count + len(self.sources))
        for i, heaviest in enumerate(self.weights.argmax(axis=1) if len(self.sources) else ()):
            nearest[count + i] = nearest[self.sources[i, heaviest]]
        return nearest

    def mix(self, column: NDArray[np.floating]) -> F64:
        """Return a column, (v, d), with the added corners."""
        values: F64 = np.concatenate([column, np.zeros((len(self.sources), column.shape[1]))])
        # One by one: an added corner may consist of others that were added before it.
        for i, (sources, weights) in enumerate(zip(self.sources, self.weights, strict=True)):
            values[len(column) + i] = weights @ values[sources]
        return values

    def mix_colors(self, colors: I64) -> I64:
        """Return packed colours, (v,), with those of the added corners."""
        if not len(self.sources):
            return colors
        channels = (colors[:, None] >> CHANNEL_SHIFTS) & 255
        mixed = self.mix(channels.astype(np.float64)).astype(np.int64)
        packed: I64 = (mixed << CHANNEL_SHIFTS).sum(axis=1)
        return packed
