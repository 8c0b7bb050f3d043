"""How a range of triangles is drawn: everything that is not a vertex."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import NamedTuple

from sketchkit.core.lights import LightRig
from sketchkit.core.matrix import Mat4
from sketchkit.draw.resources import Target, Texture, Wrap
from sketchkit.draw.shading import Shading


class Program(Enum):
    """The built-in programs."""

    FLAT = "flat"
    TEXTURED = "textured"
    LIT = "lit"
    TEXTURED_LIT = "textured and lit"
    LINE = "line"
    POINT = "point"


class Blend(IntEnum):
    """Blend modes that work on the GPU; the values are Processing's."""

    REPLACE = 0
    BLEND = 1
    ADD = 2
    SUBTRACT = 4
    LIGHTEST = 8
    DARKEST = 16
    EXCLUSION = 64
    MULTIPLY = 128
    SCREEN = 256


class Clip(NamedTuple):
    """A rectangle outside which nothing is drawn; whole pixels, y down from the top."""

    left: int
    top: int
    width: int
    height: int


class Pipeline(NamedTuple):
    """One way to draw; draws whose pipelines are equal are joined.

    Attributes
    ----------
    projection : Mat4
        Eye space to clip space as Processing defines it: +y of clip space is the top of the
        picture. A backend turns it over for a target that is rendered top row first.
    lights : LightRig
        The lights in force, in eye space; read by the lit programs alone.
    texture : Pixels, Target or None
        Read by the textured programs alone. A target is read as it is when the draw's turn comes.
    line_scale : (x, y, z)
        Eye-space ends of strokes are scaled by it, so that an outline wins over its own fill.
    shading : Shading or None
        A shader of the sketch's own, instead of `program`.
    culls_backs : bool
        Whether faces turned away may be left out, because others hide them.
    stroke_perspective : bool
        Whether the weight of lines and points is a length in eye space or in pixels.
    """

    program: Program
    target: Target
    projection: Mat4
    blend: Blend
    depth_test: bool
    depth_write: bool
    clip: Clip | None = None
    lights: LightRig = ()
    texture: Texture | None = None
    wrap: Wrap = Wrap.CLAMP
    line_scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    stroke_perspective: bool = False
    culls_backs: bool = False
    shading: Shading | None = None

    @property
    def reads_itself(self) -> bool:
        """Whether each draw reads what the one before it has drawn."""
        return self.texture is self.target
