"""The header of a PLY file: which elements there are, and what numbers each of them has."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sketchkit.assets.models.data import broken, said
from sketchkit.core.errors import SketchError

TYPES = {
    **dict.fromkeys((b"char", b"int8"), "i1"),
    **dict.fromkeys((b"uchar", b"uint8"), "u1"),
    **dict.fromkeys((b"short", b"int16"), "i2"),
    **dict.fromkeys((b"ushort", b"uint16"), "u2"),
    **dict.fromkeys((b"int", b"int32"), "i4"),
    **dict.fromkeys((b"uint", b"uint32"), "u4"),
    **dict.fromkeys((b"float", b"float32"), "f4"),
    **dict.fromkeys((b"double", b"float64"), "f8"),
}
BYTE_ORDERS = {b"ascii": "", b"binary_little_endian": "<", b"binary_big_endian": ">"}
LONGEST = 65536  # bytes; a file without an end of its header is not searched further


@dataclass(frozen=True, slots=True)
class Property:
    """A number of each row or, if `count` is not None, a list with its length before it."""

    name: str
    type: np.dtype[np.generic]
    count: np.dtype[np.generic] | None = None


@dataclass(frozen=True, slots=True)
class Element:
    """A table of the file: its name, rows and columns."""

    name: str
    count: int
    properties: list[Property] = field(default_factory=list)


@dataclass(slots=True)
class Header:
    """What stands before the data.

    Attributes
    ----------
    byte_order : str, optional
        `<` or `>`; empty for text; None until it was told.
    elements : list of Element
    comments : list
        Line, and its words.
    lines : int
        How many there are.
    end : int, bytes
        Where the data begins.
    """

    byte_order: str | None = None
    elements: list[Element] = field(default_factory=list)
    comments: list[tuple[int, list[bytes]]] = field(default_factory=list)
    lines: int = 0
    end: int = 0


def read_header(path: Path, data: bytes) -> Header:
    """Return the header of a file.

    Raises
    ------
    SketchError
        If it is none, or broken.
    """
    if not data.startswith(b"ply") or data[3:4] not in (b"\n", b"\r", b" "):
        raise SketchError(
            f"{path} is no PLY file: its first line is not ply.",
            hint="A file does not change its kind with its name: export it again.",
        )
    header = Header()
    for text in data[:LONGEST].splitlines(keepends=True):
        header.lines += 1
        header.end += len(text)
        words = text.split()
        if words == [b"end_header"] and text[-1:] in (b"\n", b"\r"):
            break
        if header.lines > 1 and words:
            _take(path, header, words)
    else:
        raise broken(path, f"line {header.lines}", "the header has no end_header")
    if header.byte_order is None:
        raise broken(path, f"line {header.lines}", "the header does not say the format")
    return header


def _take(path: Path, header: Header, words: list[bytes]) -> None:
    match words:
        case [b"format", order, *_] if order in BYTE_ORDERS:
            header.byte_order = BYTE_ORDERS[order]
        case [b"element", name, count] if count.isdigit() and len(count) < 16:
            header.elements.append(Element(said(name), int(count)))
        case [b"property", b"list", count, kind, name] if (
            header.elements and kind in TYPES and TYPES.get(count, "f")[0] != "f"
        ):
            types = _type(header, kind), _type(header, count)
            header.elements[-1].properties.append(Property(said(name), *types))
        case [b"property", kind, name] if header.elements and kind in TYPES:
            header.elements[-1].properties.append(Property(said(name), _type(header, kind)))
        case [b"comment" | b"obj_info", *rest]:
            header.comments.append((header.lines, rest))
        case _:
            problem = f"{said(b' '.join(words))[:60]!r} is no line of a header"
            raise broken(path, f"line {header.lines}", problem)


def _type(header: Header, name: bytes) -> np.dtype[np.generic]:
    return np.dtype((header.byte_order or "<") + TYPES[name])
