"""PLY files: points with whatever the header says they have, and faces of any number of corners.

Other modules read the numbers; here their names get a meaning.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sketchkit.assets.models.data import (
    F32,
    I64,
    U8,
    Model,
    ModelMaterial,
    ModelPart,
    broken,
    finite_or_zero,
    first_not_finite,
    read_bytes,
    said,
    texture_beside,
    warn_without_faces,
)
from sketchkit.assets.models.ply_binary import read_binary_tables
from sketchkit.assets.models.ply_header import Header, read_header
from sketchkit.assets.models.ply_table import Numbers, Table
from sketchkit.assets.models.ply_text import read_text_tables

PLACE, NORMAL = ("x", "y", "z"), ("nx", "ny", "nz")
UVS = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"))
RGB = ("red", "green", "blue")
CORNERS = ("vertex_indices", "vertex_index")
WHITE = (1.0, 1.0, 1.0)


def read_ply(path: Path) -> Model:
    """Return the model in a PLY file, of text or of bytes.

    Raises
    ------
    SketchError
        If the file is broken: it names the line or the byte.
    """
    data = read_bytes(path)
    header = read_header(path, data)
    read_tables = read_binary_tables if header.byte_order else read_text_tables
    tables = read_tables(path, data, header)
    points, faces = tables.get("vertex", Table()), tables.get("face", Table())
    corner_lists = next((faces.lists[name] for name in CORNERS if name in faces.lists), None)
    if corner_lists is None or not len(corner_lists[0]):
        warn_without_faces(path)
        return Model()
    lengths = corner_lists[0]
    corners = _corners(path, corner_lists, faces, points.count)
    colors = _colors(points)
    if colors is not None:
        colors = colors[corners]
    elif (face_colors := _colors(faces)) is not None:
        colors = face_colors.repeat(lengths, axis=0)
    normals = points.columns(NORMAL)
    part = ModelPart(
        "",
        _material(path, header),
        _places(path, points)[corners],
        lengths,
        normals=None if normals is None else finite_or_zero(normals)[corners],
        uvs=_uvs(points, corners, faces),
        colors=colors,
    )
    return Model([part])


def _places(path: Path, points: Table) -> F32:
    places = points.columns(PLACE)
    if places is None:
        raise broken(path, "header", "the vertices have no x, y and z")
    wrong = first_not_finite(places)
    if wrong is not None:
        problem = "a vertex is at no place that can be drawn"
        raise broken(path, points.where("vertex", wrong), problem)
    return places


def _corners(path: Path, corner_lists: tuple[I64, Numbers], faces: Table, count: int) -> I64:
    """Return which vertex each corner is, (c,)."""
    lengths, flat = corner_lists
    corners: I64 = flat.astype(np.int64)
    wrong = np.flatnonzero((corners < 0) | (corners >= count))
    if len(wrong):
        face = int(np.searchsorted(np.cumsum(lengths), wrong[0], side="right"))
        raise broken(
            path,
            faces.where("face", face),
            f"it has vertex {corners[wrong[0]]}, but the file has {count} of them",
            hint="They are counted from 0.",
        )
    return corners


def _uvs(points: Table, corners: I64, faces: Table) -> F32 | None:
    """Return texture places: those of the vertices, or two numbers a corner with the faces."""
    if "texcoord" in faces.lists:
        uvs = faces.lists["texcoord"][1].astype(np.float32)
        if len(uvs) == 2 * len(corners):
            return _from_above(uvs.reshape(-1, 2))
    for names in UVS:
        columns = points.columns(names)
        if columns is not None:
            return _from_above(columns)[corners]
    return None


def _from_above(uvs: F32) -> F32:
    """Return texture places with v counted from the top of the picture."""
    return finite_or_zero(np.stack([uvs[:, 0], 1 - uvs[:, 1]], axis=1))


def _colors(table: Table) -> U8 | None:
    """Return RGBA, (n, 4): bytes as they are, floats from 0..1, 16 bits cut off."""
    rgb = table.columns(RGB)
    if rgb is None:
        return None
    alpha = table.columns(("alpha",))
    full = {"f": 1.0, "u2": 65535.0}
    dtype = table.scalars["red"].dtype
    scale = 255 / full.get(dtype.kind, full.get(dtype.str[1:], 255.0))
    if alpha is None:
        alpha = np.full((len(rgb), 1), 255 / scale, np.float32)
    rgba = finite_or_zero(np.concatenate([rgb, alpha], axis=1)) * scale
    colors: U8 = np.clip(np.rint(rgba), 0, 255).astype(np.uint8)
    return colors


def _material(path: Path, header: Header) -> ModelMaterial:
    """Return the material, with the picture that a comment names."""
    for line, words in header.comments:
        if len(words) > 1 and words[0] == b"TextureFile":
            name = said(b" ".join(words[1:]))
            texture = texture_beside(path, f"line {line}", name)
            if texture is not None:
                return ModelMaterial(diffuse=WHITE, texture=texture)
    return ModelMaterial()
