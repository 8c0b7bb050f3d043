"""Making fonts, and choosing one."""

from __future__ import annotations

from collections.abc import Iterable

from sketchkit.api.pfont import PFont
from sketchkit.api.typesetting import FIRST_SIZE, Typesetting
from sketchkit.assets.fonts.letters import BITMAPS, OUTLINES, check_font
from sketchkit.assets.fonts.system_fonts import font_file
from sketchkit.assets.paths import find_file
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.notices import warn_once
from sketchkit.core.style import Typeface

CREATEFONT_USAGE = "name, size [, smooth [, characters]]"
DEFAULT_NAMES = ("", "Source Sans Pro", "Processing Sans Pro")


class FontChoice(Typesetting):
    """Fonts from files and from the computer."""

    def createFont(
        self,
        name: str,
        size: float,
        smooth: bool = True,
        charset: Iterable[str] | None = None,
    ) -> PFont:
        """Make a font for `textFont()`.

        Parameters
        ----------
        name : str
            A TTF or OTF file in the sketch's `data` folder, or beside the sketch. Or the name of a
            font of the computer, one of `PFont.list()`: others may not have that. If this computer
            has not, the default face takes its place.
        size : float, pixels
        smooth : bool
            Whether edges of letters are blended with what is behind them.
        charset : list of str, optional
            The characters that are drawn; otherwise all that the font has.

        Returns
        -------
        PFont

        Raises
        ------
        SketchError
            If there is no such file, or it is no font.

        See Also
        --------
        textFont, text, loadFont

        Notes
        -----
        Text is crisp in a font that was made for its size. Source: Processing's reference,
        createFont().

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
        if str(name).lower().endswith(BITMAPS):
            return self.loadFont(name)
        chosen = None if charset is None else frozenset(map(str, charset))
        return PFont(self, Typeface(_outlines_of(name), bool(smooth), chosen), size)

    def loadFont(self, filename: str) -> PFont:
        """Load a font from a file.

        Parameters
        ----------
        filename : str
            A .vlw file, which Processing's "Create Font" makes, or a TTF or OTF file; looked for
            in the sketch's `data` folder, then beside the sketch.

        Returns
        -------
        PFont

        Raises
        ------
        SketchError
            If there is no such file, or it is no font.

        See Also
        --------
        createFont, textFont

        Notes
        -----
        A .vlw file has letters of one size, which other sizes enlarge. A TTF file is made for the
        size with which it is first used. Source: Processing's reference, loadFont(), which takes
        .vlw files alone.

        Examples
        --------
        >>> font = loadFont("Serif-32.vlw")  # doctest: +SKIP
        >>> textFont(font, 32)  # doctest: +SKIP
        """
        path = str(find_file("loadFont", filename))
        if not path.lower().endswith(BITMAPS):
            check_font(path)
        return PFont(self, Typeface(path), None)

    def textFont(self, which: PFont, size: float | None = None) -> None:
        """Set text in a font from now on.

        Parameters
        ----------
        which : PFont
            From `createFont()` or `loadFont()`.
        size : float, pixels, optional
            Otherwise the size that it was made for, a whole number.

        Raises
        ------
        SketchError
            If it is no font.

        See Also
        --------
        createFont, loadFont, textSize

        Notes
        -----
        A size that is not above 0 is ignored, with a warning. Source: Processing's reference,
        textFont().

        Examples
        --------
        >>> textFont(createFont("", 24))
        >>> text("word", 10, 50)
        """
        if not isinstance(which, PFont):
            raise SketchError(
                "textFont() takes a font.", got=shown(which), hint="createFont() makes one."
            )
        own_size = which.getSize() if which._size else size or FIRST_SIZE
        self._use_face(which._face, own_size)
        if size is not None:
            self.textSize(size)


def _outlines_of(name: str) -> str:
    """Return the file of a font that a sketch names; "" is the default face."""
    if str(name).lower().endswith(OUTLINES):
        path = str(find_file("createFont", name))
        check_font(path)
        return path
    if name in DEFAULT_NAMES:
        return ""
    if found := font_file(str(name)):
        warn_once(
            f"createFont({shown(name)}) uses a font of this computer, {found}. Others may lack it: "
            "a TTF file in the sketch's data folder goes with the sketch."
        )
        return found
    warn_once(
        f"createFont({shown(name)}): this computer has no such font, so the default face takes its "
        "place. PFont.list() gives the names of those that there are; a TTF file in the sketch's "
        "data folder works everywhere."
    )
    return ""
