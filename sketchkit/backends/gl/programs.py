"""Programs: compiled once; the vertex columns that each reads, and a pipeline's uniforms."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import moderngl

from sketchkit.backends.gl.glsl import source
from sketchkit.core.lights import MOST_LIGHTS, Light, LightKind, LightRig
from sketchkit.core.matrix import (
    Affine,
    multiply4,
    normal_matrix,
    to_mat4,
    transpose3,
    transpose4,
)
from sketchkit.draw.pipeline import Pipeline, Program
from sketchkit.draw.resources import Target, Texture

# The vertex and the fragment shader of each program.
_FILES: dict[Program, tuple[str, str]] = {
    Program.FLAT: ("fill", "color"),
    Program.TEXTURED: ("fill", "texture"),
    Program.LIT: ("light", "light"),
    Program.TEXTURED_LIT: ("light", "texlight"),
    Program.LINE: ("line", "color"),
    Program.POINT: ("point", "color"),
}
LIT = (Program.LIT, Program.TEXTURED_LIT)
_COLUMNS = ("position", "color")
_LIT_COLUMNS = (*_COLUMNS, "normal", "ambient", "specular", "emissive", "shininess")
# What each program reads of a vertex.
COLUMNS: dict[Program, tuple[str, ...]] = {
    Program.FLAT: _COLUMNS,
    Program.TEXTURED: (*_COLUMNS, "uv"),
    Program.LIT: _LIT_COLUMNS,
    Program.TEXTURED_LIT: (*_LIT_COLUMNS, "uv"),
    Program.LINE: (*_COLUMNS, "direction"),
    Program.POINT: (*_COLUMNS, "offset"),
}


class BuiltInProgram:
    """One of our own programs, in one context.

    Attributes
    ----------
    compiled : moderngl.Program
    """

    def __init__(self, compiled: moderngl.Program, columns: Sequence[str]) -> None:
        self.compiled = compiled
        self._uniforms = {
            name: member
            for name in compiled
            if isinstance(member := compiled[name], moderngl.Uniform)
        }
        self._columns = [name for name in columns if name in list(compiled)]
        self._written: dict[str, object] = {}
        self._lights: LightRig | None = None

    def attributes(self) -> Iterator[tuple[str, str, bool]]:
        """Yield each attribute that it reads, the column for it, and whether that is of ints."""
        for name in self._columns:
            yield name, name, False

    def tell_of_unfed(self, columns: Collection[str]) -> None:
        """Say nothing: it knows what it reads."""

    def set_pipeline(self, pipeline: Pipeline, y_sign: float) -> None:
        """Give it the values of a pipeline; -1 for `y_sign` turns the picture over."""
        target = pipeline.target
        self._write(
            {
                "projection": transpose4(pipeline.projection),  # GLSL has columns for our rows
                "y_sign": y_sign,
                "v_range": _v_range(pipeline.texture),
                "viewport": (target.across, target.down),
                "line_scale": pipeline.line_scale,
                "perspective": pipeline.stroke_perspective,
            }
        )
        if pipeline.program in LIT and pipeline.lights is not self._lights:
            self._write(_light_values(pipeline.lights))
            self._lights = pipeline.lights

    def set_placing(self, pipeline: Pipeline, modelview: Affine, weight_scale: float) -> None:
        """Give it what takes vertices to eye space: what is there already has the identity."""
        full = to_mat4(modelview)
        self._write(
            {
                "transform": transpose4(multiply4(pipeline.projection, full)),
                "modelview": transpose4(full),
                "normal_matrix": transpose3(normal_matrix(modelview)),
                "weight_scale": weight_scale,
            }
        )

    def _write(self, values: Mapping[str, object]) -> None:
        """Write those values that the program has a use for and that are not there already."""
        for name, value in values.items():
            uniform = self._uniforms.get(name)
            if uniform is not None and self._written.get(name) != value:
                uniform.value = value
                self._written[name] = value


class Programs:
    """The built-in programs of one context."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._compiled: dict[Program, BuiltInProgram] = {}

    def get(self, program: Program) -> BuiltInProgram:
        """Return a program, compiled when it is first used."""
        if program not in self._compiled:
            compiled = compile_pair(self._context, *_FILES[program])
            self._compiled[program] = BuiltInProgram(compiled, COLUMNS[program])
        return self._compiled[program]


def compile_pair(context: moderngl.Context, vertex: str, fragment: str) -> moderngl.Program:
    """Return the program made of two of our shader files, named without their endings."""
    return context.program(
        vertex_shader=source(f"{vertex}.vert"), fragment_shader=source(f"{fragment}.frag")
    )


def _v_range(texture: Texture | None) -> tuple[float, float]:
    """Return where v begins and how far it goes: a target's rows may begin at the bottom."""
    if isinstance(texture, Target) and not texture.top_row_first:
        return 1.0, -1.0
    return 0.0, 1.0


def _light_values(lights: Sequence[Light]) -> dict[str, object]:
    """Return the arrays that lighting.glsl reads; rows of lights that are not there are 0."""
    missing = [(0.0,) * 3] * (MOST_LIGHTS - len(lights))

    def is_placed(light: Light) -> float:
        return float(light.kind is not LightKind.DIRECTIONAL)

    return {
        "light_count": len(lights),
        "light_position": [(*light.position, is_placed(light)) for light in lights]
        + [(0.0,) * 4] * len(missing),
        "light_direction": [light.direction for light in lights] + missing,
        "light_ambient": [light.ambient for light in lights] + missing,
        "light_diffuse": [light.diffuse for light in lights] + missing,
        "light_specular": [light.specular for light in lights] + missing,
        "light_falloff": [light.falloff for light in lights] + missing,
        "light_spot": [(light.spot_cosine, light.concentration) for light in lights]
        + [(0.0,) * 2] * len(missing),
    }
