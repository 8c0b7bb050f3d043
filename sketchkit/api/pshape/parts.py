"""ShapeParts: the only attributes that a retained shape has, and how its mesh is kept up to date.

The groups of methods (`tree.py`, `looks.py`, ...) add methods, never attributes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Self

import numpy as np

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import Pen
from sketchkit.api.pshape.batches import MANY, Batch, is_small
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError
from sketchkit.core.matrix import IDENTITY, Affine, multiply, volume_scale
from sketchkit.core.style import Style
from sketchkit.draw.meshes import Mesh, MeshPart
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.resources import Texture
from sketchkit.draw.retain import Quality, repaint, retain, revise, shows_corners
from sketchkit.draw.shading import BUILT_IN
from sketchkit.draw.stage import Stage
from sketchkit.draw.vertex import Layer

SMALLEST = 8  # rows, and vertices, that a new shape has room for
LAYERS = list(Layer)

Placed = tuple[MeshPart, Affine]  # a part of a mesh, and what takes it to the shape's parent


class Family(IntEnum):
    """What a shape is made of; the values are Processing's."""

    GROUP = 0
    PRIMITIVE = 101
    PATH = 102
    GEOMETRY = 103


@dataclass(frozen=True, slots=True)
class Look:
    """What `disableStyle()` puts aside."""

    fill: int
    stroke: int
    tint: int
    weight: float
    style: Style


