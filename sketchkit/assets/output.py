"""What a sketch writes: a file appears whole, or not at all."""

from __future__ import annotations

import io
import os
import shutil
import threading
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.paths import note_written
from sketchkit.core.errors import SketchError

U8 = NDArray[np.uint8]

# What a file's ending means to Pillow, and how it is told to write it.
PICTURES: dict[str, tuple[str, dict[str, int]]] = {
    ".png": ("PNG", {"compress_level": 1}),
    ".jpg": ("JPEG", {"quality": 95}),
    ".jpeg": ("JPEG", {"quality": 95}),
    ".tif": ("TIFF", {}),
    ".tiff": ("TIFF", {}),
    ".tga": ("TGA", {}),
    ".bmp": ("BMP", {}),
    ".gif": ("GIF", {}),
    ".webp": ("WEBP", {}),
}
WITHOUT_ALPHA = frozenset({"JPEG", "BMP"})


def write_file(path: Path, data: bytes) -> None:
    """Write a file, and the folders that it lies in.

    The data goes to a new file beside it first, which then takes its name: a reader never sees
    half of it, and what was there stays if the disk is full.
    """
    copy_to_file(path, io.BytesIO(data))


def copy_to_file(path: Path, source: BinaryIO) -> None:
    """Write what an open file holds, from its beginning, as `write_file` does."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.{os.getpid()}-{threading.get_ident()}.part")
    source.seek(0)
    try:
        with part.open("wb") as file:
            shutil.copyfileobj(source, file)
        os.replace(part, path)
        note_written(path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def picture_bytes(pixels: U8, suffix: str) -> bytes:
    """Return pixels, (h, w, 3 or 4) uint8, as a file of the kind that ends in `suffix`."""
    from PIL import Image  # 40 ms to import, and most sketches write no picture

    if suffix.lower() not in PICTURES:
        kinds = ", ".join(sorted(PICTURES))
        raise SketchError(f"A picture's file name ends in one of {kinds}.", got=repr(suffix))
    kind, options = PICTURES[suffix.lower()]
    if kind in WITHOUT_ALPHA:
        pixels = np.ascontiguousarray(pixels[..., :3])
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, kind, **options)
    return file.getvalue()
