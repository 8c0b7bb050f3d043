"""PImage: a picture in memory, loaded, made, or cut out of another."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.api.pconstants import PConstants
from sketchkit.api.pixel_access import PixelAccess, whole
from sketchkit.api.pixel_array import PixelArray
from sketchkit.api.pixel_effects import PixelEffects
from sketchkit.assets.output import picture_bytes, write_file
from sketchkit.assets.paths import sketch_folder
from sketchkit.assets.pictures.images import Picture, load_image, to_bytes
from sketchkit.assets.pictures.radiance import radiance_bytes
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, shown
from sketchkit.draw.resources import Pixels
from sketchkit.draw.vertex import U8
from sketchkit.imaging.filters import opaque
from sketchkit.imaging.scaling import resized

FORMATS = {c.RGB: "RGB", c.ARGB: "ARGB", c.ALPHA: "ALPHA"}
F32 = NDArray[np.float32]
BLANK = {c.RGB: (0, 0, 0, 255), c.ARGB: (0, 0, 0, 0), c.ALPHA: (0, 0, 0, 0)}  # RGBA
RADIANCE_SUFFIX = ".hdr"
MOST_PIXELS = 1 << 28  # a GB; beyond it width and height are mistaken


class PImage(PixelAccess, PixelEffects, PConstants):
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

    _floats: F32 | None

    def __init__(self, width: int, height: int, format: int = c.RGB) -> None:
        if format not in FORMATS:
            raise SketchError("An image's format is RGB, ARGB or ALPHA.", got=shown(format))
        columns, rows = whole("createImage", (width, height), "width, height")
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
    def _of(cls, data: U8, image_format: int) -> PImage:
        """Return an image of RGBA bytes, (h, w, 4), which become its own."""
        image = cls.__new__(cls)
        image._adopt(data)
        image.format = image_format
        return image

    @classmethod
    def _load(cls, caller: str, filename: str) -> PImage:
        """Return the image in a file that a sketch names."""
        return cls._of_picture(load_image(caller, filename))

    @classmethod
    def _of_picture(cls, picture: Picture) -> PImage:
        """Return the image of what a file holds."""
        image = cls.__new__(cls)
        image._hold(picture)
        return image

    def _hold(self, picture: Picture) -> None:
        """Be what a file holds: without alpha if no pixel is transparent."""
        self._adopt(picture.data)
        self._floats = picture.floats
        self.format = c.RGB if (picture.data[..., 3] == 255).all() else c.ARGB

    def _adopt(self, data: U8) -> None:
        """Take other pixels, (h, w, 4) RGBA, for its own."""
        self._own = Pixels(np.ascontiguousarray(data))
        self._pixels = PixelArray(self._own)
        self._drawn: Pixels | None = None
        self._floats = None

    def _texture(self) -> Pixels:
        """Return a copy of the image as it is now; the same one until it is changed.

        What was recorded with an earlier copy keeps its colours, and nothing has to be drawn
        before an image may change.
        """
        if self._drawn is None or self._drawn.version != self._own.version:
            self._drawn = Pixels(self._as_seen(), self._own.version)
        return self._drawn

    def _as_seen(self) -> U8:
        """Return a copy of the pixels as they are drawn and saved."""
        if self.format == c.ALPHA:
            return white_of(self._own.data[..., 2])
        return opaque(self._own.data) if self.format == c.RGB else self._own.data.copy()

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

    @pixels.setter
    def pixels(self, colors: Iterable[int | str]) -> None:
        self._pixels[:] = colors

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

    @property
    def np_floats(self) -> F32:
        """The colours as floats, (height, width, 3), linear, white is 1. Not in Processing.

        Those of a `.hdr` or `.exr` file are kept as they are, brighter than white too, until a
        pixel is changed; those of other images are copied from the pixels. Setting them sets the
        pixels, which hold what lies from 0 to 1.

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> img.np_floats = img.np_floats + 0.5
        >>> image(img, 20, 20)
        """
        if self._floats is None:
            return self._own.data[..., :3].astype(np.float32) / np.float32(255)
        return self._floats

    @np_floats.setter
    def np_floats(self, floats: F32) -> None:
        self._adopt(to_bytes(np.asarray(floats, np.float32)))
        self._floats = np.array(floats, np.float32)
        self.format = c.RGB

    def _refresh(self) -> None:
        """Do nothing: an image is always up to date."""

    def _touch(self) -> None:
        self._own.version += 1
        self._floats = None

    def _image_of(self, data: U8, image_format: int) -> PImage:
        return PImage._of(data, image_format)

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
        width, height = whole("resize", (w, h), "width, height")
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
        data = self._own.data if self.format == c.ARGB else opaque(self._own.data)
        self._adopt(resized(data, width, height))

    def save(self, filename: str) -> None:
        """Write the image to a file beside the sketch.

        Parameters
        ----------
        filename : str
            Its ending says the kind: `.png`, `.jpg`, `.tif`, `.tga`, `.hdr`, ...; without one it
            is a `.tif`.

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
        write_file(path, self._file_bytes(path.suffix))

    def _file_bytes(self, suffix: str) -> bytes:
        if suffix.lower() == RADIANCE_SUFFIX:
            return radiance_bytes(self.np_floats)
        data = self._as_seen()
        return picture_bytes(data[..., :3].copy() if self.format == c.RGB else data, suffix)

    def _repr_png_(self) -> bytes:
        """Return the picture, as Jupyter asks for it."""
        return self._file_bytes(".png")

    def __repr__(self) -> str:
        return f"<PImage {self.width} x {self.height}>"


def white_of(alphas: U8) -> U8:
    """Return white of given alphas, (h, w), as an image."""
    data = np.full((*alphas.shape, 4), 255, np.uint8)
    data[..., 3] = alphas
    return data
