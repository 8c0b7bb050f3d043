"""PFont: a face that a sketch has made for its text."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from sketchkit.api._parts import CanvasParts
from sketchkit.api.pconstants import PConstants
from sketchkit.api.pshape.shape import PShape, new_shape
from sketchkit.api.pvector import PVector
from sketchkit.assets.fonts.faces import design_size
from sketchkit.assets.fonts.glyph_outlines import rings, spaced, whole_parts
from sketchkit.assets.fonts.letters import letters_of
from sketchkit.assets.fonts.system_fonts import font_names
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, wrong_numbers
from sketchkit.core.style import Typeface

SOME_SIZE = 12  # px; of a font that has not been used yet
FINE = whole_parts(50)  # of a curve
Names = list[str]  # PFont.list() takes the name away
Points = list[PVector]
TEXTTOPOINTS_USAGE = "text, x, y [, size [, sampleFactor]]"


class PFont(PConstants):
    """A font at a size: `createFont()` makes one, `textFont()` uses it.

    Parameters
    ----------
    canvas : PGraphics
        Where it was made.
    face : Typeface
    size : float, pixels, or None
        None as long as it has not been used.

    Notes
    -----
    Source: Processing's reference, PFont.

    Examples
    --------
    >>> font = createFont("", 24)
    >>> textFont(font)
    >>> text("word", 10, 50)
    """

    def __init__(self, canvas: CanvasParts, face: Typeface, size: float | None) -> None:
        self._canvas = canvas
        self._face = face
        self._letters = letters_of(face)
        self._size = self._letters.own_size or size

    @staticmethod
    def list() -> Names:
        """Return the names of the fonts that this computer has, for `createFont()`.

        See Also
        --------
        createFont

        Notes
        -----
        Source: Processing's reference, PFont.list().

        Examples
        --------
        >>> printArray(PFont.list())  # doctest: +SKIP
        """
        return font_names()

    def getName(self) -> str:
        """Return the name of the font's file, without its ending.

        Examples
        --------
        >>> println(createFont("", 24).getName())
        """
        return Path(self._face.path).stem or "Source Sans Pro"

    def getSize(self) -> int:
        """Return the size that the font was made for, in pixels.

        Examples
        --------
        >>> println(createFont("", 24).getSize())
        """
        return self._letters.own_size or design_size(self._size or SOME_SIZE)

    def getDefaultSize(self) -> int:
        """Return the size in which `textFont()` sets text without another one, in pixels.

        Examples
        --------
        >>> println(createFont("", 24).getDefaultSize())
        """
        return self.getSize()

    def isSmooth(self) -> bool:
        """Return whether edges of letters are blended with what is behind them.

        Examples
        --------
        >>> println(createFont("", 24, False).isSmooth())
        """
        return self._face.is_smooth

    def ascent(self) -> float:
        """Return how far letters reach above the baseline, as a part of the size.

        Examples
        --------
        >>> println(createFont("", 24).ascent())
        """
        return self._letters.heights(self.getSize())[0] / self.getSize()

    def descent(self) -> float:
        """Return how far letters reach below the baseline, as a part of the size.

        Examples
        --------
        >>> println(createFont("", 24).descent())
        """
        return self._letters.heights(self.getSize())[1] / self.getSize()

    def width(self, ch: str) -> float:
        """Return how far a character moves the pen, as a part of the size.

        Parameters
        ----------
        ch : str
            One character.

        See Also
        --------
        textWidth

        Examples
        --------
        >>> println(createFont("", 24).width("m"))
        """
        return self._letters.advance(ch, self.getSize(), is_hinted=True) / self.getSize()

    def textToPoints(
        self,
        text: str,
        x: float,
        y: float,
        size: float | None = None,
        sampleFactor: float = 0.1,
    ) -> Points:
        """Return points along the outlines of a text.

        Parameters
        ----------
        text : str
            One line.
        x, y : float, pixels
            Where it begins on its baseline.
        size : float, pixels, optional
            Otherwise the size that the font was made for.
        sampleFactor : float, points a pixel
            0.1 is a point every 10 pixels.

        Returns
        -------
        list of PVector

        Raises
        ------
        SketchError
            If the font has no outlines, or a number is none.

        See Also
        --------
        createFont, text

        Notes
        -----
        Not in Processing; p5.js has it.

        Examples
        --------
        >>> font = createFont("", 80)
        >>> for p in font.textToPoints("as", 10, 80):
        ...     circle(p.x, p.y, 4)
        """
        self._check_outlines("textToPoints")
        try:
            pen, y, height = x + 0.0, y + 0.0, (size or self.getSize()) + 0.0
            spacing = 1 / sampleFactor / height
        except (TypeError, ZeroDivisionError):
            args = (text, x, y, size, sampleFactor)
            raise wrong_numbers("textToPoints", args, TEXTTOPOINTS_USAGE) from None
        points = []
        for character in text:
            for ring in rings(self._face.path, character, FINE):
                places = spaced(ring, spacing) * height + np.array([pen, y])
                points += [PVector(across, down) for across, down in places.tolist()]
            pen += self._letters.advance(character, height, is_hinted=True)
        return points

    def getShape(self, ch: str, detail: float = 0.0) -> PShape:
        """Return a character as a shape, at the font's size, its pen at (0, 0).

        Parameters
        ----------
        ch : str
            One character.
        detail : float, pixels
            How far, about, lines may be from the curves that they stand for. With 0
            `bezierDetail()` says how many lines there are.

        Returns
        -------
        PShape
            Black, without an outline.

        Raises
        ------
        SketchError
            If the font has no outlines.

        See Also
        --------
        textToPoints, shape

        Notes
        -----
        Source: Processing's PFont.getShape().

        Examples
        --------
        >>> size(200, 200, P2D)
        >>> letter = createFont("", 120).getShape("g")
        >>> shape(letter, 60, 120)
        """
        self._check_outlines("getShape")
        size = self.getSize()
        # A part of a curve that is as long as a letter is high, at most, bulges by so much.
        fine = max(1, math.isqrt(int(size / detail))) if detail > 0 else 0
        count = fine or self._canvas._bezier_detail
        made = new_shape(self._canvas, (PShape.PATH,))
        made.beginShape()
        made.noStroke()
        made.fill(0)
        for i, ring in enumerate(rings(self._face.path, ch, whole_parts(count))):
            if i:
                made.beginContour()
            for x, y in (ring * size).tolist():
                made.vertex(x, y)
            if i:
                made.endContour()
        made.endShape(c.CLOSE)
        return made

    def _check_outlines(self, caller: str) -> None:
        """Refuse a font that is made of images."""
        if self._letters.own_size is not None:
            raise SketchError(
                f"{caller}() needs outlines, and a .vlw font has images of letters instead.",
                hint="createFont() makes a font with outlines of a TTF or OTF file.",
            )

    def __repr__(self) -> str:
        return f"<PFont {self.getName()}, {self.getSize()}>"
