"""Processing's own bitmap fonts, .vlw: one image for each letter, at one size."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.errors import SketchError

U8 = NDArray[np.uint8]

HEADER = struct.Struct(">6i")  # letters, version, size, unused, ascent, descent
LETTER = struct.Struct(">7i")  # code, height, width, advance, top above the baseline, left, unused
NAMED = 10  # the first version with the font's names at the end
SMOOTH = 11  # the one that says whether it is smooth


@dataclass(frozen=True)
class BitmapLetter:
    """A letter: its mask, (h, w) uint8, where that begins from the pen, y down, and its width."""

    mask: U8
    left: int
    top: int
    advance: int


@dataclass(frozen=True)
class BitmapFont:
    """What a .vlw file holds; lengths are pixels at its size."""

    size: int
    ascent: int
    descent: int
    letters: dict[str, BitmapLetter]
    name: str = ""
    postscript_name: str = ""
    is_smooth: bool = True


def load_vlw(path: Path) -> BitmapFont:
    """Return the font of a .vlw file.

    Raises
    ------
    SketchError
        If it is none.
    """
    try:
        return read_vlw(path.read_bytes())
    except (struct.error, ValueError, OverflowError, UnicodeDecodeError):
        raise SketchError(
            f"The font {path.name} cannot be read: it is no .vlw file, or not a whole one.",
            hint="Processing's Tools > Create Font makes such files; createFont() reads TTF files.",
        ) from None


def read_vlw(data: bytes) -> BitmapFont:
    """Return the font that is written in bytes: header, letters' numbers, masks, names."""
    count, version, size, _, ascent, descent = HEADER.unpack_from(data)
    if count < 0 or size <= 0:
        raise ValueError("no font has such a size")
    end = HEADER.size + count * LETTER.size
    letters = {}
    for code, height, width, advance, top, left, _ in LETTER.iter_unpack(data[HEADER.size : end]):
        mask = np.frombuffer(data, np.uint8, height * width, end).reshape(height, width)
        end += height * width
        letters[chr(code)] = BitmapLetter(mask, left, -top, advance)
    names = ["", ""]
    for i in range(2 if version >= NAMED else 0):
        (length,) = struct.unpack_from(">H", data, end)
        names[i] = data[end + 2 : end + 2 + length].decode()
        end += 2 + length
    is_smooth = version != SMOOTH or bool(data[end])
    if not ascent and "d" in letters:
        ascent = -letters["d"].top
    if not descent and "p" in letters:
        descent = letters["p"].top + len(letters["p"].mask)
    return BitmapFont(size, ascent, descent, letters, names[0], names[1], is_smooth)
