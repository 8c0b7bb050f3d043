"""Pen: what records shapes, and its state; a canvas is one, and a retained shape is one.

The groups of methods (`paint.py`, `vertices.py`, ...) add methods to it, never attributes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from types import TracebackType
from typing import NoReturn

from sketchkit.core import constants as c
from sketchkit.core.color import ColorMode
from sketchkit.core.errors import SketchError, wrong_numbers
from sketchkit.core.lights import Vector3
from sketchkit.core.matrix import IDENTITY, Affine
from sketchkit.core.notices import warn_once
from sketchkit.core.style import NO_COLOR, Style
from sketchkit.draw.recorder import (
    NO_CUSTOM,
    Attributes,
    CurveRun,
    Custom,
    PackError,
    Recorder,
)
from sketchkit.draw.resources import Texture
from sketchkit.draw.stage import Stage

WHITE = 0xFFFFFFFF
BLACK = 0xFF000000
FACING: Vector3 = (0.0, 0.0, 1.0)


@dataclass(slots=True)
class OpenShape:
    """A `beginShape()` that has not ended yet.

    Attributes
    ----------
    first : int, bytes
        Where its corners begin in the recorder.
    first_uv : int, bytes, or None
        Where its texture coordinates begin; None as long as it has no texture.
    spline : list of (x, y, z)
        The points of `curveVertex()` so far.
    curves : list of CurveRun
    """

    kind: int
    first: int
    contours: list[int] = field(default_factory=list)
    in_contour: bool = False
    texture: Texture | None = None
    first_uv: int | None = None
    has_normals: bool = False
    has_curves: bool = False
    spline: list[tuple[float, float, float]] = field(default_factory=list)
    curves: list[CurveRun] = field(default_factory=list)


class Block:
    """What `with pushMatrix():` and its like enter and leave; without `with` it does nothing."""

    def __init__(self, leave: Callable[[], None]) -> None:
        self._leave = leave

    def __enter__(self) -> None:
        """Go on: the call itself has begun the block."""

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if kind is None:  # an error in the block is told as it is, not as what it left open
            self._leave()


@lru_cache(maxsize=4096)
def _restyled(style: Style, field_name: str, value: object) -> Style:
    """Return a style that differs in one field; the same one for the same change."""
    return replace(style, **{field_name: value})  # type: ignore[arg-type] # the callers know


class Pen:
    """Attributes of what records shapes.

    Attributes
    ----------
    _state : int
        Entry of the recorder's states for the next row; -1 when style, stage or matrix changed.
    _attributes : int
        Entry of the recorder's attributes for the next corner; -1 when they changed, and outside
        of `beginShape()`.
    _fill, _stroke, _tint : int
        Packed ARGB, or NO_COLOR.
    _weight : float
        Of strokes.
    _style : Style
        Replaced by `_restyle`.
    _stage : Stage
        Replaced by `_restage`.
    _modelview : Affine
    """

    _recorder: Recorder
    _state: int
    _attributes: int
    _fill: int
    _stroke: int
    _tint: int
    _weight: float
    _style: Style
    _stage: Stage
    _normal: Vector3
    _modelview: Affine
    _color_mode: ColorMode
    _texture_mode: int
    _curve_detail: int
    _curve_tightness: float
    _bezier_detail: int
    _shape: OpenShape | None
    _custom: Mapping[str, Custom]

    def __init__(self, recorder: Recorder, stage: Stage) -> None:
        self._recorder = recorder
        self._state = self._attributes = -1
        self._fill, self._stroke, self._tint = WHITE, BLACK, NO_COLOR
        self._weight = 1.0
        self._style = Style()
        self._stage = stage
        self._normal = FACING
        self._modelview = IDENTITY
        self._color_mode = ColorMode()
        self._texture_mode = c.IMAGE
        self._curve_detail = self._bezier_detail = 20
        self._curve_tightness = 0.0
        self._shape = None
        self._custom = NO_CUSTOM

    def _note_state(self) -> int:
        """Keep style, stage and matrix as they are now, for the rows that follow."""
        if self._style.normal is not self._normal:
            self._style = _restyled(self._style, "normal", self._normal)
        self._state = self._recorder.keep_state(
            self._style, self._stage, self._modelview, self._nesting
        )
        return self._state

    @property
    def _nesting(self) -> int:
        """Within how many pushMatrix() it is."""
        return 0

    def _note_attributes(self, caller: str) -> None:
        """Keep normal, material and weight as they are now, for the corners that follow.

        Raises
        ------
        SketchError
            If no shape is open.
        """
        if self._shape is None:
            raise SketchError(
                f"{caller}() belongs between beginShape() and endShape().",
                hint="Write beginShape() before the first vertex.",
            )
        entries = self._recorder.attributes
        material = self._style.material
        entries.append(Attributes(self._normal, material, self._weight, self._custom))
        self._attributes = len(entries) - 1

    def _restyle(self, field_name: str, value: object) -> None:
        """Change one field of the style."""
        self._style = _restyled(self._style, field_name, value)
        self._state = self._attributes = -1

    def _restage(self, **changes: object) -> None:
        """Change fields of the stage; a new section begins."""
        self._stage = replace(self._stage, **changes)  # type: ignore[arg-type] # the callers know
        self._state = -1

    def _again(self, call: Callable[..., None], args: Sequence[object], usage: str) -> None:
        """Repeat a call whose row did not go into the buffer, or say what is wrong with it."""
        if self._recorder.make_room():
            call(*args)
        elif not any(map(_is_too_large, args)):
            self._refuse(call.__name__, args, usage)
        else:  # series that run away end so; to Java it is infinite, and draws nothing
            warn_once(
                f"A number for {call.__name__}() is too large, and nothing is drawn: 3.4e38 is the "
                "most."
            )

    def _refuse(self, name: str, args: Sequence[object], usage: str) -> NoReturn:
        """Raise the error for wrong arguments, or for a weight that the row cannot hold."""
        if abs(self._weight) > c.MAX_FLOAT:  # seen late: a check in strokeWeight() would cost more
            raise wrong_numbers("strokeWeight", (self._weight,), "weight") from None
        raise wrong_numbers(name, args, usage) from None


def _is_too_large(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) > c.MAX_FLOAT


__all__ = ["BLACK", "FACING", "WHITE", "Block", "OpenShape", "PackError", "Pen"]
