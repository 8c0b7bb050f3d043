"""Programs of the sketch's own shaders: compiled, and given the values of uniforms.

Uniforms and attributes have Processing's names, of both its generations.
"""

from __future__ import annotations

import struct
import weakref
from collections.abc import Collection, Iterator, Mapping

import moderngl

from sketchkit.backends.gl.glsl import source as own_source
from sketchkit.backends.gl.sketch_values import (
    FILLED,
    LIGHT_ARRAYS,
    matrix_values,
    pipeline_values,
    stand_in_values,
)
from sketchkit.core.errors import SketchError
from sketchkit.core.matrix import Affine
from sketchkit.core.notices import warn_once
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.resources import CubeMap, Target, Texture
from sketchkit.draw.shading import (
    PREVIOUS,
    ShaderFile,
    ShaderKind,
    ShaderSource,
    Shading,
    UniformValue,
)
from sketchkit.draw.vertex import CUSTOM
from sketchkit.glsl.dialect import Modern, modernize
from sketchkit.glsl.errors import explain

TEXTURE_NAMES = ("texture", "texMap")  # what a shape is covered with
FIRST_FREE_UNIT = 1  # that is at 0
SAMPLER_TYPES = range(0x8B5D, 0x8B65)  # GL_SAMPLER_1D to GL_SAMPLER_2D_RECT_SHADOW

# The columns of vertices by Processing's names; others are those that `attrib()` gives.
COLUMN_OF = {
    "position": "position",
    "vertex": "position",
    "color": "color",
    "texCoord": "uv",
    "normal": "normal",
    "ambient": "ambient",
    "specular": "specular",
    "emissive": "emissive",
    "shininess": "shininess",
    "direction": "direction",
    "offset": "offset",
}

# What stands in for a vertex shader that the sketch has not given.
_STAND_INS = {
    ShaderKind.COLOR: "fill",
    ShaderKind.TEXTURE: "fill",
    ShaderKind.ANY: "fill",
    ShaderKind.LIGHT: "light",
    ShaderKind.TEXLIGHT: "light",
    ShaderKind.LINE: "line",
    ShaderKind.POINT: "point",
}
_OF_LAYER = {Program.LINE: "line", Program.POINT: "point"}


class SketchProgram:
    """A program of the sketch's, in one context.

    Attributes
    ----------
    compiled : moderngl.Program
    """

    def __init__(
        self, compiled: moderngl.Program, renamed: Mapping[str, str], *, has_stand_in: bool
    ) -> None:
        self.compiled = compiled
        self._has_stand_in = has_stand_in
        self._actual = renamed  # names that GLSL now has a use for itself
        self._shading: Shading | None = None
        self._units = self._assign_units()
        self._unset = set(self._uniforms_to_set())
        self._unfed = {
            column.removeprefix(CUSTOM)
            for _, column, _ in self.attributes()
            if column.startswith(CUSTOM)
        }

    def _uniforms_to_set(self) -> Iterator[str]:
        """Yield what only the sketch can give a value; the compiler has left out what is unused."""
        given = {actual: name for name, actual in self._actual.items()}
        for actual in self.compiled:
            member = self.compiled[actual]
            if not isinstance(member, moderngl.Uniform):
                continue
            has_initializer = not _is_sampler(member) and any(member.read())
            if not has_initializer and not _is_filled(given.get(actual, actual)):
                yield given.get(actual, actual)

    def _assign_units(self) -> dict[str, int]:
        """Give each sampler a texture unit of its own; elements of arrays follow one another."""
        units, free = {}, FIRST_FREE_UNIT
        covers = {self._actual.get(name, name) for name in TEXTURE_NAMES}
        for name in self.compiled:
            member = self.compiled[name]
            if isinstance(member, moderngl.Uniform) and _is_sampler(member):
                if name in covers:
                    member.value = units[name] = 0
                    continue
                units[name] = free
                last = free + member.array_length
                member.value = free if member.array_length == 1 else list(range(free, last))
                free = last
        return units

    def attributes(self) -> Iterator[tuple[str, str, bool]]:
        """Yield each attribute that it reads, the column for it, and whether that is of ints."""
        given = {actual: name for name, actual in self._actual.items()}
        for actual in self.compiled:
            member = self.compiled[actual]
            if isinstance(member, moderngl.Attribute):
                name = given.get(actual, actual)
                column = COLUMN_OF.get(name, CUSTOM + name)
                yield actual, column, str(member.shape) in "iI"

    def set_pipeline(self, pipeline: Pipeline, y_sign: float) -> None:
        """Give it the values of a pipeline: Processing's, and those that the sketch has set."""
        assert pipeline.shading is not None
        self._shading = pipeline.shading
        self._tell_of_unset(self._shading)
        given = pipeline_values(pipeline)
        if self._has_stand_in:
            given |= stand_in_values(given, y_sign)
        given["sk_y_sign"] = (y_sign,)
        if len(pipeline.lights) != 1:  # what is no array then keeps its value, as in Processing
            given = {name: value for name, value in given.items() if not self._is_lone_light(name)}
        for name, value in (dict(pipeline.shading.uniforms.values) | given).items():
            self._write(name, value)

    def _tell_of_unset(self, shading: Shading) -> None:
        """Say once which uniforms the sketch has not set."""
        missing = sorted(self._unset - shading.uniforms.values.keys())
        if not missing:
            return
        self._unset.difference_update(missing)
        what, they_are = ("a uniform", "it is") if len(missing) == 1 else ("uniforms", "they are")
        sees = " or ".join(sorted({"black" if name in self._units else "0" for name in missing}))
        warn_once(
            f"Nothing has set {', '.join(missing)}, {what} of the shader of {shading.source.name}:"
            f" {they_are} {sees}. Its set() sets {'it' if len(missing) == 1 else 'them'}.",
            shading.uniforms.place,
        )

    def tell_of_unfed(self, columns: Collection[str]) -> None:
        """Say once which attributes of the sketch's own are not among the vertices' columns."""
        shading = self._shading
        for name in sorted(self._unfed):
            if shading is not None and CUSTOM + name not in columns:
                warn_once(
                    f"Nothing feeds {name}, an attribute of the shader of {shading.source.name}:"
                    " it is 0. attrib() gives it to vertices.",
                    shading.uniforms.place,
                )
                self._unfed.discard(name)

    def _is_lone_light(self, name: str) -> bool:
        """Return whether a value of the lights would go to a uniform for one light."""
        member = self.compiled.get(name, None)
        if name not in LIGHT_ARRAYS or not isinstance(member, moderngl.Uniform):
            return False
        return bool(member.array_length == 1)

    def set_placing(self, pipeline: Pipeline, modelview: Affine, weight_scale: float) -> None:
        """Give it what takes vertices to eye space."""
        values = matrix_values(pipeline.projection, modelview)
        for name, value in (values | {"weight_scale": (weight_scale,)}).items():
            self._write(name, value)

    def textures(
        self, values: Mapping[str, UniformValue], target: Target
    ) -> Iterator[tuple[int, Texture | CubeMap | None]]:
        """Yield what goes to each texture unit; None: nothing was set.

        The target stands for what was on it before.
        """
        known = {self._actual.get(name, name): value for name, value in values.items()}
        known[PREVIOUS] = target
        for name, first in self._units.items():
            if not first:  # a shape's own texture is
                continue
            member = self.compiled[name]
            assert isinstance(member, moderngl.Uniform)
            value = known.get(name)
            images = value if isinstance(value, tuple) else (value,) * member.array_length
            for offset, image in enumerate(images):
                assert not isinstance(image, float)  # set() has looked
                yield first + offset, image

    def _write(self, name: str, value: UniformValue) -> None:
        """Write numbers into a uniform, if the compiler has kept it."""
        member = self.compiled.get(self._actual.get(name, name), None)
        if not isinstance(member, moderngl.Uniform) or _is_sampler(member):
            return
        if not isinstance(value, tuple):
            return
        count = member.dimension * member.array_length
        letter = member.fmt[-1]  # type: ignore[attr-defined] # the stubs forget it
        convert = float if letter == "f" else int
        numbers = [convert(number) for number in value[:count]]  # type: ignore[arg-type] # numbers: no sampler
        numbers += [convert(0)] * (count - len(numbers))
        member.write(struct.pack(f"{count}{letter}", *numbers))


