"""Recorder: what the sketch calls, as plain numbers. The hot path.

A call of the sketch packs one row of fixed size into a buffer that is used again each frame;
everything else is done later, for whole columns at once. Packing is also the check of arguments: a
value that is no number is refused there.
"""

from __future__ import annotations

import struct
from bisect import bisect_right
from collections.abc import Callable, Mapping
from copy import copy
from enum import Enum, IntEnum
from types import MappingProxyType
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sketchkit.core.matrix import Affine
from sketchkit.core.style import Material, Style
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.resources import Texture
from sketchkit.draw.stage import Stage

# What packing raises: for what is no number, and for one that 32 bits cannot hold.
PackError = (struct.error, OverflowError)


class Kind(IntEnum):
    """What a row draws."""

    CLEAR = 0
    POINT = 1
    LINE = 2
    TRIANGLE = 3
    QUAD = 4
    RECT = 5
    ELLIPSE = 6
    ARC = 7
    BOX = 8
    SPHERE = 9
    IMAGE = 10
    SHAPE = 11
    SETTLE = 12
    MESH = 13
    LETTER = 14


WHOLE = (Kind.CLEAR, Kind.SETTLE)  # rows that concern all pixels

# kind, state: which entry of the recorder's states; fill, stroke: packed ARGB or NO_COLOR;
# weight of the stroke; link: an entry of `shapes`, `textures` or `parts`; numbers: what the call
# was given.
ROW_DTYPE = np.dtype(
    [
        ("kind", "<i4"),
        ("state", "<i4"),
        ("fill", "<i8"),
        ("stroke", "<i8"),
        ("weight", "<f4"),
        ("link", "<i4"),
        ("numbers", "<f4", (8,)),
    ]
)
ROW = ROW_DTYPE.itemsize

Packer: TypeAlias = Callable[..., None]


def _row_packer(numbers: int) -> Packer:
    """Return what packs kind, state, fill, stroke, weight, link and so many numbers."""
    return struct.Struct(f"<iiqqfi{numbers}f{4 * (8 - numbers)}x").pack_into


(
    pack_row1,
    pack_row3,
    pack_row4,
    pack_row6,
    pack_row7,
    pack_row8,
) = (_row_packer(count) for count in (1, 3, 4, 6, 7, 8))
pack_row0 = _row_packer(0)

# A vertex of beginShape(): place, entry of `attributes`, fill (or tint) and stroke as ARGB.
CORNER_DTYPE = np.dtype(
    [("place", "<f4", (3,)), ("attributes", "<i4"), ("fill", "<i8"), ("stroke", "<i8")]
)
CORNER = CORNER_DTYPE.itemsize
pack_corner: Packer = struct.Struct("<fffiqq").pack_into
pack_place: Packer = struct.Struct("<fff").pack_into
unpack_place = struct.Struct("<fff").unpack_from

UV = 8
pack_uv: Packer = struct.Struct("<ff").pack_into


class CustomKind(Enum):
    """What an attribute of `attrib()` and its like stands for, and so how matrices change it."""

    PLAIN = "plain"
    PLACE = "place"
    DIRECTION = "direction"  # a normal


class Custom(NamedTuple):
    """An attribute that the sketch gives to vertices for a shader of its own."""

    kind: CustomKind
    values: tuple[float, ...]


NO_CUSTOM: Mapping[str, Custom] = MappingProxyType({})


class Attributes(NamedTuple):
    """What a vertex of `beginShape()` has besides place and colours.

    `custom` is never changed in place: entries share it.
    """

    normal: tuple[float, float, float]
    material: Material
    weight: float
    custom: Mapping[str, Custom] = NO_CUSTOM


class CurveRun(NamedTuple):
    """Corners of a shape that lie along a curve: what they were made from.

    Attributes
    ----------
    first : int
        The first corner after the curve's start, counted from the shape's first.
    control : (4, 3) or (3, 3) float64
        Of a Bezier curve: start, two control points or, of a quadratic one, a single one, end. Of a
        spline: the four points that its segment between the middle two depends on.
    tightness : float or None
        Of a spline; None for a Bezier curve.
    """

    first: int
    count: int  # type: ignore[assignment] # hides tuple.count, which nobody asks of a run
    control: NDArray[np.float64]
    tightness: float | None = None


class ShapeRun(NamedTuple):
    """One `beginShape()` … `endShape()`.

    Attributes
    ----------
    first, count : int
        Its corners in the recorder.
    contours : tuple of int
        Where later outlines begin, counted from `first`.
    first_uv : int or None
        Its texture coordinates, one for each corner, 0..1; None if it has no texture.
    has_normals : bool
        Whether the sketch gave a normal, so that none are made from the faces.
    curves : tuple of CurveRun
        What its corners are only steps of.
    """

    kind: int
    first: int
    count: int  # type: ignore[assignment] # hides tuple.count, which nobody asks of a run
    is_closed: bool
    contours: tuple[int, ...]
    first_uv: int | None
    texture: Texture | None
    has_normals: bool
    curves: tuple[CurveRun, ...] = ()


