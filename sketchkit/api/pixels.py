"""The pixels of a canvas: read back when they are asked for, sent when they were set."""

from __future__ import annotations

import numpy as np

from sketchkit.api._parts import blank_pixels
from sketchkit.api.images import Box, Images
from sketchkit.api.live import live
from sketchkit.api.open_corners import kept_corners
from sketchkit.api.pimage import PImage
from sketchkit.api.pixel_access import PixelAccess, PixelParts
from sketchkit.api.pixel_array import PixelArray
from sketchkit.api.pixel_effects import PixelEffects
from sketchkit.api.vertices import pixels_of
from sketchkit.core import constants as c
from sketchkit.core.notices import warn_once
from sketchkit.draw.commands import Upload
from sketchkit.draw.resources import Pixels
from sketchkit.draw.vertex import U8
from sketchkit.imaging.blits import Region
from sketchkit.imaging.masks import luminances
from sketchkit.imaging.scaling import nearest


class CanvasPixels(Images, PixelAccess, PixelEffects):
    """Reading and setting what was drawn.

    As long as nothing is drawn in between, all reading and setting is done in `_own`, a copy: it
    is read once, and sent when something is drawn.
    """

    format = c.ARGB

    @property
    @live
    def pixels(self) -> PixelArray:
        """The colours of the canvas, row by row: `pixels[y * width + x]`.

        They are what `loadPixels()` has read; `updatePixels()` shows changes.

        Examples
        --------
        >>> loadPixels()
        >>> for x in range(width):
        ...     pixels[50 * width + x] = color(255, 0, 0)
        >>> updatePixels()
        """
        return self._pixels

    @property
    @live
    def np_pixels(self) -> U8:
        """The canvas as a NumPy array, (height, width, 4), RGBA; not in Processing.

        It is what `loadPixels()` has read; `updatePixels()` shows changes.

        Examples
        --------
        >>> loadPixels()
        >>> np_pixels[20:40, :, 0] = 255
        >>> updatePixels()
        """
        return self._own.data

    def size_pixels(self) -> None:
        """Make room for as many pixels as the canvas has; they are still to be read."""
        self._own = blank_pixels(self._target)
        self._pixels.give_up()
        self._is_read = self._is_set = self._is_asked = False
        self._copied = None

    def forget_state(self) -> None:
        """Give up indices into the recorder, and the copy of the pixels: something was drawn."""
        super().forget_state()
        self._is_read = self._is_asked = False

    def take_upload(self) -> Upload | None:
        """Return the pixels that the sketch has set since they were last taken, if any."""
        if not self._is_set:
            return None
        self._is_set = False
        return Upload(self._target, self._own.data)

    def _pixel(self, x: int, y: int) -> int:
        """Return one pixel as it is stored.

        The first that is asked for after something was drawn is read alone: sketches get a colour,
        draw, get the next one, and reading all of the picture each time took most of their time.
        """
        is_drawn_on = self._recorder.row_end > 0
        if not is_drawn_on and (self._is_read or self._is_asked):
            return super()._pixel(x, y)
        with kept_corners(self._recorder, self._shape):
            pixel = self._renderer.read_pixel(self._target, x, y)
        self._is_asked = True
        red, green, blue, alpha = pixel.tolist()
        color: int = alpha << 24 | red << 16 | green << 8 | blue
        return color

    def _refresh(self) -> None:
        if self._is_read and not self._recorder.row_end:
            return
        with kept_corners(self._recorder, self._shape):
            self._own.data[:] = self._renderer.read(self._target)
        self._pixels.show(self._own)
        self._is_read = True

    def _touch(self) -> None:
        """Have the pixels sent before all that was drawn since they were read, as in Processing."""
        if len(self._pixels) == 0:
            warn_once("updatePixels() has nothing to show: loadPixels() comes first.")
            return
        self._is_set = self._is_read = True

    def _image_of(self, data: U8, image_format: int) -> PImage:
        return PImage._of(data, image_format)

    def _paste(self, source: PixelParts, x: int, y: int) -> None:
        """Draw an image.

        In JAVA2D it replaces what is there instead. In OpenGL it does so first if pixels are still
        to be sent, as in Processing: it shows where both are transparent.
        """
        if self._stage.is_java2d or self._is_set:
            super()._paste(source, x, y)
        if self._stage.is_java2d:
            return
        size = source._own.width, source._own.height
        self._copy(source, Region(0, 0, *size), Region(x, y, *size))

    def _copy(self, source: PixelParts, taken: Region, placed: Region) -> None:
        """Draw a part of an image, or of what was drawn; JAVA2D takes the nearest pixels."""
        if self._stage.is_java2d:
            self._copy_nearest(source, taken, placed)
        elif source is self:
            self._copy_own(taken, placed)
        else:
            pixels = pixels_of("copy", source)
            self._draw_over(pixels, placed, _part(taken, pixels.width, pixels.height))

    def _copy_nearest(self, source: PixelParts, taken: Region, placed: Region) -> None:
        if placed.width > 0 and placed.height > 0:
            source._refresh()
            copied = nearest(source._own.data, taken, placed.width, placed.height)
            self._draw_over(Pixels(copied, mipmaps=False), placed)

    def _copy_own(self, taken: Region, placed: Region) -> None:
        """Draw a part of what was drawn, as OpenGL does it in Processing.

        The part is copied to a texture, with all that lies above it, and that is drawn. Pixels at
        the edge of an enlarged copy are mixed with what is beside the part in the texture: nothing,
        or what earlier copies have left there.
        """
        self._refresh()
        data, (height, width, _) = self._own.data, self._own.data.shape
        left, _, right, bottom = (max(edge, 0) for edge in taken.edges)
        copied = np.zeros_like(data) if self._copied is None else self._copied.data.copy()
        copied[:bottom, left:right] = data[:bottom, left:right]
        self._copied = Pixels(copied)
        self._draw_over(self._copied, placed, _part(taken, width, height))
        self._want_layer()

    def _replace(self, data: U8, image_format: int) -> None:
        """Draw filtered pixels, as in Processing: it shows where they are transparent."""
        self._paste(PImage._of(data, image_format), 0, 0)

    def _mask_by_image(self, mask: U8) -> None:
        """Take the brightness for alpha; as in Processing, OpenGL has the mask upside down."""
        if self._stage.is_java2d:
            self._mask_by_blue(mask)
            return
        self._own.data[..., 3] = luminances(mask[::-1])
        self._touch()
        self._renderer.flush()
        self._want_layer()

    def _want_layer(self) -> None:
        """Have the next frame drawn as Processing draws after a frame without `background()`."""
        self._was_cleared = False


def _part(region: Region, width: int, height: int) -> Box:
    """Return a region of an image as a part of its texture."""
    left, top, right, bottom = region.edges
    return left / width, top / height, right / width, bottom / height
