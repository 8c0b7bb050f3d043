"""Faces: how wide text is, and where its letters lie.

How crisp text is, was a choice. Processing's P2D and P3D draw the letters of a face once, at the
size in which it is first used; at every other size and under every transform they enlarge these
images, smoothed. Three ways were measured, as the share of pixels within 2/255 of Processing's:

- Letters made anew for every size: 0.93 for a page on which `textSize()` changes. Text of the
  default face is on most pages, so `textSize()` does as in Processing, to the last bit.
- Letters made anew where a transform enlarges them: 1.00 as long as none does, 0.95 to 0.97 in
  scenes with `scale(2)` and `scale(4)`. There Processing's blur is a fault that no sketch wants,
  and so this is done. They are made at the face's size times a power of the square root of 2: a
  camera that flies into a text passes a dozen sizes, not one for each frame.
- JAVA2D draws each letter at its size on the screen, as Java does.

`createFont()` for each size and `textMode(SHAPE)` are crisp everywhere, here and in Processing.
"""

from __future__ import annotations

import math
import weakref
from collections.abc import Iterator
from functools import cached_property
from itertools import chain, pairwise, repeat
from typing import NamedTuple
from unicodedata import normalize

from sketchkit.assets.fonts.glyph_atlas import GlyphAtlas, Letter
from sketchkit.assets.fonts.letters import BLANK, Shape, letters_of
from sketchkit.core.float32 import f32
from sketchkit.core.style import Typeface
from sketchkit.draw.resources import Pixels

LARGEST = 512  # px; the shapes of larger text are made at this size, and enlarged
MOST_FACES = 256  # that are kept; a sketch may set text in a new size in each frame
MOST_ATLASES = 32  # of faces at the sizes they were made for
MOST_IMAGES = 4  # of letters at other sizes; when more are needed, all of these are given up
MOST_LINES = 2048  # whose layout is kept, of all faces: of short ones, 2 kB each
LAST_UNIT = "\uffff"  # the last character that is one for Java; those behind are two
NOTICEABLE = 1.5  # times larger: Processing's own pixels up to here, where its blur hardly shows


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


class Setting(NamedTuple):
    """How a face is set. Sizes are pixels.

    Attributes
    ----------
    made_at : int
        The size that ascent and descent are measured at.
    size : float
        Of the text, in the units of the sketch.
    drawn_at : float
        The size at which the letters' images are made.
    is_hinted : bool
        As in P2D and P3D. Without hints, as in JAVA2D, letters still begin at whole pixels.
    is_kerned : bool
        Whether some pairs of letters are closer than others.
    """

    typeface: Typeface
    made_at: int
    size: float
    drawn_at: float
    is_hinted: bool = True
    is_kerned: bool = False


class Face:
    """A face in a setting. Widths are those of the size of the text, wherever letters come from."""

    def __init__(self, setting: Setting, atlas: GlyphAtlas, layouts: Layouts) -> None:
        self.setting = setting
        self._letters = letters_of(setting.typeface)
        self._atlas = atlas
        self._advances: dict[str, float] = {}
        self._widths: dict[str, float] = {}
        self._layouts = layouts
        self._lines = layouts.of_a_face()

    def width(self, text: str) -> float:
        """Return how wide a line of text is: the sum of its letters and their kerning."""
        width = self._widths.get(text)
        if width is None:
            width = sum(map(self.advance, text), 0.0) + sum(self._kernings(text), 0.0)
            if len(self._widths) >= MOST_LINES:
                self._widths.clear()
            self._widths[text] = width
        return width

    def _kernings(self, text: str) -> Iterator[float]:
        """Yield what is between each letter and the next."""
        if self.setting.is_kerned:
            for first, second in pairwise(text):
                yield self._letters.kerning(first, second, self.setting.size)

    def advance(self, character: str) -> float:
        """Return how far the pen moves for a character."""
        width = self._advances.get(character)
        if width is None:
            setting = self.setting
            width = self._letters.advance(character, setting.size, is_hinted=setting.is_hinted)
            self._advances[character] = width
        return width

    @cached_property
    def ascent(self) -> float:
        """Pixels above the baseline."""
        return self._enlarged(self._letters.heights(self.setting.made_at)[0])

    @cached_property
    def descent(self) -> float:
        """Pixels below the baseline."""
        return self._enlarged(self._letters.heights(self.setting.made_at)[1])

    def line(self, text: str) -> Line:
        """Return text laid out; the letters are in the atlas afterwards."""
        line = self._lines.get(text)
        if line is None or line.growths != self._atlas.growths:
            # Java joins accents with their letters, P2D and P3D put them behind.
            composed = text if self.setting.is_hinted else normalize("NFC", text)
            self.place(composed)
            line = self._lay_out(composed)
            self._layouts.keep(self._lines, text, line)
        return line

    def place(self, text: str) -> None:
        """Put letters into the atlas, if they are not there yet."""
        for character in text:
            shape = self._shape(character)
            if shape is not None:
                self._atlas.place(self._letter(character, shape), shape.mask)

    def _lay_out(self, text: str) -> Line:
        quads = []
        pen = 0.0
        kernings = chain(self._kernings(text), repeat(0.0))
        for character, kerning in zip(text, kernings, strict=False):
            shape = self._shape(character)
            if shape is not None and shape is not BLANK:
                begin = pen if self.setting.is_hinted else math.floor(pen + 0.5)
                quads.append(self._quad(self._letter(character, shape), shape, begin))
            pen += self.advance(character) + kerning
            if character > LAST_UNIT and self.setting.is_hinted:
                pen += self.advance(character)  # P2D and P3D see two characters in these
        return Line(self.width(text), tuple(quads), self._atlas.growths)

    def _quad(self, letter: Letter, shape: Shape, pen: float) -> Quad:
        image, column, row = self._atlas.place(letter, shape.mask)
        pixels = self._atlas.image(image)
        height, width = shape.mask.shape
        return Quad(
            *(pixels, pen + self._scaled(shape.left), self._scaled(shape.top)),
            *(self._scaled(width), self._scaled(height)),
            *(column / pixels.width, row / pixels.height),
            *((column + width) / pixels.width, (row + height) / pixels.height),
        )

    def _scaled(self, length: int) -> float:
        """Return pixels of the shapes at the size of the text, rounded as Processing does.

        P2D and P3D divide and multiply, even by the same size, and may miss whole pixels by a bit.
        """
        if not self.setting.is_hinted and self.setting.drawn_at == self.setting.size:
            return float(length)
        return f32(f32(length / self.setting.drawn_at) * f32(self.setting.size))

    def _enlarged(self, length: int) -> float:
        """Return pixels at the size it was made for, at the size of the text."""
        return f32(f32(length / self.setting.made_at) * f32(self.setting.size))

    def _shape(self, character: str) -> Shape | None:
        setting = self.setting
        return self._letters.shape(character, setting.drawn_at, is_hinted=setting.is_hinted)

    def _letter(self, character: str, shape: Shape) -> Letter:
        setting = self.setting
        return Letter(
            *(setting.typeface, setting.drawn_at, setting.is_hinted),
            *(character, shape.left, shape.top),
        )


