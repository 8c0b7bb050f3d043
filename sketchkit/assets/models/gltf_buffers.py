"""The bytes of glTF and GLB files, and the arrays and pictures in them."""

from __future__ import annotations

import base64
import binascii
import io
import warnings
from pathlib import Path
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.models.data import beside, broken, read_bytes, texture_beside
from sketchkit.assets.models.json_place import JsonPlace
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import Pixels

Numbers = NDArray[np.generic]

GLB_HEADER = 12  # bytes: magic, version, length
CHUNK_HEADER = 8
JSON_CHUNK, BINARY_CHUNK = b"JSON", b"BIN\0"
TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class GltfFile:
    """A document with its buffers.

    Attributes
    ----------
    path : Path
    document : JsonPlace
    """

    def __init__(self, path: Path) -> None:
        data = read_bytes(path)
        text, self._chunk = _chunks(path, data) if data.startswith(b"glTF") else (data, None)
        if b"\0" in text[:64]:
            raise SketchError(f"{path} is no glTF file: it holds no JSON.")
        self.path = path
        self.document = JsonPlace.parsed(path, text)
        self._buffers: dict[str, bytes] = {}
        self._pictures: dict[str, Path | Pixels | None] = {}
        self._lists: dict[str, list[JsonPlace]] = {}

    def item(self, number: JsonPlace, kind: str) -> JsonPlace:
        """Return one of the document's `meshes`, `nodes` and so on."""
        if kind not in self._lists:
            self._lists[kind] = list(self.document[kind])
        return number.of(self._lists[kind], kind)

    def array(self, number: JsonPlace, widths: tuple[int, ...]) -> Numbers:
        """Return the rows of an accessor, (n, w); fractions of whole numbers become floats.

        Raises
        ------
        SketchError
            If it is not in the file, or not of one of the widths.
        """
        accessor = self.item(number, "accessors")
        kind = TYPES.get(accessor["componentType"].whole())
        width = WIDTHS.get(accessor["type"].text())
        if kind is None or width not in widths:
            raise accessor.wrong("numbers of another type, for " + number.trail)
        if accessor["sparse"].value is not None or "bufferView" not in accessor:
            raise accessor.wrong("a bufferView, and nothing sparse")
        count = accessor["count"].whole()
        data, stride = self._view(accessor["bufferView"])
        dtype = np.dtype(kind)
        stride = stride or dtype.itemsize * width
        begin = accessor["byteOffset"].whole(0)
        end = begin + stride * (count - 1) + dtype.itemsize * width
        if count and (end > len(data) or stride < dtype.itemsize):
            raise accessor.wrong(f"as many numbers as its buffer view has, {len(data)} bytes")
        steps = (stride, dtype.itemsize)
        rows: Numbers = np.ndarray((count, width), dtype, data, begin if count else 0, steps)
        return _fractions(rows) if accessor["normalized"].value is True else rows

    def picture(self, number: JsonPlace) -> Path | Pixels | None:
        """Return the picture of a texture; None, with a warning, if its file is missing."""
        image = self.item(self.item(number, "textures")["source"], "images")
        if image.trail not in self._pictures:
            self._pictures[image.trail] = self._picture(image)
        return self._pictures[image.trail]

    def _picture(self, image: JsonPlace) -> Path | Pixels | None:
        if "bufferView" in image:
            return _decoded(image, self._view(image["bufferView"])[0])
        uri = image["uri"].text()
        if uri.startswith("data:"):
            return _decoded(image, _data_of(image["uri"], uri))
        return texture_beside(self.path, image.trail, unquote(uri))

    def _view(self, number: JsonPlace) -> tuple[bytes, int]:
        """Return the bytes of a buffer view, and its stride, 0 if they follow closely."""
        view = self.item(number, "bufferViews")
        data = self._buffer(view["buffer"])
        begin = view["byteOffset"].whole(0)
        end = begin + view["byteLength"].whole()
        if end > len(data):
            raise view.wrong(f"a range within the buffer, which has {len(data)} bytes")
        return data[begin:end], view["byteStride"].whole(0)

    def _buffer(self, number: JsonPlace) -> bytes:
        buffer = self.item(number, "buffers")
        if buffer.trail not in self._buffers:
            self._buffers[buffer.trail] = self._read_buffer(buffer)
        return self._buffers[buffer.trail]

    def _read_buffer(self, buffer: JsonPlace) -> bytes:
        if "uri" not in buffer:
            if self._chunk is None:
                raise buffer.wrong("a uri, for the file has no binary part")
            return self._chunk
        uri = buffer["uri"].text()
        if uri.startswith("data:"):
            return _data_of(buffer["uri"], uri)
        found = beside(self.path, unquote(uri))
        if found is None:
            hint = "Copy it beside the model, or export as GLB, which is one file."
            raise broken(self.path, buffer.trail, f"there is no file {unquote(uri)}", hint=hint)
        return read_bytes(found)


def _chunks(path: Path, data: bytes) -> tuple[bytes, bytes | None]:
    """Return the JSON of a GLB file, and its binary part."""
    version, length = (int.from_bytes(data[at : at + 4], "little") for at in (4, 8))
    if version != 2:
        raise broken(path, "byte 4", "only version 2 of glTF is read", got=str(version))
    if length > len(data):
        problem = f"the file ends, but should have {length} bytes"
        raise broken(path, f"byte {len(data)}", problem, hint="It was not copied whole.")
    found: dict[bytes, bytes] = {}
    at = GLB_HEADER
    while at + CHUNK_HEADER <= length:
        begin = at + CHUNK_HEADER
        end = begin + int.from_bytes(data[at : at + 4], "little")
        if end > length:
            raise broken(path, f"byte {at}", "a part is longer than the file")
        found.setdefault(data[at + 4 : begin], data[begin:end])
        at = end
    if JSON_CHUNK not in found:
        raise broken(path, f"byte {GLB_HEADER}", "the part with JSON is missing")
    return found[JSON_CHUNK], found.get(BINARY_CHUNK)


def _data_of(place: JsonPlace, uri: str) -> bytes:
    """Return the bytes that are written in an address."""
    head, comma, body = uri.partition(",")
    if not comma:
        raise place.wrong("data:…, with the data after a comma")
    if not head.endswith(";base64"):
        return unquote_to_bytes(body)
    try:
        return base64.b64decode(body)
    except (binascii.Error, ValueError):
        raise place.wrong("data in base64") from None


def _decoded(image: JsonPlace, data: bytes) -> Pixels:
    """Return a picture, PNG or JPEG, that lies within the file."""
    from PIL import Image  # 40 ms, and most models have no picture

    try:
        # Pillow remarks on odd headers; whoever drew the picture cannot help it.
        with warnings.catch_warnings(action="ignore"), Image.open(io.BytesIO(data)) as picture:
            return Pixels(np.array(picture.convert("RGBA")))
    except (OSError, SyntaxError, ValueError, EOFError, Image.DecompressionBombError):
        raise broken(image.path, image.trail, "the picture is broken") from None


def _fractions(rows: Numbers) -> Numbers:
    """Return whole numbers as 0..1, or -1..1 if they have a sign."""
    if rows.dtype.kind == "f":
        return rows
    largest = np.iinfo(rows.dtype.str).max
    fractions: Numbers = np.maximum(rows.astype(np.float64) / largest, -1.0)
    return fractions
