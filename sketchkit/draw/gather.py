"""Many small retained shapes as one: what they recorded, joined, each under its own matrix.

A group of thousands of children is then expanded and drawn at once. Where a child has only moved,
or got other colours, its entries are written over the old ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Affine
from sketchkit.draw.recorder import CORNER, ROW, UV, Kind, Recorder
from sketchkit.draw.stage import Stage


class Member(NamedTuple):
    """One of the shapes that are joined.

    Attributes
    ----------
    matrix : Affine
        What takes it to where the whole is.
    weight_scale : float
        By what the weights of its outlines are multiplied.
    """

    recorder: Recorder
    matrix: Affine
    weight_scale: float


class Extent(NamedTuple):
    """How much of each table a recorder fills, or where in a joined one a shape's part begins."""

    rows: int
    corners: int
    uvs: int
    states: int
    attributes: int
    shapes: int
    textures: int

    def after(self, other: Extent) -> Extent:
        """Return where the next part begins."""
        return Extent(*(a + b for a, b in zip(self, other, strict=True)))


NOTHING = Extent(0, 0, 0, 0, 0, 0, 0)


class Gathering:
    """The joined recorder, and where in it each shape begins.

    Attributes
    ----------
    recorder : Recorder
    """

    def __init__(self, members: Sequence[Member], stage: Stage) -> None:
        self.recorder = joined = Recorder(1)
        self._sizes = [_extent(member.recorder) for member in members]
        self._starts = [NOTHING]
        for size in self._sizes:
            self._starts.append(self._starts[-1].after(size))
        whole = self._starts[-1]
        for buffer, length in (
            (joined.rows, whole.rows * ROW),
            (joined.corners, whole.corners * CORNER),
            (joined.uvs, whole.uvs * UV),
        ):
            buffer[:] = bytes(length)
        joined.row_end, joined.corner_end, joined.uv_end = (
            whole.rows * ROW,
            whole.corners * CORNER,
            whole.uvs * UV,
        )
        joined.stages[:] = [stage] * whole.states
        if any(member.recorder.normals is not None for member in members):
            joined.normals = np.zeros((whole.corners, 3), np.float32)
        for index, member in enumerate(members):
            self.renew(index, member)
            first = self._starts[index].rows * ROW
            joined.origins += [(first + end, call) for end, call in member.recorder.origins]

    def fits(self, index: int, recorder: Recorder) -> bool:
        """Return whether a shape still fills as much as when it was gathered."""
        has_place = recorder.normals is None or self.recorder.normals is not None
        return has_place and _extent(recorder) == self._sizes[index]

    def move(self, index: int, matrix: Affine) -> None:
        """Take one shape elsewhere."""
        first, states = self._starts[index].states, self._sizes[index].states
        self.recorder.matrices[12 * first : 12 * (first + states)] = matrix * states

    def renew(self, index: int, member: Member) -> None:
        """Take over what one shape is now."""
        own, joined, start = member.recorder, self.recorder, self._starts[index]
        size = self._sizes[index]
        rows = joined.row_array()[start.rows : start.rows + size.rows]
        rows[:] = own.row_array()
        rows["state"] += start.states
        rows["weight"] *= member.weight_scale
        is_shape = rows["kind"] == Kind.SHAPE
        has_texture = ~is_shape & (rows["link"] > 0)
        rows["link"] += np.where(is_shape, start.shapes, has_texture * start.textures).astype("i4")
        corners = joined.corner_array()[start.corners : start.corners + size.corners]
        corners[:] = own.corner_array()
        corners["attributes"] += start.attributes
        joined.uv_array()[start.uvs : start.uvs + size.uvs] = own.uv_array()
        if joined.normals is not None:
            joined.normals[start.corners : start.corners + size.corners] = _normals_of(own)
        self._renew_tables(member, start)

    def _renew_tables(self, member: Member, start: Extent) -> None:
        """Take over the lists that rows and corners refer to."""
        own, joined = member.recorder, self.recorder
        states = len(own.styles)
        first, last = start.states, start.states + states
        joined.styles[first:last] = own.styles
        joined.matrices[12 * first : 12 * last] = member.matrix * states
        end = start.after(_extent(own))
        joined.attributes[start.attributes : end.attributes] = own.attributes
        joined.textures[start.textures : end.textures] = own.textures
        joined.shapes[start.shapes : end.shapes] = [
            run._replace(
                first=run.first + start.corners,
                first_uv=None if run.first_uv is None else run.first_uv + start.uvs,
                has_normals=run.has_normals or own.normals is not None,
            )
            for run in own.shapes
        ]


def _extent(recorder: Recorder) -> Extent:
    return Extent(
        recorder.row_end // ROW,
        recorder.corner_end // CORNER,
        recorder.uv_end // UV,
        len(recorder.styles),
        len(recorder.attributes),
        len(recorder.shapes),
        len(recorder.textures),
    )


def _normals_of(own: Recorder) -> NDArray[np.float32]:
    """Return the normal of each corner, (n, 3)."""
    if own.normals is not None:
        return own.normals
    table = np.array([entry.normal for entry in own.attributes], np.float32).reshape(-1, 3)
    normals: NDArray[np.float32] = table[own.corner_array()["attributes"]]
    return normals
