"""Shaders on a canvas: which of the sketch's own programs draw."""

from __future__ import annotations

from sketchkit.api._pen import WHITE, OpenShape, Pen
from sketchkit.api.images import WHOLE
from sketchkit.api.paint import check_choice
from sketchkit.api.pixels import CanvasPixels
from sketchkit.api.pshader import PShader
from sketchkit.api.shader_files import ShaderPaths
from sketchkit.api.textures import begin_uvs
from sketchkit.assets.paths import find_file
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.core.matrix import IDENTITY, ortho
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.shading import PREVIOUS, ShaderKind, Shadings

# What shader() may be told to draw, and the slot for it.
SLOTS = {c.TRIANGLES: "fills", c.LINES: "lines", c.POINTS: "points"}
SLOT_NAMES = {c.TRIANGLES: "TRIANGLES", c.LINES: "LINES", c.POINTS: "POINTS"}
SLOT_OF = {ShaderKind.LINE: c.LINES, ShaderKind.POINT: c.POINTS}


class Shaders(CanvasPixels):
    """GLSL programs of the sketch's own, instead of the built-in ones."""

    def loadShader(self, fragFilename: str, vertFilename: str | None = None) -> PShader:
        """Load a shader from files.

        Parameters
        ----------
        fragFilename : str
            The fragment shader: beside the sketch, or in its `data` folder.
        vertFilename : str, optional
            The vertex shader. Without it a built-in one goes before the fragment shader.

        Returns
        -------
        PShader

        Raises
        ------
        SketchError
            If there is no such file, or the shader does not compile: with the line in that file.

        See Also
        --------
        shader, filter, resetShader, PShader

        Notes
        -----
        GLSL as Processing's tutorials write it (`attribute`, `varying`, `texture2D`, without
        `#version`) is understood on every machine. Source: Processing's reference, loadShader();
        the course guide's section 4.10.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> shader(wave)
        >>> rect(20, 20, 60, 60)
        """
        fragment = find_file("loadShader", fragFilename)
        vertex = None if vertFilename is None else find_file("loadShader", vertFilename)
        return PShader._load(ShaderPaths(fragment, vertex), self._renderer.backend)

    def shader(self, shader: PShader, kind: int | None = None) -> None:
        """Draw with a shader from now on, until `resetShader()`.

        Parameters
        ----------
        shader : PShader
        kind : TRIANGLES, LINES or POINTS, optional
            What it draws: what is filled (without it), strokes or points.

        Raises
        ------
        SketchError
            If it is no shader, or does not compile, or the CPU renderer draws.

        See Also
        --------
        loadShader, resetShader, filter

        Notes
        -----
        A shader with `#define PROCESSING_COLOR_SHADER` (or TEXTURE, LIGHT, TEXLIGHT) draws only
        what is neither textured nor lit (or textured, lit, both). It stays from frame to frame.
        Source: Processing's reference, shader().

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> wave = loadShader("wave.glsl")
        >>> shader(wave)
        >>> rect(20, 20, 60, 60)
        >>> resetShader()
        >>> rect(40, 40, 50, 50)
        """
        self._check_shader("shader", shader)
        if kind is None:
            kind = SLOT_OF.get(shader._source.kind, c.TRIANGLES)
        check_choice("shader", kind, SLOT_NAMES)
        self._shaders = {**self._shaders, SLOTS[kind]: shader}
        shader._canvases.add(self)
        if PREVIOUS in shader._declared:
            self._target.is_noted = True
        self._follow_shaders()

    def resetShader(self, kind: int | None = None) -> None:
        """Draw with the built-in shader again: what is filled, or LINES or POINTS.

        Examples
        --------
        >>> size(100, 100, P2D)
        >>> shader(loadShader("wave.glsl"))
        >>> resetShader()
        >>> rect(20, 20, 60, 60)
        """
        kind = c.TRIANGLES if kind is None else kind
        check_choice("resetShader", kind, SLOT_NAMES)
        dropped = self._shaders.get(SLOTS[kind])
        self._shaders = {
            slot: shader for slot, shader in self._shaders.items() if slot != SLOTS[kind]
        }
        if dropped is not None and dropped not in self._shaders.values():
            dropped._canvases.discard(self)
        self._follow_shaders()

    def filter(self, kind: int | PShader, number: float | None = None) -> None:
        """Change all pixels: blur, gray, invert and the like, or with a shader.

        Parameters
        ----------
        kind : BLUR, GRAY, INVERT, OPAQUE, POSTERIZE, THRESHOLD, ERODE, DILATE, or PShader
            A shader finds what was drawn so far as `texture`.
        number : float, optional
            The radius of BLUR, at first 1; the level of THRESHOLD, 0 to 1, at first 0.5; the
            number of values that POSTERIZE leaves of each part of a colour, 2 to 255.

        Raises
        ------
        SketchError
            If it is no kind of filter, or the number does not fit it.

        See Also
        --------
        copy, blend, tint, loadShader

        Notes
        -----
        ERODE grows dark areas, DILATE light ones. A blur takes the same time for any radius.
        Source: Processing's reference, filter().

        Examples
        --------
        >>> circle(50, 50, 60)
        >>> filter(BLUR, 3)
        >>> filter(INVERT)
        """
        if not isinstance(kind, PShader):
            super().filter(kind, number)
            return
        self._check_shader("filter", kind)
        saved = self._stage, self._modelview
        width, height = self._target.width, self._target.height
        self._restage(
            is_3d=False,
            is_java2d=False,
            projection=ortho(0.0, width, -height, 0.0, -1.0, 1.0),
            depth_test=False,
            depth_write=False,
            lights=None,
            blend=Blend.REPLACE,
            shadings=Shadings(fills=kind._shading()),
        )
        self._modelview = IDENTITY
        shaders, self._shaders = self._shaders, {}  # those in force do not hold here
        Pen._note_state(self)
        self._pack_image(self._target, (0, 0, width, height, *WHOLE), WHITE)
        self._shaders = shaders
        self._stage, self._modelview = saved
        self._state = -1
        self._want_layer()

    def _begin_uvs(self, shape: OpenShape) -> None:
        """Keep texture coordinates without a texture too, as long as a shader may read them."""
        if shape.first_uv is None and "fills" in self._shaders:
            begin_uvs(self._recorder, shape)

    def _check_shader(self, caller: str, shader: object) -> None:
        if not isinstance(shader, PShader):
            hint = "loadShader() makes one, in setup()."
            raise SketchError(
                f"{caller}() takes a PShader.", got=f"{kind_of(shader)}: {shown(shader)}", hint=hint
            )
        self._renderer.backend.prepare(shader._source)
