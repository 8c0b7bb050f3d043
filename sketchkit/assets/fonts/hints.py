"""Copies of a TTF file in which hints do what they do in Java: as long ago, or nothing.

A TTF file is a directory of tables. `cvt ` holds the heights and stems that hints snap to, in the
font's units; `prep` is a program that prepares a size.
"""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

I64 = NDArray[np.int64]

HEADER = struct.Struct(">4sHHHH")  # what it is, number of tables, three numbers that speed searches
ENTRY = struct.Struct(">4sLLL")  # tag, checksum, offset, length
PIXEL = 64  # FreeType counts in 64ths
FLAGS = 17  # the byte in `head` with a bit that says whether sizes are rounded to whole pixels
WHOLE_SIZES = 8

# "Run no glyph's program": PUSHB 1, 1; INSTCTRL. Then nothing three times, PUSHB 0; POP: FreeType
# hints by itself where this table is shorter than 8 bytes.
NO_HINTS = bytes([0xB1, 1, 1, 0x8E]) + bytes([0xB0, 0, 0x21]) * 3

Tables = dict[bytes, bytes]


def as_java_reads(font: bytes, size: int) -> bytes:
    """Return a TTF whose capitals are as high as Java draws them at a size.

    Java's FreeType multiplies by a scale of which it has cut off six bits, newer ones by all of
    it. So 656 units at 16 pixels are 10.484 there and 10.5 here, and round to another pixel. Such
    values are lowered by one unit; the older FreeType rounds that as before.
    """
    tables = _tables(font)
    if b"cvt " not in tables or b"head" not in tables:
        return font
    units = np.frombuffer(tables[b"cvt "], ">i2").astype(np.int64)
    per_em = int.from_bytes(tables[b"head"][18:20], "big")
    scale = ((size * PIXEL << 16) + per_em // 2) // per_em
    cut = _scaled(units * PIXEL, scale >> 6)
    differs = _whole_pixels(_scaled(units, scale)) > _whole_pixels(cut)
    if not differs.any():
        return font
    return _joined(font, {**tables, b"cvt ": (units - differs).astype(">i2").tobytes()})


def without_hints(font: bytes) -> bytes:
    """Return a TTF whose letters have the shapes that were drawn, whatever the size."""
    tables = _tables(font)
    if b"glyf" not in tables or b"head" not in tables:
        return font
    head = bytearray(tables[b"head"])
    head[FLAGS] &= ~WHOLE_SIZES
    return _joined(font, {**tables, b"head": bytes(head), b"prep": NO_HINTS})


def _tables(font: bytes) -> Tables:
    """Return the tables of a font; none of a collection, or of what is no font."""
    if font[:4] not in (b"\0\1\0\0", b"true"):
        return {}
    _, count, *_ = HEADER.unpack_from(font)
    entries = ENTRY.iter_unpack(font[HEADER.size :][: count * ENTRY.size])
    return {tag: font[offset : offset + length] for tag, _, offset, length in entries}


def _joined(font: bytes, tables: Tables) -> bytes:
    """Return a font with other tables. Nobody checks the sums, so they are left 0."""
    start = HEADER.size + ENTRY.size * len(tables)
    directory, body = b"", b""
    for tag in sorted(tables):
        directory += ENTRY.pack(tag, 0, start + len(body), len(tables[tag]))
        body += tables[tag] + bytes(-len(tables[tag]) % 4)
    return HEADER.pack(font[:4], len(tables), 0, 0, 0) + directory + body


def _scaled(values: I64, scale: int) -> I64:
    """Return values times a scale in 65536ths, rounded away from 0 in the middle."""
    scaled: I64 = np.sign(values) * ((np.abs(values) * scale + (1 << 15)) >> 16)
    return scaled


def _whole_pixels(values: I64) -> I64:
    return (np.abs(values) + PIXEL // 2) // PIXEL
