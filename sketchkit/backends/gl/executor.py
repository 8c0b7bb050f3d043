"""GlBackend: carries out draw lists with OpenGL 3.3."""

from __future__ import annotations

from typing import NamedTuple

import moderngl

from sketchkit.backends.gl.buffers import Buffers
from sketchkit.backends.gl.context import headless_context, window_context
from sketchkit.backends.gl.cubes import Cubes
from sketchkit.backends.gl.programs import BuiltInProgram, Programs, compile_pair
from sketchkit.backends.gl.sketch_programs import SketchProgram, SketchPrograms
from sketchkit.backends.gl.targets import Surfaces
from sketchkit.backends.gl.textures import Textures
from sketchkit.backends.gl.turning import FindFunction, Turning
from sketchkit.core.matrix import IDENTITY, Affine
from sketchkit.draw.commands import Clear, Draw, DrawList, DrawMesh, Settle, Settling, Upload
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.pipeline import Blend, Clip, Pipeline, Program
from sketchkit.draw.resources import CubeMap, Pixels, Target, Texture
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import U8


class _BlendRule(NamedTuple):
    """How a source and what is there already make a pixel: factors and equation of the colours.

    Alphas are added in every mode but REPLACE.
    """

    source: int
    destination: int
    equation: int = moderngl.FUNC_ADD


_BLEND_RULES: dict[Blend, _BlendRule] = {
    Blend.REPLACE: _BlendRule(moderngl.ONE, moderngl.ZERO),
    Blend.BLEND: _BlendRule(moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA),
    Blend.ADD: _BlendRule(moderngl.SRC_ALPHA, moderngl.ONE),
    Blend.SUBTRACT: _BlendRule(moderngl.SRC_ALPHA, moderngl.ONE, moderngl.FUNC_REVERSE_SUBTRACT),
    Blend.LIGHTEST: _BlendRule(moderngl.ONE, moderngl.ONE, moderngl.MAX),
    Blend.DARKEST: _BlendRule(moderngl.ONE, moderngl.ONE, moderngl.MIN),
    Blend.EXCLUSION: _BlendRule(moderngl.ONE_MINUS_DST_COLOR, moderngl.ONE_MINUS_SRC_COLOR),
    Blend.MULTIPLY: _BlendRule(moderngl.ZERO, moderngl.SRC_COLOR),
    Blend.SCREEN: _BlendRule(moderngl.ONE_MINUS_DST_COLOR, moderngl.ONE),
}


Placing = tuple[Affine, float]
IN_PLACE: Placing = (IDENTITY, 1.0)


