"""PGraphics: a surface to draw on, the groups of methods joined."""

from __future__ import annotations

from collections.abc import Callable
from types import TracebackType
from typing import TYPE_CHECKING, Self

from sketchkit.api._parts import BACKDROP, TRANSPARENT
from sketchkit.api._pen import Block
from sketchkit.api._sketch_parts import SMOOTH_SAMPLES
from sketchkit.api.attribs import Attribs
from sketchkit.api.camera import Camera
from sketchkit.api.color import Color
from sketchkit.api.curves import Curves
from sketchkit.api.gl_access import GlAccess
from sketchkit.api.hints import Hints
from sketchkit.api.lights import Lights
from sketchkit.api.materials import Materials
from sketchkit.api.pconstants import PConstants
from sketchkit.api.pimage import PImage
from sketchkit.api.shaders import Shaders
from sketchkit.api.shapes import RetainedShapes
from sketchkit.api.shapes2d import Shapes2D
from sketchkit.api.shapes3d import Shapes3D
from sketchkit.api.stacks import Stacks
from sketchkit.api.text import Text
from sketchkit.api.textures import Textures
from sketchkit.api.view import Views
from sketchkit.assets.output import picture_bytes
from sketchkit.core.constants import ARGB, FX2D, JAVA2D, P3D
from sketchkit.core.errors import SketchError
from sketchkit.draw.commands import Settling
from sketchkit.draw.recorder import Kind
from sketchkit.draw.renderer import Reader, Renderer
from sketchkit.draw.resources import Target
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import U8


