"""The draw list: the one thing that the API side and the backends share."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from sketchkit.core.matrix import Affine
from sketchkit.draw.layers import PieceOrder
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.pipeline import Clip, Pipeline
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8, Layer, VertexBlock


@dataclass(frozen=True, slots=True)
class Clear:
    """Replace every pixel of a target inside of a clip, alpha included.

    `color` is straight RGBA, 0..255 each; `depth` says whether depth is reset to the farthest.
    """

    target: Target
    color: tuple[int, int, int, int]
    depth: bool = True
    clip: Clip | None = None


class Settling(Enum):
    """What becomes of the old picture when a frame begins."""

    KEEP = "keep"  # it stays as it is, and depth is reset
    MEAN = "mean"  # all samples of a pixel get their mean; depth stays
    NOTE = "note"  # it is kept beside, for shaders that read what they draw on
    TURN = "turn"  # all get the first one's value, the rows change places, and depth is reset


@dataclass(frozen=True, slots=True)
class Settle:
    """Begin a frame over the old picture.

    For TURN, the target has been turned over already: its `top_row_first` is the new one.
    """

    target: Target
    how: Settling


@dataclass(frozen=True, slots=True)
class Draw:
    """Draw `count` indices of a layer's block, from `first` on."""

    pipeline: Pipeline
    layer: Layer
    first: int
    count: int


@dataclass(frozen=True, slots=True)
class DrawMesh:
    """Draw a part of geometry that stays; `modelview` takes it to eye space."""

    pipeline: Pipeline
    part: MeshPart
    modelview: Affine


@dataclass(frozen=True, slots=True)
class Upload:
    """Replace pixels of a target, alpha included and every sample of them; depth stays.

    `data` is (h, w, 4), straight RGBA, top row first, and lies inside of the target: its top left
    corner comes to `left`, `top`, counted from the top left of the picture.
    """

    target: Target
    data: U8
    left: int = 0
    top: int = 0


Command = Clear | Settle | Draw | DrawMesh | Upload


def target_of(command: Command) -> Target:
    """Return what a command is carried out on."""
    return command.pipeline.target if isinstance(command, Draw | DrawMesh) else command.target


@dataclass(slots=True)
class DrawList:
    """Commands in order, and the vertices that they refer to.

    `orders` says which row each triangle of a block was made from; no renderer reads it.
    """

    commands: list[Command] = field(default_factory=list)
    blocks: dict[Layer, VertexBlock] = field(default_factory=dict)
    orders: dict[Layer, PieceOrder] = field(default_factory=dict)
