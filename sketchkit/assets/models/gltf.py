"""glTF and GLB files: the triangles of a scene, each mesh where its nodes put it.

v of texture places counts from the top, as ours. Colours are linear there and become sRGB.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketchkit.assets.models.data import (
    F32,
    I64,
    U8,
    Model,
    ModelMaterial,
    ModelPart,
    Rgb,
    finite_or_zero,
    first_not_finite,
    warn_without_faces,
)
from sketchkit.assets.models.gltf_buffers import GltfFile, Numbers
from sketchkit.assets.models.json_place import JsonPlace
from sketchkit.core.errors import SketchError
from sketchkit.draw.resources import Pixels

F64 = NDArray[np.float64]

TRIANGLES, STRIP, FAN = 4, 5, 6
UNREAD = {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}


class _Placed(NamedTuple):
    """A node, and the matrix that takes its points to the scene's space, (4, 4)."""

    node: JsonPlace
    matrix: F64


def read_gltf(path: Path) -> Model:
    """Return the model in a glTF or GLB file; lines and points are left out.

    Raises
    ------
    SketchError
        If the file is broken: it names the byte, the line or the place in the JSON.
    """
    file = GltfFile(path)
    for extension in file.document["extensionsRequired"]:
        if extension.text() in UNREAD:
            hint = "Export the model without compression."
            problem = f"{path} is compressed by {extension.value}, which cannot be read."
            raise SketchError(problem, hint=hint)
    model = Model([part for placed in _nodes(file) for part in _parts_of_node(file, placed)])
    if not model.parts:
        warn_without_faces(path)
    return model


def _nodes(file: GltfFile) -> Iterator[_Placed]:
    """Yield the nodes of the scene, each before its children."""
    document = file.document
    if "scenes" in document:
        roots = list(file.item(_or_first(document["scene"]), "scenes")["nodes"])
    else:
        roots = _roots(file)
    seen: set[str] = set()
    waiting = [(root, np.eye(4)) for root in reversed(roots)]
    while waiting:
        number, above = waiting.pop()
        node = file.item(number, "nodes")
        if node.trail in seen:
            raise number.wrong("a node that has no other parent")
        seen.add(node.trail)
        placed = _Placed(node, above @ _matrix(node))
        yield placed
        waiting += [(child, placed.matrix) for child in reversed(list(node["children"]))]


def _or_first(number: JsonPlace) -> JsonPlace:
    return JsonPlace(number.path, number.trail, 0) if number.value is None else number


def _roots(file: GltfFile) -> list[JsonPlace]:
    """Return the numbers of the nodes without a parent, for files without scenes."""
    nodes = list(file.document["nodes"])
    children = {child.whole() for node in nodes for child in node["children"]}
    return [
        JsonPlace(file.path, node.trail, number)
        for number, node in enumerate(nodes)
        if number not in children
    ]


def _matrix(node: JsonPlace) -> F64:
    """Return what a node does to its points, (4, 4)."""
    if "matrix" in node:
        columns = node["matrix"].numbers(tuple(np.eye(4).ravel()))
        return np.array(columns).reshape(4, 4).T
    x, y, z, w = node["rotation"].numbers((0.0, 0.0, 0.0, 1.0))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * node["scale"].numbers((1.0, 1.0, 1.0))
    matrix[:3, 3] = node["translation"].numbers((0.0, 0.0, 0.0))
    return matrix


def _parts_of_node(file: GltfFile, placed: _Placed) -> Iterator[ModelPart]:
    """Yield a part for each of a mesh's primitives that has triangles."""
    if "mesh" not in placed.node:
        return
    mesh = file.item(placed.node["mesh"], "meshes")
    name = placed.node["name"].text("") or mesh["name"].text("")
    for primitive in mesh["primitives"]:
        if primitive["mode"].whole(TRIANGLES) in (TRIANGLES, STRIP, FAN):
            part = _part(file, primitive, name, placed.matrix)
            if len(part.lengths):
                yield part


