"""Frames: the samples of a target, and how a picture is made of them.

Rows are in the order of the target's buffer, which may begin at the bottom of the picture (see
draw/resources.py, Target). Only `window_of`, `vertices` and `shading` need to know.
"""

from __future__ import annotations

from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.commands import Settling
from sketchkit.draw.pipeline import Clip, Pipeline
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import F32, U8

I64 = NDArray[np.int64]
_Scalar = TypeVar("_Scalar", bound=np.generic)

SUBPIXELS = 256  # per pixel; GL rasterisers round vertices to this grid
DEPTH_BITS = 24
FARTHEST = (1 << DEPTH_BITS) - 1
NO_TRIANGLE = 0xFFFFFFFF


class SampleGrid(NamedTuple):
    """Where in a pixel its samples lie.

    Attributes
    ----------
    shift : pixels
        Taken from all window coordinates before anything else, so that with one sample a whole
        number is the centre of a pixel. With four it is the pixel's corner.
    places : (x, y) of each sample, pixels
    centre : pixels
        Where, in x and in y, colours are evaluated.
    """

    shift: float
    places: tuple[tuple[float, float], ...]
    centre: float


_GRIDS = {
    1: SampleGrid(0.5, ((0.0, 0.0),), 0.0),
    # Mesa's places; Processing's frames are made with them .
    4: SampleGrid(0.0, ((0.375, 0.125), (0.875, 0.375), (0.125, 0.625), (0.625, 0.875)), 0.5),
}


class Window(NamedTuple):
    """A part of a frame, in its own rows: the right and the bottom are outside."""

    left: int
    top: int
    right: int
    bottom: int

    @property
    def is_empty(self) -> bool:
        """Whether no pixel is inside."""
        return self.left >= self.right or self.top >= self.bottom

    def part_of(self, samples: NDArray[_Scalar]) -> NDArray[_Scalar]:
        """Return the view of the window in an array (samples, height, width, ...)."""
        return samples[:, self.top : self.bottom, self.left : self.right]

    def widened(self) -> Window:
        """Return the window with what a clip lets through besides (see raster, `_limit`)."""
        return Window(max(self.left - 1, 0), max(self.top - 1, 0), self.right, self.bottom)

    def meet(self, left: int, top: int, right: int, bottom: int) -> Window:
        """Return what of the window is also inside the given edges."""
        return Window(
            max(self.left, left),
            max(self.top, top),
            min(self.right, right),
            min(self.bottom, bottom),
        )


class Frame:
    """What a target holds.

    Attributes
    ----------
    samples, height, width : int
    colors : (samples, height, width, 4) uint8
    version : int
        The target's, when the frame was made.
    grid : SampleGrid
    """

    def __init__(self, target: Target) -> None:
        self.version = target.version
        self.grid = _GRIDS[target.samples]
        self.samples, self.height, self.width = target.samples, target.height, target.width
        self.colors: U8 = np.zeros((self.samples, self.height, self.width, 4), np.uint8)
        self._depths: I64 | None = None

    @property
    def depths(self) -> I64:
        """Return (samples, height, width): depth times 2**32, and below that NO_TRIANGLE.

        The lower half is free for `visibility` to note which triangle is nearest: the least of two
        such numbers is the nearer one. Made when first asked for: most 2D sketches never do.
        """
        if self._depths is None:
            self._depths = np.full(self.colors.shape[:3], FARTHEST << 32 | NO_TRIANGLE)
        return self._depths

    def clear(self, window: Window, color: tuple[int, int, int, int], *, depth: bool) -> None:
        """Give every sample of a window a colour and, if `depth`, make it farthest."""
        packed = np.array(color, np.uint8).view(np.uint32)
        window.part_of(self.colors.view(np.uint32))[...] = packed
        if depth and self._depths is not None:
            window.part_of(self._depths)[...] = FARTHEST << 32 | NO_TRIANGLE

    def replace(self, data: U8, left: int, top: int) -> None:
        """Give every sample of pixels, (h, w, 4) in the frame's rows, another colour."""
        height, width = data.shape[:2]
        self.colors[:, top : top + height, left : left + width] = data

    def settle(self, how: Settling) -> None:
        """Begin a frame over the old picture."""
        if how is Settling.NOTE:
            return  # only shaders would read it
        if how is Settling.MEAN:
            self.colors[...] = self.picture()
            return
        if how is Settling.TURN:
            self.colors[...] = self.colors[0, ::-1].copy()
        self._depths = None

    def picture(self) -> U8:
        """Return the average of the samples, (height, width, 4)."""
        averages: U8 = self.colors[0].copy()
        packed = self.colors.view(np.uint32)[..., 0]
        row, column = np.nonzero((packed[1:] != packed[0]).any(axis=0))
        averages[row, column] = average(self.colors[:, row, column])
        return averages


class Surface(NamedTuple):
    """What a draw changes: a frame, the part of it that the draw reaches, and in which way."""

    frame: Frame
    window: Window
    pipeline: Pipeline


def window_of(target: Target, clip: Clip | None) -> Window:
    """Return what a clip, given from the top of the picture, leaves of the frame."""
    whole = Window(0, 0, target.width, target.height)
    if clip is None:
        return whole
    top = clip.top if target.top_row_first else target.height - clip.top - clip.height
    return whole.meet(clip.left, top, clip.left + clip.width, top + clip.height)


def packed_depths(z: F32) -> I64:
    """Return depths, 0 (near) to 1, as `Frame.depths` has them, with 0 in the lower half."""
    packed: I64 = np.rint(bounded(z) * float(FARTHEST)).astype(np.int64) << 32
    return packed


def bounded(values: F32) -> F32:
    """Return values with what is below 0 or above 1 moved there; what is no number becomes 0."""
    between: F32 = np.minimum(np.fmax(values, 0), 1)
    return between


def average(samples: U8) -> U8:
    """Return the mean over the first axis.

    In float32 and one after the other, as Mesa does: a mean that lies half-way between two whole
    numbers then falls to the same side.
    """
    total: F32 = np.zeros(samples.shape[1:], np.float32)
    for sample in samples:
        total += sample * np.float32(1 / 255)
    mean: U8 = np.rint(total * np.float32(255 / len(samples))).astype(np.uint8)
    return mean
