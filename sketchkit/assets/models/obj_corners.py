"""The corners of OBJ faces, `place/uv/normal`, to row numbers.

In most files all corners are written alike, and then they are read at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sketchkit.assets.models.data import I64, broken, said, starts
from sketchkit.assets.models.number_rows import NumberRows
from sketchkit.core.errors import SketchError

DIGITS = b"0123456789-"
LARGEST_INDEX = 2**62  # beyond any file, and short of what 64 bits hold
NOUNS = ("vertex (v)", "texture place (vt)", "normal (vn)")


class Faces(NamedTuple):
    """Where the faces are: their lines, (f,), and the corner each begins with, (f + 1,)."""

    path: Path
    lines: I64
    begins: I64

    def line(self, corner: int) -> int:
        """Return the line of a corner."""
        return int(self.lines[np.searchsorted(self.begins, corner, side="right") - 1])


def faces_of_corners(path: Path, lines: list[int], lengths: list[int]) -> Faces:
    """Return where faces are that have so many corners."""
    return Faces(path, np.array(lines, np.int64), starts(lengths))


def corner_indices(
    faces: Faces, words: list[bytes], rows: tuple[NumberRows, NumberRows, NumberRows]
) -> tuple[I64, I64, I64]:
    """Return the rows of places, uvs and normals, (c,) each, -1 for none.

    Parameters
    ----------
    faces : Faces
    words : list of bytes
        The corners as they were written.
    rows : tuple
        What there is of places, uvs and normals.

    Raises
    ------
    SketchError
        If a corner cannot be read, or has an index of something that is not there.
    """
    written = _alike(words)
    if written is None:
        written = _one_by_one(faces, words)
    if len(rows[2]) and not len(rows[1]) and not written[:, 2].any():
        written = written[:, [0, 2, 1]]  # in `1/2` the second number is then a normal
    places = _resolved(faces, written[:, 0], rows[0], 0)
    uvs = _optional(faces, written[:, 1], rows[1], 1)
    return places, uvs, _optional(faces, written[:, 2], rows[2], 2)


def _alike(words: list[bytes]) -> I64 | None:
    """Return the numbers of corners, (c, 3), 0 for none, if all are of one form, else None.

    What is left without the digits tells the form; the count of numbers tells that none is short.
    """
    text = b" ".join(words)
    match set(text.translate(None, DIGITS).split()):
        case forms if not forms:
            columns = [0]
        case forms if forms == {b"/"}:
            columns = [0, 1]
        case forms if forms == {b"//"} and b"//" not in text:
            columns = [0, 1, 2]
        case forms if forms == {b"//"} and text.count(b"//") == len(words):
            columns = [0, 2]
        case _:
            return None
    try:
        numbers = np.array(list(map(int, text.replace(b"/", b" ").split())), np.int64)
    except (ValueError, OverflowError):
        return None
    if len(numbers) != len(words) * len(columns):
        return None
    written = np.zeros((len(words), 3), np.int64)
    written[:, columns] = numbers.reshape(-1, len(columns))
    return written


def _one_by_one(faces: Faces, words: list[bytes]) -> I64:
    """Return the numbers of corners, (c, 3), 0 for none."""
    written = np.zeros((len(words), 3), np.int64)
    for corner, word in enumerate(words):
        try:
            written[corner] = _corner(word)
        except ValueError:
            raise broken(
                faces.path,
                f"line {faces.line(corner)}",
                f"{said(word)[:40]!r} is no corner of a face",
                hint="A corner is 7, 7/2, 7//5 or 7/2/5: vertex, texture place, normal.",
            ) from None
    return written


def _corner(word: bytes) -> tuple[int, int, int]:
    """Return the three numbers of a corner, 0 for one that is left out."""
    place, uv, normal, *more = [*word.split(b"/"), b"", b""]
    if more not in ([], [b""], [b"", b""]):
        raise ValueError
    return _index(place), _index(uv or b"0"), _index(normal or b"0")


def _index(word: bytes) -> int:
    return max(-LARGEST_INDEX, min(int(word), LARGEST_INDEX))


def _optional(faces: Faces, written: I64, rows: NumberRows, column: int) -> I64:
    """Return the rows of uvs or normals; a file without any of them may number them freely."""
    if not len(rows):
        return np.full(len(written), -1)
    return _resolved(faces, written, rows, column)


def _resolved(faces: Faces, written: I64, rows: NumberRows, column: int) -> I64:
    """Return rows from 0 on; negative numbers count back from the face's line."""
    is_relative = written < 0
    found = written - 1
    is_wrong = found >= len(rows)
    if is_relative.any():
        seen = np.searchsorted(np.array(rows.lines, np.int64), faces.lines)
        back = np.repeat(seen, np.diff(faces.begins)) + written
        found = np.where(is_relative, back, found)
        is_wrong |= is_relative & (back < 0)
    if column == 0:
        is_wrong |= written == 0
    if is_wrong.any():
        raise _out_of_range(faces, written, int(np.argmax(is_wrong)), (len(rows), column))
    return found


def _out_of_range(faces: Faces, written: I64, corner: int, there_are: Sequence[int]) -> SketchError:
    count, column = there_are
    return broken(
        faces.path,
        f"line {faces.line(corner)}",
        f"the face has {NOUNS[column]} {written[corner]}, but the file has {count} of them",
        hint="They are counted from 1." if written[corner] == 0 else None,
    )
