"""Animated PNG: every pixel exact, and a rate as exact. Pillow packs the pixels, we the frames."""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Iterator
from fractions import Fraction
from typing import BinaryIO

from sketchkit.assets.movies.encoder import U8, Change, Changes

SIGNATURE = b"\x89PNG\r\n\x1a\n"
LONGEST = 0xFFFF  # what numerator and denominator of a frame's time can be


class ApngEncoder:
    """Writes an animated PNG; of a single frame, a PNG."""

    def __init__(self, file: BinaryIO, size: tuple[int, int], fps: float) -> None:
        self._file = file
        self._frame_s = 1 / Fraction(fps).limit_denominator(100)
        self._changes = Changes()
        self._waiting: Change | None = None
        self._count = self._written = self._sequence = 0
        width, height = size
        file.write(SIGNATURE)
        self._chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
        self._control_at = file.tell()
        self._chunk(b"acTL", struct.pack(">II", 0, 0))  # how many there are is known at the end

    def add(self, pixels: U8) -> None:
        """Take the next frame, (h, w, 3)."""
        change = self._changes.next(self._count, pixels)
        if change:
            self._write_waiting()
            self._waiting = change
        self._count += 1

    def finish(self) -> str | None:
        """Write what is missing."""
        self._write_waiting()
        self._chunk(b"IEND", b"")
        self._file.seek(self._control_at)
        self._chunk(b"acTL", struct.pack(">II", self._written, 0))
        return None

    def close(self) -> None:
        """Let go of the last frame."""
        self._waiting = None

    def _write_waiting(self) -> None:
        if self._waiting is None:
            return
        frame, x, y, pixels = self._waiting
        lasts_s = self._frame_s * (self._count - frame)
        while lasts_s.numerator > LONGEST:
            lasts_s = Fraction(lasts_s).limit_denominator(max(lasts_s.denominator // 2, 1))
            if lasts_s.denominator == 1:
                lasts_s = min(lasts_s, Fraction(LONGEST))
        height, width = pixels.shape[:2]
        time = (lasts_s.numerator, lasts_s.denominator)
        control = struct.pack(">IIIIIHHBB", self._next(), width, height, x, y, *time, 0, 0)
        self._chunk(b"fcTL", control)
        for data in _packed(pixels):
            if self._written == 0:
                self._chunk(b"IDAT", data)
            else:
                self._chunk(b"fdAT", struct.pack(">I", self._next()) + data)
        self._written += 1

    def _next(self) -> int:
        self._sequence += 1
        return self._sequence - 1

    def _chunk(self, kind: bytes, data: bytes) -> None:
        check = zlib.crc32(kind + data)
        self._file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check))


def _packed(pixels: U8) -> Iterator[bytes]:
    """Yield the data of a picture's chunks `IDAT`."""
    from PIL import Image  # 40 ms to import

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG", compress_level=4)
    png = file.getvalue()
    place = len(SIGNATURE)
    while place < len(png):
        (length,) = struct.unpack_from(">I", png, place)
        if png[place + 4 : place + 8] == b"IDAT":
            yield png[place + 8 : place + 8 + length]
        place += length + 12
