"""Shaders of the sketch's own, as plain data: what they are, and the values that they are given."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

from sketchkit.core.notices import Place
from sketchkit.draw.resources import CubeMap, Texture

PREVIOUS = "ppixels"  # Processing's sampler of what the canvas showed before

# Numbers in the order in which GLSL stores them, an image, or several for an array of samplers.
UniformValue = tuple[float, ...] | Texture | CubeMap | tuple[Texture, ...]


class ShaderKind(Enum):
    """What a define in its source limits a shader to; the names are Processing's."""

    COLOR = "COLOR"  # neither texture nor light
    TEXTURE = "TEXTURE"
    LIGHT = "LIGHT"
    TEXLIGHT = "TEXLIGHT"
    LINE = "LINE"
    POINT = "POINT"
    ANY = "POLY"  # no define


@dataclass(frozen=True, slots=True)
class ShaderFile:
    """One of a program's two shaders.

    Attributes
    ----------
    text : str
        As the sketch has it.
    name : str
        Its file, for messages; of one given as text: what it is.
    """

    text: str
    name: str


@dataclass(frozen=True, eq=False)
class ShaderSource:
    """A program of the sketch's own; another one, when its files change.

    Attributes
    ----------
    vertex, fragment : ShaderFile or None
        None stands for the built-in one.
    kind : ShaderKind
    attributes : frozenset of str
        Names of what its vertex shader reads of a vertex.
    """

    vertex: ShaderFile | None
    fragment: ShaderFile | None
    kind: ShaderKind
    attributes: frozenset[str]

    @property
    def name(self) -> str:
        """What messages call it."""
        return next(file.name for file in (self.fragment, self.vertex) if file is not None)

    @property
    def reads_material(self) -> bool:
        """Whether it makes sense with lights alone, in Processing's view."""
        return bool(self.attributes & {"ambient", "specular", "emissive", "shininess"})


@dataclass(frozen=True, eq=False, slots=True)
class Uniforms:
    """The values that a sketch had given to a shader when something was drawn.

    Attributes
    ----------
    values : dict
    place : Place or None
        Where the sketch chose the shader, or gave it the values: remarks are about that line.
    """

    values: Mapping[str, UniformValue] = field(default_factory=dict)
    place: Place | None = None


class Shading(NamedTuple):
    """A shader, and the values it is used with."""

    source: ShaderSource
    uniforms: Uniforms

    def serves(self, *, is_textured: bool, is_lit: bool) -> bool:
        """Return whether fills of this kind are drawn by it; else the built-in one does."""
        match self.source.kind:
            case ShaderKind.COLOR:
                return not is_textured and not is_lit
            case ShaderKind.TEXTURE:
                return is_textured and not is_lit
            case ShaderKind.LIGHT:
                return not is_textured and is_lit
            case ShaderKind.TEXLIGHT:
                return is_textured and is_lit
            case ShaderKind.ANY:
                return is_lit or not self.source.reads_material
            case _:
                return False


class Shadings(NamedTuple):
    """The shaders in force, by what they draw; None: the built-in ones."""

    fills: Shading | None = None
    lines: Shading | None = None
    points: Shading | None = None

    @property
    def reads_normals(self) -> bool:
        """Whether fills need normals and materials even without lights."""
        return self._reads({"normal", "ambient", "specular", "emissive", "shininess"})

    @property
    def reads_uvs(self) -> bool:
        """Whether fills need texture coordinates even without a texture."""
        return self._reads({"texCoord"})

    def _reads(self, names: set[str]) -> bool:
        return self.fills is not None and bool(self.fills.source.attributes & names)


BUILT_IN = Shadings()
