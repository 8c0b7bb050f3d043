"""Pixels one by one, or all of them: what an image and a canvas have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

from sketchkit.api.pixel_array import PixelArray
from sketchkit.core import constants as c
from sketchkit.core.color import to_packed
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.draw.resources import Pixels
from sketchkit.draw.vertex import U8
from sketchkit.imaging.blits import Region, part, paste

if TYPE_CHECKING:
    from sketchkit.api.pimage import PImage

GET_USAGE = "x, y | x, y, width, height"


class PixelParts:
    """What the functions of pixels need of the image or the canvas that has them.

    Attributes
    ----------
    format : RGB, ARGB or ALPHA
        RGB has no alpha: it counts as 255. ALPHA is white, its lowest byte is the alpha.
    _own : Pixels
        The pixels, each as `pixels` shows it. Those of a canvas are out of date once something
        was drawn: `_refresh` them first.
    _pixels : PixelArray
        A window on them.
    """

    format: int
    _own: Pixels
    _pixels: PixelArray

    def _refresh(self) -> None:
        """Bring the pixels up to date, before they are read or some of them are changed."""
        raise NotImplementedError

    def _touch(self) -> None:
        """Have a change of the pixels show."""
        raise NotImplementedError

    def _image_of(self, data: U8, image_format: int) -> PImage:
        """Return an image of pixels, (h, w, 4), which become its own."""
        raise NotImplementedError


class PixelAccess(PixelParts):
    """Reading and setting pixels."""

    @overload
    def get(self) -> PImage: ...
    @overload
    def get(self, x: float, y: float, /) -> int: ...
    @overload
    def get(self, x: float, y: float, w: float, h: float, /) -> PImage: ...
    def get(self, *place: float) -> int | PImage:
        """Return the colour of one pixel, or a copy of a part, or of the whole picture.

        Parameters
        ----------
        *place : 2 or 4 int, pixels
            x and y; or x, y, width and height of a part. Without numbers: all of it.

        Returns
        -------
        int or PImage
            A colour, or an image. Outside of the picture all is transparent black.

        Raises
        ------
        SketchError
            If there are not 0, 2 or 4 numbers.

        See Also
        --------
        set, pixels, copy

        Notes
        -----
        Of a canvas it shows what was drawn so far; of one with `smooth()`, each pixel's mean. Many
        calls in a row cost no more than one that draws. Source: Processing's reference, get().

        Examples
        --------
        >>> circle(50, 50, 60)
        >>> corner = get(10, 10, 40, 40)
        >>> image(corner, 60, 60)
        >>> fill(get(50, 50))
        """
        if len(place) == 2:
            x, y = whole("get", place, GET_USAGE)
            height, width, _ = self._own.data.shape
            if 0 <= x < width and 0 <= y < height:
                return self._shown(self._pixel(x, y))
            return 0
        self._refresh()
        if not place:
            return self._image_of(self._own.data.copy(), self.format)
        numbers = whole("get", place, GET_USAGE)
        if len(numbers) == 4:
            return self._part(Region(*numbers))
        raise wrong_numbers("get", place, GET_USAGE, (0, 2, 4))

    def _pixel(self, x: int, y: int) -> int:
        """Return one pixel as it is stored."""
        self._refresh()
        color: int = self._pixels[y * self._own.width + x]
        return color

    def _part(self, region: Region) -> PImage:
        """Return a copy of a part; what is outside is transparent."""
        x, y, width, height = region
        if width <= 0 or height <= 0:
            raise SketchError(
                "get() takes a width and a height above 0.",
                got=f"get({shown(x)}, {shown(y)}, {shown(width)}, {shown(height)})",
            )
        is_cropped = x < 0 or y < 0 or x + width > self._own.width or y + height > self._own.height
        image_format = c.ARGB if is_cropped and self.format == c.RGB else self.format
        return self._image_of(part(self._own.data, region), image_format)

    def set(self, x: float, y: float, value: int | str | PImage) -> None:
        """Set the colour of one pixel, or copy an image to a place.

        Parameters
        ----------
        x, y : int, pixels
            The pixel, or where the image's top left corner comes. Outside nothing is changed.
        value : color or PImage
            An image replaces what is there in another image, alpha included. On a canvas it is
            drawn: through transparent pixels the canvas stays seen.

        Raises
        ------
        SketchError
            If x or y is no number, or the value is neither a colour nor an image.

        See Also
        --------
        get, pixels, copy

        Notes
        -----
        A single number is a packed colour here, not a gray: write `color(255)`. The matrix does not
        count. Source: Processing's reference, set().

        Examples
        --------
        >>> for i in range(60):
        ...     set(20 + i, 50 + i % 10, color(255, 0, 0))
        """
        try:
            column, row = int(x + 0), int(y + 0)
        except (TypeError, ValueError):
            raise wrong_numbers("set", (x, y, value), "x, y, color") from None
        self._refresh()
        if isinstance(value, PixelParts):
            value._refresh()
            self._paste(value, column, row)
            return
        packed = to_packed(value, "set")
        height, width, _ = self._own.data.shape
        if 0 <= column < width and 0 <= row < height:
            self._pixels[row * width + column] = self._stored(packed)
            self._touch()

    def _paste(self, source: PixelParts, x: int, y: int) -> None:
        """Copy other pixels to a place."""
        paste(source._own.data, self._own.data, x, y)
        self._touch()

    def _shown(self, color: int) -> int:
        """Return the colour that a pixel stands for."""
        if self.format == c.RGB:
            return color | 0xFF000000
        return color if self.format == c.ARGB else (color & 255) << 24 | 0xFFFFFF

    def _stored(self, color: int) -> int:
        """Return what becomes the pixel of a colour."""
        if self.format == c.RGB:
            return color | 0xFF000000
        return color if self.format == c.ARGB else color & 255

    def loadPixels(self) -> None:
        """Read what was drawn into `pixels`; those of an image are always ready.

        See Also
        --------
        updatePixels, pixels, get

        Notes
        -----
        Source: Processing's reference, loadPixels().

        Examples
        --------
        >>> circle(50, 50, 60)
        >>> loadPixels()
        >>> for i in range(0, len(pixels), 3):
        ...     pixels[i] = color(0, 90, 102)
        >>> updatePixels()
        """
        self._refresh()

    def updatePixels(self, *region: int) -> None:
        """Have changes of `pixels` and `np_pixels` show.

        Parameters
        ----------
        *region : 4 int, optional
            The part that was changed: x, y, width, height. All of it is taken over anyhow.

        See Also
        --------
        loadPixels, pixels

        Notes
        -----
        Those of an image show where it is drawn next. Source: Processing's reference,
        updatePixels().

        Examples
        --------
        >>> loadPixels()
        >>> for x in range(width):
        ...     pixels[50 * width + x] = color(255, 0, 0)
        >>> updatePixels()
        """
        if len(region) not in (0, 4):
            raise wrong_numbers("updatePixels", region, "x, y, width, height", (0, 4))
        self._touch()


def whole(name: str, numbers: tuple[float, ...], usage: str) -> list[int]:
    """Return numbers cut off to whole ones."""
    try:
        return [int(number + 0) for number in numbers]
    except (TypeError, ValueError):
        raise wrong_numbers(name, numbers, usage) from None
