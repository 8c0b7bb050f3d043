"""What a retained shape is drawn with, given back as corners: triangles, lines and points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c
from sketchkit.core.matrix import Affine, normal_matrix, volume_scale
from sketchkit.draw.meshes import MeshPart
from sketchkit.draw.vertex import F32, U8, Layer, VertexBlock

I64 = NDArray[np.int64]


@dataclass(slots=True)
class BulkCorners:
    """Many corners of one shape, as columns.

    Attributes
    ----------
    places : (n, 3) float32
    colors : (n,) int64, packed ARGB, or None
        Fill of what is filled, else stroke; None: the shape's own.
    normals : (n, 3) float32 or None
    uvs : (n, 2) float32 or None
        0..1 over the texture.
    weights : (n,) float32 or None
        Of lines and points, pixels.
    """

    places: F32
    colors: I64 | None = None
    normals: F32 | None = None
    uvs: F32 | None = None
    weights: F32 | None = None


def placed(places: F32, matrix: Affine) -> F32:
    """Return points, (n, 3), where a transform takes them."""
    rows = np.array(matrix, np.float32).reshape(3, 4)
    moved: F32 = places @ rows[:, :3].T + rows[:, 3]
    return moved


def tessellate_parts(parts: Sequence[tuple[MeshPart, Affine]]) -> Iterator[tuple[int, BulkCorners]]:
    """Yield the kind of `beginShape()` and the corners for all fills, all lines, all points."""
    for layer, kind, corners_of in _LAYERS:
        found = [
            corners_of(part.mesh.blocks[layer], part, matrix)
            for part, matrix in parts
            if part.layer is layer
        ]
        if found:
            yield kind, _joined(found)


def _triangles(block: VertexBlock, part: MeshPart, matrix: Affine) -> BulkCorners:
    index = block.indices[part.first : part.first + part.count]
    normals = uvs = None
    if block.normals is not None:
        turned = np.array(normal_matrix(matrix), np.float32).reshape(3, 3).T
        normals = block.normals[index] @ turned
    if block.uvs is not None:
        uvs = block.uvs[index]
    colors = pack_rgba(block.colors[index])
    return BulkCorners(placed(block.positions[index], matrix), colors, normals, uvs)


def _lines(block: VertexBlock, part: MeshPart, matrix: Affine) -> BulkCorners:
    """Return two corners for each segment: a strip's two triangles are (a, b, c) and (c, b, d)."""
    assert block.directions is not None
    triangles = block.indices[part.first : part.first + part.count].reshape(-1, 3).astype(np.int64)
    first, second = triangles[:-1], triangles[1:]
    step = np.diff(first, axis=1)
    is_segment = (step == 1).all(axis=1) & (second[:, 0] == first[:, 2])
    begin = first[is_segment, 0]
    start = block.positions[begin]
    ends = np.stack([start, start + block.directions[begin, :3]], axis=1).reshape(-1, 3)
    colors = np.stack([block.colors[begin], block.colors[begin + 2]], axis=1).reshape(-1, 4)
    weights = 2 * np.abs(block.directions[begin, 3]) * np.float32(volume_scale(matrix))
    return BulkCorners(placed(ends, matrix), pack_rgba(colors), weights=weights.repeat(2))


def _points(block: VertexBlock, part: MeshPart, matrix: Affine) -> BulkCorners:
    """Return one corner for each fan: its hub."""
    assert block.offsets is not None
    used = np.unique(block.indices[part.first : part.first + part.count])
    sizes = np.abs(block.offsets[used]).max(axis=1)
    hubs = np.flatnonzero(sizes == 0)
    weights = 2 * sizes[np.minimum(hubs + 1, len(sizes) - 1)] * np.float32(volume_scale(matrix))
    at = used[hubs]
    return BulkCorners(
        placed(block.positions[at], matrix), pack_rgba(block.colors[at]), weights=weights
    )


_LAYERS: tuple[tuple[Layer, int, Callable[[VertexBlock, MeshPart, Affine], BulkCorners]], ...] = (
    (Layer.FILLS, c.TRIANGLES, _triangles),
    (Layer.LINES, c.LINES, _lines),
    (Layer.POINTS, c.POINTS, _points),
)


def pack_rgba(colors: U8) -> I64:
    """Return RGBA bytes, (n, 4), as packed ARGB."""
    red, green, blue, alpha = colors.astype(np.int64).T
    packed: I64 = alpha << 24 | red << 16 | green << 8 | blue
    return packed


def _joined(parts: Sequence[BulkCorners]) -> BulkCorners:
    """Return all corners, one part after the other; a column that one lacks is left out."""

    def column(name: str) -> NDArray[np.generic] | None:
        columns = [getattr(part, name) for part in parts]
        return None if any(each is None for each in columns) else np.concatenate(columns)

    names = ("places", "colors", "normals", "uvs", "weights")
    return BulkCorners(*(column(name) for name in names))  # type: ignore[arg-type] # each of its own dtype
