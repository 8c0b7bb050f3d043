"""GlyphAtlas: the shapes of letters side by side in images, so that a page is one draw."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.style import Typeface
from sketchkit.draw.resources import Pixels

U8 = NDArray[np.uint8]

# Text that is drawn smaller than it was made takes the means of neighbouring pixels, and so it
# shows where letters lie. These are Processing's rules, and its numbers.
SIDE = 1024  # of a full image
FIRST_HEIGHT = 256
GAP = 1  # clear pixels on each side of a letter

MOST_PIXELS = SIDE - 2 * GAP  # that a mask may be wide or high


class Letter(NamedTuple):
    """A character, drawn in a face at a size in pixels.

    `left` and `top` are where the top left corner of its mask is from the pen, y down.
    """

    face: Typeface
    size: float
    is_hinted: bool
    character: str
    left: int
    top: int


class Place(NamedTuple):
    """Where a mask lies: which image, and where in it."""

    image: int
    column: int
    row: int


@dataclass(eq=False)
class Sheet(Pixels):
    """An image of letters.

    Attributes
    ----------
    letters : dict of (column, row) to Letter
        Which letter lies where, for files that show its outline instead.
    """

    letters: dict[tuple[int, int], Letter] = field(default_factory=dict)


class GlyphAtlas:
    """Images in which letters are white, and alpha is how much of each pixel they cover.

    Masks are put side by side in the order of their use, in rows from the top, each row as high
    as its highest mask. When an image is full, one twice as high takes its place, in which all
    masks stay where they are; what was recorded with the old one goes on using that. When it is
    as high as wide, another one is begun.

    Parameters
    ----------
    height : int, pixels
        Of the highest letter, about.

    Attributes
    ----------
    growths : int
        How often an image was replaced: from then on its letters have other coordinates, 0..1.
    """

    def __init__(self, height: int = FIRST_HEIGHT) -> None:
        self.growths = 0
        self._first_height = max(height, FIRST_HEIGHT)
        self._images = [_empty(self._first_height)]
        self._places: dict[Letter, Place] = {}
        self._column = self._row = self._row_height = 0

    @property
    def image_count(self) -> int:
        """How many images there are."""
        return len(self._images)

    def place(self, letter: Letter, mask: U8) -> Place:
        """Return where a mask lies, (h, w) uint8; it is put in if it is not there yet."""
        return self._places.get(letter) or self._add(letter, mask)

    def image(self, number: int) -> Sheet:
        """Return an image as it is now."""
        return self._images[number]

    def _add(self, letter: Letter, mask: U8) -> Place:
        height, width = mask.shape
        self._make_room(width + 2 * GAP, height + 2 * GAP)
        place = Place(len(self._images) - 1, self._column + GAP, self._row + GAP)
        image = self._images[-1]
        image.data[self._row :, self._column :][: height + 2 * GAP, : width + 2 * GAP, :3] = 255
        image.data[place.row :, place.column :][:height, :width, 3] = mask
        image.version += 1
        image.letters[place.column, place.row] = letter
        self._column += width + 2 * GAP
        self._places[letter] = place
        return place

    def _make_room(self, width: int, height: int) -> None:
        """Have so much room to the right of and below the next place."""
        if self._column + width > SIDE:
            self._column = 0
            self._row += self._row_height  # the highest so far: later rows are not lower, either
        self._row_height = max(self._row_height, height)
        while self._row + self._row_height > self._images[-1].height:
            if self._images[-1].height >= SIDE:
                self._images.append(_empty(self._first_height))
                self._column = self._row = 0
                self._row_height = height
            else:
                self._grow()

    def _grow(self) -> None:
        old = self._images[-1]
        larger = _empty(2 * old.height)
        larger.data[: old.height] = old.data
        larger.letters = old.letters
        self._images[-1] = larger
        self.growths += 1


def _empty(height: int) -> Sheet:
    return Sheet(np.zeros((height, SIDE, 4), np.uint8))
