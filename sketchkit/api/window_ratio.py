"""`windowRatio()`: a sketch that keeps its own size, however large the window is."""

from __future__ import annotations

from math import floor
from typing import NamedTuple

from sketchkit.api._sketch_parts import SketchParts
from sketchkit.api.live import live
from sketchkit.core.errors import SketchError, shown, wrong_numbers


class _Fit(NamedTuple):
    """Where in the window the sketch's own area lies."""

    left: float
    top: float
    scale: float


WHOLE = _Fit(0.0, 0.0, 1.0)  # what there is without windowRatio(): it is asked for in each frame


class WindowRatio(SketchParts):
    """The area that `windowRatio()` asks for, and places in it."""

    def windowRatio(self, wide: float, high: float) -> None:
        """Draw in an area of fixed size, which each frame is stretched to fill the window.

        Parameters
        ----------
        wide, high : float
            The area's size in the sketch's own units; `rwidth` and `rheight` from now on.

        See Also
        --------
        windowResizable, rmouseX, rwidth

        Notes
        -----
        It holds from the next frame on. The area keeps its proportions and lies in the middle of
        the window. Use `rmouseX` and `rmouseY` in place of `mouseX` and `mouseY`.

        Examples
        --------
        >>> def setup():
        ...     size(400, 300)
        ...     windowResizable(True)
        ...     windowRatio(200, 200)
        >>> def draw():
        ...     circle(rmouseX, rmouseY, 20)
        """
        try:
            area = int(wide), int(high)
        except (TypeError, ValueError, OverflowError):
            raise wrong_numbers("windowRatio", (wide, high), "wide, high") from None
        if min(area) < 1:
            raise SketchError(
                "windowRatio() takes two numbers above 0.",
                got=f"windowRatio({shown(wide)}, {shown(high)})",
            )
        self._format.ratio = area

    @property
    @live
    def rwidth(self) -> int:
        """Width of the area that `windowRatio()` has set; without it the same as `width`.

        Examples
        --------
        >>> println(rwidth)
        """
        return self._format.ratio[0] if self._format.ratio else self.canvas.width

    @property
    @live
    def rheight(self) -> int:
        """Height of the area that `windowRatio()` has set; without it the same as `height`.

        Examples
        --------
        >>> println(rheight)
        """
        return self._format.ratio[1] if self._format.ratio else self.canvas.height

    @property
    @live
    def rmouseX(self) -> int:
        """What `mouseX` is in the area of `windowRatio()`.

        Examples
        --------
        >>> circle(rmouseX, rmouseY, 20)
        """
        fit = self._fit()
        place = self.pointer.x
        return place if fit is WHOLE else floor((place - fit.left) / fit.scale)

    @property
    @live
    def rmouseY(self) -> int:
        """What `mouseY` is in the area of `windowRatio()`.

        Examples
        --------
        >>> circle(rmouseX, rmouseY, 20)
        """
        fit = self._fit()
        place = self.pointer.y
        return place if fit is WHOLE else floor((place - fit.top) / fit.scale)

    @property
    @live
    def ratioScale(self) -> float:
        """How many pixels of the window a unit of `windowRatio()` has; 1 without it.

        Examples
        --------
        >>> println(ratioScale)
        """
        return self._fit().scale

    @property
    @live
    def ratioLeft(self) -> float:
        """How far the area of `windowRatio()` is from the window's left edge, in pixels.

        Examples
        --------
        >>> println(ratioLeft)
        """
        return self._fit().left

    @property
    @live
    def ratioTop(self) -> float:
        """How far the area of `windowRatio()` is from the window's top edge, in pixels.

        Examples
        --------
        >>> println(ratioTop)
        """
        return self._fit().top

    def begin_ratio(self) -> None:
        """Let a frame begin in the area that is asked for."""
        if self._format.ratio:
            fit = self._fit()
            self.canvas.translate(fit.left, fit.top)
            self.canvas.scale(fit.scale)

    def _fit(self) -> _Fit:
        if not self._format.ratio:
            return WHOLE
        wide, high = self._format.ratio
        width, height = self.canvas.width, self.canvas.height
        scale = min(width / wide, height / high)
        return _Fit((width - scale * wide) / 2, (height - scale * high) / 2, scale)
