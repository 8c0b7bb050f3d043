"""Layers: pieces collected into columns of vertices, and put in the order of drawing."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.depth_sort import depth_order
from sketchkit.draw.resources import Texture
from sketchkit.draw.rows import project
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import CUSTOM, Materials, VertexBlock

I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]
U8 = NDArray[np.uint8]
U32 = NDArray[np.uint32]


def unpack_argb(colors: I64) -> U8:
    """Return packed colours as RGBA bytes, one more dimension of 4."""
    # On little- and big-endian machines alike: shift, then take the low byte.
    return np.stack([colors >> 16, colors >> 8, colors, colors >> 24], axis=-1).astype(np.uint8)


class LayerPieces:
    """Vertices and triangles of one layer, collected piece by piece, then put in order."""

    def __init__(self) -> None:
        self.columns: dict[str, list[NDArray[np.generic]]] = {}
        self.indices: list[U32] = []  # (n, 3t) each: the corners of each piece's triangles
        self.keys: list[I64] = []  # (n,) each: where in the order each piece comes
        self.textures: list[list[Texture] | None] = []
        self.hides_back: list[Bool] = []  # (n,) each
        self.vertex_count = 0

    def add(
        self,
        keys: I64,
        triangles: I64,
        columns: dict[str, NDArray[np.generic]],
        textures: list[Texture] | None = None,
        hides_back: Bool | None = None,
    ) -> None:
        """Add pieces; a column is (n, k, d), or (n, 1, d) for one value a piece."""
        count, corners = columns["positions"].shape[:2]
        for name, column in columns.items():
            full = np.broadcast_to(column, (count, corners, *column.shape[2:]))
            flat = full.reshape(count * corners, *column.shape[2:])
            self.columns.setdefault(name, []).append(flat)
        first = np.uint32(self.vertex_count) + np.arange(count, dtype=np.uint32) * np.uint32(
            corners
        )
        self.indices.append(first[:, None] + triangles.ravel().astype(np.uint32))
        self.keys.append(keys)
        self.textures.append(textures)
        self.hides_back.append(np.zeros(count, np.bool_) if hides_back is None else hides_back)
        self.vertex_count += count * corners

    def in_order(self) -> tuple[U32, PieceOrder]:
        """Return indices in drawing order, and the pieces in that order."""
        keys = np.concatenate(self.keys)
        sizes = np.concatenate([np.full(len(part), part.shape[1]) for part in self.indices])
        if len(self.keys) == 1 and (keys[1:] >= keys[:-1]).all():
            order = np.arange(len(keys))
            indices = self.indices[0].ravel()
        else:
            order = np.argsort(keys, kind="stable")
            starts = np.empty(len(keys), np.int64)
            starts[order] = np.cumsum(sizes[order]) - sizes[order]
            indices = np.empty(int(sizes.sum()), np.uint32)
            done = 0
            for part in self.indices:
                mine = starts[done : done + len(part)]
                indices[mine[:, None] + np.arange(part.shape[1])] = part
                done += len(part)
        textures: list[Texture | None] | None = None
        if any(part is not None for part in self.textures):
            every: list[Texture | None] = []
            for part_keys, part_textures in zip(self.keys, self.textures, strict=True):
                every += part_textures or [None] * len(part_keys)
            textures = [every[i] for i in order]
        hides_back = np.concatenate(self.hides_back)[order]
        return indices, PieceOrder(keys[order], np.cumsum(sizes[order]), textures, hides_back)

    def block(self, indices: U32) -> VertexBlock:
        """Return the vertices with indices put in order."""
        joined = {
            name: parts[0] if len(parts) == 1 else np.concatenate(parts)
            for name, parts in self.columns.items()
        }
        materials = None
        if "ambient" in joined:
            names = ("ambient", "specular", "emissive", "shininess")
            materials = Materials(*(joined.pop(name) for name in names))  # type: ignore[arg-type] # columns are of one dtype each
        custom = {
            name.removeprefix(CUSTOM): joined.pop(name)
            for name in list(joined)
            if name.startswith(CUSTOM)
        }
        return VertexBlock(
            indices=indices,
            materials=materials,
            custom=custom,  # type: ignore[arg-type] # ditto
            **joined,  # type: ignore[arg-type] # ditto
        )


class Run(NamedTuple):
    """A range of indices that is drawn in one way."""

    begin: int
    end: int
    texture: Texture | None
    hides_back: bool


class PieceOrder:
    """Pieces of a layer in drawing order: rows, ends of their indices, textures, hidden backs.

    Attributes
    ----------
    keys : (n,) int64
        Twice the row of each piece, and 1 more for an outline in the plane. Unlike `rows` they
        stay with the triangles that depth has put in another order.
    """

    def __init__(
        self, keys: I64, ends: I64, textures: list[Texture | None] | None, hides_back: Bool
    ) -> None:
        self.keys = keys
        self.rows = keys >> 1
        self.ends = ends
        self.textures = textures
        self.hides_back = hides_back

    def runs(self, first: int, last: int) -> list[Run]:
        """Return ranges of indices of the rows first..last-1, split where the texture changes."""
        begin, end = (int(i) for i in np.searchsorted(self.rows, (first, last)))
        if begin == end:
            return []
        cuts = [begin, end]
        if self.textures is not None:
            ids = np.array([id(texture) for texture in self.textures[begin:end]])
            cuts = [begin, *(begin + 1 + np.flatnonzero(ids[1:] != ids[:-1])).tolist(), end]
        return [
            Run(
                int(self.ends[a - 1]) if a else 0,
                int(self.ends[b - 1]),
                self.textures[a] if self.textures is not None else None,
                bool(self.hides_back[a:b].all()),
            )
            for a, b in pairwise(cuts)
        ]

    def owner(self, triangle: int) -> tuple[int, bool]:
        """Return the row of a triangle of the layer, and whether it belongs to an outline."""
        key = int(self.keys[np.searchsorted(self.ends, 3 * triangle, side="right")])
        return key >> 1, bool(key & 1)

    def sort(self, first: int, last: int, block: VertexBlock, stage: Stage) -> None:
        """Put the triangles of the rows first..last-1 in order of depth."""
        begin, end = (int(i) for i in np.searchsorted(self.rows, (first, last)))
        if begin == end:
            return
        start = int(self.ends[begin - 1]) if begin else 0
        run = slice(start, int(self.ends[end - 1]))
        triangles = block.indices[run].reshape(-1, 3)
        x, y, z, w = project(stage.projection, *np.moveaxis(block.positions[triangles], 2, 0))
        order = depth_order(np.stack([x / w, y / w, -z / w], axis=2))
        block.indices[run] = triangles[order].ravel()
        self._split(begin, end, start, order)

    def _split(self, begin: int, end: int, start: int, order: I64) -> None:
        """Follow sorted triangles: each is a piece from now on."""
        sizes = np.diff(self.ends[begin:end], prepend=start) // 3
        pieces = np.repeat(np.arange(begin, end), sizes)[order]
        if self.textures is not None:
            self.textures[begin:end] = [self.textures[piece] for piece in pieces]
        self.keys = np.concatenate([self.keys[:begin], self.keys[pieces], self.keys[end:]])
        rows = np.full(len(pieces), self.rows[begin])
        self.rows = np.concatenate([self.rows[:begin], rows, self.rows[end:]])
        nothing = np.zeros(len(pieces), np.bool_)  # what is sorted is translucent
        self.hides_back = np.concatenate([self.hides_back[:begin], nothing, self.hides_back[end:]])
        ends = start + 3 * np.arange(1, len(pieces) + 1)
        self.ends = np.concatenate([self.ends[:begin], ends, self.ends[end:]])
