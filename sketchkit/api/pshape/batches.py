"""Groups of many small shapes, drawn as one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from sketchkit.core.matrix import Affine
from sketchkit.draw.gather import Gathering, Member
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.recorder import CORNER, Recorder
from sketchkit.draw.resources import Texture
from sketchkit.draw.retain import retain
from sketchkit.draw.stage import Stage

MANY = 64  # shapes: fewer are drawn one by one, so that moving one sends nothing
SMALL = 256  # corners: larger ones keep a mesh of their own


class Leaf(Protocol):
    """What a batch asks of a shape."""

    _recorder: Recorder
    _version: int

    def _current_texture(self) -> Texture | None: ...

    @property
    def _first_scale(self) -> float: ...


PlacedLeaf = tuple[Leaf, Affine]  # with what takes it to the group


def is_small(leaf: Leaf) -> bool:
    """Return whether a shape is drawn with others."""
    return 0 < leaf._recorder.corner_end <= SMALL * CORNER


class Batch:
    """The leaves of a group, gathered; brought up to date when it is drawn."""

    def __init__(self, leaves: Sequence[PlacedLeaf], stage: Stage) -> None:
        self._leaves = [leaf for leaf, _ in leaves]
        self._versions = [leaf._version for leaf, _ in leaves]
        self._matrices = [matrix for _, matrix in leaves]
        self._gathering = Gathering([_member(*leaf) for leaf in leaves], stage)
        self._parts: list[MeshPart] | None = None

    def follow(self, leaves: Sequence[PlacedLeaf]) -> bool:
        """Take over what has changed; return False if the batch has to be made anew."""
        if [leaf for leaf, _ in leaves] != self._leaves:
            return False
        matrices = [matrix for _, matrix in leaves]
        versions = [leaf._version for leaf in self._leaves]
        if versions == self._versions and matrices == self._matrices:
            return True
        for index, (leaf, matrix) in enumerate(leaves):
            if versions[index] != self._versions[index]:
                if not self._gathering.fits(index, leaf._recorder):
                    return False
                self._gathering.renew(index, _member(leaf, matrix))
            elif matrix != self._matrices[index]:
                self._gathering.move(index, matrix)
        self._versions, self._matrices = versions, matrices
        self._parts = None
        return True

    def parts(self, texture: Texture | None) -> list[MeshPart]:
        """Return the parts of the mesh of all leaves, textured with the image as it is now."""
        if self._parts is None:
            self._parts = retain(self._gathering.recorder, 1.0)
        return [
            part if part.texture is None else part._replace(texture=texture) for part in self._parts
        ]


def _member(leaf: Leaf, matrix: Affine) -> Member:
    return Member(leaf._recorder, matrix, leaf._first_scale)
