"""The 255 colours of a GIF, chosen once for the whole film, and which of them a pixel gets.

If all frames have no more colours, each stays exact. Else a pixel gets the nearest one, or, by a
fixed pattern (Bayer's) and in the share that gives its own colour on average, the one beyond: so
areas that do not change do not flicker, as they do when errors are spread to neighbours, and a
colour that is in the palette is never dotted.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.movies.encoder import U8

COLORS = 255  # 256 without the one that stands for "as before"
BITS = 6  # of each channel tell colours apart when they are counted
CELLS = 1 << 3 * BITS
SAMPLE = 60_000  # entries from which the palette is chosen
ROUNDS = 6  # of k-means
DECIDING = 16_384  # cells, the fullest ones: more would take seconds and change little
FLAT = 1 / 500  # of all pixels in one cell: a flat area, whose colour is kept exact
AT_ONCE = 8192  # colours compared with the palette: 25 MB

Indexer = Callable[[U8], U8]
Floats = NDArray[np.float32]


class ColorCount:
    """Counts the colours of frames."""

    def __init__(self) -> None:
        self._exact: set[tuple[int, ...]] | None = set()  # None: they are too many
        self._counts = np.zeros(CELLS)
        self._sums = np.zeros((3, CELLS))

    def add(self, pixels: U8) -> None:
        """Count the pixels of a frame, (h, w, 3)."""
        from PIL import Image  # 40 ms to import

        if self._exact is not None:
            few = Image.fromarray(pixels).getcolors(COLORS)
            self._exact |= {color for _, color in few or () if isinstance(color, tuple)}
            if few is None or len(self._exact) > COLORS:
                self._exact = None
        cells = _cells(pixels).ravel()
        self._counts += np.bincount(cells, minlength=CELLS)
        for channel, sums in enumerate(self._sums):
            sums += np.bincount(cells, pixels[..., channel].ravel(), CELLS)

    def palette(self) -> tuple[U8, Indexer]:
        """Return the colours, (255, 3), and what gives each pixel of a frame its index."""
        if self._exact is not None:
            colors = np.array(sorted(self._exact), np.uint8).reshape(-1, 3)
            return _filled(colors), _exact_indexer(colors)
        used = np.flatnonzero(self._counts)
        counts = self._counts[used]
        means = (self._sums[:, used] / counts).T
        colors = _with_flat_areas(_chosen(means, counts), means, counts)
        return colors, _dithering_indexer(colors, used, means.astype(np.float32))


def _cells(pixels: U8) -> NDArray[np.int32]:
    """Return to which cell of the colour cube each pixel belongs."""
    high = (pixels >> (8 - BITS)).astype(np.int32)
    return high[..., 0] << 2 * BITS | high[..., 1] << BITS | high[..., 2]


def _filled(colors: U8) -> U8:
    return np.concatenate([colors, np.zeros((COLORS - len(colors), 3), np.uint8)])


def _chosen(means: NDArray[np.float64], counts: NDArray[np.float64]) -> U8:
    """Return a palette. Small areas count more than by their pixels: they are seen as well.

    Pillow's octree begins, and rounds of k-means let each colour move into the middle of its own.
    """
    from PIL import Image  # 40 ms to import

    weights = np.sqrt(counts)
    repeats = np.maximum(weights * (SAMPLE / weights.sum()), 1).astype(int)
    sample = Image.fromarray(np.repeat(np.round(means).astype(np.uint8), repeats, axis=0)[None])
    start = sample.quantize(COLORS, Image.Quantize.FASTOCTREE).getpalette() or []
    heavy = np.argsort(-weights)[:DECIDING]
    means, weights = means[heavy], weights[heavy]
    colors = _filled(np.array(start, np.uint8).reshape(-1, 3)[:COLORS]).astype(np.float64)
    for _ in range(ROUNDS):
        nearest = _nearest(colors.astype(np.float32), means.astype(np.float32))
        totals = np.bincount(nearest, weights, COLORS)
        sums = [np.bincount(nearest, weights * channel, COLORS) for channel in means.T]
        errors = weights * ((means - colors[nearest]) ** 2).sum(axis=1)
        colors = (np.array(sums) / np.maximum(totals, 1e-9)).T
        unused = np.flatnonzero(totals == 0)[: len(means)]
        colors[unused] = means[np.argsort(-errors)[: len(unused)]]
    return np.round(colors).astype(np.uint8)


def _with_flat_areas(colors: U8, means: NDArray[np.float64], counts: NDArray[np.float64]) -> U8:
    """Return the palette with the exact colours of large flat areas in it."""
    flat = np.flatnonzero(counts > counts.sum() * FLAT)
    free = np.ones(COLORS, bool)
    for color in np.round(means[flat[np.argsort(-counts[flat])]]):
        distances = ((colors - color) ** 2).sum(axis=1)
        nearest = int(np.argmin(np.where(free, distances, np.inf)))
        colors[nearest], free[nearest] = color, False
    return colors


def _exact_indexer(colors: U8) -> Indexer:
    known = _packed(colors)  # they rise, as the colours were sorted

    def index(pixels: U8) -> U8:
        return np.searchsorted(known, _packed(pixels)).astype(np.uint8)

    return index


def _packed(pixels: U8) -> NDArray[np.int32]:
    wide = pixels.astype(np.int32)
    return wide[..., 0] << 16 | wide[..., 1] << 8 | wide[..., 2]


def _dithering_indexer(colors: U8, used: NDArray[np.intp], means: Floats) -> Indexer:
    """Return what maps pixels by a table: for each cell two colours and the share of the second."""
    palette = colors.astype(np.float32)
    near = _nearest(palette, means)
    beyond = _nearest(palette, np.clip(2 * means - palette[near], 0, 255))
    way, whole = means - palette[near], palette[beyond] - palette[near]
    length = (whole**2).sum(axis=1)
    share = np.where(length > 0, (way * whole).sum(axis=1) / np.maximum(length, 1), 0)
    first, second = np.zeros(CELLS, np.uint8), np.zeros(CELLS, np.uint8)
    shares = np.zeros(CELLS, np.float32)
    first[used], second[used], shares[used] = near, beyond, share

    def index(pixels: U8) -> U8:
        cells = _cells(pixels)
        height, width = cells.shape
        pattern = np.tile(BAYER, (height // 8 + 1, width // 8 + 1))[:height, :width]
        return np.where(shares[cells] > pattern, second[cells], first[cells])

    return index


def _nearest(palette: Floats, colors: Floats) -> NDArray[np.intp]:
    """Return the index of the palette's nearest colour for each of some."""
    lengths = (palette**2).sum(axis=1)
    parts = [
        np.argmin(lengths - 2 * (colors[start : start + AT_ONCE] @ palette.T), axis=1)
        for start in range(0, len(colors), AT_ONCE)
    ]
    return np.concatenate(parts)


def _bayer(size: int) -> NDArray[np.int64]:
    """Return 0 to size squared - 1, spread as evenly as can be; `size` is a power of 2."""
    if size == 1:
        return np.zeros((1, 1), np.int64)
    coarse = _bayer(size // 2)
    return np.tile(4 * coarse, (2, 2)) + np.kron([[0, 2], [3, 1]], np.ones_like(coarse))


BAYER = ((_bayer(8) + 0.5) / 64).astype(np.float32)
