"""Pictures as addresses that hold all of them, so that a page needs no other file."""

from __future__ import annotations

import base64
import io
from pathlib import Path

from PIL import Image

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
THUMBNAIL_PX = 160  # the most, both ways: then a class of 300 stays within a few megabytes


def picture_uri(folder: Path, picture: Path | None) -> str:
    """Return a PNG file of the results as an address; "" if it is not there."""
    data = _content(folder, picture)
    return _uri("png", data) if data.startswith(PNG_SIGNATURE) else ""


def thumbnail_uri(folder: Path, picture: Path | None) -> str:
    """Return a small copy of a picture of the results as an address; "" if it is not there."""
    data = _content(folder, picture)
    if not data.startswith(PNG_SIGNATURE):
        return ""
    try:
        with Image.open(io.BytesIO(data)) as image:
            small = image.convert("RGBA")
    except (OSError, SyntaxError, Image.DecompressionBombError):  # Pillow's for broken files
        return ""
    small.thumbnail((THUMBNAIL_PX, THUMBNAIL_PX), Image.Resampling.LANCZOS)
    file = io.BytesIO()
    small.save(file, "WEBP", quality=80)
    return _uri("webp", file.getvalue())


def _content(folder: Path, picture: Path | None) -> bytes:
    """Return a file's content: nothing if it is missing, or lies outside of the results."""
    if picture is None:
        return b""
    path = (folder / picture).resolve()
    if not path.is_relative_to(folder.resolve()):
        return b""
    try:
        return path.read_bytes()
    except OSError:
        return b""


def _uri(kind: str, data: bytes) -> str:
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"
