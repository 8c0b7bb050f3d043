"""What the file of a model holds, as plain data, whatever its format was.

The corners of the faces stand one after another, so that each face can become a shape by itself.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.paths import note_read, search_folders
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import warn_once
from sketchkit.draw.resources import Pixels

F32 = NDArray[np.float32]
I64 = NDArray[np.int64]
U8 = NDArray[np.uint8]
Rgb = tuple[float, float, float]

GRAY: Rgb = (0.5, 0.5, 0.5)  # Processing's, for what a material does not say


@dataclass(frozen=True, slots=True)
class ModelMaterial:
    """How the faces of a part look.

    Attributes
    ----------
    name : str
    ambient, diffuse, specular : Rgb
        As the file has them: 0..1, if it is right.
    shininess : float
    opacity : float
        1 is opaque.
    texture : Path or Pixels, optional
        A picture beside the model, which is there, or one that lies within its file.
    """

    name: str = "default"
    ambient: Rgb = GRAY
    diffuse: Rgb = GRAY
    specular: Rgb = GRAY
    shininess: float = 0.0
    opacity: float = 1.0
    texture: Path | Pixels | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ModelPart:
    """Faces that follow one another in the file, of one group and one material.

    Attributes
    ----------
    name : str
        The group's, object's or node's; empty without one.
    material : ModelMaterial
    places : (c, 3) float32
        Of the corners, face by face.
    lengths : (f,) int64
        How many corners each face has.
    normals : (c, 3) float32, optional
        As in the file; zeros where a corner has none.
    uvs : (c, 2) float32, optional
        0..1, v from the top of the picture down; zeros where a corner has none.
    colors : (c, 4) uint8, optional
        Straight alpha.
    """

    name: str
    material: ModelMaterial
    places: F32
    lengths: I64
    normals: F32 | None = None
    uvs: F32 | None = None
    colors: U8 | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """A model: its parts, joined, have the faces in the order of the file."""

    parts: list[ModelPart] = field(default_factory=list)


def broken(
    path: Path, where: str, problem: str, *, got: str | None = None, hint: str | None = None
) -> SketchError:
    """Return the error for a file that cannot be understood at a line or byte."""
    return SketchError(f"{path}, {where}: {problem}.", got=got, hint=hint)


def read_bytes(path: Path) -> bytes:
    """Return what is in a file.

    Raises
    ------
    SketchError
        If it cannot be read, or is empty.
    """
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise SketchError(f"{path} cannot be read: {problem.strerror}.") from None
    if not data.strip():
        raise SketchError(f"{path} is empty.", hint="Export the model again.")
    return data


def read_text(path: Path, kind: str) -> bytes:
    """Return what is in a file that has to be text of the given kind.

    Raises
    ------
    SketchError
        If it cannot be read, is empty, or has bytes that no text has.
    """
    data = read_bytes(path)
    at = data.find(b"\0", 0, 4096)
    if at >= 0:
        raise broken(
            path,
            f"byte {at}",
            f"this is no text, so it is no {kind} file",
            hint="A file does not change its kind with its name: export it again.",
        )
    return data.removeprefix(b"\xef\xbb\xbf")


def said(word: bytes) -> str:
    """Return a word of a file as text that can be shown."""
    return word.decode("utf-8", errors="replace")


def beside(path: Path, name: str) -> Path | None:
    """Return the file that another one names, or None.

    It is looked for beside that one, then in the sketch's folders; a path from the computer that
    the model was made on will do for its last part.
    """
    slashed = name.replace("\\", "/")
    for candidate in dict.fromkeys((name, slashed, slashed.rpartition("/")[2])):
        for folder in (path.parent, *search_folders()):
            try:
                if candidate and (folder / candidate).is_file():
                    note_read(folder / candidate)
                    return folder / candidate
            except OSError:  # a name longer than the system's
                continue
    return None


def texture_beside(path: Path, where: str, name: str) -> Path | None:
    """Return the picture that a file names; without it the model loads as well, with a warning."""
    found = beside(path, name)
    if found is None:
        warn_once(f"{path}, {where}: there is no picture {name}; the model is drawn without it.")
    return found


def warn_without_faces(path: Path) -> None:
    """Say that nothing will show."""
    warn_once(f"{path} has no faces, so there is nothing to draw.")


def finite_or_zero(values: F32) -> F32:
    """Return values with 0 for infinite ones and for those that are no number."""
    return np.where(np.isfinite(values), values, np.float32(0))


def first_not_finite(rows: F32) -> int | None:
    """Return which row has a number that cannot be drawn, or None."""
    wrong = np.flatnonzero(~np.isfinite(rows).all(axis=1))
    return int(wrong[0]) if len(wrong) else None


def starts(lengths: Iterable[int] | I64) -> I64:
    """Return where each run begins, and where the last one ends, (f + 1,)."""
    return np.concatenate([[0], np.cumsum(np.asarray(lengths, np.int64))]).astype(np.int64)
