"""Models of files as shapes that are kept: a group of faces, as in Processing.

Faces become shapes of their own only when the sketch asks for them. Until then, and as long as none
of them is changed, all faces of one material are one shape.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import WHITE
from sketchkit.api.pimage import PImage
from sketchkit.api.pshape.parts import Family
from sketchkit.api.pshape.shape import PShape
from sketchkit.assets.models.data import ModelMaterial, ModelPart
from sketchkit.assets.models.loading import load_model
from sketchkit.assets.pictures.images import Picture, load_picture
from sketchkit.core import constants as c
from sketchkit.core.matrix import IDENTITY
from sketchkit.draw.resources import Pixels
from sketchkit.draw.tessellation import BulkCorners, pack_rgba

I64 = NDArray[np.int64]

KINDS = {3: c.TRIANGLES, 4: c.QUADS}  # of faces with so many corners; others are polygons
OPAQUE = 0xFF000000


def model_shape(canvas: CanvasParts, path: Path) -> PShape:
    """Return the model in a file.

    Raises
    ------
    SketchError
        If the file is broken, or its kind unknown.
    """
    images: dict[object, PImage] = {}
    parts = load_model(path).parts
    return ModelShape(canvas, [(part, _image_of(part.material, images)) for part in parts])


def _image_of(material: ModelMaterial, images: dict[object, PImage]) -> PImage | None:
    """Return a material's texture, loaded once for all that use it."""
    texture = material.texture
    if texture is None:
        return None
    key = id(texture) if isinstance(texture, Pixels) else texture
    if key not in images:
        images[key] = PImage._of_picture(_picture_of(texture))
    return images[key]


def _picture_of(texture: Path | Pixels) -> Picture:
    """Return a texture's picture: from a file, or what lay within the model's own."""
    return Picture(texture.data) if isinstance(texture, Pixels) else load_picture(texture)


class ModelShape(PShape):
    """A group of the faces of a model."""

    def __init__(self, canvas: CanvasParts, parts: list[tuple[ModelPart, PImage | None]]) -> None:
        self._faces: list[Any] | None = None  # Any: a property cannot say Self
        super().__init__(canvas, Family.GROUP)
        self._faces = None
        self._lengths = [part.lengths.tolist() for part, _ in parts]
        self._whole = [_shape_of(canvas, part, image) for part, image in parts]

    @property
    def _children(self) -> list[Any]:  # Any: as above
        """The faces as shapes, made when first asked for."""
        if self._faces is None:
            self._faces = list(self._taken_out())
        return self._faces

    @_children.setter
    def _children(self, children: list[Any]) -> None:  # Any: as above
        self._faces = children

    def getChildCount(self) -> int:
        """Return the number of faces."""
        return sum(map(len, self._lengths)) if self._faces is None else len(self._faces)

    def _members(self) -> list[Any]:  # Any: as above
        return self._whole if self._faces is None else self._faces

    def _pieces(self) -> list[Any]:  # Any: as above
        return self._members() if self._is_taken_apart() else self._whole

    def _is_taken_apart(self) -> bool:
        """Return whether the faces differ from what they were when they were first asked for."""
        faces = self._members()
        return len(faces) != sum(map(len, self._lengths)) or any(
            face._version or face._matrix is not IDENTITY for face in faces
        )

    def _taken_out(self) -> Iterator[PShape]:
        """Yield each face as a shape, in the order of the file."""
        for shape, lengths in zip(self._whole, self._lengths, strict=True):
            first = 0
            for length in lengths:
                face = shape._cut_out(KINDS.get(length, c.POLYGON), first, length)
                face._parent = self
                yield face
                first += length


def _shape_of(canvas: CanvasParts, part: ModelPart, image: PImage | None) -> PShape:
    """Return all faces of a part as one shape, in the look of their material.

    As in Processing, the diffuse colour is the fill, and its colour in ambient light too; a
    textured face shows its image in the sketch's tint. Nothing else of a material shows.
    """
    shape = PShape(canvas, Family.GEOMETRY)
    shape._stroke = min(shape._stroke, ~shape._stroke)
    shape._fill = _packed(part.material)
    shape._texture_mode = c.NORMAL
    shape._texture_source = image
    weight = shape._weight
    shape._put_corners(_corners_of(part, shape._tint if image is not None else None), "fill")
    shape._weight = weight
    texture = None if image is None else image._texture()
    for length, first, count in _alike(part.lengths):
        kind = KINDS.get(length, c.POLYGON)
        shape._put_run(kind, first, count, texture, is_closed=True)
    return shape


def _corners_of(part: ModelPart, tint: int | None) -> BulkCorners:
    """Return the corners of all faces; those with a texture have a tint for colour."""
    count = len(part.places)
    colors, normals, uvs = None, part.normals, part.uvs
    if tint is not None:
        colors = np.full(count, WHITE if tint < 0 else tint)
        uvs = np.zeros((count, 2), np.float32) if uvs is None else uvs
    elif part.colors is not None:
        colors = pack_rgba(part.colors)
    if normals is not None:
        normals = np.where(normals.any(axis=1, keepdims=True), normals, (0.0, 0.0, 1.0))
    # What has no stroke when it is made has a weight of 0 in Processing, until it gets another.
    return BulkCorners(part.places, colors, normals, uvs, np.zeros(count, np.float32))


def _alike(lengths: I64) -> Iterator[tuple[int, int, int]]:
    """Yield length, first corner and number of corners of faces that can be drawn as one.

    These are triangles, or quads, that follow one another; any other face is alone.
    """
    starts = np.cumsum(lengths) - lengths
    begins = np.append(True, (np.diff(lengths) != 0) | ~np.isin(lengths[1:], list(KINDS)))
    rows = np.flatnonzero(begins)
    ends = np.append(starts[rows[1:]], lengths.sum())
    for row, end in zip(rows.tolist(), ends.tolist(), strict=True):
        yield int(lengths[row]), int(starts[row]), int(end - starts[row])


def _packed(material: ModelMaterial) -> int:
    """Return the diffuse colour, packed; bytes are cut off, not rounded."""
    red, green, blue = (min(max(int(part * 255), 0), 255) for part in material.diffuse)
    return OPAQUE | red << 16 | green << 8 | blue
