"""Mesh: geometry that stays where it lies, and what has changed in it since it was last looked at.

A retained shape is expanded once, in its own coordinates; drawing it again costs a matrix. A
backend keeps a copy and asks for the edits that it has not seen.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.resources import Texture
from sketchkit.draw.vertex import Layer, VertexBlock

if TYPE_CHECKING:
    from sketchkit.draw.layers import PieceOrder
    from sketchkit.draw.recorder import Recorder

NEAR = 64  # vertices: changes nearer together than this are sent as one
MOST_EDITS = 4096  # beyond it, everything is sent anew


class Edit(NamedTuple):
    """Vertices first..last-1 of one column of one layer have changed."""

    layer: Layer
    column: str
    first: int
    last: int


@dataclass(eq=False)
class Mesh:
    """Geometry in object space.

    Attributes
    ----------
    blocks : dict of Layer to VertexBlock
    source : Recorder
        The calls that it was made from, as edits have left them.
    weight_scale : float
        By what the weights of its outlines were multiplied.
    version : int
        Number of edits ever made.
    orders : dict of Layer to PieceOrder
        Which row of `source` each triangle was made from; no renderer reads it.
    """

    blocks: dict[Layer, VertexBlock]
    source: Recorder | None = None
    weight_scale: float = 1.0
    version: int = 0
    orders: dict[Layer, PieceOrder] = field(default_factory=dict)
    _edits: list[Edit] = field(default_factory=list)
    _forgotten: int = 0

    def note_change(self, layer: Layer, column: str, vertices: NDArray[np.integer]) -> None:
        """Note that vertices of a column, ascending, have other values now."""
        if not len(vertices):
            return
        cuts = np.flatnonzero(np.diff(vertices) > NEAR) + 1
        firsts = vertices[np.concatenate([[0], cuts])].tolist()
        lasts = vertices[np.concatenate([cuts - 1, [len(vertices) - 1]])].tolist()
        self._edits += [
            Edit(layer, column, first, last + 1) for first, last in zip(firsts, lasts, strict=True)
        ]
        self.version += len(firsts)
        if len(self._edits) > MOST_EDITS:
            self._forgotten += len(self._edits)
            self._edits.clear()

    def edits_since(self, version: int) -> list[Edit] | None:
        """Return the edits after a version; None if everything may be different."""
        if version < self._forgotten:
            return None
        return self._edits[version - self._forgotten :]

    @property
    def vertex_count(self) -> int:
        """Vertices of all layers."""
        return sum(len(block.positions) for block in self.blocks.values())


class MeshPart(NamedTuple):
    """A run of a mesh's triangles that is drawn in one way.

    Attributes
    ----------
    first, count : int
        Indices of the layer's block.
    weight_scale : float
        By what the weights of its lines and points are multiplied.
    """

    mesh: Mesh
    layer: Layer
    first: int
    count: int  # type: ignore[assignment] # hides tuple.count, which nobody asks of a part
    texture: Texture | None
    weight_scale: float = 1.0
