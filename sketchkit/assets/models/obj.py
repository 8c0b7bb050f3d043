"""OBJ files, read as Processing reads them.

What the lines hold is collected as words; numbers are made of all words of a kind at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sketchkit.assets.models.data import (
    F32,
    I64,
    Model,
    ModelMaterial,
    ModelPart,
    beside,
    read_text,
    said,
    starts,
    warn_without_faces,
)
from sketchkit.assets.models.mtl import read_mtl
from sketchkit.assets.models.number_rows import NumberRows
from sketchkit.assets.models.obj_corners import corner_indices, faces_of_corners
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import warn_once


class _Run(NamedTuple):
    """From which face on a name and a material hold; the material is one of the file's."""

    first: int
    name: str
    material: int


@dataclass
class _Lines:
    """What the lines of a file gave so far."""

    path: Path
    rows: dict[bytes, NumberRows] = field(
        default_factory=lambda: {b"v": NumberRows(3), b"vt": NumberRows(2), b"vn": NumberRows(3)}
    )
    corners: list[bytes] = field(default_factory=list)
    lengths: list[int] = field(default_factory=list)
    face_lines: list[int] = field(default_factory=list)
    runs: list[_Run] = field(default_factory=lambda: [_Run(0, "", 0)])
    materials: list[ModelMaterial] = field(default_factory=list)
    material_places: dict[str, int] = field(default_factory=dict)
    has_library: bool = False


def read_obj(path: Path) -> Model:
    """Return the model in an OBJ file, with the materials of its MTL files.

    A missing MTL file or texture is a warning.

    Raises
    ------
    SketchError
        If the file is broken: it names the line.
    """
    lines = _Lines(path)
    for number, text in _statements(read_text(path, "OBJ")):
        words = text.split()
        if words:
            _take(lines, number, words)
    if not lines.lengths:
        if not len(lines.rows[b"v"]):
            raise SketchError(
                f"{path} is no OBJ file: no line begins with v or f.",
                hint="Export the model again, as OBJ.",
            )
        warn_without_faces(path)
        return Model()
    return Model(list(_parts(lines)))


def _statements(text: bytes) -> Iterator[tuple[int, bytes]]:
    """Yield the lines and their numbers; a line that ends in a backslash goes on in the next."""
    lines = text.splitlines()
    if b"\\" not in text:
        yield from enumerate(lines, 1)
        return
    pending, first = b"", 0
    for number, line in enumerate(lines, 1):
        first = first if pending else number
        goes_on = line.rstrip().endswith(b"\\") and not line.lstrip().startswith(b"#")
        pending += line.rstrip()[:-1] + b" " if goes_on else line
        if not goes_on:
            yield first, pending
            pending = b""
    yield first, pending


def _take(lines: _Lines, number: int, words: list[bytes]) -> None:
    """Take a statement; those that Processing does not know have no effect."""
    keyword = words[0]
    if keyword == b"f":
        _take_face(lines, number, words)
    elif keyword in lines.rows:
        values = words[1:]
        if keyword == b"vt" and len(values) == 1:
            values.append(b"0")  # v may be left out
        lines.rows[keyword].add(lines.path, number, values)
    elif keyword in (b"g", b"o"):
        material = lines.runs[-1].material
        name = said(words[1]) if len(words) > 1 else ""
        lines.runs.append(_Run(len(lines.lengths), name, material))
    elif keyword == b"usemtl":
        _use_material(lines, number, said(b" ".join(words[1:])))
    elif keyword == b"mtllib":
        _take_library(lines, number, words[1:])


def _take_face(lines: _Lines, number: int, words: list[bytes]) -> None:
    corners = words[1:]
    if b"#" in b"".join(corners):
        comment = next(at for at, word in enumerate(corners) if b"#" in word)
        corners = corners[:comment]
    lines.corners += corners
    lines.lengths.append(len(corners))
    lines.face_lines.append(number)


def _use_material(lines: _Lines, number: int, name: str) -> None:
    """Change the material; without the one that is named, it is the first of all."""
    place = lines.material_places.get(name)
    if place is None and lines.has_library:
        warn_once(f"{lines.path}, line {number}: no MTL file has a material {name!r}.")
    lines.runs.append(_Run(len(lines.lengths), lines.runs[-1].name, place or 0))


def _take_library(lines: _Lines, number: int, words: list[bytes]) -> None:
    """Read MTL files; the words are their names, or that of one with spaces in it."""
    whole = said(b" ".join(words))
    names = [whole] if beside(lines.path, whole) else [said(word) for word in words]
    for name in names:
        found = beside(lines.path, name)
        if found is None:
            warn_once(f"{lines.path}, line {number}: there is no file {name}; the model is gray.")
            continue
        lines.has_library = True
        for material in read_mtl(found, len(lines.materials)):
            lines.material_places[material.name] = len(lines.materials)
            lines.materials.append(material)


def _parts(lines: _Lines) -> Iterator[ModelPart]:
    """Yield the faces by runs of one name and one material."""
    path = lines.path
    arrays = {keyword: rows.array(path) for keyword, rows in lines.rows.items()}
    uvs = arrays[b"vt"]
    uvs[:, 1] = 1 - uvs[:, 1]
    faces = faces_of_corners(path, lines.face_lines, lines.lengths)
    places, uv_rows, normal_rows = corner_indices(
        faces, lines.corners, (lines.rows[b"v"], lines.rows[b"vt"], lines.rows[b"vn"])
    )
    lengths = np.array(lines.lengths, np.int64)
    begins = starts(lengths)
    materials = lines.materials or [ModelMaterial()]
    for run, end in _joined(lines.runs, len(lengths)):
        corners = slice(begins[run.first], begins[end])
        yield ModelPart(
            run.name,
            materials[run.material],
            arrays[b"v"][places[corners]],
            lengths[run.first : end],
            normals=_rows_or_none(arrays[b"vn"], normal_rows[corners]),
            uvs=_rows_or_none(uvs, uv_rows[corners]),
        )


def _joined(runs: list[_Run], count: int) -> Iterator[tuple[_Run, int]]:
    """Yield the runs that have faces, equal ones as one, and the face each ends before."""
    kept: list[_Run] = []
    for run in runs:
        if kept and kept[-1].first == run.first:
            kept.pop()  # it had no faces
        if not kept or kept[-1][1:] != run[1:]:
            kept.append(run)
    ends = [run.first for run in kept[1:]] + [count]
    return ((run, end) for run, end in zip(kept, ends, strict=True) if run.first < end)


def _rows_or_none(values: F32, rows: I64) -> F32 | None:
    """Return a row for each corner, zeros where it has none; None if none of them has."""
    if not (rows >= 0).any():
        return None
    return np.where(rows[:, None] >= 0, values[rows], np.float32(0))
