"""The index of an MP4 brought to its front, so that a browser plays it while it still loads.

An encoder knows the index (the box `moov`) only at the end, and writes it there. It counts places
from the beginning of the file, so each of them is moved along with the pictures.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import BinaryIO, NamedTuple

CONTAINERS = (b"moov", b"trak", b"mdia", b"minf", b"stbl")  # that lead to the places
PLACES = {b"stco": "I", b"co64": "Q"}  # lists of places of 32 and of 64 bits
HEADER, LARGE_HEADER = 8, 16  # bytes before what a box holds
CHUNK = 1 << 20


class Box(NamedTuple):
    """A part of the file: its kind, where it begins and ends, and where what it holds begins."""

    kind: bytes
    start: int
    content: int
    end: int


def bring_index_to_front(file: BinaryIO) -> None:
    """Put the index of a complete MP4 before its pictures, in place.

    A file of another build is left as it is.
    """
    end = file.seek(0, 2)
    boxes = {box.kind: box for box in _boxes(file, 0, end)}
    first, index, pictures = (boxes.get(kind) for kind in (b"ftyp", b"moov", b"mdat"))
    if first is None or index is None or pictures is None or index.start < pictures.start:
        return
    if index.end != end:
        return
    file.seek(index.start)
    moved = bytearray(file.read(index.end - index.start))
    try:
        _shift_places(moved, len(moved))
    except struct.error:  # a place is too far for 32 bits
        return
    _move(file, first.end, index.start, len(moved))
    file.seek(first.end)
    file.write(moved)


def _boxes(file: BinaryIO, start: int, end: int) -> Iterator[Box]:
    while start + HEADER <= end:
        file.seek(start)
        size, kind = struct.unpack(">I4s", file.read(HEADER))
        content = start + HEADER
        if size == 1:
            (size,) = struct.unpack(">Q", file.read(8))
            content = start + LARGE_HEADER
        if size < content - start:  # 0 means: to the end of the file; less is none
            size = end - start
        yield Box(kind, start, content, start + size)
        start += size


def _shift_places(index: bytearray, by: int, start: int = 0, end: int | None = None) -> None:
    """Add to each place that an index, or a box within it, counts."""
    end = len(index) if end is None else end
    while start + HEADER <= end:
        size, kind = struct.unpack_from(">I4s", index, start)
        if size < HEADER:
            return
        if kind in CONTAINERS:
            _shift_places(index, by, start + HEADER, start + size)
        elif kind in PLACES:
            (count,) = struct.unpack_from(">I", index, start + HEADER + 4)
            form = f">{count}{PLACES[kind]}"
            places = struct.unpack_from(form, index, start + HEADER + 8)
            struct.pack_into(form, index, start + HEADER + 8, *(place + by for place in places))
        start += size


def _move(file: BinaryIO, start: int, end: int, by: int) -> None:
    """Move a part of a file towards its end, piece by piece from the last one on."""
    while end > start:
        begin = max(start, end - CHUNK)
        file.seek(begin)
        piece = file.read(end - begin)
        file.seek(begin + by)
        file.write(piece)
        end = begin
