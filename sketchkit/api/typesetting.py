"""How text is set: size, face and alignment, and how much room it takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sketchkit.api._parts import CanvasParts
from sketchkit.api.paint import check_choice, chosen
from sketchkit.assets.fonts.faces import Face, Setting, design_size, fonts_of
from sketchkit.assets.fonts.letters import letters_of
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.core.float32 import f32
from sketchkit.core.notices import warn_once
from sketchkit.core.style import DEFAULT_FACE, Typeface, Typography
from sketchkit.data.strings import nfs

LEADING = f32(1.275)  # from line to line, in heights of a letter from ascent to descent
FIRST_SIZE = 12.0
TEXTALIGN_USAGE = "horizontal [, vertical]"
TEXTWIDTH_USAGE = "text | characters, start, length"
CHARACTERS_USAGE = "characters, start, stop, x, y [, z]"
ALIGNMENTS = {c.LEFT: "LEFT", c.CENTER: "CENTER", c.RIGHT: "RIGHT"}
VERTICAL = {c.TOP: "TOP", c.CENTER: "CENTER", c.BASELINE: "BASELINE", c.BOTTOM: "BOTTOM"}
TEXT_MODES = {c.MODEL: "MODEL", c.SHAPE: "SHAPE"}


class Typesetting(CanvasParts):
    """Size, face and alignment of text, and measuring it.

    A face is made once, at the size in which it is first used; at other sizes its letters are
    enlarged, and its ascent and descent in proportion, as in Processing.
    """

    def textSize(self, size: float) -> None:
        """Set the size of text; the distance of lines follows it.

        Parameters
        ----------
        size : float, pixels
            At first 12.

        See Also
        --------
        text, textLeading, textFont

        Notes
        -----
        In P2D and P3D the letters of a face are made for the size in which it is first used, and
        enlarged for others; a font of `createFont()` for each size, or `textMode(SHAPE)`, is crisp.
        In JAVA2D all text is. A size that is not above 0 is ignored, with a warning. Source:
        Processing's reference, textSize().

        Examples
        --------
        >>> textSize(32)
        >>> text("word", 10, 50)
        """
        try:
            wanted = f32(size + 0.0)
        except TypeError:
            self._refuse("textSize", (size,), "size")
        if wanted <= 0:
            warn_once(f"textSize({shown(size)}) has no effect: the size is above 0.")
        elif self._typography.design_size:
            self._size_text(wanted)
        else:
            self._use_face(DEFAULT_FACE, wanted)

    def _size_text(self, size: float) -> None:
        self._typography = replace(self._typography, size=size)
        leading = f32(f32(self.textAscent() + self.textDescent()) * LEADING)
        self._typography = replace(self._typography, leading=leading)

    def _use_face(self, face: Typeface, size: float) -> None:
        """Set text in a face, made at a size."""
        made_at = letters_of(face).own_size or design_size(size)
        self._typography = replace(self._typography, face=face, design_size=made_at, size=size)
        self._size_text(size)

    def _typeset(self) -> Typography:
        """Return how text is set; the face is made when it is first needed."""
        if not self._typography.design_size:
            self._use_face(DEFAULT_FACE, FIRST_SIZE)
        return self._typography

    def _set_face(self) -> Face:
        """Return the face that text is set in, at its size."""
        typography = self._typeset()
        made_at, size, is_java2d = typography.design_size, typography.size, self._stage.is_java2d
        return fonts_of(self._renderer).set(
            Setting(
                *(typography.face, made_at, size, made_at),
                is_hinted=not is_java2d,
                is_kerned=is_java2d and size != made_at,  # so Processing makes the faces of JAVA2D
            )
        )

    def textAlign(self, alignX: int, alignY: int = c.BASELINE) -> None:
        """Set which point of a text its x and y are.

        Parameters
        ----------
        alignX : LEFT, CENTER or RIGHT
        alignY : TOP, CENTER, BOTTOM or BASELINE
            Of several lines, all together.

        Raises
        ------
        SketchError
            If it is none of these.

        See Also
        --------
        text, textAscent, textDescent

        Notes
        -----
        Source: Processing's reference, textAlign().

        Examples
        --------
        >>> textAlign(CENTER, CENTER)
        >>> text("word", 50, 50)
        """
        across = chosen("textAlign", alignX, ALIGNMENTS, c.LEFT)
        down = chosen("textAlign", alignY, VERTICAL, c.BASELINE)
        self._typography = replace(self._typography, align_x=across, align_y=down)

    def textLeading(self, leading: float) -> None:
        r"""Set the distance from line to line, until the next `textSize()` or `textFont()`.

        Parameters
        ----------
        leading : float, pixels

        See Also
        --------
        textSize, text

        Notes
        -----
        The first text of a sketch that has called neither of these sets size and leading anew, as
        in Processing. Source: Processing's reference, textLeading().

        Examples
        --------
        >>> textSize(12)
        >>> textLeading(30)
        >>> text("two\nlines", 10, 30)
        """
        try:
            self._typography = replace(self._typography, leading=f32(leading + 0.0))
        except TypeError:
            self._refuse("textLeading", (leading,), "leading")

    def textWidth(self, what: object, start: float = 0, length: float | None = None) -> float:
        """Return how wide a text is, in pixels; of several lines, the widest.

        Parameters
        ----------
        what : str or number
        start, length : int, optional
            Of a list of characters: the first one that counts, and how many.

        Raises
        ------
        SketchError
            If the list has no such characters.

        See Also
        --------
        text, textAscent

        Notes
        -----
        The sum of its letters' widths: each a whole number in P2D and P3D. Source: Processing's
        reference, textWidth().

        Examples
        --------
        >>> line(10, 52, 10 + textWidth("word"), 52)
        >>> text("word", 10, 50)
        """
        if length is None:
            written = as_text(what)
        elif isinstance(what, Sequence):
            written = characters("textWidth", what, start, start + length)
        else:
            self._refuse("textWidth", (what, start, length), TEXTWIDTH_USAGE)
        return max(map(self._set_face().width, written.split("\n")))

    def textAscent(self) -> float:
        """Return how far letters reach above the baseline, in pixels.

        Examples
        --------
        >>> textSize(32)
        >>> line(0, 60 - textAscent(), 100, 60 - textAscent())
        >>> text("dog", 10, 60)
        """
        return self._set_face().ascent

    def textDescent(self) -> float:
        """Return how far letters reach below the baseline, in pixels.

        Examples
        --------
        >>> textSize(32)
        >>> line(0, 60 + textDescent(), 100, 60 + textDescent())
        >>> text("dog", 10, 60)
        """
        return self._set_face().descent

    def textMode(self, mode: int) -> None:
        """Choose how letters are drawn.

        Parameters
        ----------
        mode : MODEL or SHAPE
            MODEL, at first: as images, made for the size of the text. SHAPE: as filled shapes,
            which are crisp at every size and under every transform, and take more time.

        Raises
        ------
        SketchError
            If it is neither.

        See Also
        --------
        text, createFont

        Notes
        -----
        JAVA2D knows MODEL alone, and is as crisp. As other shapes, SHAPE obeys `noFill()`, lights
        and `blendMode()`. Source: Processing's reference, textMode().

        Examples
        --------
        >>> size(200, 100, P2D)
        >>> textMode(SHAPE)
        >>> scale(5)
        >>> text("word", 5, 15)
        """
        check_choice("textMode", mode, TEXT_MODES)
        if mode == c.SHAPE and self._stage.is_java2d:
            warn_once("textMode(SHAPE) has no effect in JAVA2D; size() with P2D or P3D has it.")
            return
        self._typography = replace(self._typography, mode=mode)


def as_text(what: object) -> str:
    """Return what `text()` shows of a value: of a float a sign or a space, and three decimals."""
    if isinstance(what, str):
        return what
    if isinstance(what, bool) or hasattr(what, "__index__") or not hasattr(what, "__float__"):
        return str(what)
    number = float(what)
    return nfs(number, 0, 3) if math.isfinite(number) else str(number)


def characters(caller: str, what: Sequence[object], start: float, stop: float) -> str:
    """Return characters of a list, from one place to before another, as a text.

    Raises
    ------
    SketchError
        If the list has not got them.
    """
    try:
        first, end = int(start), int(stop)
    except (TypeError, ValueError):
        raise wrong_numbers(caller, (what, start, stop), CHARACTERS_USAGE) from None
    if not 0 <= first <= end <= len(what):
        raise SketchError(
            f"{caller}() takes characters of a list that has {len(what)} of them.",
            got=f"from {first} to before {end}",
        )
    return "".join(chr(one) if isinstance(one, int) else str(one) for one in what[first:end])
