"""Single letters: their shapes and widths, of fonts made of outlines and of fonts made of bitmaps.

FreeType draws outlines, through Pillow. In P2D and P3D letters are drawn with the hints that the
font has, and advance by whole pixels; in JAVA2D without, and by fractions: so Java does, and the
default face comes out as Processing's to the last bit.
"""

from __future__ import annotations

import io
import os
import struct
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.fonts.files import file_of
from sketchkit.assets.fonts.glyph_atlas import MOST_PIXELS
from sketchkit.assets.fonts.hints import as_java_reads, without_hints
from sketchkit.assets.fonts.outlines import exact_advance, pair_kerning
from sketchkit.assets.fonts.vlw import BitmapFont, load_vlw
from sketchkit.core.errors import SketchError
from sketchkit.core.style import Typeface

if TYPE_CHECKING:
    from PIL import ImageFont

# The older way of reading hints is Java's; only thus are % and " the same to the last bit. It has
# to be chosen before anyone, the sketch too, loads FreeType.
os.environ.setdefault("FREETYPE_PROPERTIES", "truetype:interpreter-version=35")

U8 = NDArray[np.uint8]

OUTLINES = (".ttf", ".otf", ".ttc")
BITMAPS = ".vlw"
WITHOUT_WIDTH = frozenset("\t\r\n\u2028\u2029")  # Java gives them neither width nor shape
NOWHERE = "\uffff"  # a code that no font has a letter for
PIXEL = 64  # FreeType counts lengths in 64ths, and factors in 65536ths
ONE = 1 << 16
SMALLEST, LARGEST = 0.5, 65535.0  # sizes that FreeType takes, in pixels
LARGEST_DRAWN = 8192.0  # beyond it a corner of a letter fills what an image of letters can hold


class Shape(NamedTuple):
    """A letter's mask, (h, w) uint8, and where its top left corner is from the pen, y down."""

    mask: U8
    left: int
    top: int


BLANK = Shape(np.zeros((1, 1), np.uint8), 0, 0)


class Letters(Protocol):
    """A font's letters. Sizes are pixels."""

    @property
    def own_size(self) -> int | None:
        """The only size that there is; None for outlines."""
        ...

    @property
    def made_at_once(self) -> str:
        """Characters whose images are made with the face; all others when they are needed."""
        ...

    def shape(self, character: str, size: float, *, is_hinted: bool) -> Shape | None:
        """Return a letter as it is drawn, BLANK if there is nothing to see; None leaves a gap."""
        ...

    def advance(self, character: str, size: float, *, is_hinted: bool) -> float:
        """Return how far the pen moves for a letter."""
        ...

    def kerning(self, first: str, second: str, size: float) -> float:
        """Return how much further two letters are from one another, below 0 as a rule."""
        ...

    def heights(self, size: int) -> tuple[int, int]:
        """Return pixels above the baseline, of a "d", and below it, of a "p", as Processing."""
        ...


class OutlineLetters:
    """Letters of a TTF or OTF file."""

    own_size = None

    def __init__(self, face: Typeface) -> None:
        self._face = face
        self.made_at_once = "".join(sorted(face.characters or ()))

    def shape(self, character: str, size: float, *, is_hinted: bool) -> Shape | None:
        """Return a letter as it is drawn.

        What the font lacks is left out in P2D and P3D, where hints are in force. In JAVA2D it is
        the font's own sign for that, a box as a rule.
        """
        if character in WITHOUT_WIDTH:
            return BLANK
        if is_hinted and not self._has(character):
            return None
        return _draw(self._face.path, size, character, self._face.is_smooth, is_hinted)

    def advance(self, character: str, size: float, *, is_hinted: bool) -> float:
        """Return how far the pen moves for a letter: whole pixels where hints are in force."""
        if character in WITHOUT_WIDTH:
            return 0.0
        if is_hinted:
            return float(round(_open(self._face.path, size).getlength(character)))
        units, em = exact_advance(self._face.path, character)
        scale = round(int(size * PIXEL) * ONE / em)  # FreeType's steps: halves of a pixel show them
        return units * scale // PIXEL / ONE

    def kerning(self, first: str, second: str, size: float) -> float:
        """Return how much further two letters are from one another, below 0 as a rule."""
        return pair_kerning(self._face.path, first, second) * size

    def heights(self, size: int) -> tuple[int, int]:
        """Return pixels above the baseline, of a "d", and below it, of a "p"."""
        tall, deep = (_draw(self._face.path, size, letter, self._face.is_smooth) for letter in "dp")
        return -tall.top, deep.top + deep.mask.shape[0]

    def _has(self, character: str) -> bool:
        chosen = self._face.characters
        return (chosen is None or character in chosen) and _is_in(self._face.path, character)


