"""What a shader is made of: its text, read from files, and what that declares."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from sketchkit.core.errors import SketchError
from sketchkit.core.notices import warn_once
from sketchkit.draw.shading import ShaderFile, ShaderKind, ShaderSource
from sketchkit.glsl.interface import Declared, read_interface

# What our vertex shader reads of a vertex where the sketch has none of its own.
STAND_IN_ATTRIBUTES = {
    ShaderKind.COLOR: {"position", "color"},
    ShaderKind.LIGHT: {"position", "color", "normal", "texCoord"},
    ShaderKind.TEXLIGHT: {"position", "color", "normal", "texCoord"},
}
TEXTURED = {"position", "color", "texCoord"}

Declarations = Mapping[str, Declared]


class ShaderPaths(NamedTuple):
    """The files of a shader."""

    fragment: Path
    vertex: Path | None

    @property
    def all(self) -> tuple[Path, ...]:
        """Both, or the one there is."""
        return (self.fragment,) if self.vertex is None else (self.fragment, self.vertex)

    def read(self) -> tuple[ShaderSource, Declarations]:
        """Return what the files hold now, and the uniforms that it declares.

        Raises
        ------
        SketchError
            If a file cannot be read.
        """
        vertex = None if self.vertex is None else _read_file(self.vertex)
        return read_source(vertex, _read_file(self.fragment))


def read_source(
    vertex: ShaderFile | None, fragment: ShaderFile
) -> tuple[ShaderSource, Declarations]:
    """Return a shader of two texts, and the uniforms that it declares."""
    interface = read_interface(vertex.text if vertex else None, fragment.text)
    if vertex is not None and interface.kinds_differ:
        warn_once(
            f"{vertex.name} and {fragment.name} are for different kinds of shapes, as their"
            f" #define PROCESSING_..._SHADER say: {vertex.name} decides."
        )
    kind = ShaderKind(interface.kind or ShaderKind.ANY.value)
    attributes = interface.attributes
    if vertex is None:
        attributes = frozenset(STAND_IN_ATTRIBUTES.get(kind, TEXTURED))
    return ShaderSource(vertex, fragment, kind, frozenset(attributes)), interface.uniforms


def _read_file(path: Path) -> ShaderFile:
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise SketchError(f"{path} cannot be read: {problem.strerror}.") from None
    try:
        return ShaderFile(data.decode("utf-8-sig"), path.name)
    except UnicodeDecodeError:  # a comment in an older encoding
        return ShaderFile(data.decode("latin-1"), path.name)
