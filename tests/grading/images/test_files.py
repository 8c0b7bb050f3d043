import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from sketchkit.core.errors import SketchError
from sketchkit.grading.images.files import load_pixels


def png(width: int, height: int) -> bytes:
    """Return a small PNG file that claims to be of some size."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        checksum = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = (
        chunk(b"IHDR", header),
        chunk(b"IDAT", zlib.compress(b"\0" * 100)),
        chunk(b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def test_colours_are_read(tmp_path: Path) -> None:
    pixels = np.arange(60, dtype=np.uint8).reshape(4, 5, 3)
    Image.fromarray(pixels).save(tmp_path / "a.png")

    assert np.array_equal(load_pixels(tmp_path / "a.png"), pixels)


def test_what_is_transparent_shows_white(tmp_path: Path) -> None:
    pixels = np.array([[(10, 20, 30, 255), (10, 20, 30, 0), (0, 0, 0, 128)]], np.uint8)
    Image.fromarray(pixels).save(tmp_path / "a.png")

    assert load_pixels(tmp_path / "a.png").tolist() == [
        [[10, 20, 30], [255, 255, 255], [127, 127, 127]]
    ]


def test_greys_of_16_bits_are_read(tmp_path: Path) -> None:
    Image.fromarray(np.array([[0, 65535, 32896]], np.uint16)).save(tmp_path / "a.png")

    assert load_pixels(tmp_path / "a.png")[0, :, 0].tolist() == [0, 255, 128]


@pytest.mark.parametrize(("width", "height"), [(8000, 8000), (2_000_000, 2_000_000)])
def test_large_picture_is_refused_before_it_is_decoded(
    tmp_path: Path, width: int, height: int
) -> None:
    (tmp_path / "bomb.png").write_bytes(png(width, height))

    with pytest.raises(SketchError, match="too large"):
        load_pixels(tmp_path / "bomb.png")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is no picture"),
        (b"hello", "is no picture"),
        (png(100, 100), "is broken"),
        (png(100, 100)[:40], "is broken|is no picture"),
        (b"%!PS-Adobe-3.0 EPSF-3.0\n", "is no picture"),
    ],
)
def test_what_is_no_picture_is_refused(tmp_path: Path, content: bytes, words: str) -> None:
    (tmp_path / "a.png").write_bytes(content)

    with pytest.raises(SketchError, match=words):
        load_pixels(tmp_path / "a.png")


def test_missing_file_and_folder_are_told(tmp_path: Path) -> None:
    with pytest.raises(SketchError, match="There is no file"):
        load_pixels(tmp_path / "a.png")
    with pytest.raises(SketchError, match="folder"):
        load_pixels(tmp_path)
