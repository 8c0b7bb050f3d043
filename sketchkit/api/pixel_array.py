"""`pixels`: an image's bytes as the list of colours that sketches know."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from sketchkit.core.color import to_packed
from sketchkit.core.errors import SketchError, shown
from sketchkit.draw.resources import Pixels
from sketchkit.imaging.packing import U8, U32, to_argb, to_rgba


class PixelArray:
    """The colours of an image, row by row from the top left: `pixels[y * width + x]`.

    It is a window on the image, not a copy. Colours are ints, 0xAARRGGBB; what Java would have
    written (negative ints) and strings are understood too.

    Parameters
    ----------
    image : Pixels
        Its data is contiguous, and stays the same array.
    """

    __slots__ = ("_image", "_words")

    def __init__(self, image: Pixels) -> None:
        self.show(image)

    def show(self, image: Pixels) -> None:
        """Be the window on an image."""
        self._image = image
        # RGBA as it lies in memory is 0xAABBGGRR to the (little-endian) machines that we run on.
        self._words = memoryview(image.data.data).cast("B").cast("I")

    def give_up(self) -> None:
        """Show nothing any more, until there is an image again."""
        self._words = memoryview(bytearray())

    def __len__(self) -> int:
        return len(self._words)

    @overload
    def __getitem__(self, place: int) -> int: ...
    @overload
    def __getitem__(self, place: slice) -> list[int]: ...
    def __getitem__(self, place: int | slice) -> int | list[int]:
        try:
            word: int = self._words[place]  # type: ignore[assignment] # slices: TypeError below
            return word & 0xFF00FF00 | (word & 255) << 16 | word >> 16 & 255
        except (TypeError, IndexError):
            if isinstance(place, slice):
                colors: list[int] = to_argb(self._rows()[place]).tolist()
                return colors
        return self[self._index(place)]

    @overload
    def __setitem__(self, place: int, color: int | str) -> None: ...
    @overload
    def __setitem__(self, place: slice, color: Iterable[int | str] | int | str) -> None: ...
    def __setitem__(self, place: Any, color: Any) -> None:  # Any: see the overloads
        self._image.version += 1
        try:
            self._words[place] = color & 0xFF00FF00 | (color & 255) << 16 | color >> 16 & 255
        except (TypeError, IndexError, ValueError):
            if isinstance(place, slice):
                self._set_many(place, color)
            else:
                self._rows()[self._index(place)] = to_rgba(_one(color))

    def __iter__(self) -> Iterator[int]:
        return iter(self[:])

    def __array__(
        self, dtype: DTypeLike = np.uint32, copy: bool | None = None
    ) -> NDArray[np.generic]:
        return to_argb(self._rows()).astype(dtype or np.uint32)

    def __repr__(self) -> str:
        return f"<pixels: {len(self)} colours>"

    def _rows(self) -> U8:
        """Return the bytes, one row for each pixel."""
        return self._image.data.reshape(-1, 4)

    def _index(self, place: object) -> int:
        """Return a place counted from 0; a float is cut off, as everywhere in a sketch."""
        try:
            index = int(place)  # type: ignore[call-overload] # what is no number is told so
        except (TypeError, ValueError):
            raise SketchError(
                "A place in pixels is a whole number.", got=f"pixels[{shown(place)}]"
            ) from None
        count = len(self)
        if count == 0:
            raise SketchError(
                "There are no pixels yet.",
                got=f"pixels[{shown(place)}]",
                hint="Write loadPixels() first.",
            )
        if -count <= index < count:
            return int(index % count)
        raise SketchError(
            f"There are {count} pixels, from pixels[0] to pixels[{count - 1}].",
            got=f"pixels[{shown(place)}]",
            hint="The pixel at x, y is pixels[y * width + x].",
        )

    def _set_many(self, places: slice, colors: Iterable[int | str] | int | str) -> None:
        rows = self._rows()[places]
        if isinstance(colors, int | str):
            rows[:] = to_rgba(_one(colors))
            return
        if isinstance(colors, np.ndarray):
            packed = (colors.astype(np.int64) & 0xFFFFFFFF).astype(np.uint32)
        else:
            packed = np.array([to_packed(color, "pixels") for color in colors], np.uint32)
        if len(packed) != len(rows):
            raise SketchError(
                "A slice of pixels takes as many colours as it has.",
                got=f"{len(packed)} colours for {len(rows)} pixels",
            )
        rows[:] = to_rgba(packed)


def _one(color: object) -> U32:
    """Return a colour that a sketch holds as an array without dimensions."""
    return np.array(to_packed(color, "pixels"), np.uint32)
