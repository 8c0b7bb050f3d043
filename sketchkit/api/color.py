"""Colours: making them, and reading their parts."""

from __future__ import annotations

import math

from sketchkit.api._pen import Pen
from sketchkit.core import color as colors
from sketchkit.core import constants as c
from sketchkit.core.color import ColorMode
from sketchkit.core.errors import SketchError, shown

ColorLike = int | float | str
COLORMODE_USAGE = "mode [, max] | mode, max1, max2, max3 [, maxAlpha]"
LERPCOLOR_USAGE = "color1, color2, amount"
RED_USAGE = GREEN_USAGE = BLUE_USAGE = ALPHA_USAGE = "color"
HUE_USAGE = SATURATION_USAGE = BRIGHTNESS_USAGE = "color"


class Color(Pen):
    """Colours are ints, packed as 0xAARRGGBB; strings such as "#CC6600" and "orange" do as well."""

    def colorMode(
        self,
        mode: int,
        max1: float | None = None,
        max2: float | None = None,
        max3: float | None = None,
        maxA: float | None = None,
    ) -> None:
        """Set what the numbers of a colour mean.

        Parameters
        ----------
        mode : RGB or HSB
        max1, max2, max3 : float, optional
            The largest red or hue, green or saturation, blue or brightness. One number alone
            stands for all, alpha included. At first 255.
        maxA : float, optional
            The largest alpha.

        Raises
        ------
        SketchError
            If the mode is neither RGB nor HSB, or a maximum is not above 0.

        See Also
        --------
        color, fill, background

        Notes
        -----
        Source: Processing's reference, colorMode().

        Examples
        --------
        >>> colorMode(HSB, 360, 100, 100)
        >>> background(210, 60, 90)
        """
        if mode not in (c.RGB, c.HSB):
            hint = f"Write {mode} without quotes." if str(mode) in ("RGB", "HSB") else None
            raise SketchError("colorMode() takes RGB or HSB first.", got=shown(mode), hint=hint)
        old = self._color_mode
        if max1 is None:
            maxima = old.max1, old.max2, old.max3, old.max_alpha
        elif max2 is None or max3 is None:
            maxima = max1, max1, max1, max1
        else:
            maxima = max1, max2, max3, old.max_alpha if maxA is None else maxA
        try:
            self._color_mode = ColorMode(mode, *maxima)
        except TypeError:
            given = [number for number in (max1, max2, max3, maxA) if number is not None]
            self._refuse("colorMode", (mode, *given), COLORMODE_USAGE)

    def color(self, *args: ColorLike) -> int:
        """Make a colour.

        Parameters
        ----------
        *args : float, int or str
            Gray; gray and alpha; three components in the current `colorMode()`; three and alpha; or
            a colour (packed, or a string) and alpha.

        Returns
        -------
        int
            Packed as 0xAARRGGBB.

        Raises
        ------
        SketchError
            If the arguments make no colour.

        See Also
        --------
        colorMode, lerpColor, red

        Notes
        -----
        Components are cut off, not rounded. One int above 255 is a packed colour. Source:
        Processing's reference, color().

        Examples
        --------
        >>> c = color(255, 204, 0)
        >>> fill(c)
        >>> rect(20, 20, 60, 60)
        """
        return colors.pack(self._color_mode, *args)

    def red(self, rgb: ColorLike) -> float:
        """Return the red part of a colour, on the first scale of `colorMode()`.

        Examples
        --------
        >>> fill(red(color(200, 10, 10)), 0, 0)
        >>> rect(20, 20, 60, 60)
        """
        return colors.red(self._color_mode, self._packed("red", rgb))

    def green(self, rgb: ColorLike) -> float:
        """Return the green part of a colour, on the second scale of `colorMode()`.

        Examples
        --------
        >>> fill(0, green(color(10, 200, 10)), 0)
        >>> rect(20, 20, 60, 60)
        """
        return colors.green(self._color_mode, self._packed("green", rgb))

    def blue(self, rgb: ColorLike) -> float:
        """Return the blue part of a colour, on the third scale of `colorMode()`.

        Examples
        --------
        >>> fill(0, 0, blue(color(10, 10, 200)))
        >>> rect(20, 20, 60, 60)
        """
        return colors.blue(self._color_mode, self._packed("blue", rgb))

    def alpha(self, rgb: ColorLike) -> float:
        """Return the alpha of a colour, on the fourth scale of `colorMode()`.

        Examples
        --------
        >>> fill(alpha(color(0, 100)))
        >>> rect(20, 20, 60, 60)
        """
        return colors.alpha(self._color_mode, self._packed("alpha", rgb))

    def hue(self, rgb: ColorLike) -> float:
        """Return the hue of a colour, on the first scale of `colorMode()`.

        Examples
        --------
        >>> fill(hue(color(0, 126, 255)))
        >>> rect(20, 20, 60, 60)
        """
        return colors.hue(self._color_mode, self._packed("hue", rgb))

    def saturation(self, rgb: ColorLike) -> float:
        """Return the saturation of a colour, on the second scale of `colorMode()`.

        Examples
        --------
        >>> fill(saturation(color(0, 126, 255)))
        >>> rect(20, 20, 60, 60)
        """
        return colors.saturation(self._color_mode, self._packed("saturation", rgb))

    def brightness(self, rgb: ColorLike) -> float:
        """Return the brightness of a colour, on the third scale of `colorMode()`.

        Examples
        --------
        >>> fill(brightness(color(0, 126, 255)))
        >>> rect(20, 20, 60, 60)
        """
        return colors.brightness(self._color_mode, self._packed("brightness", rgb))

    def lerpColor(self, c1: ColorLike, c2: ColorLike, amt: float) -> int:
        """Return a colour between two others.

        Parameters
        ----------
        c1, c2 : color
        amt : float
            0 gives the first, 1 the second; between them each part goes in a straight line, in
            the current `colorMode()`. It is held within 0 and 1.

        Notes
        -----
        Parts are rounded, and alpha is a part too: 0 is transparent black, not `color(0)`. Source:
        Processing's reference, lerpColor().

        Examples
        --------
        >>> fill(lerpColor(color(255, 0, 0), color(0, 0, 255), 0.5))
        >>> rect(20, 20, 60, 60)
        """
        start, stop = self._packed("lerpColor", c1), self._packed("lerpColor", c2)
        try:
            return colors.lerp_color(start, stop, amt, self._color_mode.model)
        except TypeError:
            self._refuse("lerpColor", (c1, c2, amt), LERPCOLOR_USAGE)

    def _packed(self, name: str, value: ColorLike) -> int:
        """Return a colour that a sketch holds: an int is packed, and 0 is a transparent pixel."""
        is_number = isinstance(value, float) and math.isfinite(value)
        return colors.to_packed(int(value) if is_number else value, name)
