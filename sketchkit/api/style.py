"""Style: what shapes are filled and outlined with, how numbers are read, and putting it aside."""

from __future__ import annotations

from dataclasses import replace

from sketchkit.api._parts import Block, CanvasParts
from sketchkit.api.color import ColorLike
from sketchkit.core import constants as c
from sketchkit.core.color import USAGE, pack
from sketchkit.core.errors import SketchError, either, shown, wrong_numbers
from sketchkit.core.style import NO_COLOR, SavedStyle
from sketchkit.draw.pipeline import Blend

# The usual call, three whole numbers, becomes three look-ups; whatever is not found goes the long
# way. A float that is whole finds its entry too.
_RED = {value: 0xFF000000 | value << 16 for value in range(256)}
_GREEN = {value: value << 8 for value in range(256)}
_BLUE = {value: value for value in range(256)}

RECT_MODES = {c.CORNER: "CORNER", c.CORNERS: "CORNERS", c.RADIUS: "RADIUS", c.CENTER: "CENTER"}
CAPS = {c.ROUND: "ROUND", c.SQUARE: "SQUARE", c.PROJECT: "PROJECT"}
JOINS = {c.MITER: "MITER", c.BEVEL: "BEVEL", c.ROUND: "ROUND"}
FILL_USAGE = STROKE_USAGE = TINT_USAGE = USAGE
RECTMODE_USAGE = ELLIPSEMODE_USAGE = " | ".join(RECT_MODES.values())
IMAGEMODE_USAGE = "CORNER | CORNERS | CENTER"
STROKECAP_USAGE = " | ".join(CAPS.values())
STROKEJOIN_USAGE = " | ".join(JOINS.values())
MOST_SAVED = 64  # pushStyle() without popStyle(): beyond it a pop is missing, not a deep drawing


def check_choice(name: str, value: object, choices: dict[int, str]) -> None:
    """Raise a SketchError unless `value` is one of the constants."""
    try:
        is_known = value in choices
    except TypeError:  # a list, say
        is_known = False
    if not is_known:
        is_quoted = value in choices.values()
        hint = f"Write {value} without quotes." if is_quoted else None
        problem = f"{name}() takes {either(choices.values())}."
        raise SketchError(problem, got=shown(value), hint=hint)