class ShapeParts(Pen):
    """Attributes of a retained shape.

    Attributes
    ----------
    _canvas : CanvasParts
        Which made it.
    _family : Family
    _kind : int
        A constant of `beginShape()`, or of `createShape()`.
    _matrix : Affine
        What takes the shape to its parent.
    _own_steps : Affine
        All its transforms so far: the same, but for those that came late (transforms.py).
    _is_settled : bool
        Of the root of a tree: whether the tree as it is now was drawn or measured.
    _texture_source : object or None
        The image that covers it, asked for its pixels at each drawing.
    _meshes : list of MeshPart or None
        None when it has to be expanded anew.
    _edits : dict of Quality to set of int
        Corners that have changed since the mesh was last brought up to date.
    _repaints : dict of Quality to int
        New colours of all that is filled, or stroked.
    _put_aside : Look or None
        The shape's own look while the sketch's is used.
    _version : int
        How often the sketch has changed more of it than its matrix.
    _batch : Batch or None
        Of a group of many small shapes: all of them in one mesh.
    _is_read_path : bool
        Whether it was a path in an SVG file: the codes of its vertices begin with BREAK.
    _document_size : (width, height) or None
        What the file says of which it was read.
    """

    _canvas: CanvasParts
    _family: Family
    _kind: int
    _name: str | None
    _parent: Self | None
    _version: int
    _batch: Batch | None
    _children: list[Self]
    _names: dict[str, Self]
    _matrix: Affine
    _own_steps: Affine
    _is_settled: bool
    _is_visible: bool
    _texture_source: object | None
    _meshes: list[MeshPart] | None
    _edits: dict[Quality, set[int]]
    _repaints: dict[Quality, int]
    _put_aside: Look | None
    _is_read_path: bool
    _document_size: tuple[float, float] | None
    _scale_at_first: float | None

    def __init__(self, canvas: CanvasParts, family: Family) -> None:
        super().__init__(Recorder(SMALLEST), _resting(canvas))
        self._canvas = canvas
        self._family = family
        self._kind = c.POLYGON
        self._name = self._parent = None
        self._children = []
        self._names = {}
        self._matrix = self._own_steps = IDENTITY
        self._is_settled = False
        self._is_visible = True
        self._is_read_path = False
        self._version = 0
        self._batch = None
        self._scale_at_first: float | None = None
        self._texture_source = self._meshes = self._put_aside = self._document_size = None
        self._edits, self._repaints = {}, {}
        self._take_look(canvas)

    def _take_look(self, pen: Pen) -> None:
        """Take over everything that a pen draws with."""
        self._fill, self._stroke, self._tint = pen._fill, pen._stroke, pen._tint
        self._weight, self._style = pen._weight, pen._style
        self._color_mode, self._texture_mode = pen._color_mode, pen._texture_mode
        self._curve_detail, self._curve_tightness = pen._curve_detail, pen._curve_tightness
        self._bezier_detail = pen._bezier_detail

    @property
    def _is_group(self) -> bool:
        return self._family is Family.GROUP

    def _leaves(self) -> Iterator[Self]:
        """Yield the shapes of the tree that are no groups."""
        if not self._is_group:
            yield self
        for member in self._members():
            yield from member._leaves()

    def _members(self) -> list[Self]:
        """Return the shapes in a group, or what stands for them as long as nobody asked."""
        return self._children

    def _pieces(self) -> list[Self]:
        """Return the shapes that a group is drawn with: its children, or what stands for them."""
        return self._children

    def _surroundings(self) -> Affine:
        """Return where the groups that the shape is in take it.

        Processing's P2D and P3D draw a child there also if it is drawn alone; JAVA2D does not.
        """
        if self._parent is None or self._canvas._stage.is_java2d:
            return IDENTITY
        return multiply(self._parent._surroundings(), self._parent._matrix)

    def _root(self) -> Self:
        return self if self._parent is None else self._parent._root()

    def _settle(self) -> None:
        """Note that the tree is drawn or measured as it is now."""
        self._root()._is_settled = True

    def _unsettle(self) -> None:
        """Note that the tree has other vertices, or other shapes: no transform is late any more."""
        root = self._root()
        if root._is_settled:
            root._is_settled = False
            root._realign()

    def _realign(self) -> None:
        """Have everything in the tree where its own transforms take it to its parent."""
        self._matrix = self._own_steps
        for piece in self._pieces():
            piece._realign()

    def _must_be_ended(self, caller: str) -> None:
        """Refuse what makes sense only after `endShape()`."""
        if self._shape is not None:
            raise SketchError(
                f"{caller}() belongs after endShape().",
                hint="Between beginShape() and endShape() write fill(), stroke(), vertex() ...",
            )

    def _edit(self, quality: Quality, corner: int) -> None:
        """Note that a corner has another value."""
        self._version += 1
        self._unsettle()
        if self._meshes is None:
            return
        if shows_corners(self._kind, quality):
            self._edits.setdefault(quality, set()).add(corner)
        else:
            self._expand_anew()

    def _repaint(self, quality: Quality, color: int) -> None:
        """Note that all that is filled, or stroked, has another colour."""
        self._version += 1
        if self._meshes is not None:
            self._edits.pop(quality, None)
            self._repaints[quality] = color

    def _expand_anew(self) -> None:
        """Have the mesh made again when the shape is next drawn."""
        self._version += 1
        self._unsettle()
        self._meshes = None
        self._edits.clear()
        self._repaints.clear()

    def _drawn(self, canvas: CanvasParts) -> list[Placed]:
        """Return what a canvas draws of the shape and of its children, in its order.

        In Processing's P2D and P3D a group is one piece: first everything filled is drawn, then
        all lines, then all points, whether children are visible or not. In JAVA2D, and if children
        have different textures, they are drawn one after the other.
        """
        if not self._is_visible:
            return []
        if self._put_aside is not None:
            self._wear_look_of(canvas)
        if not self._is_group:
            return self._placed(canvas)
        pieces = self._pieces()
        if canvas._stage.is_java2d or self._is_fragmented():
            parts = [placed for piece in pieces for placed in piece._drawn(canvas)]
        else:
            parts = self._as_one(canvas)
            parts.sort(key=lambda placed: LAYERS.index(placed[0].layer))
        return [(part, multiply(self._matrix, matrix)) for part, matrix in parts]

    def _as_one(self, canvas: CanvasParts) -> list[Placed]:
        """Return the parts of all shapes in a group; many small ones are joined."""
        leaves = [leaf for piece in self._pieces() for leaf in piece._placed_leaves()]
        small = [leaf for leaf in leaves if is_small(leaf[0])]
        others = [leaf for leaf in leaves if not is_small(leaf[0])]
        if len(small) < MANY or (others and not self._stage.is_3d):  # in 2D the order shows
            return [placed for piece in self._pieces() for placed in piece._gathered(canvas)]
        if self._batch is None or not self._batch.follow(small):
            self._batch = Batch(small, _resting(canvas, is_3d=self._stage.is_3d))
        texture = next((t for leaf, _ in small if (t := leaf._current_texture())), None)
        parts = [(part, IDENTITY) for part in self._batch.parts(texture)]
        for leaf, matrix in others:
            parts += [(part, matrix) for part, _ in leaf._placed(canvas)]
        return parts

    def _placed_leaves(self) -> Iterator[tuple[Self, Affine]]:
        """Yield the shapes of the tree, and what takes them to its parent."""
        if not self._is_group:
            yield self, self._matrix
            return
        for piece in self._pieces():
            for leaf, matrix in piece._placed_leaves():
                yield leaf, multiply(self._matrix, matrix)

    @property
    def _first_scale(self) -> float:
        """By how much the shape had been enlarged when it was first drawn.

        A scale that came before counts twice for outlines: Processing does so.
        """
        if self._scale_at_first is None:
            self._scale_at_first = volume_scale(self._matrix)
        return self._scale_at_first

    def _gathered(self, canvas: CanvasParts) -> list[Placed]:
        """Return all parts of the tree, as a piece of a larger group."""
        if not self._is_group:
            return self._placed(canvas)
        parts = [placed for piece in self._pieces() for placed in piece._gathered(canvas)]
        return [(part, multiply(self._matrix, matrix)) for part, matrix in parts]

    def _placed(self, canvas: CanvasParts) -> list[Placed]:
        """Return the parts of a shape that is no group."""
        texture = self._current_texture()
        return [
            (part if part.texture is None else part._replace(texture=texture), self._matrix)
            for part in self._up_to_date(canvas)
        ]

    def _is_fragmented(self) -> bool:
        """Return whether the children of a group are drawn one by one."""
        sources = {id(leaf._texture_source) for leaf in self._leaves()}
        is_textured = any(leaf._texture_source is not None for leaf in self._leaves())
        strokes = any(
            leaf._texture_source is not None and leaf._stroke >= 0 for leaf in self._leaves()
        )
        return is_textured and (len(sources) > 1 or strokes)

    def _current_texture(self) -> Texture | None:
        """Return the image that covers the shape, as it is now."""
        source = self._texture_source
        return None if source is None else source._texture()  # type: ignore[attr-defined] # texture() has looked

    def _up_to_date(self, canvas: CanvasParts) -> list[MeshPart]:
        """Return the parts of the mesh, brought up to what the shape is now."""
        if self._meshes is None:
            stage = _resting(canvas, is_3d=self._stage.is_3d)
            self._recorder.replace_stage(self._stage, stage)
            self._stage = stage
            self._scale_at_first = None
            self._meshes = retain(self._recorder, self._first_scale)
        elif self._edits or self._repaints:
            self._revise(canvas)
        return self._meshes

    def _revise(self, canvas: CanvasParts) -> None:
        """Carry edits over to the mesh."""
        if not self._meshes:
            return
        mesh = self._meshes[0].mesh
        if mesh in canvas._recorder.meshes:
            canvas._renderer.flush()  # what was drawn with the old values keeps them
        with_ambient = self._style.material.ambient < 0
        for quality, color in self._repaints.items():
            repaint(mesh, quality, color, with_ambient=with_ambient)
        for quality, corners in self._edits.items():
            revise(mesh, self._recorder, quality, np.array(sorted(corners)))
        self._edits.clear()
        self._repaints.clear()

    def _mesh(self) -> Mesh | None:
        """Return the mesh of a shape that is no group, or None if there is nothing in it."""
        parts = self._up_to_date(self._canvas)
        return parts[0].mesh if parts else None

    def _wear_look_of(self, canvas: CanvasParts) -> None:
        """Take over the look of the sketch, after `disableStyle()`."""
        raise NotImplementedError


def scaled(part: MeshPart, matrix: Affine) -> MeshPart:
    """Return a part whose lines and points are as much thicker as a matrix enlarges."""
    if part.layer is Layer.FILLS or matrix == IDENTITY:
        return part
    return part._replace(weight_scale=volume_scale(matrix))


def _resting(canvas: CanvasParts, *, is_3d: bool | None = None) -> Stage:
    """Return the stage of what is retained: seen from where the canvas's camera is."""
    stage = canvas._stage
    return replace(
        stage,
        is_3d=stage.is_3d if is_3d is None else is_3d,
        lights=(),
        depth_sort=False,
        clip=None,
        sighting=canvas._modelview,
        shadings=BUILT_IN,
    )
