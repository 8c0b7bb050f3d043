"""GlyphAtlas: the shapes of letters side by side in one image, so that a page is one draw."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketchkit.draw.resources import Pixels
from sketchkit.draw.vertex import U8

WIDTH = 1024
FIRST_HEIGHT = 128
MOST_HEIGHT = 4096  # 16 MB; when it is full, an empty one takes its place
GAP = 1  # clear pixels on each side, for letters between pixels take some of what is beside them
MOST_COLUMNS = WIDTH - 2 * GAP  # of one mask

Key = tuple[str, int, str]  # file, size, character


class Place(NamedTuple):
    """Where a mask lies in the atlas."""

    column: int
    row: int


class GlyphAtlas:
    """White images whose alpha is how much of each pixel a letter covers.

    Masks are put in rows from the top, each row as high as its highest mask. A fuller atlas is a
    new image twice as high, in which all keep their places; what was recorded with the old image
    goes on using that.

    Attributes
    ----------
    pixels : Pixels
        The newest image.
    """

    def __init__(self) -> None:
        self._begin()

    def _begin(self) -> None:
        self.pixels = _empty(FIRST_HEIGHT)
        self._places: dict[Key, Place] = {}
        self._next = Place(0, 0)
        self._row_height = 0

    def place(self, key: Key, mask: U8) -> Place:
        """Return where a mask lies, (h, w) uint8; it is put in if it is not there yet."""
        return self._places.get(key) or self._add(key, mask)

    def _add(self, key: Key, mask: U8) -> Place:
        height, width = (size + 2 * GAP for size in mask.shape)
        self._make_room(width, height)
        column, row = self._next.column + GAP, self._next.row + GAP
        self.pixels.data[row : row + mask.shape[0], column : column + mask.shape[1], 3] = mask
        self.pixels.version += 1
        self._next = Place(self._next.column + width, self._next.row)
        self._row_height = max(self._row_height, height)
        self._places[key] = Place(column, row)
        return self._places[key]

    def _make_room(self, width: int, height: int) -> None:
        """Have the next place leave so much room to its right and below."""
        if self._next.column + width > WIDTH:
            self._next = Place(0, self._next.row + self._row_height)
            self._row_height = 0
        if self._next.row + height > MOST_HEIGHT:
            self._begin()
        while self._next.row + height > self.pixels.height:
            larger = _empty(2 * self.pixels.height)
            larger.data[: self.pixels.height] = self.pixels.data
            self.pixels = larger


def _empty(height: int) -> Pixels:
    data = np.full((height, WIDTH, 4), 255, np.uint8)
    data[..., 3] = 0
    return Pixels(data, mipmaps=False)
