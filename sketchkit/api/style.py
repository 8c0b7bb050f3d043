"""Style: how numbers are read, how colours are mixed, and putting it all aside."""

from __future__ import annotations

from sketchkit.api._parts import Block, CanvasParts
from sketchkit.api.paint import Paint, check_choice, chosen
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError
from sketchkit.core.style import SavedStyle
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.resources import Wrap

RECT_MODES = {c.CORNER: "CORNER", c.CORNERS: "CORNERS", c.RADIUS: "RADIUS", c.CENTER: "CENTER"}
RECTMODE_USAGE = ELLIPSEMODE_USAGE = " | ".join(RECT_MODES.values())
IMAGEMODE_USAGE = "CORNER | CORNERS | CENTER"
WRAPS = {c.CLAMP: "CLAMP", c.REPEAT: "REPEAT"}
MOST_SAVED = 64  # pushStyle() without popStyle(): beyond it a pop is missing, not a deep drawing


class Styling(CanvasParts, Paint):
    """The modes of shapes, and the stack of styles."""

    def rectMode(self, mode: int) -> None:
        """Set what the numbers of `rect()` mean.

        Parameters
        ----------
        mode : CORNER, CORNERS, CENTER or RADIUS
            Corner and size (at first); two corners; centre and size; centre and half the size.

        Examples
        --------
        >>> rectMode(CENTER)
        >>> rect(50, 50, 60, 40)
        """
        self._restyle("rect_mode", chosen("rectMode", mode, RECT_MODES, c.CORNERS))

    def ellipseMode(self, mode: int) -> None:
        """Set what the numbers of `ellipse()` and `arc()` mean; the same modes as `rectMode()`.

        At first CENTER.

        Examples
        --------
        >>> ellipseMode(CORNER)
        >>> ellipse(20, 20, 60, 40)
        """
        self._restyle("ellipse_mode", chosen("ellipseMode", mode, RECT_MODES, c.CORNER))

    def imageMode(self, mode: int) -> None:
        """Set what the numbers of `image()` mean: CORNER (at first), CORNERS or CENTER.

        Examples
        --------
        >>> imageMode(CENTER)
        """
        allowed = {key: name for key, name in RECT_MODES.items() if key != c.RADIUS}
        check_choice("imageMode", mode, allowed)
        self._image_mode = mode

    def blendMode(self, mode: int) -> None:
        """Set how colours are mixed with what is there already.

        Parameters
        ----------
        mode : BLEND, ADD, SUBTRACT, DARKEST, LIGHTEST, EXCLUSION, MULTIPLY, SCREEN or REPLACE
            DARKEST, LIGHTEST, EXCLUSION, MULTIPLY and SCREEN ignore alpha, as in Processing. The
            modes that its OpenGL renderers lack (DIFFERENCE and others) change nothing.

        Examples
        --------
        >>> blendMode(ADD)
        >>> fill(255, 0, 0)
        >>> rect(20, 20, 40, 40)
        """
        if mode in set(Blend) and mode != self._blend_mode:
            self._restage(blend=Blend(mode))
            self._blend_mode = mode

    def textureWrap(self, wrap: int) -> None:
        """Set what shows beyond a texture's edges: CLAMP (at first) or REPEAT.

        Examples
        --------
        >>> textureWrap(REPEAT)
        """
        check_choice("textureWrap", wrap, WRAPS)
        if wrap != self._stage.wrap:
            self._restage(wrap=Wrap(wrap))

    def pushStyle(self) -> Block:
        """Put the style aside until `popStyle()`; `with pushStyle():` takes it back by itself.

        See Also
        --------
        popStyle, push, pushMatrix

        Examples
        --------
        >>> with pushStyle():
        ...     fill(255, 0, 0)
        ...     rect(10, 10, 30, 30)
        >>> rect(60, 60, 30, 30)
        """
        if len(self._styles) >= MOST_SAVED:
            raise SketchError(
                f"pushStyle() was called {MOST_SAVED} times without popStyle().",
                hint="Write a popStyle() for each pushStyle().",
            )
        self._styles.append(
            SavedStyle(
                self._style,
                self._fill,
                self._stroke,
                self._tint,
                self._weight,
                self._color_mode,
                self._image_mode,
                self._shape_mode,
                self._blend_mode,
                self._typography,
            )
        )
        return Block(self.popStyle)

    def popStyle(self) -> None:
        """Take back the style that `pushStyle()` put aside.

        Raises
        ------
        SketchError
            If there is none.

        Examples
        --------
        >>> pushStyle()
        >>> noFill()
        >>> popStyle()
        >>> rect(20, 20, 60, 60)
        """
        if not self._styles:
            raise SketchError(
                "popStyle() without pushStyle().",
                hint="Each popStyle() takes back what one pushStyle() before it put aside.",
            )
        saved = self._styles.pop()
        self._style = saved.style
        self._fill, self._stroke, self._tint = saved.fill, saved.stroke, saved.tint
        self._weight, self._color_mode = saved.stroke_weight, saved.color_mode
        self._image_mode, self._shape_mode = saved.image_mode, saved.shape_mode
        self._typography = saved.typography
        self._state = self._attributes = -1
        self.blendMode(saved.blend_mode)
