"""STL files, of text and of bytes: triangles with a normal each."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sketchkit.assets.models.data import (
    F32,
    Model,
    ModelMaterial,
    ModelPart,
    broken,
    finite_or_zero,
    first_not_finite,
    read_bytes,
    said,
    warn_without_faces,
)
from sketchkit.assets.models.number_rows import NumberRows, is_number, single
from sketchkit.core.errors import SketchError

WITHOUT_NUMBERS = {b"outer", b"endloop", b"endfacet", b""}
VERTEX = (b"vertex", None, None, None)
# The words of a facet; None stands for a number.
NORMAL = (b"facet", b"normal", None, None, None)
FACET = (*NORMAL, b"outer", b"loop", *VERTEX, *VERTEX, *VERTEX, b"endloop", b"endfacet")
HEADER = 84  # bytes; the last four count the triangles
TRIANGLE = np.dtype([("normal", "<f4", 3), ("places", "<f4", (3, 3)), ("attribute", "<u2")])


def read_stl(path: Path) -> Model:
    """Return the model in an STL file.

    Raises
    ------
    SketchError
        If the file is broken: it names the line, or the byte in a file that is no text.
    """
    data = read_bytes(path)
    # Files of bytes may begin with "solid" too, against the rule.
    is_text = data.lstrip().startswith(b"solid") and b"\0" not in data[:1024]
    model = _text(path, data) if is_text else _binary(path, data)
    if not model.parts:
        warn_without_faces(path)
    return model


def _binary(path: Path, data: bytes) -> Model:
    if len(data) < HEADER:
        raise SketchError(
            f"{path} is no STL file: it neither begins with solid nor has a header of 84 bytes.",
            got=f"{len(data)} bytes",
        )
    count = int.from_bytes(data[HEADER - 4 : HEADER], "little")
    there_are = (len(data) - HEADER) // TRIANGLE.itemsize
    if there_are < count:
        raise broken(
            path,
            f"byte {len(data)}",
            f"the file ends after {there_are} of {count} triangles",
            hint="It was not copied whole, or it is no STL file.",
        )
    triangles = np.frombuffer(data, TRIANGLE, count, HEADER)
    places = triangles["places"].reshape(-1, 3).astype(np.float32)
    wrong = first_not_finite(places)
    if wrong is not None:
        byte = HEADER + wrong // 3 * TRIANGLE.itemsize
        raise broken(path, f"byte {byte}", "a corner is at no place that can be drawn")
    return Model([_part("", places, triangles["normal"])] if count else [])


def _part(name: str, places: F32, face_normals: F32) -> ModelPart:
    """Return triangles, (3f, 3), with their normals, (f, 3), for each corner."""
    normals = finite_or_zero(face_normals.astype(np.float32)).repeat(3, axis=0)
    return ModelPart(
        name,
        ModelMaterial(),
        places,
        np.full(len(face_normals), 3, np.int64),
        normals=normals if normals.any() else None,
    )


def _text(path: Path, data: bytes) -> Model:
    """Return a model from text: at once if it is one solid, written as most are."""
    head, _, rest = data.strip().partition(b"\n")
    body, _, tail = rest.rpartition(b"\n")
    if head.startswith(b"solid") and tail.split()[:1] == [b"endsolid"]:
        rows = _usual_facets(body.split())
        if rows is not None:
            name = said(b" ".join(head.split()[1:]))
            return Model([_part(name, rows[:, 3:].reshape(-1, 3), rows[:, :3])])
    return Model(list(_parts_by_line(path, data)))


def _usual_facets(words: list[bytes]) -> F32 | None:
    """Return normal and corners of facets, (f, 12), or None if a word is not where it should be."""
    size = len(FACET)
    count = len(words) // size
    columns = [at for at, word in enumerate(FACET) if word is None]
    if not count or any(
        words[at::size] != [word] * count for at, word in enumerate(FACET) if word is not None
    ):
        return None
    try:
        numbers = single(float(word) for at in columns for word in words[at::size])
    except ValueError:
        return None
    return numbers.reshape(len(columns), count).T if np.isfinite(numbers).all() else None


def _parts_by_line(path: Path, data: bytes) -> Iterator[ModelPart]:
    """Yield a part for each `solid` that has facets."""
    name, first, line = "", 1, 0
    normals, places = NumberRows(3), NumberRows(3)
    for line, text in enumerate(data.splitlines(), 1):
        words = text.split()
        keyword = words[0].lower() if words else b""
        if keyword == b"vertex":
            places.add(path, line, words[1:])
        elif keyword == b"facet":
            _check_facet(path, first, len(places) - 3 * len(normals))
            first = line
            normals.add(path, line, words[2:])
        elif keyword == b"solid":
            name = said(b" ".join(words[1:]))
        elif keyword == b"endsolid":
            _check_facet(path, first, len(places) - 3 * len(normals))
            if len(normals):
                yield _part(name, places.array(path), _facet_normals(normals))
            normals, places = NumberRows(3), NumberRows(3)
        elif keyword not in WITHOUT_NUMBERS:
            problem = f"{said(words[0])[:40]!r} is no word of an STL file"
            raise broken(path, f"line {line}", problem)
    if len(normals) or len(places):
        problem = "the file ends before its endsolid"
        raise broken(path, f"line {line}", problem, hint="It was not copied whole.")


def _check_facet(path: Path, line: int, surplus: int) -> None:
    """Refuse a facet, begun in a line, that has less or more than three corners."""
    if surplus:
        got = str(3 + surplus)
        raise broken(path, f"line {line}", "a facet has to have three corners", got=got)


def _facet_normals(rows: NumberRows) -> F32:
    """Return the normals, (f, 3); one that is no number, of a triangle without an area, is 0."""
    numbers = (float(word) if is_number(word) else 0.0 for word in rows.words)
    return single(numbers).reshape(-1, 3)