class GlBackend:
    """Draws with the graphics card, or with a driver in software that stands in for one."""

    name = "gl"

    def __init__(
        self, context: moderngl.Context, origin: str, find: FindFunction | None = None
    ) -> None:
        self.context = context
        # What nothing refers to any more is released on the GPU too, at the next list of commands:
        # at once would be too early, as without a window the context is current only meanwhile.
        context.gc_mode = "context_gc"
        self.origin = origin
        self._turning = Turning(context, find)
        self._programs = Programs(context)
        self._sketch_programs = SketchPrograms(context)
        self._buffers = Buffers(context)
        self._surfaces = Surfaces(context)
        self._textures = Textures(context)
        self._cubes = Cubes(context)
        self._show: moderngl.VertexArray | None = None
        self._first_sample: moderngl.VertexArray | None = None
        self._copy: moderngl.VertexArray | None = None

    @classmethod
    def headless(cls) -> GlBackend:
        """Return a backend without a window.

        Raises
        ------
        NoContextError
            If no OpenGL 3.3 can be had.
        """
        return cls(*headless_context())

    @classmethod
    def for_window(cls, find: FindFunction) -> GlBackend:
        """Return a backend for the window whose context is current.

        `find` returns the address of a function of OpenGL.

        Raises
        ------
        NoContextError
            If the window has less than OpenGL 3.3.
        """
        return cls(window_context(), "window", find)

    def describe(self) -> dict[str, str]:
        """Return vendor, renderer and version, and where the context comes from."""
        info = self.context.info
        return {
            "context": self.origin,
            "vendor": info["GL_VENDOR"],
            "renderer": info["GL_RENDERER"],
            "version": info["GL_VERSION"],
        }

    def execute(self, commands: DrawList) -> None:
        """Carry out the commands in order."""
        with self.context:
            self._release_unused()
            self._execute(commands)

    def _release_unused(self) -> None:
        unused = self.context.objects
        while unused:
            made = unused.popleft()
            if hasattr(made, "release"):  # else it was released by name
                made.release()

    def _execute(self, commands: DrawList) -> None:
        self._buffers.upload(commands.blocks)
        bound: Pipeline | None = None
        placed: Placing | None = None
        for command in commands.commands:
            if isinstance(command, Draw | DrawMesh):
                if command.pipeline != bound or bound.reads_itself:
                    self._bind(command.pipeline)
                    bound, placed = command.pipeline, None
                if (placing := _placing(command)) != placed:
                    self._program(bound).set_placing(bound, *placing)
                    placed = placing
                self._draw(command)
                continue
            bound = None
            self.context.disable(moderngl.CULL_FACE)
            self._turning.reset()
            match command:
                case Clear():
                    self._clear(command)
                case Settle():
                    self._settle(command)
                case Upload(target, data, left, top):
                    self._surfaces.get(target).upload(self.context, target, data, left, top)
        if bound is not None:  # else these would hold for copies too
            self.context.disable(moderngl.CULL_FACE)
            self._turning.reset()
            self._surfaces.get(bound.target).framebuffer.scissor = None  # type: ignore[assignment]

    def _clear(self, command: Clear) -> None:
        framebuffer = self._surfaces.get(command.target).begin_drawing()
        framebuffer.scissor = _scissor(command.target, command.clip)  # type: ignore[assignment] # the stubs forget None
        framebuffer.depth_mask = command.depth
        red, green, blue, alpha = (channel / 255 for channel in command.color)
        framebuffer.clear(red, green, blue, alpha, depth=1.0)
        framebuffer.scissor = None  # type: ignore[assignment] # the same

    def _settle(self, command: Settle) -> None:
        if command.how is Settling.NOTE:
            self._surfaces.get(command.target).note(self.context, self._turning_copy())
            return
        if self._first_sample is None:
            self._first_sample = self._whole_screen("sample")
        self.context.clear_samplers()
        surface = self._surfaces.get(command.target)
        surface.settle(self.context, command.how, self._first_sample)

    def _turning_copy(self) -> moderngl.VertexArray:
        """Return what draws a texture over a framebuffer, upside down."""
        if self._copy is None:
            self._copy = self._whole_screen("copy")
            self._copy.program["y_sign"] = -1.0
        return self._copy

    def _whole_screen(self, fragment: str) -> moderngl.VertexArray:
        """Return a triangle over the whole framebuffer, drawn by a fragment shader."""
        program = compile_pair(self.context, "show", fragment)
        program["y_sign"] = 1.0
        return self.context.vertex_array(program, [])

    def _bind(self, pipeline: Pipeline) -> None:
        """Make ready to draw; images first: to have the picture of a canvas may take drawing."""
        shading = pipeline.shading
        if pipeline.texture is not None:
            self._use_texture(0, pipeline.texture, pipeline)
        elif shading is not None:
            self._textures.use_nothing(0)
        program = self._program(pipeline)
        if shading is not None and isinstance(program, SketchProgram):
            for unit, texture in program.textures(shading.uniforms.values, pipeline.target):
                self._use_sampler(unit, texture, pipeline)
        self._set_state(pipeline)
        y_sign = self._turning.turn(top_row_first=pipeline.target.top_row_first)
        program.set_pipeline(pipeline, y_sign)

    def _set_state(self, pipeline: Pipeline) -> None:
        """Choose the framebuffer, and how what is drawn meets what is there."""
        context, target = self.context, pipeline.target
        framebuffer = self._surfaces.get(target).begin_drawing()
        framebuffer.use()
        framebuffer.depth_mask = pipeline.depth_write
        framebuffer.scissor = _scissor(target, pipeline.clip)  # type: ignore[assignment] # the stubs forget None
        (context.enable if pipeline.depth_test else context.disable)(moderngl.DEPTH_TEST)
        context.depth_func = "<="
        (context.enable if pipeline.culls_backs else context.disable)(moderngl.CULL_FACE)
        rule = _BLEND_RULES[pipeline.blend]
        context.enable(moderngl.BLEND)
        replaces = pipeline.blend is Blend.REPLACE
        alpha = (moderngl.ONE, moderngl.ZERO if replaces else moderngl.ONE)
        context.blend_equation = rule.equation, moderngl.FUNC_ADD
        context.blend_func = (rule.source, rule.destination, *alpha)  # type: ignore[assignment] # the stubs know pairs alone

    def _use_texture(self, unit: int, texture: Texture, pipeline: Pipeline) -> None:
        """Bind an image, or the picture of a canvas, to a texture unit."""
        if isinstance(texture, Pixels):
            self._textures.use(texture, pipeline.wrap, unit)
            return
        self._turning.reset()
        surface = self._surfaces.get(texture)
        # A shader of the sketch's finds row 0 of a canvas at the bottom, as in Processing.
        if pipeline.shading is not None and texture.top_row_first:
            picture = surface.turned(self.context, self._turning_copy())
        else:
            picture = surface.picture(self.context, pipeline.target)
        self._textures.use_picture(picture, pipeline.wrap, unit)

    def _program(self, pipeline: Pipeline) -> BuiltInProgram | SketchProgram:
        """Return the program that a pipeline is drawn with."""
        if pipeline.shading is None:
            return self._programs.get(pipeline.program)
        return self._sketch_programs.get(pipeline.shading.source, pipeline.program)

    def _use_sampler(
        self, unit: int, texture: Texture | CubeMap | None, pipeline: Pipeline
    ) -> None:
        """Bind what a sampler of the sketch's has: of what is drawn on, the picture of before."""
        if texture is pipeline.target:
            previous = self._surfaces.get(pipeline.target).previous
            if previous is not None:
                self._textures.use_picture(previous, pipeline.wrap, unit)
                return
            texture = None
        match texture:
            case None:
                self._textures.use_nothing(unit)
            case CubeMap():
                self._turning.reset()
                self._cubes.use(texture, self._rows, unit)
            case _:
                self._use_texture(unit, texture, pipeline)

    def _draw(self, command: Draw | DrawMesh) -> None:
        program = self._program(command.pipeline)
        if isinstance(command, Draw):
            drawn: Draw | MeshPart = command
            array = self._buffers.array(command.layer, program)
        else:
            drawn = command.part
            array = self._buffers.mesh_array(drawn.mesh, drawn.layer, program)
        array.render(moderngl.TRIANGLES, vertices=drawn.count, first=drawn.first)

    def prepare(self, source: ShaderSource) -> None:
        """Compile a shader of the sketch's.

        Raises
        ------
        SketchError
            If it does not compile, with the line of the sketch's own file.
        """
        with self.context:
            self._sketch_programs.get(source, Program.FLAT)

    def read(self, target: Target) -> U8:
        """Return what was drawn, (h, w, 4) RGBA, top row first, samples averaged."""
        with self.context:
            return self._rows(target)

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return one pixel of it, (4,) RGBA."""
        row = y if target.top_row_first else target.height - 1 - y
        with self.context:
            return self._surfaces.get(target).read_pixel(self.context, x, row)

    def _rows(self, target: Target) -> U8:
        rows = self._surfaces.get(target).read(self.context)
        return rows.copy() if target.top_row_first else rows[::-1].copy()

    def present(self, target: Target, size: tuple[int, int]) -> None:
        """Show a target in the window, whose framebuffer has `size` pixels."""
        if self._show is None:
            self._show = self._whole_screen("show")
        picture = self._surfaces.get(target).average(self.context)
        window = self.context.detect_framebuffer(0)
        window.viewport = (0, 0, *size)
        window.use()
        self.context.disable(moderngl.DEPTH_TEST | moderngl.BLEND)
        self.context.clear_samplers()
        picture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        picture.use(location=0)
        self._show.program["y_sign"] = -1.0 if target.top_row_first else 1.0
        self._show.render(moderngl.TRIANGLES, vertices=3)

    def forget(self, resource: Pixels | Target | Mesh) -> None:
        """Let go of the copy of a resource."""
        match resource:
            case Target():
                self._surfaces.forget(resource)
            case Mesh():
                self._buffers.forget(resource)
            case Pixels():
                self._textures.forget(resource)

    def close(self) -> None:
        """Let go of the context and everything in it."""
        self.context.release()


def _placing(command: Draw | DrawMesh) -> Placing:
    """Return what takes a command's vertices to eye space, and the scale of its weights."""
    if isinstance(command, Draw):
        return IN_PLACE
    return command.modelview, command.part.weight_scale


def _scissor(target: Target, clip: Clip | None) -> tuple[int, int, int, int] | None:
    """Return a clip in the framebuffer's own rows."""
    if clip is None:
        return None
    y = clip.top if target.top_row_first else target.height - clip.top - clip.height
    return clip.left, y, max(0, clip.width), max(0, clip.height)
