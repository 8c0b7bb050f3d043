"""Regions of difference: pixels that differ and touch each other, corners too."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, label

Bools = NDArray[np.bool_]

TOUCHING = np.ones((3, 3), bool)  # a slanted line is one region


class Region(NamedTuple):
    """The largest region.

    Attributes
    ----------
    size : int
        Its pixels.
    box : left, top, width, height
    pixels : (height, width) bool
        Which of the box's pixels are in it.
    others : int
        How many more regions there are.
    """

    size: int
    box: tuple[int, int, int, int]
    pixels: Bools
    others: int


def largest_region(is_different: Bools) -> Region | None:
    """Return the largest connected region of an (h, w) map; None if nothing differs."""
    labels, count = label(is_different, TOUCHING)
    if not count:
        return None
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0  # what does not differ
    largest = int(sizes.argmax())
    rows, columns = find_objects(labels, max_label=largest)[largest - 1]
    return Region(
        size=int(sizes[largest]),
        box=(columns.start, rows.start, columns.stop - columns.start, rows.stop - rows.start),
        pixels=labels[rows, columns] == largest,
        others=int(count) - 1,
    )