class SketchPrograms:
    """The sketch's programs, compiled when they are first used."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._compiled: weakref.WeakKeyDictionary[ShaderSource, dict[str, SketchProgram]] = (
            weakref.WeakKeyDictionary()
        )

    def get(self, source: ShaderSource, program: Program) -> SketchProgram:
        """Return a source's program for what a built-in program would draw.

        Raises
        ------
        SketchError
            If it does not compile, with the line of the sketch's own file.
        """
        stand_in = _OF_LAYER.get(program, _STAND_INS[source.kind])
        family = stand_in if source.vertex is None else "its own"
        programs = self._compiled.setdefault(source, {})
        if family not in programs:
            programs[family] = self._compile(source, stand_in)
        return programs[family]

    def _compile(self, source: ShaderSource, stand_in: str) -> SketchProgram:
        version = min(self._context.version_code, 450)
        vertex = _modern(source.vertex, "vertex", version)
        fragment = _modern(source.fragment, "fragment", version)
        try:
            compiled = self._context.program(
                vertex_shader=vertex.text if vertex else own_source(f"sketch/{stand_in}.vert"),
                fragment_shader=fragment.text if fragment else own_source("sketch/color.frag"),
            )
        except moderngl.Error as problem:
            raise SketchError(*_explained(str(problem), source, vertex, fragment)) from None
        renamed = {
            name: actual
            for shader in (vertex, fragment)
            if shader is not None
            for name, actual in shader.renamed.items()
        }
        return SketchProgram(compiled, renamed, has_stand_in=vertex is None)


def _modern(file: ShaderFile | None, stage: str, version: int) -> Modern | None:
    return None if file is None else modernize(file.text, stage, version)


def _explained(
    log: str, source: ShaderSource, vertex: Modern | None, fragment: Modern | None
) -> tuple[str]:
    return (explain(log, source.vertex, source.fragment, vertex, fragment),)


def _is_filled(name: str) -> bool:
    """Return whether a uniform is none that the sketch has to set."""
    return name in FILLED or name == PREVIOUS or name.startswith(("sk_", "gl_"))


def _is_sampler(member: moderngl.Uniform) -> bool:
    return member.gl_type in SAMPLER_TYPES  # type: ignore[attr-defined] # ditto
