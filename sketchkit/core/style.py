"""What shapes look like, apart from their colours: what `pushStyle()` saves."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

from sketchkit.core import constants as c
from sketchkit.core.color import ColorMode

NO_COLOR = -1  # a packed colour is 0..0xFFFFFFFF; what is negative stands for noFill(), noStroke()


@dataclass(frozen=True, slots=True)
class Material:
    """How a surface answers light; colours are packed ARGB.

    `ambient` is NO_COLOR until `ambient()` is called: until then the fill colour serves.
    """

    ambient: int = NO_COLOR
    specular: int = 0xFF7D7D7D
    emissive: int = 0xFF000000
    shininess: float = 1.0


@dataclass(frozen=True, eq=False, slots=True)
class Style:
    """The state that a shape takes with it when it is recorded.

    It is replaced, never changed, and its identity is its key. Fill, stroke, tint and the weight
    of strokes are not here: sketches change them at every call, so each shape records its own.
    """

    rect_mode: int = c.CORNER
    ellipse_mode: int = c.CENTER
    stroke_cap: int = c.ROUND
    stroke_join: int = c.MITER
    material: Material = Material()
    normal: tuple[float, float, float] = (0.0, 0.0, 1.0)
    sphere_detail: tuple[int, int] = (30, 30)


class Typeface(NamedTuple):
    """Letters that a text can be set in.

    Attributes
    ----------
    path : str
        The font's file; "" is the default face.
    is_smooth : bool
        Whether edges of letters are blended with what is behind them.
    characters : frozenset of str, or None
        Those that are drawn; None is all that the file has.
    """

    path: str = ""
    is_smooth: bool = True
    characters: frozenset[str] | None = None


DEFAULT_FACE = Typeface()


@dataclass(frozen=True, slots=True)
class Typography:
    """How text is set.

    Attributes
    ----------
    size, leading : float, pixels
    align_x, align_y, mode : int
    face : Typeface
    design_size : int, pixels
        The size at which the face was made, and its ascent and descent measured; 0 until it is
        first used.
    """

    size: float = 12.0
    leading: float = 14.0
    align_x: int = c.LEFT
    align_y: int = c.BASELINE
    mode: int = c.MODEL
    face: Typeface = DEFAULT_FACE
    design_size: int = 0


@dataclass(slots=True)
class SavedStyle:
    """Everything that `pushStyle()` puts aside."""

    style: Style
    fill: int
    stroke: int
    tint: int
    stroke_weight: float
    color_mode: ColorMode
    image_mode: int
    shape_mode: int
    blend_mode: int
    typography: Typography


__all__ = ["NO_COLOR", "Material", "SavedStyle", "Style", "Typeface", "Typography", "replace"]
