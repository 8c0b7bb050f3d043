"""PFont: a face that a sketch has made for its text."""

from __future__ import annotations

from pathlib import Path

from sketchkit.assets.fonts import design_size, heights


class PFont:
    """A font at a size: `createFont()` makes one, `textFont()` uses it.

    Parameters
    ----------
    path : str
        The font's file; "" is the default face.
    size : float, pixels

    Notes
    -----
    Source: Processing's reference, PFont.

    Examples
    --------
    >>> font = createFont("", 24)
    >>> textFont(font)
    >>> text("word", 10, 50)
    """

    def __init__(self, path: str, size: float) -> None:
        self._path = path
        self._size = size

    def getName(self) -> str:
        """Return the name of the font's file, without its ending.

        Examples
        --------
        >>> println(createFont("", 24).getName())
        """
        return Path(self._path).stem or "Source Sans Pro"

    def getSize(self) -> int:
        """Return the size that the font was made for, in pixels.

        Examples
        --------
        >>> println(createFont("", 24).getSize())
        """
        return design_size(self._size)

    def ascent(self) -> float:
        """Return how far letters reach above the baseline, as a part of the size.

        Examples
        --------
        >>> println(createFont("", 24).ascent())
        """
        return heights(self._path, self.getSize())[0] / self.getSize()

    def descent(self) -> float:
        """Return how far letters reach below the baseline, as a part of the size.

        Examples
        --------
        >>> println(createFont("", 24).descent())
        """
        return heights(self._path, self.getSize())[1] / self.getSize()

    def __repr__(self) -> str:
        return f"<PFont {self.getName()}, {self._size:g}>"
