"""What is done to many pixels at once: `copy()`, `blend()`, `filter()` and `mask()`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from sketchkit.api.filter_kinds import check_filter, filtered
from sketchkit.api.pixel_access import PixelParts
from sketchkit.api.pixel_array import PixelArray
from sketchkit.core import constants as c
from sketchkit.core.color import to_packed
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.draw.vertex import U8
from sketchkit.imaging.blending import BLEND_MODES, blended
from sketchkit.imaging.blits import Region, blit
from sketchkit.imaging.packing import to_argb, to_rgba

if TYPE_CHECKING:
    from sketchkit.api.pimage import PImage

REGIONS = "sx, sy, sw, sh, dx, dy, dw, dh"
COPY_USAGE = f"{REGIONS} | image, {REGIONS}"
BLEND_USAGE = f"{REGIONS}, mode | image, {REGIONS}, mode"


class PixelEffects(PixelParts):
    """Regions copied and blended, filters and masks."""

    def copy(self, *args: float | PImage) -> PImage | None:
        """Copy a region to another one, of whatever size; without arguments: make a copy of all.

        Parameters
        ----------
        *args : image, optional, and 8 int, pixels
            The image that is copied from, if it is another one; x, y, width and height of what is
            copied; x, y, width and height of where it comes.

        Returns
        -------
        PImage or None
            An image of its own with the same pixels, if there are no arguments.

        Raises
        ------
        SketchError
            If there are not 0, 8 or 9 arguments of these kinds.

        See Also
        --------
        blend, get, set

        Notes
        -----
        In an image, pixels are replaced, alpha included. A canvas draws what is copied: through
        transparent pixels it stays seen. Source: Processing's reference, copy().

        Examples
        --------
        >>> circle(30, 30, 40)
        >>> copy(0, 0, 50, 50, 50, 50, 50, 50)
        >>> img = createImage(10, 10, RGB)
        >>> copy(img, 0, 0, 10, 10, 60, 10, 30, 20)
        """
        if not args:
            self._refresh()
            return self._image_of(self._own.data.copy(), self.format)
        source, taken, placed = self._regions("copy", args, args, COPY_USAGE, (0, 8, 9))
        self._copy(source, taken, placed)
        return None

    def _copy(self, source: PixelParts, taken: Region, placed: Region) -> None:
        """Replace a region of this by one of another, or of this too."""
        self._blend(source, taken, placed, c.REPLACE)

    def blend(self, *args: float | PImage) -> None:
        """Blend a region over another one, of whatever size.

        Parameters
        ----------
        *args : image, optional, 8 int, pixels, and the mode
            The image that is blended over this, if it is another one; x, y, width and height of
            what is taken; x, y, width and height of where it comes; BLEND, ADD, SUBTRACT,
            LIGHTEST, DARKEST, DIFFERENCE, EXCLUSION, MULTIPLY, SCREEN, OVERLAY, HARD_LIGHT,
            SOFT_LIGHT, DODGE, BURN or REPLACE.

        Raises
        ------
        SketchError
            If there are not 9 or 10 arguments of these kinds.

        See Also
        --------
        copy, blendColor, blendMode

        Notes
        -----
        Alpha counts in all modes but REPLACE. SOFT_LIGHT and BURN look at the blue of what is
        blended over alone, as in Processing. Source: Processing's reference, blend().

        Examples
        --------
        >>> background(255, 204, 0)
        >>> circle(30, 30, 40)
        >>> blend(0, 0, 50, 50, 20, 20, 70, 70, MULTIPLY)
        """
        mode = args[-1] if args else None
        if len(args) in (9, 10) and mode not in BLEND_MODES:
            raise SketchError(
                "blend() takes a mode last: BLEND, ADD, SUBTRACT, MULTIPLY, ...",
                got=shown(mode),
                hint=f"Write {mode} without quotes." if isinstance(mode, str) else None,
            )
        source, taken, placed = self._regions("blend", args, args[:-1], BLEND_USAGE, (9, 10))
        assert isinstance(mode, int)
        self._blend(source, taken, placed, mode)

    def _blend(self, source: PixelParts, taken: Region, placed: Region, mode: int) -> None:
        self._refresh()
        source._refresh()
        blit(source._own.data, taken, self._own.data, placed, mode)
        self._touch()

    def _regions(
        self,
        name: str,
        args: Sequence[object],
        places: Sequence[object],
        usage: str,
        counts: tuple[int, ...],
    ) -> tuple[PixelParts, Region, Region]:
        """Return what is copied from, and both regions; `places` are `args` without a mode."""
        source: PixelParts = self
        numbers = places
        if len(places) == 9:
            if not isinstance(places[0], PixelParts):
                raise wrong_numbers(name, args, usage, counts)
            source, numbers = places[0], places[1:]
        if len(numbers) != 8:
            raise wrong_numbers(name, args, usage, counts)
        try:
            sizes = [int(number + 0) for number in numbers]  # type: ignore[operator] # checked so
        except (TypeError, ValueError):
            raise wrong_numbers(name, args, usage, counts) from None
        return source, Region(*sizes[:4]), Region(*sizes[4:])

    @staticmethod
    def blendColor(c1: int | str, c2: int | str, mode: int) -> int:
        """Blend a colour over another one.

        Parameters
        ----------
        c1, c2 : color
            The one below, and the one above: its alpha counts.
        mode : BLEND, ADD, SUBTRACT, LIGHTEST, DARKEST, DIFFERENCE, EXCLUSION, MULTIPLY, ...
            All modes of `blend()`.

        Returns
        -------
        int
            A colour.

        Raises
        ------
        SketchError
            If these are no colours, or it is no mode.

        See Also
        --------
        blend, lerpColor, color

        Notes
        -----
        Source: Processing's reference, PImage.blendColor().

        Examples
        --------
        >>> fill(blendColor(color(255, 0, 0), color(0, 0, 255, 128), ADD))
        >>> rect(20, 20, 60, 60)
        """
        if mode not in BLEND_MODES:
            raise SketchError(
                "blendColor() takes a mode last: BLEND, ADD, SUBTRACT, MULTIPLY, ...",
                got=shown(mode),
            )
        below, above = (
            to_rgba(np.array(to_packed(color, "blendColor"), np.uint32)) for color in (c1, c2)
        )
        return int(to_argb(blended(below, above, mode)))

    def filter(self, kind: int, number: float | None = None) -> None:
        """Change all pixels: blur, gray, invert and the like.

        Parameters
        ----------
        kind : BLUR, GRAY, INVERT, OPAQUE, POSTERIZE, THRESHOLD, ERODE or DILATE
        number : float, optional
            The radius of BLUR, at first 1; the level of THRESHOLD, 0 to 1, at first 0.5; the
            number of values that POSTERIZE leaves of each part of a colour, 2 to 255.

        Raises
        ------
        SketchError
            If it is no kind of filter, or the number does not fit it.

        See Also
        --------
        copy, blend, tint

        Notes
        -----
        ERODE grows dark areas, DILATE light ones. A blur takes the same time for any radius.
        Source: Processing's reference, filter().

        Examples
        --------
        >>> circle(50, 50, 60)
        >>> filter(BLUR, 3)
        >>> filter(INVERT)
        """
        check_filter(kind, number)
        self._refresh()
        data, image_format = filtered(self._own.data, self.format, kind, number)
        self._replace(data, image_format)

    def _replace(self, data: U8, image_format: int) -> None:
        """Show other pixels, of the same size."""
        self._own.data[:] = data
        self.format = image_format
        self._touch()

    def mask(self, mask: PImage | Sequence[int]) -> None:
        """Make this as transparent as another image is dark.

        Parameters
        ----------
        mask : PImage or list of int
            Of the same size. Its blue is the alpha: 0 is clear, 255 opaque.

        Raises
        ------
        SketchError
            If the size differs.

        See Also
        --------
        blend, tint, alpha

        Notes
        -----
        On a canvas of P2D and P3D, how bright the mask is counts, not its blue alone, and as in
        Processing it lies there upside down; mask an image instead. Source: Processing's reference,
        mask().

        Examples
        --------
        >>> img = createImage(60, 60, RGB)
        >>> hole = createImage(60, 60, RGB)
        >>> hole.set(30, 30, color(255))
        >>> img.mask(hole)
        >>> image(img, 20, 20)
        """
        self._refresh()
        data = self._mask_data(mask)
        if isinstance(mask, PixelParts):
            self._mask_by_image(data)
        else:
            self._mask_by_blue(data)

    def _mask_by_image(self, mask: U8) -> None:
        self._mask_by_blue(mask)

    def _mask_by_blue(self, mask: U8) -> None:
        """Take the blue of a mask, (h, w, 4), for alpha."""
        self._own.data[..., 3] = mask[..., 2]
        self.format = c.ARGB
        self._touch()

    def _mask_data(self, mask: PixelParts | Sequence[int] | PixelArray) -> U8:
        """Return the pixels of a mask, (h, w, 4)."""
        height, width, _ = self._own.data.shape
        if isinstance(mask, PixelParts):
            mask._refresh()
            data, size = mask._own.data, f"{mask._own.width} x {mask._own.height} pixels"
        else:
            try:
                colors = np.array(mask, np.int64)
            except (TypeError, ValueError):
                raise SketchError(
                    "mask() takes an image or a list of numbers.", got=shown(mask)
                ) from None
            data, size = to_rgba((colors & 0xFFFFFFFF).astype(np.uint32)), f"{colors.size} numbers"
            if colors.size == width * height:
                data = data.reshape(height, width, 4)
        if data.shape != (height, width, 4):
            raise SketchError(
                "A mask is as large as what it masks.", got=f"{size} for {width} x {height} pixels"
            )
        return data
