"""GIF. The frames wait, packed, in a file without a name until the palette for all can be chosen.

A GIF counts hundredths of a second, and programs that show one take less than two of them for ten:
so 50 frames a second are the most. Faster films leave frames out and keep their speed.
"""

from __future__ import annotations

import struct
import tempfile
import zlib
from collections.abc import Iterator
from typing import BinaryIO

import numpy as np

from sketchkit.assets.movies.encoder import U8, Change, Changes
from sketchkit.assets.movies.palette import ColorCount, Indexer

FASTEST = 50  # frames a second
AS_BEFORE = 255  # the index of a pixel that does not change
LONGEST = 0xFFFF  # hundredths of a second
FOR_EVER = b"\x21\xff\x0bNETSCAPE2.0\x03\x01\0\0\0"
STAYS = 1  # a frame is not taken away before the next


class GifEncoder:
    """Writes a GIF."""

    def __init__(self, file: BinaryIO, size: tuple[int, int], fps: float) -> None:
        self._file = file
        self._size = size
        self._fps = fps
        self._count = 0
        self._starts: list[int] = []  # of the frames that are kept, in hundredths of a second
        self._colors = ColorCount()
        self._waiting = tempfile.TemporaryFile()  # noqa: SIM115 # closed at the end

    def add(self, pixels: U8) -> None:
        """Take the next frame, (h, w, 3)."""
        start = self._start_of(self._count)
        if not self._starts or start > self._starts[-1]:
            self._starts.append(start)
            self._colors.add(pixels)
            data = zlib.compress(pixels.tobytes(), 1)
            self._waiting.write(struct.pack("<I", len(data)) + data)
        self._count += 1

    def finish(self) -> str | None:
        """Choose the palette and write everything."""
        colors, index = self._colors.palette()
        width, height = self._size
        self._file.write(b"GIF89a" + struct.pack("<HHBBB", width, height, 0xF7, 0, 0))
        self._file.write(colors.tobytes() + b"\0\0\0" + FOR_EVER)
        self._write_frames(index)
        self._file.write(b"\x3b")
        left_out = self._count - len(self._starts)
        if not left_out:
            return None
        return (
            f"A GIF shows at most {FASTEST} frames a second: {left_out} of {self._count} frames "
            f"were left out, so that it is as fast as it should be."
        )

    def close(self) -> None:
        """Let go of the frames that wait."""
        self._waiting.close()

    def _write_frames(self, index: Indexer) -> None:
        """Write what each frame changes, as long as it is to be seen."""
        changes = Changes()
        last = np.full((self._size[1], self._size[0]), AS_BEFORE, np.uint8)
        shown: Change | None = None
        for start, pixels in zip(self._starts, self._waiting_frames(), strict=True):
            indices = index(pixels)
            change = changes.next(start, indices)
            if change is None:
                continue
            if shown:
                self._write_frame(shown, until=start)
            shown, last = _only_what_differs(change, last), indices
        end = max(round(self._count * 100 / self._fps), self._starts[-1] + 100 // FASTEST)
        if shown:
            self._write_frame(shown, until=end)

    def _waiting_frames(self) -> Iterator[U8]:
        width, height = self._size
        self._waiting.seek(0)
        while head := self._waiting.read(4):
            data = zlib.decompress(self._waiting.read(struct.unpack("<I", head)[0]))
            yield np.frombuffer(data, np.uint8).reshape(height, width, 3)

    def _write_frame(self, change: Change, *, until: int) -> None:
        from PIL import GifImagePlugin, Image  # 40 ms to import

        image = Image.fromarray(np.ascontiguousarray(change.pixels))
        blocks = GifImagePlugin.getdata(
            image,
            (change.x, change.y),
            duration=min(until - change.frame, LONGEST) * 10,
            disposal=STAYS,
            transparency=AS_BEFORE,
        )
        self._file.write(b"".join(blocks))

    def _start_of(self, frame: int) -> int:
        """Return when a frame is to be seen, in hundredths of a second."""
        if self._fps <= FASTEST:
            return round(frame * 100 / self._fps)
        return int(frame * FASTEST / self._fps) * (100 // FASTEST)


def _only_what_differs(change: Change, last: U8) -> Change:
    """Return a change whose unchanged pixels are left open: that packs better."""
    frame, x, y, pixels = change
    height, width = pixels.shape
    before = last[y : y + height, x : x + width]
    return Change(frame, x, y, np.where(pixels == before, np.uint8(AS_BEFORE), pixels))