def origin_of(origins: list[tuple[int, object]], row: int) -> object:
    """Return which call recorded a row; None if nobody has noted it."""
    at = bisect_right(origins, row * ROW, key=lambda entry: entry[0])
    return origins[at][1] if at < len(origins) else None


class Recorder:
    """What was called since the last flush.

    Attributes
    ----------
    rows, corners, uvs : bytearray
        Used up to `row_end`, `corner_end`, `uv_end` bytes.
    styles, stages, matrices : list
        The states that rows refer to: entry i of each (12 numbers each of `matrices`).
    nestings : list of int
        Within how many pushMatrix() each of these states was used. Nothing is drawn by it; it is
        there for those who look at how a sketch is made.
    attributes : list of Attributes
    shapes : list of ShapeRun
    textures : list of Texture
        Of images and letters, which have no shape.
    parts : list of MeshPart
        Of retained shapes.
    meshes : set of Mesh
        Those of `parts`.
    normals : (n, 3) float32 or None
        Of all corners, instead of those of `attributes`: of what was given in bulk, or edited.
    origins : list of (bytes, object)
        Which call of the sketch recorded the rows up to there. It stays empty unless somebody
        inspects the sketch (runtime/explore/noting.py), who says what a call is.
    """

    __slots__ = (
        "attributes",
        "corner_end",
        "corners",
        "matrices",
        "meshes",
        "nestings",
        "normals",
        "origins",
        "parts",
        "row_end",
        "rows",
        "shapes",
        "stages",
        "styles",
        "textures",
        "uv_end",
        "uvs",
    )

    def __init__(self, capacity: int = 1024) -> None:
        self.origins: list[tuple[int, object]] = []
        self.rows = bytearray(capacity * ROW)
        self.corners = bytearray(capacity * CORNER)
        self.uvs = bytearray(capacity * UV)
        self.corner_end = self.uv_end = self.row_end = 0
        self.clear()

    def clear(self) -> None:
        """Forget everything; states and attributes that were handed out are no longer valid."""
        self.row_end = self.corner_end = self.uv_end = 0
        self.styles: list[Style] = []
        self.stages: list[Stage] = []
        self.matrices: list[float] = []
        self.nestings: list[int] = []
        self.attributes: list[Attributes] = []
        self.shapes: list[ShapeRun] = []
        self.textures: list[Texture] = []
        self.parts: list[MeshPart] = []
        self.meshes: set[Mesh] = set()
        self.normals: NDArray[np.float32] | None = None
        if self.origins:
            self.origins = []

    def part(self, first: int, last: int) -> Recorder:
        """Return a recorder with the rows first..last-1 alone, which refer to the same states."""
        part = copy(self)
        part.rows = self.rows[first * ROW : last * ROW]
        part.row_end = len(part.rows)
        return part

    def keep_state(self, style: Style, stage: Stage, modelview: Affine, nesting: int = 0) -> int:
        """Return the index of a state for the rows that follow."""
        self.styles.append(style)
        self.stages.append(stage)
        self.matrices.extend(modelview)
        self.nestings.append(nesting)
        return len(self.styles) - 1

    def replace_stage(self, old: Stage, new: Stage, first: int = 0) -> None:
        """Let the rows that were recorded with one stage, from a state on, have another."""
        self.stages[first:] = [new if stage is old else stage for stage in self.stages[first:]]

    def first_state_after(self, kind: Kind) -> int:
        """Return the first state of the rows behind the last one of a kind."""
        rows = self.row_array()
        states = rows["state"][rows["kind"] == kind]
        return int(states[-1]) + 1 if len(states) else 0

    def make_room(self) -> bool:
        """Return whether a buffer was full; it is twice as long afterwards."""
        grown = False
        for buffer, end, size in (
            (self.rows, self.row_end, ROW),
            (self.corners, self.corner_end, CORNER),
            (self.uvs, self.uv_end, UV),
        ):
            if end + size > len(buffer):
                buffer.extend(bytes(len(buffer)))
                grown = True
        return grown

    @property
    def has_shapes(self) -> bool:
        """Whether there are rows that do not concern the whole target."""
        return bool((~np.isin(self.row_array()["kind"], WHOLE)).any())

    def row_array(self) -> NDArray[np.void]:
        """Return a view of the rows, (n,) of ROW_DTYPE; it must not outlive the next call."""
        return np.frombuffer(memoryview(self.rows)[: self.row_end], ROW_DTYPE)

    def corner_array(self) -> NDArray[np.void]:
        """Return a view of the corners, (n,) of CORNER_DTYPE; it must not outlive the next call."""
        return np.frombuffer(memoryview(self.corners)[: self.corner_end], CORNER_DTYPE)

    def uv_array(self) -> NDArray[np.float32]:
        """Return a view of the texture coordinates, (n, 2); it must not outlive the next call."""
        uvs = np.frombuffer(memoryview(self.uvs)[: self.uv_end], np.float32)
        return uvs.reshape(-1, 2)
