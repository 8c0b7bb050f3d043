"""What a sketch gives to a uniform, as the shader declares it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.api.pvector import PVector
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.draw.resources import CubeMap, Pixels, Target, Texture
from sketchkit.glsl.interface import Declared

MATRICES = (PMatrix2D, PMatrix3D)
SIZES = {"float": 1, "double": 1, "int": 1, "uint": 1, "bool": 1}
SIZES |= {f"{kind}vec{n}": n for kind in ("", "i", "u", "b", "d") for n in (2, 3, 4)}
SIDES = {"mat2": 2, "mat3": 3, "mat4": 4, "mat2x2": 2, "mat3x3": 3, "mat4x4": 4}
SIZES |= {name: side * side for name, side in SIDES.items()}
FACES = 6  # of a cube map
# What Processing's set() may be told after a list or matrix: it follows from the declaration.
HINTS = (2, 3, 4, True, False)


def numbers_for(name: str, declared: Declared, values: tuple[object, ...]) -> tuple[float, ...]:
    """Return the numbers for a uniform, in the order in which GLSL stores them.

    Raises
    ------
    SketchError
        If they do not fit what the shader declares.
    """
    if len(values) == 2 and _may_have_hint(values[0]) and values[1] in HINTS:
        values = values[:1]
    size = SIZES.get(declared.type)
    if size is None:
        raise SketchError(
            f"{name} is a {declared.type} in the shader: set its members one by one.",
            hint=f'Write set("{name}.member", value).',
        )
    numbers = list(_flat(name, declared, values))
    if numbers and isinstance(values[0], PVector) and size < 3 and len(values) == 1:
        numbers = numbers[:size]
    wanted = size * (declared.length or 1)
    fits = len(numbers) == wanted
    if declared.length is not None:  # the first elements of an array may be set alone
        fits = 0 < len(numbers) <= wanted and len(numbers) % size == 0
    if not fits:
        raise _unfit(name, declared, values, wanted)
    return tuple(numbers)


def textures_for(
    name: str, declared: Declared, values: tuple[object, ...]
) -> Texture | CubeMap | tuple[Texture, ...]:
    """Return the image for a sampler; of an array several, of a cube map six.

    Raises
    ------
    SketchError
        If they are no images, or too few, or do not fit together.
    """
    images = list(values)
    if len(images) == 1 and isinstance(images[0], list | tuple):
        images = list(images[0])
    found = [_texture_of(name, declared, image) for image in images]
    wanted = declared.length or (FACES if "Cube" in declared.type else 1)
    if len(found) != wanted:
        raise SketchError(
            f"{name} is a {_declaration(declared)} in the shader: it takes {wanted} images.",
            got=str(len(found)),
        )
    if "Cube" in declared.type:
        return _cube_of(name, found)
    return found[0] if wanted == 1 else tuple(found)


def _cube_of(name: str, faces: list[Texture]) -> CubeMap:
    sizes = {(face.width, face.height) for face in faces}
    if len(sizes) > 1 or faces[0].width != faces[0].height:
        raise SketchError(
            f"{name} is a samplerCube in the shader: its six images are squares of one size.",
            got=", ".join(f"{width} x {height}" for width, height in sorted(sizes)),
        )
    return CubeMap(tuple(faces))


def _texture_of(name: str, declared: Declared, image: object) -> Texture:
    texture = getattr(image, "_texture", None)
    found = texture() if callable(texture) else None
    if not isinstance(found, Pixels | Target):
        raise SketchError(
            f"{name} is a {_declaration(declared)} in the shader: it takes an image.",
            got=f"{kind_of(image)}: {shown(image)}",
        )
    return found


def _flat(name: str, declared: Declared, values: Iterable[Any]) -> Iterator[float]:  # Any: checked
    """Yield the numbers of whatever a sketch gives."""
    for value in values:
        if isinstance(value, PVector):
            yield from (value.x, value.y, value.z)
        elif isinstance(value, MATRICES):
            yield from _matrix_numbers(value, SIDES.get(declared.type, 4))
        elif _is_number(value):
            yield float(value)
        else:
            yield from _of_sequence(name, declared, value)


def _of_sequence(
    name: str, declared: Declared, value: Iterable[Any]
) -> Iterator[float]:  # Any: checked
    """Yield the numbers of a list: nested rows of a matrix are stored as columns."""
    side = SIDES.get(declared.type)
    rows = _as_rows(value) if side else None
    if rows is not None and rows.shape[-2:] == (side, side):
        yield from np.swapaxes(rows, -1, -2).ravel().tolist()
        return
    if isinstance(value, str):  # its letters are strings again
        raise _unfit(name, declared, (value,), SIZES[declared.type])
    try:
        yield from _flat(name, declared, iter(value))
    except TypeError:
        raise _unfit(name, declared, (value,), SIZES[declared.type]) from None


def _as_rows(value: object) -> np.ndarray[Any, np.dtype[np.float64]] | None:  # Any: its shape
    """Return nested lists of numbers, or a NumPy array, as rows; None if it is neither."""
    if isinstance(value, list | tuple) and any(isinstance(part, MATRICES) for part in value):
        return None  # NumPy would take them for rows too, but theirs are GLSL's columns
    try:
        rows = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        return None
    return rows if rows.ndim >= 2 else None


def _matrix_numbers(matrix: PMatrix2D | PMatrix3D, side: int) -> list[float]:
    """Return the upper left part of a matrix, row by row: GLSL takes the rows for columns."""
    if isinstance(matrix, PMatrix2D):
        matrix = PMatrix3D(matrix)
    return [
        float(getattr(matrix, f"m{row}{column}")) for row in range(side) for column in range(side)
    ]


def _may_have_hint(value: object) -> bool:
    """Return whether Processing's set() may say more behind it: of lists and matrices."""
    return not _is_number(value) and not isinstance(value, PVector)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float | np.number | np.bool_)


def _declaration(declared: Declared) -> str:
    return declared.type if declared.length is None else f"{declared.type}[{declared.length}]"


def _unfit(name: str, declared: Declared, values: tuple[object, ...], wanted: int) -> SketchError:
    noun = "number" if wanted == 1 else "numbers"
    return SketchError(
        f"{name} is a {_declaration(declared)} in the shader: it takes {wanted} {noun}.",
        got=", ".join(map(shown, values)) or "nothing",
    )