class BitmapLetters:
    """Letters of a .vlw file: images at one size, which other sizes enlarge."""

    def __init__(self, font: BitmapFont) -> None:
        self._font = font
        self.own_size = font.size
        self.made_at_once = "".join(font.letters)

    def shape(self, character: str, size: float, *, is_hinted: bool) -> Shape | None:
        """Return a letter's image, whatever the size."""
        letter = self._font.letters.get(character)
        if letter is None:
            return None
        return Shape(_cut(letter.mask), letter.left, letter.top)

    def advance(self, character: str, size: float, *, is_hinted: bool) -> float:
        """Return how far the pen moves: not at all for what the file lacks."""
        letter = self._font.letters.get("i" if character == " " else character)  # as Processing
        return 0.0 if letter is None else letter.advance / self._font.size * size

    def kerning(self, first: str, second: str, size: float) -> float:
        """Return 0: such files have none."""
        return 0.0

    def heights(self, size: int) -> tuple[int, int]:
        """Return pixels above and below the baseline, at its own size."""
        return self._font.ascent, self._font.descent


@lru_cache(maxsize=256)
def letters_of(face: Typeface) -> Letters:
    """Return the letters of a face."""
    if face.path.lower().endswith(BITMAPS):
        return BitmapLetters(load_vlw(Path(face.path)))
    return OutlineLetters(face)


def check_font(path: str) -> None:
    """Open a TTF or OTF file.

    Raises
    ------
    SketchError
        If it is no font.
    """
    _open(path, 12)


@lru_cache(maxsize=16384)
def _draw(
    path: str, size: float, character: str, is_smooth: bool = True, is_hinted: bool = True
) -> Shape:
    """Return the shape of a letter."""
    font = _open(path, min(size, LARGEST_DRAWN), is_hinted)
    drawn, (left, top) = font.getmask2(character, mode="L" if is_smooth else "1", anchor="ls")
    width, height = drawn.size
    mask = np.frombuffer(bytes(drawn), np.uint8).reshape(height, width)
    # Where its edge lies shows when it is enlarged: at the first pixel that is covered at all.
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if not len(rows):
        return BLANK
    tight = mask[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    return Shape(_cut(tight), left + int(columns[0]), top + int(rows[0]))


def _cut(mask: U8) -> U8:
    """Return as much of a mask as an image of letters can hold."""
    return mask[:MOST_PIXELS, :MOST_PIXELS]


@lru_cache(maxsize=16384)
def _is_in(path: str, character: str) -> bool:
    """Return whether a font has a letter: it looks otherwise than one that no font has."""
    mine, none = (_draw(path, 64, letter, True, False) for letter in (character, NOWHERE))
    return mine[1:] != none[1:] or not np.array_equal(mine[0], none[0])


@lru_cache(maxsize=64)
def _open(path: str, size: float, is_hinted: bool = True) -> ImageFont.FreeTypeFont:
    size = min(max(size, SMALLEST), LARGEST)
    try:
        original = _bytes(path)
        data = as_java_reads(original, int(size)) if is_hinted else _unhinted(path)
        source = file_of(path) if data is original else io.BytesIO(data)  # each keeps a copy
        return open_outlines(source, size)
    except (OSError, struct.error) as problem:
        raise SketchError(
            f"The font {path} cannot be read: {problem}.", hint="Fonts are TTF or OTF files."
        ) from None


def open_outlines(source: str | io.BytesIO, size: float) -> ImageFont.FreeTypeFont:
    """Return a font of FreeType's.

    Raises
    ------
    OSError
        If it is none.
    """
    from PIL import ImageFont  # 40 ms to import, and most sketches write nothing

    # The basic layout puts letter after letter, as Processing does.
    return ImageFont.truetype(source, size, layout_engine=ImageFont.Layout.BASIC)


@lru_cache(maxsize=32)
def _bytes(path: str) -> bytes:
    return Path(file_of(path)).read_bytes()


@lru_cache(maxsize=32)
def _unhinted(path: str) -> bytes:
    return without_hints(_bytes(path))
