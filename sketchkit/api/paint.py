"""Paint: what shapes are filled and outlined with."""

from __future__ import annotations

from dataclasses import replace

from sketchkit.api._pen import Pen
from sketchkit.api.color import ColorLike
from sketchkit.core import constants as c
from sketchkit.core.color import USAGE, pack
from sketchkit.core.errors import SketchError, either, shown, wrong_numbers
from sketchkit.core.notices import warn_once
from sketchkit.core.style import NO_COLOR

# The usual call, three whole numbers, becomes three look-ups; whatever is not found goes the long
# way. A float that is whole finds its entry too.
_RED = {value: 0xFF000000 | value << 16 for value in range(256)}
_GREEN = {value: value << 8 for value in range(256)}
_BLUE = {value: value for value in range(256)}

CAPS = {c.ROUND: "ROUND", c.SQUARE: "SQUARE", c.PROJECT: "PROJECT"}
JOINS = {c.MITER: "MITER", c.BEVEL: "BEVEL", c.ROUND: "ROUND"}
FILL_USAGE = STROKE_USAGE = TINT_USAGE = USAGE
STROKECAP_USAGE = " | ".join(CAPS.values())
STROKEJOIN_USAGE = " | ".join(JOINS.values())


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


def chosen(name: str, value: int, choices: dict[int, str], otherwise: int) -> int:
    """Return one of the constants; for another number what Processing takes it for."""
    if isinstance(value, int) and value not in choices:
        taken = choices.get(otherwise, "nothing")
        warn_once(f"{name}() takes {either(choices.values())}; {value} is taken for {taken}.")
        return otherwise
    check_choice(name, value, choices)
    return value


class Paint(Pen):
    """Fill, stroke and tint."""

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
        if self._stroke >= 0:
            self._stroke = ~self._stroke  # negative: none, but a shape can have it back

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
        self._restyle("stroke_cap", chosen("strokeCap", cap, CAPS, c.SQUARE))

    def strokeJoin(self, join: int) -> None:
        """Set how segments of an outline meet: MITER (at first), BEVEL or ROUND.

        In P3D joins are always bevels.

        Examples
        --------
        >>> strokeWeight(10)
        >>> strokeJoin(ROUND)
        >>> rect(25, 25, 50, 50)
        """
        otherwise = c.BEVEL if self._stage.is_java2d else c.MITER
        self._restyle("stroke_join", chosen("strokeJoin", join, JOINS, otherwise))

    def _mix(self, name: str, *args: ColorLike | None) -> int:
        """Return the packed colour of the arguments that were given."""
        given = [arg for arg in args if arg is not None]
        if args[0] is None:
            raise wrong_numbers(name, (None, *given), USAGE)
        return pack(self._color_mode, *given, name=name)

    def _material(self, **changes: object) -> None:
        """Change parts of the material."""
        self._restyle("material", replace(self._style.material, **changes))  # type: ignore[arg-type] # the callers know