class Styling(CanvasParts):
    """Fill, stroke, tint, and the modes of shapes."""

    def fill(
        self,
        v1: ColorLike,
        v2: float | None = None,
        v3: float | None = None,
        alpha: float | None = None,
    ) -> None:
        """Set the colour that shapes are filled with.

        Parameters
        ----------
        v1 : float, color or str
            Gray, or the first component in the current `colorMode()`, or a whole colour.
        v2, v3 : float, optional
            The other components; with a gray or a colour, `v2` is its alpha.
        alpha : float, optional
            0 is transparent.

        Raises
        ------
        SketchError
            If the arguments make no colour.

        See Also
        --------
        noFill, stroke, colorMode, background

        Notes
        -----
        Source: Processing's reference, fill().

        Examples
        --------
        >>> fill(200, 80, 40)
        >>> rect(20, 20, 60, 60)
        """
        if alpha is None and self._color_mode.is_plain:
            try:
                self._fill = _RED[v1] | _GREEN[v2] | _BLUE[v3]  # type: ignore[index] # misses are caught
                return
            except (KeyError, TypeError):
                pass
        self._fill = self._mix("fill", v1, v2, v3, alpha)

    def noFill(self) -> None:
        """Leave shapes unfilled.

        Examples
        --------
        >>> noFill()
        >>> ellipse(50, 50, 60, 60)
        """
        if self._fill >= 0:
            self._fill = ~self._fill  # negative: none, but text goes on in the old colour

    def stroke(
        self,
        v1: ColorLike,
        v2: float | None = None,
        v3: float | None = None,
        alpha: float | None = None,
    ) -> None:
        """Set the colour of lines, points and outlines; arguments as for `fill()`.

        Parameters
        ----------
        v1 : float, color or str
        v2, v3, alpha : float, optional

        Raises
        ------
        SketchError
            If the arguments make no colour.

        See Also
        --------
        noStroke, strokeWeight, fill

        Notes
        -----
        Source: Processing's reference, stroke().

        Examples
        --------
        >>> stroke(0, 0, 255)
        >>> line(10, 10, 90, 90)
        """
        if alpha is None and self._color_mode.is_plain:
            try:
                self._stroke = _RED[v1] | _GREEN[v2] | _BLUE[v3]  # type: ignore[index] # misses are caught
                return
            except (KeyError, TypeError):
                pass
        self._stroke = self._mix("stroke", v1, v2, v3, alpha)

    def noStroke(self) -> None:
        """Leave shapes without outlines; lines and points are not drawn at all.

        Examples
        --------
        >>> noStroke()
        >>> rect(20, 20, 60, 60)
        """
        self._stroke = NO_COLOR

    def tint(
        self,
        v1: ColorLike,
        v2: float | None = None,
        v3: float | None = None,
        alpha: float | None = None,
    ) -> None:
        """Set the colour that images and textures are multiplied with; arguments as for `fill()`.

        `tint(255, 128)` shows them half transparent.

        Parameters
        ----------
        v1 : float, color or str
        v2, v3, alpha : float, optional

        See Also
        --------
        noTint, image, texture

        Examples
        --------
        >>> tint(255, 120, 120)
        """
        self._tint = self._mix("tint", v1, v2, v3, alpha)

    def noTint(self) -> None:
        """Show images and textures in their own colours.

        Examples
        --------
        >>> noTint()
        """
        self._tint = NO_COLOR

    def _mix(self, name: str, *args: ColorLike | None) -> int:
        """Return the packed colour of the arguments that were given."""
        given = [arg for arg in args if arg is not None]
        if args[0] is None:
            raise wrong_numbers(name, (None, *given), USAGE)
        return pack(self._color_mode, *given, name=name)

    def strokeWeight(self, weight: float) -> None:
        """Set how thick lines, points and outlines are.

        Parameters
        ----------
        weight : float, pixels
            Scaled with the current matrix.

        See Also
        --------
        stroke, strokeCap, strokeJoin

        Notes
        -----
        Source: Processing's reference, strokeWeight().

        Examples
        --------
        >>> strokeWeight(8)
        >>> line(20, 20, 80, 80)
        """
        try:
            self._weight = weight + 0.0
        except TypeError:
            self._refuse("strokeWeight", (weight,), "weight")
        self._attributes = -1

    def strokeCap(self, cap: int) -> None:
        """Set how lines end: ROUND (at first), SQUARE or PROJECT. P3D has no caps.

        Examples
        --------
        >>> strokeWeight(12)
        >>> strokeCap(SQUARE)
        >>> line(20, 50, 80, 50)
        """
        check_choice("strokeCap", cap, CAPS)
        self._restyle("stroke_cap", cap)

    def strokeJoin(self, join: int) -> None:
        """Set how segments of an outline meet: MITER (at first), BEVEL or ROUND.

        In P3D joins are always bevels.

        Examples
        --------
        >>> strokeWeight(10)
        >>> strokeJoin(ROUND)
        >>> rect(25, 25, 50, 50)
        """
        check_choice("strokeJoin", join, JOINS)
        self._restyle("stroke_join", join)

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
        check_choice("rectMode", mode, RECT_MODES)
        self._restyle("rect_mode", mode)

    def ellipseMode(self, mode: int) -> None:
        """Set what the numbers of `ellipse()` and `arc()` mean; the same modes as `rectMode()`.

        At first CENTER.

        Examples
        --------
        >>> ellipseMode(CORNER)
        >>> ellipse(20, 20, 60, 40)
        """
        check_choice("ellipseMode", mode, RECT_MODES)
        self._restyle("ellipse_mode", mode)

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

    def _material(self, **changes: object) -> None:
        """Change parts of the material."""
        self._restyle("material", replace(self._style.material, **changes))  # type: ignore[arg-type] # the callers know
