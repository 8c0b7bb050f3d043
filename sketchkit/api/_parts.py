"""CanvasParts: the only attributes that a canvas has, besides those of every pen.

The groups of methods (`shapes2d.py`, `transforms.py`, ...) add methods to them, never attributes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol
from weakref import WeakSet

import numpy as np

from sketchkit.api._pen import BLACK, FACING, WHITE, Block, OpenShape, Pen
from sketchkit.api.pixel_array import PixelArray
from sketchkit.core import constants as c
from sketchkit.core.lights import Vector3
from sketchkit.core.matrix import IDENTITY, Affine
from sketchkit.core.style import NO_COLOR, SavedStyle, Typography
from sketchkit.draw.commands import Upload
from sketchkit.draw.recorder import ROW, Kind, PackError, pack_row0
from sketchkit.draw.renderer import RecordsRows, Renderer
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.shading import BUILT_IN, Shading, Shadings
from sketchkit.draw.stage import Stage

BACKDROP = 0xFFCCCCCC  # what a window shows before the first background()
TRANSPARENT = 0  # what a canvas out of sight shows


class HasShading(Protocol):
    """A shader."""

    _canvases: WeakSet[RecordsRows]

    @property
    def _follows_images(self) -> bool: ...

    def _shading(self) -> Shading: ...


class CanvasParts(Pen):
    """Attributes of a canvas.

    Attributes
    ----------
    _shaders : dict of str to PShader
        Those in force, by what they draw: `Shadings`' names.
    _camera : Affine
        The modelview with which a frame begins.
    _own : Pixels
        A copy of what was drawn, always the same array as long as the size stays.
    _pixels : PixelArray
        A window on it; on nothing before it was read.
    _is_read, _is_set : bool
        Whether the copy is up to date, and whether it has changes that are still to be sent.
    _copied : Pixels or None
        What `copy()` has copied from this canvas to itself.
    """

    _renderer: Renderer
    _target: Target
    _camera: Affine
    _eye_distance: float
    _matrices: list[tuple[Affine, Affine]]
    _styles: list[SavedStyle]
    _image_mode: int
    _shape_mode: int
    _blend_mode: int
    _typography: Typography
    _light_falloff: Vector3
    _light_specular: Vector3
    _has_drawn: bool
    _was_cleared: bool
    _is_layered: bool
    _is_offscreen: bool
    _is_drawing: bool
    _repeats_keys: bool
    _when_drawn: list[Callable[[], None]]
    _shaders: Mapping[str, HasShading]
    _own: Pixels
    _pixels: PixelArray
    _is_read: bool
    _is_set: bool
    _is_asked: bool
    _copied: Pixels | None

    def __init__(self, renderer: Renderer, target: Target) -> None:
        super().__init__(renderer.recorder, Stage(target))
        self._renderer = renderer
        self._target = target
        self._camera = IDENTITY
        self._eye_distance = 1.0
        self._matrices = []
        self._styles = []
        self._image_mode = self._shape_mode = c.CORNER
        self._blend_mode = c.BLEND
        self._typography = Typography()
        self._light_falloff, self._light_specular = (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        self._has_drawn = self._was_cleared = self._is_layered = False
        self._is_offscreen = self._is_drawing = self._repeats_keys = False
        self._when_drawn = []
        self._shaders = {}
        self._own = blank_pixels(target)
        self._pixels = PixelArray(self._own)
        self._is_read = self._is_set = self._is_asked = False
        self._copied = None
        renderer.register(self)

    def forget_state(self) -> None:
        """Give up indices into the recorder: it has been cleared."""
        self._state = self._attributes = -1

    def _note_state(self) -> int:
        """Keep style, stage and matrix as they are now, with the shaders' values."""
        if not self._shaders:
            return super()._note_state()
        self._follow_shaders()
        state = super()._note_state()
        if any(shader._follows_images for shader in self._shaders.values()):
            self._state = -1  # look again before the next row
        return state

    def _follow_shaders(self) -> None:
        """Let the stage have the shaders in force, with the values that they have now."""
        chosen = {slot: shader._shading() for slot, shader in self._shaders.items()}
        shadings = Shadings(**chosen) if chosen else BUILT_IN
        if shadings != self._stage.shadings:
            self._restage(shadings=shadings)

    def take_upload(self) -> Upload | None:
        """Return the pixels that the sketch has set since they were last taken, if any."""
        return None

    def _pack_whole(self, kind: Kind, color: int = NO_COLOR, link: int = 0) -> None:
        """Record a row that concerns all pixels: a clear, or the start of a frame."""
        state = self._state if self._state >= 0 else self._note_state()
        recorder = self._recorder
        recorder.make_room()
        pack_row0(recorder.rows, recorder.row_end, kind, state, color, NO_COLOR, 0.0, link)
        recorder.row_end += ROW
        self._was_cleared |= kind is Kind.CLEAR

    @property
    def _nesting(self) -> int:
        return len(self._matrices)

    @property
    def _is_3d(self) -> bool:
        return self._stage.is_3d


def blank_pixels(target: Target) -> Pixels:
    """Return room for a copy of what is on a target."""
    return Pixels(np.zeros((target.height, target.width, 4), np.uint8))


__all__ = ["BACKDROP", "BLACK", "FACING", "WHITE", "Block", "CanvasParts", "OpenShape", "PackError"]
