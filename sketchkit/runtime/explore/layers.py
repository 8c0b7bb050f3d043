"""Layers: what was drawn over a pixel, and how much of it still shows."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.frames import average
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.vertex import U8
from sketchkit.runtime.explore.log import Moment
from sketchkit.runtime.explore.noting import Chain

VISIBLE = 1 / 255  # a share of the colour that shows at all
CLEAR_SHARE = 0.1  # of a sample's colour: who gives less is not said to have drawn it
Shares = NDArray[np.float64]


class Part(Enum):
    """What of a call it is."""

    FILL = "fill"
    STROKE = "stroke"
    POINT = "point"
    BACKGROUND = "background"
    PIXELS = "pixels"


@dataclass(eq=False)
class Layer:
    """What one call has drawn over the pixel.

    Attributes
    ----------
    moment : Moment
        The command that first brought it there.
    row : int
        Of the step's records; -1 if there is none.
    inner_row : int or None
        Of a retained shape: the row of the shape's own recorder.
    color : (4,) uint8
        Of its last fragment.
    covered : int
        How many of the pixel's samples it covers.
    shares : (samples,) float64
        How much of each sample's colour it has given, 0..1.
    behind, beneath : Layer or None
        What was nearer, and what was drawn over it, where it is hidden.
    transparent, unchanging, clipped, discarded : int
        Samples where it was drawn with alpha 0, where its blend mode has changed nothing, which a
        clip has kept from it, and where its own shader draws nothing.
    uv : (u, v) or None
        The place on the texture.
    pipeline : Pipeline or None
    setter : Chain
        Of pixels that were set: by whom.
    change : int
        The most by which it has changed a channel of a sample when it was drawn.
    """

    moment: Moment
    row: int
    part: Part
    color: U8
    shares: Shares
    inner_row: int | None = None
    covered: int = 0
    behind: Layer | None = None
    beneath: Layer | None = None
    transparent: int = 0
    unchanging: int = 0
    clipped: int = 0
    discarded: int = 0
    uv: tuple[float, float] | None = None
    pipeline: Pipeline | None = None
    setter: Chain = ()
    change: int = 0

    @property
    def share(self) -> float:
        """How much of the pixel's colour it has given, 0..1."""
        return float(self.shares.mean())

    @property
    def is_visible(self) -> bool:
        """Whether anything of it shows."""
        return bool((self.shares > VISIBLE).any())


@dataclass
class History:
    """What was drawn over a pixel.

    Attributes
    ----------
    layers : list of Layer
        In the order of drawing.
    colors : (samples, 4) uint8
        What it comes to.
    is_whole : bool
        Whether nothing older has been there.
    """

    layers: list[Layer]
    colors: U8
    is_whole: bool

    @property
    def color(self) -> tuple[int, int, int, int]:
        """Red, green, blue and alpha of the pixel."""
        red, green, blue, alpha = average(self.colors).tolist()
        return red, green, blue, alpha

    @property
    def answer(self) -> Layer | None:
        """Return who has drawn the pixel: the layer that is on top at most of its samples."""
        votes: dict[Layer, int] = {}
        for sample in range(len(self.colors)):
            for layer in reversed(self.layers):
                if layer.shares[sample] >= CLEAR_SHARE:
                    votes[layer] = votes.get(layer, 0) + 1
                    break
        ranked = sorted(votes, key=lambda layer: (votes[layer], self.layers.index(layer)))
        return ranked[-1] if ranked else None
