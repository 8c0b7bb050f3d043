"""Radiance pictures, `.hdr`: colours as floats, brighter than white too.

A pixel is four bytes: red, green, blue and the power of two that they share. Each row holds first
all reds, then all greens, ..., with runs of equal bytes shortened.
"""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
F32 = NDArray[np.float32]

MAGIC = b"#?"
BIAS = 128 + 8  # of the exponent: bytes are fractions of 256
MOST = float(np.finfo(np.float32).max)
WIDTHS = range(8, 1 << 15)  # rows of these are written in runs, others pixel by pixel
MOST_EQUAL, MOST_DIFFERENT = 127, 128  # bytes in one run


def read_radiance(file: bytes) -> F32:
    """Return the colours in a file, (h, w, 3), linear.

    Raises
    ------
    ValueError
        If it is broken, or a kind that nobody writes: turned, or in other colours.
    """
    header, _, rest = file.partition(b"\n\n")
    if not header.startswith(MAGIC) or b"FORMAT=32-bit_rle_xyze" in header:
        raise ValueError("it does not begin as a Radiance picture in red, green and blue")
    size, _, data = rest.partition(b"\n")
    found = re.fullmatch(rb"-Y (\d+) \+X (\d+)", size.strip())
    if not found:
        raise ValueError("it has no size that can be read")
    height, width = int(found[1]), int(found[2])
    begins_run = data[:2] == b"\2\2" and width in WIDTHS
    pixels = _in_runs(data, height, width) if begins_run else _plain(data, height, width)
    return _to_floats(pixels)


def radiance_bytes(floats: F32) -> bytes:
    """Return colours, (h, w, 3), as a file."""
    height, width, _ = floats.shape
    size = f"-Y {height} +X {width}\n".encode()
    pixels = _to_bytes(floats)
    header = MAGIC + b"RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size
    if width not in WIDTHS:
        return header + pixels.tobytes()
    start = bytes((2, 2, width >> 8, width & 255))
    rows = (start + b"".join(_runs(channel) for channel in row.T) for row in pixels)
    return header + b"".join(rows)


def _to_floats(pixels: U8) -> F32:
    """Return bytes, (h, w, 4), as floats, (h, w, 3)."""
    exponents = pixels[..., 3:].astype(np.int32) - BIAS
    floats = np.ldexp(pixels[..., :3].astype(np.float32), exponents)
    return np.where(pixels[..., 3:] > 0, floats, 0).astype(np.float32)


def _to_bytes(floats: F32) -> U8:
    """Return floats as bytes; what is negative or no number becomes 0."""
    colors = np.nan_to_num(np.maximum(floats, 0), posinf=MOST)
    highest = colors.max(axis=2)
    exponents = np.frexp(highest)[1]
    pixels = np.empty((*highest.shape, 4), np.uint8)
    scaled = np.ldexp(colors, (BIAS - 128 - exponents)[..., None])
    pixels[..., :3] = np.minimum(scaled, 255)
    pixels[..., 3] = np.clip(exponents + 128, 1, 255)
    pixels[highest < 1e-32] = 0
    return pixels


def _plain(data: bytes, height: int, width: int) -> U8:
    """Return pixels that follow each other."""
    if len(data) < height * width * 4:
        raise ValueError("it ends too early")
    return np.frombuffer(data, np.uint8, height * width * 4).reshape(height, width, 4)


def _in_runs(data: bytes, height: int, width: int) -> U8:
    """Return pixels from rows of runs."""
    place = 0
    pixels = np.empty((height, width, 4), np.uint8)
    for row in pixels:
        if data[place : place + 2] != b"\2\2":
            raise ValueError("it ends too early")
        place += 4
        channels = bytearray()
        while len(channels) < 4 * width and place + 1 < len(data):
            count = data[place]
            if count > MOST_DIFFERENT:
                channels += data[place + 1 : place + 2] * (count - MOST_DIFFERENT)
                place += 2
            else:
                channels += data[place + 1 : place + 1 + count]
                place += 1 + count
        if len(channels) != 4 * width:
            raise ValueError("it ends too early")
        row[:] = np.frombuffer(channels, np.uint8).reshape(4, width).T
    return pixels


def _runs(channel: U8) -> bytes:
    """Return a row of bytes in runs: equal ones once, all others as they are."""
    changes = np.flatnonzero(np.diff(channel)) + 1
    starts = [0, *changes.tolist(), len(channel)]
    packed, waiting = bytearray(), bytearray()
    data = channel.tobytes()
    for start, end in pairwise(starts):
        if end - start < 3:
            waiting += data[start:end]
            continue
        packed += _different(waiting)
        waiting.clear()
        for first in range(start, end, MOST_EQUAL):
            packed += bytes((MOST_DIFFERENT + min(end - first, MOST_EQUAL), data[start]))
    return bytes(packed + _different(waiting))


def _different(data: bytearray) -> bytes:
    """Return bytes as they are, with their count before each 128 of them."""
    parts = (data[first : first + MOST_DIFFERENT] for first in range(0, len(data), MOST_DIFFERENT))
    return b"".join(bytes((len(part),)) + part for part in parts)