class PGraphics(
    Shaders,  # before what it overrides: vertices keep texture coordinates for it
    Color,
    Lights,
    Materials,
    Stacks,
    Shapes2D,
    Curves,
    RetainedShapes,
    Textures,
    Attribs,
    Shapes3D,
    Camera,
    Hints,
    Views,
    Text,
    GlAccess,
    PConstants,
):
    """A surface to draw on: the window's is one, and `createGraphics()` makes others.

    It has every drawing function of a sketch as a method, a style and a camera of its own.

    Notes
    -----
    Source: Processing's reference, PGraphics.

    Examples
    --------
    >>> pg = createGraphics(60, 60, P2D)
    >>> with pg:
    ...     pg.background(0, 60, 90)
    ...     pg.circle(30, 30, 40)
    >>> isinstance(pg, PGraphics)
    True
    >>> image(pg, 20, 20)
    """

    def __init__(self, renderer: Renderer | None = None, target: Target | None = None) -> None:
        if renderer is not None and target is not None:
            super().__init__(renderer, target)

    if not TYPE_CHECKING:  # or any attribute would be right for the type checker

        def __getattr__(self, name: str) -> object:
            """Tell that `PGraphics()` alone is nothing to draw on; some sketches begin with it."""
            if "_renderer" in vars(self) or name.startswith("__"):
                problem = f"{type(self).__name__!r} object has no attribute {name!r}"
                raise AttributeError(problem, name=name, obj=self)
            raise SketchError(
                "PGraphics() alone is nothing to draw on.",
                hint="createGraphics(width, height) makes one of that size.",
            )

    @property
    def width(self) -> int:
        """Width in the sketch's units."""
        return self._target.across

    @property
    def height(self) -> int:
        """Height in the sketch's units."""
        return self._target.down

    @property
    def target(self) -> Target:
        """What it draws on."""
        return self._target

    @property
    def has_shapes(self) -> bool:
        """Whether something but a background was drawn since the last flush."""
        return self._recorder.has_shapes

    @property
    def repeats_keys(self) -> bool:
        """Whether keys that repeat because they are held reach the sketch in P2D and P3D."""
        return self._repeats_keys

    def resize(
        self, width: int, height: int, renderer_name: str, samples: int, density: int = 1
    ) -> None:
        """Give the surface a size and a renderer; what was drawn is lost."""
        self._renderer.flush()
        self._target.resize(width, height, samples, density)
        self.size_pixels()
        is_3d = renderer_name == P3D
        self._stage = Stage(
            self._target,
            is_3d=is_3d,
            is_java2d=renderer_name in (JAVA2D, FX2D),
            is_perspective=is_3d,
            depth_test=is_3d,
        )
        self._restage(projection=self._flat_projection())
        if is_3d:
            self.perspective()
        self._place_camera(self._default_camera())
        self._pack_whole(Kind.CLEAR, TRANSPARENT if self._is_offscreen else BACKDROP)
        self._has_drawn = self._was_cleared = self._is_layered = False

    def offscreen(self, width: int, height: int, renderer_name: str, samples: int) -> PGraphics:
        """Return another canvas of the same density, drawn on out of sight."""
        density = self._target.density
        canvas = PGraphics(self._renderer, Target(1, 1, top_row_first=False))
        canvas._is_offscreen = True
        canvas.resize(width, height, renderer_name, samples, density)
        return canvas

    def beginDraw(self) -> Block:
        """Begin to draw on a canvas of `createGraphics()`; `with pg:` ends it too.

        See Also
        --------
        endDraw, createGraphics

        Notes
        -----
        Matrix and lights begin anew each time; camera, projection and style stay, and so does the
        picture until `background()` or `clear()`. Source: Processing's reference,
        PGraphics.beginDraw().

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> with pg.beginDraw():  # or: with pg
        ...     pg.circle(30, 30, 40)
        >>> image(pg, 20, 20)
        """
        if self._is_offscreen and not self._is_drawing:
            self.begin_frame()
            self._is_drawing = True
        return Block(self.endDraw)

    def endDraw(self) -> None:
        """End drawing on a canvas of `createGraphics()`.

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> pg.beginDraw()
        >>> pg.background(255, 204, 0)
        >>> pg.endDraw()
        >>> image(pg, 20, 20)
        """
        self._is_drawing = False
        for call in self._when_drawn:
            self._renderer.flush()
            call()

    def __enter__(self) -> Self:
        """Begin to draw: `with pg:` is short for `with pg.beginDraw():`."""
        self.beginDraw()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        Block(self.endDraw).__exit__(kind, error, traceback)

    def dispose(self) -> None:
        """Do nothing: `endDraw()` has done all; in Processing it finishes an SVG or PDF file.

        Examples
        --------
        >>> pg = createGraphics(60, 60, SVG, "disc.svg")
        >>> with pg.beginDraw():
        ...     pg.circle(30, 30, 40)
        >>> pg.dispose()
        """

    def save(self, filename: str) -> None:
        """Write the picture to a file beside the sketch; its ending says the kind.

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> with pg.beginDraw():
        ...     pg.circle(30, 30, 40)
        >>> pg.save("disc.png")
        """
        PImage._of(self.image_data(), ARGB).save(filename)

    def _repr_png_(self) -> bytes:
        """Return the picture, as Jupyter asks for it."""
        return picture_bytes(self.image_data()[..., : 4 if self._is_offscreen else 3], ".png")

    def when_drawn(self, call: Callable[[], None]) -> None:
        """Have `call` called at each `endDraw()`."""
        self._when_drawn.append(call)

    def smooth(self, level: int = 2) -> None:
        """Draw edges softly, or hard with 0; on a canvas of `createGraphics()` before it is drawn.

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> pg.smooth()
        """
        if self._is_offscreen and not self._has_drawn:
            samples, density = SMOOTH_SAMPLES if level else 1, self._target.density
            self._target.resize(self.width, self.height, samples, density)

    def noSmooth(self) -> None:
        """Draw hard edges on a canvas of `createGraphics()`, called before it is drawn on.

        Examples
        --------
        >>> pg = createGraphics(60, 60, P2D)
        >>> pg.noSmooth()
        """
        self.smooth(0)

    def _texture(self) -> Target:
        """Return the picture, as it is when its turn to be drawn comes."""
        return self._target

    def begin_frame(self, *, is_looping: bool = True) -> None:
        """Put back what does not last from frame to frame: matrix, lights, normal.

        `is_looping` says whether `draw()` is called again and again.
        """
        self._matrices.clear()
        self._normal = (0.0, 0.0, 1.0)
        self._light_falloff, self._light_specular = (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        self._place_camera(self._camera)
        if self._stage.lights is not None:
            self._restage(lights=None)
        if self._target.is_noted and (self._is_offscreen or self._is_layered):
            self._pack_settle(Settling.NOTE)
        if not self._is_offscreen:  # on others everything stays as it is, samples and depth too
            self._pack_settle(self._settling(is_looping=is_looping))
        self._has_drawn, self._was_cleared = True, False

    def _pack_settle(self, how: Settling) -> None:
        self._pack_whole(Kind.SETTLE, link=list(Settling).index(how))

    def _settling(self, *, is_looping: bool) -> Settling:
        """Return what becomes of the old picture as a frame begins, as in Processing.

        It draws straight into the window as long as each frame begins with `background()`. After
        the first frame without one, or after `noLoop()`, or if a shader wants the picture of
        before, it draws into a buffer of its own. That is rendered the other way up, and begins
        each frame with the averaged old picture and with the old depth; at the change, each pixel
        has only one of its samples. It shows at edges, and so it is followed here.
        """
        if self._stage.is_java2d:
            return Settling.KEEP  # it draws into one image for ever
        if self._is_layered:
            return Settling.MEAN
        begins_anew = self._was_cleared or not self._has_drawn
        if is_looping and begins_anew and not self._target.is_noted:
            return Settling.KEEP
        self._renderer.flush()
        self._target.turn_over()
        self._is_layered = True
        return Settling.TURN

    def end_frame(self) -> None:
        """Draw everything recorded so far."""
        self._renderer.flush()

    def image_data(self) -> U8:
        """Return the picture, (h, w, 4) RGBA, top row first."""
        return self._renderer.read(self._target)

    def look(self, target: Target) -> U8:
        """Return what is on a canvas without what was recorded last, (h, w, 4)."""
        return self._renderer.backend.read(target)

    def begin_reading(self, reader: Reader) -> None:
        """Have a reader follow what is drawn from now on."""
        self._renderer.flush()
        self._renderer.readers.append(reader)

    def end_reading(self, reader: Reader) -> None:
        """Have it follow no longer."""
        self._renderer.flush()
        self._renderer.readers.remove(reader)
