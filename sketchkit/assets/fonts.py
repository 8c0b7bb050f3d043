"""Faces: how wide text is, and where its letters lie.

FreeType draws the letters, through Pillow, with the hints that the face has: so Java does, and the
default face comes out as Processing's to the last bit.
"""

from __future__ import annotations

import os
import weakref
from functools import cached_property, lru_cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.glyph_atlas import MOST_COLUMNS, GlyphAtlas
from sketchkit.assets.paths import find_file
from sketchkit.core.errors import SketchError
from sketchkit.core.float32 import f32
from sketchkit.draw.resources import Pixels

if TYPE_CHECKING:
    from PIL import ImageFont

U8 = NDArray[np.uint8]

FONT_FILES = (".ttf", ".otf", ".ttc")
LARGEST = 512  # px; the shapes of larger text are made at this size, and enlarged
MOST_FACES = 256  # that are kept; a sketch may set text in a new size in each frame
MOST_LINES = 4096  # whose layout is kept, for each face
WITHOUT_WIDTH = frozenset("\t\r\n\u2028\u2029")  # Java gives them neither width nor shape


class Quad(NamedTuple):
    """A letter of a line.

    Attributes
    ----------
    pixels : Pixels
        The atlas that it lies in.
    left, top : float, pixels
        From the line's origin: its left end, on the baseline.
    width, height : float, pixels
    u1, v1, u2, v2 : float
        Its left, top, right and bottom in the atlas, 0..1.
    """

    pixels: Pixels
    left: float
    top: float
    width: float
    height: float
    u1: float
    v1: float
    u2: float
    v2: float


class Line(NamedTuple):
    """Text laid out: its width in pixels, its letters, and how large the atlas was then."""

    width: float
    quads: tuple[Quad, ...]
    growths: int


class Shape(NamedTuple):
    """A letter's mask, (h, w) uint8, and where its top left corner is from the pen, y down."""

    mask: U8
    left: int
    top: int


BLANK = Shape(np.zeros((1, 1), np.uint8), 0, 0)


class Face:
    """A face whose letters were drawn at one size, `made_at`, and that is set in another.

    Letters are enlarged, and not drawn anew, as in Processing: the widths are those of a face
    that was made for the size.
    """

    def __init__(self, path: str, made_at: int, size: float, atlas: GlyphAtlas) -> None:
        self._path = path
        self._made_at = made_at
        self._size = size
        self._atlas = atlas
        self._advances: dict[str, float] = {}
        self._lines: dict[str, Line] = {}

    def width(self, text: str) -> float:
        """Return how wide a line of text is: the sum of whole pixels, without kerning."""
        return sum(map(self.advance, text), 0.0)

    def advance(self, character: str) -> float:
        """Return how far the pen moves for a character."""
        width = self._advances.get(character)
        if width is None:
            is_blank = character in WITHOUT_WIDTH
            font = _open(self._path, self._size)
            width = 0.0 if is_blank else float(round(font.getlength(character)))
            self._advances[character] = width
        return width

    @cached_property
    def ascent(self) -> float:
        """Pixels above the baseline."""
        return self._scaled(heights(self._path, self._made_at)[0])

    @cached_property
    def descent(self) -> float:
        """Pixels below the baseline."""
        return self._scaled(heights(self._path, self._made_at)[1])

    def line(self, text: str) -> Line:
        """Return text laid out; the letters are in the atlas afterwards."""
        line = self._lines.get(text)
        if line is None or line.growths != self._atlas.growths:
            self._place_letters(text)
            line = self._lay_out(text)
            if len(self._lines) >= MOST_LINES:
                self._lines.clear()
            self._lines[text] = line
        return line

    def _place_letters(self, text: str) -> None:
        for character in text:
            self._atlas.place(character, self._shape(character).mask)

    def _lay_out(self, text: str) -> Line:
        quads = []
        pen = 0.0
        for character in text:
            if self._shape(character) is not BLANK:
                quads.append(self._quad(character, pen))
            pen += self.advance(character)
        return Line(pen, tuple(quads), self._atlas.growths)

    def _quad(self, character: str, pen: float) -> Quad:
        mask, left, top = self._shape(character)
        image, column, row = self._atlas.place(character, mask)
        pixels = self._atlas.image(image)
        height, width = mask.shape
        return Quad(
            *(pixels, pen + self._scaled(left), self._scaled(top)),
            *(self._scaled(width), self._scaled(height)),
            *(column / pixels.width, row / pixels.height),
            *((column + width) / pixels.width, (row + height) / pixels.height),
        )

    def _scaled(self, length: int) -> float:
        """Return pixels of the shapes at the size of the text, rounded as Processing does."""
        return f32(f32(length / self._made_at) * f32(self._size))

    def _shape(self, character: str) -> Shape:
        return _draw(self._path, self._made_at, character)


