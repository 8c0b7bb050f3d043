"""What rows become before they are vertices: many pieces of the same number of corners each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.resources import Texture

F32 = NDArray[np.floating]  # single; NumPy's stubs widen quotients
I32 = NDArray[np.int32]
I64 = NDArray[np.int64]
Bool = NDArray[np.bool_]


@dataclass(slots=True)
class Fills:
    """Filled pieces; `n` of them with `k` corners.

    Attributes
    ----------
    rows : (n,) int64
        The row that each piece belongs to, ascending.
    x, y, z : (n, k) float32, object space
        A dimension may be 1, and stands for all.
    triangles : (t, 3) int64
        How every piece is split.
    colors : (n, k) or (n, 1) int64, packed ARGB
    is_stroke : bool
        An outline in the plane: drawn after the fill of its row, without texture or light.
    snap : (n,) bool or None
        Which pieces are moved to whole pixels.
    shift : (n, 2) float32 or None, pixels
        By how much each piece is moved after the transform.
    uvs : (n, k, 2) float32 or None
    textures : list of Texture, one for each piece, or None
    normals : (n or 1, k or 1, 3) float32, object space, or None
        None: from the corners of each piece, in eye space.
    normal_givers : (n, 3) int32 or None
        Where `normals` is None: whose normal each corner takes; None: that of its own piece.
    ambient : (n, k) or (n, 1) int64, packed ARGB, or None
        Ambient colour where `ambient()` was not called; None: that of `colors`.
    attributes : (n, k) int64 or None
        Entry of the recorder's attributes, for the material; None: the material of the row's style.
    sources : (n, k) int64 or None
        The recorder's corners that these are; None: they are none of them.
    hides_back : (n,) bool or None
        Which pieces hide their own back faces, so that those need not be drawn; None: none does.
    """

    rows: I64
    x: F32
    y: F32
    z: F32
    triangles: I64
    colors: I64
    is_stroke: bool = False
    snap: Bool | None = None
    shift: F32 | None = None
    uvs: F32 | None = None
    textures: list[Texture] | None = None
    normals: F32 | None = None
    normal_givers: I32 | None = None
    ambient: I64 | None = None
    attributes: I64 | None = None
    sources: I64 | None = None
    hides_back: Bool | None = None


@dataclass(slots=True)
class Lines:
    """Polylines of P3D; `n` of them through `k` points.

    Attributes
    ----------
    rows : (n,) int64, ascending
    x, y, z : (n, k) float32, object space
    colors : (n, k) or (n, 1) int64, packed ARGB
    weights : (n, k) or (n, 1) float32, before the scale of the matrix
    is_closed, is_joined : bool
    sources : (n, k) int64 or None
        As of `Fills`.
    """

    rows: I64
    x: F32
    y: F32
    z: F32
    colors: I64
    weights: F32
    is_closed: bool
    is_joined: bool
    sources: I64 | None = None


@dataclass(slots=True)
class Points:
    """Points of P3D, (n,) of them; each is a fan around its place.

    Attributes
    ----------
    rows : (n,) int64, ascending
    x, y, z : (n,) float32, object space
    colors : (n,) int64, packed ARGB
    offsets : (n, v, 2) float32, pixels
        From the place to the corners of the fan; the first is its hub.
    triangles : (t, 3) int64
    sources : (n,) int64 or None
        As of `Fills`.
    """

    rows: I64
    x: F32
    y: F32
    z: F32
    colors: I64
    offsets: F32
    triangles: I64
    sources: I64 | None = None


@dataclass(slots=True)
class Expansion:
    """All pieces of a list, in any order: their rows say which comes first."""

    fills: list[Fills]
    lines: list[Lines]
    points: list[Points]
