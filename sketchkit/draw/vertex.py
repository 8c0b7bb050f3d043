"""The vertex layouts, once, for shaders and for both renderers.

Vertices are columns, not rows: a program binds the columns that it reads, and a column that no
draw of the list reads is not made. Positions, directions and normals of immediate drawing are
already in eye space, as in Processing.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

F32 = NDArray[np.float32]
U8 = NDArray[np.uint8]
U32 = NDArray[np.uint32]
I32 = NDArray[np.int32]


CUSTOM = "custom "  # before the names of columns that sketches add, until they are in a block


class Layer(Enum):
    """Which of a list's vertex blocks: filled triangles, strokes in 3D, points in 3D."""

    FILLS = "fills"
    LINES = "lines"
    POINTS = "points"


@dataclass(slots=True)
class Materials:
    """What a lit vertex is made of.

    Attributes
    ----------
    ambient, specular, emissive : (n, 4) uint8
        RGBA; alpha is not read.
    shininess : (n,) float32
    """

    ambient: U8
    specular: U8
    emissive: U8
    shininess: F32


@dataclass(slots=True)
class VertexBlock:
    """The vertices of one layer, and the triangles between them.

    Attributes
    ----------
    positions : (n, 3) float32, eye space
    colors : (n, 4) uint8, straight RGBA
        Fill, tint or stroke colour.
    indices : (3m,) uint32
        Corners of the triangles, in the order in which they are drawn.
    uvs : (n, 2) float32 or None
        0..1 over the texture, v down. FILLS only.
    normals : (n, 3) float32, eye space, or None
        Not of unit length. FILLS only.
    materials : Materials or None
        FILLS only.
    directions : (n, 4) float32 or None
        LINES only: to the other end of the segment (eye space), and half the weight with the sign
        of the side. All zero at the middle of a join.
    offsets : (n, 2) float32 or None
        POINTS only: from the centre, in pixels (eye-space units with stroke perspective).
    sources : (n,) int32 or None
        Of what is retained: the corner of the recorder that each vertex shows (0 where there are
        none), or -1 of an outline in the plane. No renderer reads it; it leads an edit of the
        shape to its vertices.
    custom : dict of (n, k) float32
        FILLS only: what `attrib()` gave, by name; places and normals in the space of `positions`.
    """

    positions: F32
    colors: U8
    indices: U32
    uvs: F32 | None = None
    normals: F32 | None = None
    materials: Materials | None = None
    directions: F32 | None = None
    offsets: F32 | None = None
    sources: I32 | None = None
    custom: dict[str, F32] = field(default_factory=dict)
