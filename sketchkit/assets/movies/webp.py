"""Animated WebP. Pillow packs each frame, we put them into the container.

Frames of few colours, as most sketches draw, are kept exact: so they are smaller, too. Others lose
a little, as a JPEG does.
"""

from __future__ import annotations

import io
import struct
from typing import BinaryIO

from sketchkit.assets.movies.encoder import U8, Change, Changes

FEW_COLORS = 256
QUALITY = 90  # of the frames with many colours
HAS_ANIMATION = 0x02
KEEP_AND_REPLACE = 0x02  # the frame is not blended with what is there, and stays
LONGEST = 0xFFFFFF  # ms


class WebpEncoder:
    """Writes an animated WebP."""

    def __init__(self, file: BinaryIO, size: tuple[int, int], fps: float) -> None:
        self._file = file
        self._fps = fps
        self._changes = Changes(grid=2)  # places of frames are even
        self._waiting: Change | None = None
        self._count = 0
        width, height = size
        file.write(b"RIFF\0\0\0\0WEBP")
        flags = struct.pack("<I", HAS_ANIMATION)
        self._chunk(b"VP8X", flags + _uint24(width - 1) + _uint24(height - 1))
        self._chunk(b"ANIM", struct.pack("<IH", 0xFF000000, 0))  # behind it black; for ever

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
        length = self._file.tell()
        self._file.seek(4)
        self._file.write(struct.pack("<I", length - 8))
        return None

    def close(self) -> None:
        """Let go of the last frame."""
        self._waiting = None

    def _write_waiting(self) -> None:
        if self._waiting is None:
            return
        frame, x, y, pixels = self._waiting
        height, width = pixels.shape[:2]
        lasts_ms = round(self._count * 1000 / self._fps) - round(frame * 1000 / self._fps)
        head = b"".join(
            map(_uint24, (x // 2, y // 2, width - 1, height - 1, min(lasts_ms, LONGEST)))
        )
        self._chunk(b"ANMF", head + bytes([KEEP_AND_REPLACE]) + _packed(pixels))

    def _chunk(self, kind: bytes, data: bytes) -> None:
        odd = b"\0" * (len(data) % 2)
        self._file.write(kind + struct.pack("<I", len(data)) + data + odd)


def _packed(pixels: U8) -> bytes:
    """Return a picture as the chunks that a frame consists of."""
    from PIL import Image  # 40 ms to import

    image = Image.fromarray(pixels)
    is_exact = image.getcolors(FEW_COLORS) is not None
    file = io.BytesIO()
    image.save(file, "WEBP", lossless=is_exact, quality=50 if is_exact else QUALITY, method=2)
    return file.getvalue()[12:]  # without the container of a single picture


def _uint24(value: int) -> bytes:
    return value.to_bytes(3, "little")
