"""Models of files as shapes that are kept: a group of faces, as in Processing.

Faces become shapes of their own only when the sketch asks for them. Until then, and as long as none
of them is changed, all faces of one kind and material are one shape.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.api._parts import CanvasParts
from sketchkit.api._pen import WHITE
from sketchkit.api.pimage import PImage
from sketchkit.api.pshape import PShape
from sketchkit.api.pshape_parts import Family
from sketchkit.assets.images import Picture, load_picture
from sketchkit.assets.model_data import ModelMaterial, ModelPart
from sketchkit.assets.models import load_model
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


class Faces(NamedTuple):
    """Faces of one part with the same number of corners.

    Attributes
    ----------
    kind : int
        Of `beginShape()`.
    corners : (f, k) int64
        Those of each face, in the part.
    """

    part: ModelPart
    image: PImage | None
    kind: int
    corners: I64


class ModelShape(PShape):
    """A group of the faces of a model."""

    def __init__(self, canvas: CanvasParts, parts: list[tuple[ModelPart, PImage | None]]) -> None:
        self._faces: list[Any] | None = None  # Any: a property cannot say Self
        super().__init__(canvas, Family.GROUP)
        self._faces = None
        self._parts = parts
        self._whole = [_leaf(canvas, faces) for part in parts for faces in _by_kind(*part)]

    @property
    def _children(self) -> list[Any]:  # Any: as above
        """The faces as shapes, made when first asked for."""
        if self._faces is None:
            self._faces = list(self._unpacked())
        return self._faces

    @_children.setter
    def _children(self, children: list[Any]) -> None:  # Any: as above
        self._faces = children

    def getChildCount(self) -> int:
        """Return the number of faces."""
        if self._faces is None:
            return sum(len(part.lengths) for part, _ in self._parts)
        return len(self._faces)

    def _pieces(self) -> list[Any]:  # Any: as above
        if self._faces is None or not self._is_taken_apart():
            return self._whole
        return self._faces

    def _is_taken_apart(self) -> bool:
        """Return whether the sketch has changed a face, or added or removed one."""
        faces = self._faces or []
        count = sum(len(part.lengths) for part, _ in self._parts)
        return len(faces) != count or any(
            face._version or face._matrix is not IDENTITY for face in faces
        )

    def _unpacked(self) -> Iterator[PShape]:
        """Yield each face as a shape, in the order of the file."""
        for part, image in self._parts:
            ends = np.cumsum(part.lengths)
            for end, length in zip(ends.tolist(), part.lengths.tolist(), strict=True):
                corners = np.arange(end - length, end)[None]
                kind = KINDS.get(length, c.POLYGON)
                face = _leaf(self._canvas, Faces(part, image, kind, corners))
                face._parent = self
                yield face


def _by_kind(part: ModelPart, image: PImage | None) -> Iterator[Faces]:
    """Yield the faces of a part: all triangles, all quads, then polygons one by one."""
    starts = np.cumsum(part.lengths) - part.lengths
    for length in np.unique(part.lengths).tolist():
        own = starts[part.lengths == length]
        corners = own[:, None] + np.arange(length)
        if length in KINDS:
            yield Faces(part, image, KINDS[length], corners)
        else:
            for row in corners:
                yield Faces(part, image, c.POLYGON, row[None])


def _leaf(canvas: CanvasParts, faces: Faces) -> PShape:
    """Return faces as one shape, in the look of their material.

    As in Processing, the diffuse colour is the fill, and its colour in ambient light too; a
    textured face shows its image in the sketch's tint. Nothing else of a material shows.
    """
    part, index = faces.part, faces.corners.ravel()
    shape = PShape(canvas, Family.GEOMETRY)
    shape._stroke = min(shape._stroke, ~shape._stroke)
    shape._fill = _packed(part.material)
    shape._texture_mode = c.NORMAL
    colors = None
    if faces.image is not None:
        colors = np.full(len(index), WHITE if shape._tint < 0 else shape._tint)
    elif part.colors is not None:
        colors = pack_rgba(part.colors[index])
    normals = None
    if part.normals is not None:
        normals = part.normals[index].copy()
        normals[~normals.any(axis=1)] = (0.0, 0.0, 1.0)
    uvs = None if part.uvs is None else part.uvs[index]
    if faces.image is not None and uvs is None:
        uvs = np.zeros((len(index), 2), np.float32)
    texture = None if faces.image is None else faces.image._texture()
    corners = BulkCorners(part.places[index], colors, normals, uvs)
    shape._fill_in_bulk(faces.kind, corners, texture, is_closed=True)
    shape._texture_source = faces.image
    shape._version = 0
    return shape


def _packed(material: ModelMaterial) -> int:
    """Return the diffuse colour, packed; bytes are cut off, not rounded."""
    red, green, blue = (min(max(int(part * 255), 0), 255) for part in material.diffuse)
    return OPAQUE | red << 16 | green << 8 | blue