def _part(file: GltfFile, primitive: JsonPlace, name: str, matrix: F64) -> ModelPart:
    attributes = primitive["attributes"]
    local = file.array(attributes["POSITION"], (3,)).astype(np.float64)
    corners = _corners(file, primitive, len(local))
    if np.linalg.det(matrix[:3, :3]) < 0:  # a mirror turns the faces around
        corners = corners.reshape(-1, 3)[:, ::-1].ravel()
    with np.errstate(over="ignore", invalid="ignore"):
        places = (local @ matrix[:3, :3].T + matrix[:3, 3]).astype(np.float32)
    if first_not_finite(places) is not None:
        raise attributes["POSITION"].wrong("places that can be drawn")
    material, uv_set = _material(file, primitive)
    normals = _optional(file, attributes, "NORMAL", (3,), len(local))
    uvs = _optional(file, attributes, f"TEXCOORD_{uv_set}", (2,), len(local))
    colors = _optional(file, attributes, "COLOR_0", (3, 4), len(local))
    return ModelPart(
        name,
        material,
        places[corners],
        np.full(len(corners) // 3, 3, np.int64),
        normals=None if normals is None else _turned(normals, matrix)[corners],
        uvs=None if uvs is None else uvs[corners],
        colors=None if colors is None else _rgba(colors)[corners],
    )


def _corners(file: GltfFile, primitive: JsonPlace, count: int) -> I64:
    """Return the vertices of the triangles, (3t,)."""
    if "indices" in primitive:
        order = file.array(primitive["indices"], (1,)).ravel().astype(np.int64)
        if len(order) and not 0 <= order.min() <= order.max() < count:
            raise primitive["indices"].wrong(f"indices below {count}, for so many are the vertices")
    else:
        order = np.arange(count)
    mode = primitive["mode"].whole(TRIANGLES)
    if mode == TRIANGLES:
        return order[: len(order) // 3 * 3]
    first = np.arange(max(len(order) - 2, 0))
    if mode == FAN:
        triangles = np.stack([first + 1, first + 2, np.zeros_like(first)], axis=1)
    else:
        odd = first % 2
        triangles = np.stack([first, first + 1 + odd, first + 2 - odd], axis=1)
    return order[triangles.ravel()]


def _optional(
    file: GltfFile, attributes: JsonPlace, name: str, widths: tuple[int, ...], count: int
) -> F32 | None:
    """Return an attribute as float32, one row for each vertex, or None if there is none."""
    if name not in attributes:
        return None
    rows: Numbers = file.array(attributes[name], widths)
    if len(rows) != count:
        raise attributes[name].wrong(f"{count} rows, as there are vertices")
    return finite_or_zero(rows.astype(np.float32))


def _turned(normals: F32, matrix: F64) -> F32:
    """Return normals in the scene's space: by the cofactors, which a flat matrix has as well."""
    rows = matrix[:3, :3]
    cofactors = np.stack([np.cross(rows[1], rows[2]), np.cross(rows[2], rows[0])])
    cofactors = np.concatenate([cofactors, [np.cross(rows[0], rows[1])]])
    cofactors *= np.sign(np.linalg.det(rows)) or 1
    turned = normals @ cofactors.T
    lengths = np.linalg.norm(turned, axis=1, keepdims=True)
    unit = np.divide(turned, lengths, out=np.zeros_like(turned), where=lengths > 0)
    return finite_or_zero(unit.astype(np.float32))


def _rgba(colors: F32) -> U8:
    """Return linear colours, RGB or RGBA, as bytes."""
    rgba = np.ones((len(colors), 4), np.float32)
    rgba[:, : colors.shape[1]] = np.clip(colors, 0, 1)
    rgba[:, :3] = _srgb(rgba[:, :3])
    return np.rint(rgba * 255).astype(np.uint8)


def _srgb(linear: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return light of 0..1 as the numbers of a screen: the curve of IEC 61966-2-1."""
    return np.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055)


def _material(file: GltfFile, primitive: JsonPlace) -> tuple[ModelMaterial, int]:
    """Return the material of a primitive, and which texture places its picture takes."""
    if "material" not in primitive:
        return _colored("default", (1.0, 1.0, 1.0, 1.0)), 0
    material = file.item(primitive["material"], "materials")
    metal = material["pbrMetallicRoughness"]
    if metal.value is None:
        metal = JsonPlace(file.path, metal.trail, {})
    color = metal["baseColorFactor"].numbers((1.0, 1.0, 1.0, 1.0))
    if material["alphaMode"].text("OPAQUE") == "OPAQUE":
        color = (*color[:3], 1.0)
    picture, uv_set = None, 0
    if "baseColorTexture" in metal:
        picture = file.picture(metal["baseColorTexture"]["index"])
        uv_set = metal["baseColorTexture"]["texCoord"].whole(0)
    return _colored(material["name"].text(""), color, picture), uv_set


def _colored(
    name: str, color: tuple[float, ...], picture: Path | Pixels | None = None
) -> ModelMaterial:
    """Return a material of a linear colour, RGBA, with its numbers in steps of the screen's."""
    screen = np.rint(_srgb(np.clip(np.array(color[:3]), 0, 1)) * 255) / 255
    red, green, blue = (float(channel) for channel in screen)
    rgb: Rgb = (red, green, blue)
    return ModelMaterial(name, ambient=rgb, diffuse=rgb, opacity=color[3], texture=picture)
