"""PImage: a picture in memory, loaded, made, or cut out of another."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import overload

import numpy as np

from sketchkit.api.pixel_array import PixelArray
from sketchkit.assets.output import picture_bytes, write_file
from sketchkit.assets.paths import sketch_folder
from sketchkit.assets.resizing import resized
from sketchkit.core import constants as c
from sketchkit.core.color import to_packed
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.draw.resources import Pixels
from sketchkit.draw.vertex import U8

FORMATS = {c.RGB: "RGB", c.ARGB: "ARGB", c.ALPHA: "ALPHA"}
GET_USAGE = "x, y | x, y, width, height"
BLANK = {c.RGB: (0, 0, 0, 255), c.ARGB: (0, 0, 0, 0), c.ALPHA: (255, 255, 255, 0)}  # RGBA
MOST_PIXELS = 1 << 28  # a GB; beyond it width and height are mistaken


class PImage:
    """A picture: `loadImage()` and `createImage()` make one.

    Parameters
    ----------
    width, height : int, pixels
        Both above 0.
    format : RGB, ARGB or ALPHA
        RGB begins black, ARGB and ALPHA begin transparent.

    Attributes
    ----------
    format : int
        RGB if it has no transparent pixels.

    Raises
    ------
    SketchError
        If the size is not positive, or the format unknown.

    Notes
    -----
    What was drawn keeps its colours: a later change of the image shows where it is drawn next.
    Source: Processing's reference, PImage.

    Examples
    --------
    >>> img = PImage(40, 40, RGB)
    >>> for i in range(40):
    ...     img.set(i, i, color(255, 204, 0))
    >>> image(img, 30, 30)
    """

    def __init__(self, width: int, height: int, format: int = c.RGB) -> None:
        if format not in FORMATS:
            raise SketchError("An image's format is RGB, ARGB or ALPHA.", got=shown(format))
        columns, rows = _whole("createImage", (width, height), "width, height")
        if rows <= 0 or columns <= 0 or rows * columns > MOST_PIXELS:
            raise SketchError(
                "An image is at least 1 pixel wide and high, and fits into memory.",
                got=f"{columns} x {rows}",
            )
        data = np.empty((rows, columns, 4), np.uint8)
        data[:] = BLANK[format]
        self._adopt(data)
        self.format = format

    @classmethod
    def _of(cls, data: U8, image_format: int | None = None) -> PImage:
        """Return an image of RGBA bytes, (h, w, 4), which become its own."""
        image = cls.__new__(cls)
        image._adopt(data)
        if image_format is None:
            image_format = c.RGB if (data[..., 3] == 255).all() else c.ARGB
        image.format = image_format
        return image

    def _adopt(self, data: U8) -> None:
        """Take other pixels, (h, w, 4) RGBA, for its own."""
        self._own = Pixels(np.ascontiguousarray(data))
        self._pixels = PixelArray(self._own)
        self._drawn: Pixels | None = None

    def _texture(self) -> Pixels:
        """Return a copy of the image as it is now; the same one until it is changed.

        What was recorded with an earlier copy keeps its colours, and nothing has to be drawn
        before an image may change.
        """
        if self._drawn is None or self._drawn.version != self._own.version:
            self._drawn = replace(self._own, data=self._own.data.copy())
        return self._drawn

    @property
    def width(self) -> int:
        """Columns of pixels."""
        return self._own.width

    @property
    def height(self) -> int:
        """Rows of pixels."""
        return self._own.height

    @property
    def pixelDensity(self) -> int:
        """Pixels of the image for one unit of the sketch, across and down: always 1."""
        return 1

    @property
    def pixelWidth(self) -> int:
        """Columns of pixels; the same as `width`."""
        return self.width

    @property
    def pixelHeight(self) -> int:
        """Rows of pixels; the same as `height`."""
        return self.height

    @property
    def pixels(self) -> PixelArray:
        """The colours, row by row: `pixels[y * width + x]`; `updatePixels()` shows changes.

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> for i in range(len(img.pixels)):
        ...     img.pixels[i] = color(0, 90, i % 256)
        >>> img.updatePixels()
        >>> image(img, 20, 20)
        """
        return self._pixels

    @property
    def np_pixels(self) -> U8:
        """The bytes as a NumPy array, (height, width, 4), RGBA; not a copy. Not in Processing.

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> img.np_pixels[:, 30:, 0] = 255
        >>> img.updatePixels()
        >>> image(img, 20, 20)
        """
        return self._own.data

    def loadPixels(self) -> None:
        """Prepare `pixels`: they are always ready, and nothing has to be done.

        Examples
        --------
        >>> img = createImage(10, 10, RGB)
        >>> img.loadPixels()
        """

    def updatePixels(self, *region: int) -> None:
        """Have changes of `pixels` and `np_pixels` show where the image is drawn next.

        Parameters
        ----------
        *region : 4 int, optional
            The part that was changed. All of it is taken over anyhow.

        Examples
        --------
        >>> img = createImage(10, 10, RGB)
        >>> img.pixels[0] = color(255)
        >>> img.updatePixels()
        """
        if len(region) not in (0, 4):
            raise wrong_numbers("updatePixels", region, "x, y, width, height", (0, 4))
        self._own.version += 1

    @overload
    def get(self) -> PImage: ...
    @overload
    def get(self, x: float, y: float, /) -> int: ...
    @overload
    def get(self, x: float, y: float, w: float, h: float, /) -> PImage: ...
    def get(self, *place: float) -> int | PImage:
        """Return the colour of one pixel, or a copy of a part, or of the whole image.

        Parameters
        ----------
        *place : 2 or 4 int, pixels
            x and y; or x, y, width and height of a part. Without numbers: all of it.

        Returns
        -------
        int or PImage
            A colour, or an image. Outside of the image all is transparent black.

        Raises
        ------
        SketchError
            If there are not 0, 2 or 4 numbers.

        See Also
        --------
        set, copy

        Notes
        -----
        Source: Processing's reference, PImage.get().

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> fill(img.get(5, 5))
        >>> rect(20, 20, 60, 60)
        """
        if not place:
            return self.copy()
        numbers = _whole("get", place, GET_USAGE)
        if len(numbers) == 2:
            x, y = numbers
            if not (0 <= x < self.width and 0 <= y < self.height):
                return 0
            return self._pixels[y * self.width + x]
        if len(numbers) == 4:
            return self._part(*numbers)
        raise wrong_numbers("get", place, GET_USAGE, (0, 2, 4))

    def _part(self, x: int, y: int, width: int, height: int) -> PImage:
        """Return a copy of a part; what is outside of the image is transparent."""
        part = PImage(width, height, c.ARGB)
        is_cropped = x < 0 or y < 0 or x + width > self.width or y + height > self.height
        part.format = c.ARGB if is_cropped and self.format == c.RGB else self.format
        _paste(self._own.data, part._own.data, -x, -y)
        return part

    def copy(self) -> PImage:
        """Return an image of its own with the same pixels.

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> other = img.copy()
        >>> other.set(0, 0, color(255))
        >>> image(other, 20, 20)
        """
        return PImage._of(self._own.data.copy(), self.format)

    def set(self, x: float, y: float, value: int | str | PImage) -> None:
        """Set the colour of one pixel, or copy another image into this one.

        Parameters
        ----------
        x, y : int, pixels
            The pixel, or where the other's top left corner comes. Outside nothing is changed.
        value : color or PImage
            An image replaces what is there, alpha included.

        Raises
        ------
        SketchError
            If x or y is no number, or the value is neither a colour nor an image.

        See Also
        --------
        get, pixels

        Notes
        -----
        A single number is a packed colour here, not a gray: write `color(255)`. Source:
        Processing's reference, PImage.set().

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> img.set(30, 30, color(255, 0, 0))
        >>> image(img, 20, 20)
        """
        try:
            column, row = int(x + 0), int(y + 0)
        except (TypeError, ValueError):
            raise wrong_numbers("set", (x, y, value), "x, y, color") from None
        self._own.version += 1
        if isinstance(value, PImage):
            _paste(value._own.data, self._own.data, column, row)
            return
        packed = to_packed(value, "set")
        if 0 <= column < self.width and 0 <= row < self.height:
            self._own.data[row, column] = self._stored(packed)

    def _stored(self, color: int) -> tuple[int, int, int, int]:
        """Return the RGBA that a colour leaves in an image of this format."""
        red, green, blue, alpha = color >> 16 & 255, color >> 8 & 255, color & 255, color >> 24
        if self.format == c.ALPHA:  # alone the lowest byte counts: it is the alpha of white
            return 255, 255, 255, blue
        return red, green, blue, 255 if self.format == c.RGB else alpha

    def resize(self, w: float, h: float) -> None:
        """Change the size.

        Parameters
        ----------
        w, h : int, pixels
            If one of them is 0, the other one decides and the proportions stay.

        Raises
        ------
        SketchError
            If neither is above 0.

        Notes
        -----
        Bilinear. Source: Processing's reference, PImage.resize().

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> img.resize(80, 0)
        >>> image(img, 10, 10)
        """
        width, height = _whole("resize", (w, h), "width, height")
        # In 32 bits, as Processing: 120 of 160 rows make 119 or 120 columns, depending on it.
        if width == 0 and height > 0:
            width = int(np.float32(self.width) * (np.float32(height) / np.float32(self.height)))
        elif height == 0 and width > 0:
            height = int(np.float32(self.height) * (np.float32(width) / np.float32(self.width)))
        if width <= 0 or height <= 0 or width * height > MOST_PIXELS:
            raise SketchError(
                "resize() takes a width and a height above 0; one of them may be 0.",
                got=f"resize({shown(w)}, {shown(h)})",
            )
        self._adopt(resized(self._own.data, width, height))

    def save(self, filename: str) -> None:
        """Write the image to a file beside the sketch.

        Parameters
        ----------
        filename : str
            Its ending says the kind: `.png`, `.jpg`, `.tif`, `.tga`, ...; without one it is a
            `.tif`.

        Raises
        ------
        SketchError
            If the ending is none of a picture.

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> img.save("black.png")
        """
        path = sketch_folder() / Path(filename)
        path = path if path.suffix else path.with_suffix(".tif")
        data = self._own.data[..., :3] if self.format == c.RGB else self._own.data
        write_file(path, picture_bytes(np.ascontiguousarray(data), path.suffix))

    def __repr__(self) -> str:
        return f"<PImage {self.width} x {self.height}>"


def _paste(source: U8, target: U8, x: int, y: int) -> None:
    """Copy an image into another, its top left corner at x, y of that; what is outside is cut."""
    left, top = max(x, 0), max(y, 0)
    right = min(x + source.shape[1], target.shape[1])
    bottom = min(y + source.shape[0], target.shape[0])
    if left < right and top < bottom:
        target[top:bottom, left:right] = source[top - y : bottom - y, left - x : right - x]


def _whole(name: str, numbers: tuple[float, ...], usage: str) -> list[int]:
    """Return numbers cut off to whole ones."""
    try:
        return [int(number + 0) for number in numbers]
    except (TypeError, ValueError):
        raise wrong_numbers(name, numbers, usage) from None
