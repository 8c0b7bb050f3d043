"""Values of a draw list as JSON and bytes, and back.

Which classes there may be is a table: reading makes nothing else, and calls nothing but them.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from enum import Enum
from typing import TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.lights import Light, LightKind
from sketchkit.core.notices import Place
from sketchkit.core.style import Material, Style
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.pipeline import Blend, Clip
from sketchkit.draw.recorder import CurveRun, Custom, CustomKind, ShapeRun
from sketchkit.draw.resources import CubeMap, Pixels, Target, Wrap
from sketchkit.draw.shading import (
    ShaderFile,
    ShaderKind,
    ShaderSource,
    Shading,
    Shadings,
    Uniforms,
)
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import Layer, Materials, VertexBlock
from sketchkit.tape.messages import TapeError

Resource: TypeAlias = Pixels | Target | Mesh | ShaderSource | CubeMap
RESOURCES = (Pixels, Target, Mesh, ShaderSource, CubeMap)  # written once, then called by a number

# What is written field by field. Those of SHARED are the same object again when they are read.
CLASSES: dict[str, type] = {
    kind.__name__: kind
    for kind in (
        Clip,
        CurveRun,
        Custom,
        Light,
        Material,
        Materials,
        MeshPart,
        ShaderFile,
        Shading,
        Shadings,
        ShapeRun,
        Stage,
        Style,
        Uniforms,
        VertexBlock,
    )
}
SHARED = (Stage, Style, Uniforms)
ENUMS: dict[str, type[Enum]] = {
    kind.__name__: kind for kind in (Blend, CustomKind, Layer, LightKind, ShaderKind, Wrap)
}
DTYPES = frozenset({"<f4", "<f8", "|u1", "<u4", "<i4", "<i8"})


class Encoder:
    """Writes the values of one message.

    Parameters
    ----------
    number_of : callable
        Returns the number of a resource, which has been written before.

    Attributes
    ----------
    body : bytearray
    """

    def __init__(self, number_of: Callable[[Resource], int]) -> None:
        self.body = bytearray()
        self._number_of = number_of
        self._shared: dict[int, int] = {}  # by identity
        self._kept: list[object] = []  # so that no identity is used again

    def encode(self, value: object) -> object:
        """Return a value as JSON has it; arrays go to the body."""
        if isinstance(value, RESOURCES):
            return {"r": self._number_of(value)}
        if CLASSES.get(type(value).__name__) is type(value):
            return self._object(type(value).__name__, value)
        match value:
            case Enum():
                return {"e": type(value).__name__, "v": value.value}
            case None | bool() | int() | float() | str():
                return value
            case np.ndarray():
                return self.array(value)
            case np.generic():
                return value.item()
            case Place(file=file, line=line):
                return {"p": [file, line]}
        return self._collection(value)

    def _collection(self, value: object) -> object:
        match value:
            case list():
                return [self.encode(item) for item in value]
            case tuple():
                return {"t": [self.encode(item) for item in value]}
            case Mapping():
                return {"m": [[key, self.encode(item)] for key, item in value.items()]}
        raise TypeError(f"a tape has no place for a {type(value).__name__}")

    def array(self, array: NDArray[np.generic] | bytes | bytearray | memoryview) -> object:
        """Return where in the body an array has been put."""
        data = np.ascontiguousarray(
            array if isinstance(array, np.ndarray) else np.frombuffer(array, np.uint8)
        )
        start = len(self.body)
        self.body += data.tobytes()
        return {"a": data.dtype.str, "s": list(data.shape), "o": start}

    def _object(self, name: str, value: object) -> object:
        if not isinstance(value, SHARED):
            return {"c": name, "v": self._fields(value)}
        if id(value) in self._shared:
            return {"i": self._shared[id(value)]}
        fields = self._fields(value)  # first: they may be shared as well
        self._shared[id(value)] = len(self._kept)
        self._kept.append(value)
        return {"c": name, "v": fields}

    def _fields(self, value: object) -> list[object]:
        if isinstance(value, tuple):  # a NamedTuple
            return [self.encode(item) for item in value]
        fields = dataclasses.fields(cast("Style", value))  # any dataclass
        return [self.encode(getattr(value, field.name)) for field in fields]


class Decoder:
    """Reads the values of one message.

    Parameters
    ----------
    body : bytes
    resources : mapping
        By number.
    """

    def __init__(self, body: bytes, resources: Mapping[int, Resource]) -> None:
        self._body = body
        self._resources = resources
        self._shared: list[object] = []

    def decode(self, value: object) -> object:
        """Return the value that was encoded.

        Raises
        ------
        TapeError
            If none can have been.
        """
        try:
            return self._decode(value)
        except (KeyError, IndexError, TypeError, ValueError, RecursionError):
            raise TapeError("The recording is damaged.") from None

    def array(self, value: object) -> NDArray[np.generic]:
        """Return an array of its own, which may be written to."""
        try:
            return self._array(cast("dict[str, object]", value))
        except (KeyError, TypeError, ValueError):
            raise TapeError("The recording is damaged.") from None

    def _decode(self, value: object) -> object:
        if isinstance(value, list):
            return [self._decode(item) for item in value]
        return self._decode_tagged(value) if isinstance(value, dict) else value

    def _decode_tagged(self, value: dict[str, object]) -> object:
        match value:
            case {"t": list(items)}:
                return tuple(self._decode(item) for item in items)
            case {"m": list(entries)}:
                return {key: self._decode(item) for key, item in entries}
            case {"a": _}:
                return self._array(value)
            case {"e": str(name), "v": plain}:
                return ENUMS[name](plain)
            case {"r": int(number)}:
                return self._resources[number]
            case {"i": int(index)}:
                return self._shared[index]
            case {"p": [str(file), int(line)]}:
                return Place(file, line, {})
            case {"c": str(name), "v": list(fields)}:
                return self._object(name, fields)
        raise TypeError

    def _object(self, name: str, fields: list[object]) -> object:
        made: object = CLASSES[name](*[self._decode(field) for field in fields])
        if isinstance(made, SHARED):
            self._shared.append(made)
        return made

    def _array(self, value: Mapping[str, object]) -> NDArray[np.generic]:
        name, shape, start = value["a"], value["s"], value["o"]
        if name not in DTYPES or not isinstance(shape, list) or not isinstance(start, int):
            raise TypeError
        dtype, sizes = np.dtype(str(name)), [int(size) for size in shape]
        if min([start, *sizes]) < 0:
            raise ValueError
        count = int(np.prod(sizes, dtype=object)) if sizes else 1
        data = np.frombuffer(self._body, dtype, count, start) if count else np.empty(0, dtype)
        return data.reshape(sizes).copy()