class Layouts:
    """The lines that were laid out, of all faces; when there are many, all are forgotten."""

    def __init__(self) -> None:
        self._all: list[dict[str, Line]] = []
        self._count = 0

    def of_a_face(self) -> dict[str, Line]:
        """Return room for the lines of one face."""
        self._all.append({})
        return self._all[-1]

    def keep(self, lines: dict[str, Line], text: str, line: Line) -> None:
        """Keep a line of a face."""
        if self._count >= MOST_LINES:
            self._count = 0
            for every in self._all:
                every.clear()
        lines[text] = line
        self._count += 1


class Fonts:
    """The faces of one sketch, and the images in which their letters lie.

    Each face has images of its own for the size that it was made for, as in Processing. Letters
    at all other sizes share some: a page of them is one draw, and there are never many.
    """

    def __init__(self) -> None:
        self._atlases: dict[tuple[Typeface, int], GlyphAtlas] = {}
        self._shared = GlyphAtlas()
        self._faces: dict[Setting, Face] = {}
        self._layouts = Layouts()

    def face(self, typeface: Typeface, made_at: int, size: float) -> Face:
        """Return a face whose letters are enlarged from the size it was made for."""
        return self.set(Setting(typeface, made_at, size, made_at))

    def set(self, setting: Setting) -> Face:
        """Return a face in a setting."""
        if self._shared.image_count > MOST_IMAGES:
            self._forget()
        found = self._faces.get(setting)
        if found is None:
            if len(self._faces) > MOST_FACES or len(self._atlases) > MOST_ATLASES:
                self._forget()
            found = self._faces[setting] = Face(setting, self._atlas(setting), self._layouts)
            found.place(letters_of(setting.typeface).made_at_once)
        return found

    def _atlas(self, setting: Setting) -> GlyphAtlas:
        if not setting.is_hinted or setting.drawn_at != setting.made_at:
            return self._shared
        key = setting.typeface, setting.made_at
        if key not in self._atlases:
            self._atlases[key] = GlyphAtlas(setting.made_at)
        return self._atlases[key]

    def _forget(self) -> None:
        """Begin anew. What has been recorded keeps its images until it is drawn."""
        if self._shared.image_count > MOST_IMAGES:
            self._shared = GlyphAtlas()
        if len(self._atlases) > MOST_ATLASES:
            self._atlases.clear()
        self._faces.clear()
        self._layouts = Layouts()


_fonts: weakref.WeakKeyDictionary[object, Fonts] = weakref.WeakKeyDictionary()


def fonts_of(owner: object) -> Fonts:
    """Return the fonts of a sketch, `owner` being its renderer.

    Each has its own, so that its pictures do not depend on what else was drawn in the process.
    """
    found = _fonts.get(owner)
    if found is None:
        found = _fonts[owner] = Fonts()
    return found


def design_size(size: float) -> int:
    """Return the whole size at which a face is made that is first used at some size."""
    return min(max(1, int(size + 0.5)), LARGEST)


def enlarged_size(made_at: int, enlargement: float) -> int:
    """Return the size at which letters are drawn anew that a transform enlarges.

    It is that of the face where it makes them but a little larger, or smaller.
    """
    steps = round(2 * math.log2(enlargement)) if enlargement >= NOTICEABLE else 0
    return min(round(made_at * 2 ** (steps / 2)), max(LARGEST, made_at))
