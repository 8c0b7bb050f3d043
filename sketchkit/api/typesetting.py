"""How text is set: size, face and alignment, and how much room it takes."""

from __future__ import annotations

import math
from dataclasses import replace

from sketchkit.api._parts import CanvasParts
from sketchkit.api.pfont import PFont
from sketchkit.api.style import check_choice
from sketchkit.assets.fonts import FONT_FILES, Face, design_size, find_face, fonts_of
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.float32 import f32
from sketchkit.core.notices import warn_once
from sketchkit.core.style import Typography
from sketchkit.data.strings import nfs

LEADING = f32(1.275)  # from line to line, in heights of a letter from ascent to descent
FIRST_SIZE = 12.0
CREATEFONT_USAGE = "name, size"
TEXTALIGN_USAGE = "horizontal [, vertical]"
TEXTFONT_USAGE = "font [, size]"
TEXTWIDTH_USAGE = "text"
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
        A size that is not above 0 is ignored, with a warning. Source: Processing's reference,
        textSize().

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
            self._use_face("", wanted)

    def _size_text(self, size: float) -> None:
        self._typography = replace(self._typography, size=size)
        leading = f32(f32(self.textAscent() + self.textDescent()) * LEADING)
        self._typography = replace(self._typography, leading=leading)

    def _use_face(self, path: str, size: float) -> None:
        """Set text in a face, made at a size."""
        self._typography = replace(
            self._typography, face=path, design_size=design_size(size), size=size
        )
        self._size_text(size)

    def _typeset(self) -> Typography:
        """Return how text is set; the face is made when it is first needed."""
        if not self._typography.design_size:
            self._use_face("", FIRST_SIZE)
        return self._typography

    def _set_face(self) -> Face:
        """Return the face that text is set in, at its size."""
        typography = self._typeset()
        fonts = fonts_of(self._renderer)
        return fonts.face(typography.face, typography.design_size, typography.size)

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
        check_choice("textAlign", alignX, ALIGNMENTS)
        check_choice("textAlign", alignY, VERTICAL)
        self._typography = replace(self._typography, align_x=alignX, align_y=alignY)

    def textLeading(self, leading: float) -> None:
        r"""Set the distance from line to line, until the next `textSize()`.

        Parameters
        ----------
        leading : float, pixels

        Examples
        --------
        >>> textLeading(30)
        >>> text("two\nlines", 10, 30)
        """
        try:
            self._typography = replace(self._typeset(), leading=f32(leading + 0.0))
        except TypeError:
            self._refuse("textLeading", (leading,), "leading")

    def textWidth(self, what: object) -> float:
        """Return how wide a text is, in pixels; of several lines, the widest.

        Parameters
        ----------
        what : str or number

        See Also
        --------
        text, textAscent

        Notes
        -----
        The sum of its letters' widths, each a whole number. Source: Processing's reference,
        textWidth().

        Examples
        --------
        >>> line(10, 52, 10 + textWidth("word"), 52)
        >>> text("word", 10, 50)
        """
        return max(map(self._set_face().width, as_text(what).split("\n")))

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
        """Accept MODEL or SHAPE; text looks the same in both.

        Examples
        --------
        >>> textMode(SHAPE)
        >>> text("word", 10, 50)
        """
        check_choice("textMode", mode, TEXT_MODES)

    def createFont(
        self, name: str, size: float, smooth: bool = True, charset: object = None
    ) -> PFont:
        """Make a font for `textFont()`.

        Parameters
        ----------
        name : str
            A TTF or OTF file in the sketch's `data` folder, or beside the sketch. For the name of
            a font of the system, the default face is taken: it looks the same everywhere.
        size : float, pixels
        smooth, charset : optional
            Accepted as in Processing; letters are always smooth, and made when they are needed.

        Returns
        -------
        PFont

        Raises
        ------
        SketchError
            If there is no such file, or it is no font.

        See Also
        --------
        textFont, text

        Notes
        -----
        Source: Processing's reference, createFont().

        Examples
        --------
        >>> font = createFont("", 32)
        >>> textFont(font)
        >>> text("word", 10, 50)
        """
        try:
            is_positive = size > 0
        except TypeError:
            self._refuse("createFont", (name, size), CREATEFONT_USAGE)
        if not is_positive:
            raise SketchError("createFont() takes a size above 0.", got=shown(size))
        if str(name).lower().endswith(FONT_FILES):
            return PFont(find_face("createFont", name), size)
        if name:
            warn_once(
                f"createFont({shown(name)}): the default face takes its place. For another one put "
                "its TTF or OTF file into the sketch's data folder."
            )
        return PFont("", size)

    def textFont(self, which: PFont, size: float | None = None) -> None:
        """Set text in a font from now on.

        Parameters
        ----------
        which : PFont
            From `createFont()`.
        size : float, pixels, optional
            Otherwise the size that it was made for.

        Raises
        ------
        SketchError
            If it is no font.

        Notes
        -----
        Source: Processing's reference, textFont().

        Examples
        --------
        >>> textFont(createFont("", 24))
        >>> text("word", 10, 50)
        """
        if not isinstance(which, PFont):
            raise SketchError(
                "textFont() takes a font.", got=shown(which), hint="createFont() makes one."
            )
        self._use_face(which._path, which._size)
        if size is not None:
            self.textSize(size)


def as_text(what: object) -> str:
    """Return what `text()` shows of a value: of a float a sign or a space, and three decimals."""
    if isinstance(what, str):
        return what
    if isinstance(what, bool) or hasattr(what, "__index__") or not hasattr(what, "__float__"):
        return str(what)
    number = float(what)
    return nfs(number, 0, 3) if math.isfinite(number) else str(number)