class Fonts:
    """The faces of one sketch, and the images in which their letters lie."""

    def __init__(self) -> None:
        self._atlases: dict[tuple[str, int], GlyphAtlas] = {}
        self._faces: dict[tuple[str, int, float], Face] = {}

    def face(self, path: str, made_at: int, size: float) -> Face:
        """Return a face, drawn and set at sizes in pixels; "" is the path of the default face."""
        key = path, made_at, size
        found = self._faces.get(key)
        if found is None:
            if len(self._faces) >= MOST_FACES:
                self._faces.clear()
            atlas = self._atlases.setdefault((path, made_at), GlyphAtlas(made_at))
            found = self._faces[key] = Face(path, made_at, size, atlas)
        return found


_fonts: weakref.WeakKeyDictionary[object, Fonts] = weakref.WeakKeyDictionary()


def fonts_of(owner: object) -> Fonts:
    """Return the fonts of a sketch, `owner` being its renderer.

    Each has its own, so that its pictures do not depend on what else was drawn in the process.
    """
    found = _fonts.get(owner)
    if found is None:
        found = _fonts[owner] = Fonts()
    return found


def heights(path: str, size: int) -> tuple[int, int]:
    """Return pixels above the baseline, of a "d", and below it, of a "p", as Processing does."""
    tall, deep = _draw(path, size, "d"), _draw(path, size, "p")
    return -tall.top, deep.top + deep.mask.shape[0]


def design_size(size: float) -> int:
    """Return the whole size at which a face is made that is first used at some size."""
    return min(max(1, int(size + 0.5)), LARGEST)


def find_face(caller: str, filename: str) -> str:
    """Return the path of a font file that a sketch names.

    Raises
    ------
    SketchError
        If there is no such file, or it is no font.
    """
    path = str(find_file(caller, filename))
    _open(path, 12)
    return path


@lru_cache(maxsize=8192)
def _draw(path: str, size: int, character: str) -> Shape:
    """Return the shape of a letter."""
    if character in WITHOUT_WIDTH:
        return BLANK
    drawn, (left, top) = _open(path, size).getmask2(character, mode="L", anchor="ls")
    width, height = drawn.size
    mask = np.frombuffer(bytes(drawn), np.uint8).reshape(height, width)
    # Where its edge lies shows when it is enlarged: at the first pixel that is covered at all.
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if not len(rows):
        return BLANK
    tight = mask[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    return Shape(tight[:, :MOST_COLUMNS], left + int(columns[0]), top + int(rows[0]))


@lru_cache(maxsize=256)
def _open(path: str, size: float) -> ImageFont.FreeTypeFont:
    # The older way of reading hints is Java's; only thus are % and " the same to the last bit. It
    # has to be chosen before FreeType is loaded.
    os.environ.setdefault("FREETYPE_PROPERTIES", "truetype:interpreter-version=35")
    from PIL import ImageFont  # 40 ms to import, and most sketches write nothing

    try:
        # The basic layout puts letter after letter, as Processing does.
        return ImageFont.truetype(path or _default(), size, layout_engine=ImageFont.Layout.BASIC)
    except OSError as problem:
        raise SketchError(
            f"The font {path} cannot be read: {problem}.", hint="Fonts are TTF or OTF files."
        ) from None


@lru_cache(maxsize=1)
def _default() -> str:
    """Return the file of the default face: Processing's own is a copy of it."""
    return str(Path(str(files("font_source_sans_pro"))) / "files" / "SourceSansPro-Regular.ttf")
