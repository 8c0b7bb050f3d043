import base64
import json
import struct

import numpy as np
import pytest

from sketchkit.assets.models.gltf import read_gltf
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.resources import Pixels
from tests.assets.models.model_files import DATA, corners, written

TRIANGLE = json.loads((DATA / "triangle.gltf").read_text())
BUFFER = base64.b64decode(TRIANGLE["buffers"][0]["uri"].partition(",")[2])


def changed(**parts):
    """Return the triangle's document, without its picture, and with some parts replaced."""
    document = json.loads(json.dumps(TRIANGLE))
    del document["textures"], document["images"]
    del document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    return document | parts


def glb(document, binary=BUFFER):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def parts_of(folder, document):
    return read_gltf(written(folder, "a.gltf", json.dumps(document))).parts


def test_nodes_place_their_mesh():
    (part,) = read_gltf(DATA / "triangle.gltf").parts

    assert corners(part) == [[[10, 0, 0], [12, 0, 0], [10, 2, 0]]]
    assert part.name == "flag"


def test_the_texture_is_a_file_and_its_places_stay():
    (part,) = read_gltf(DATA / "triangle.gltf").parts

    assert part.material.texture == DATA / "sign.png"
    assert part.uvs.tolist() == [[0, 0], [1, 0], [0, 1]]


def test_linear_colours_become_those_of_the_screen():
    (part,) = read_gltf(DATA / "triangle.gltf").parts

    # 0.5 on the screen is ((0.5 + 0.055) / 1.055)^2.4 = 0.2140 linear, and 0.5020 is 0.2159.
    assert part.material.diffuse == (1, 128 / 255, 0)
    assert part.material.opacity == 0.5


def test_without_blending_a_material_is_opaque(tmp_path):
    materials = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}}]

    (part,) = parts_of(tmp_path, changed(materials=materials))

    assert part.material.opacity == 1


def test_a_binary_file_has_its_buffer_and_picture_within(tmp_path):
    picture = (DATA / "sign.png").read_bytes()
    document = json.loads((DATA / "triangle.gltf").read_text())
    document["buffers"] = [{"byteLength": len(BUFFER + picture)}]
    document["bufferViews"].append(
        {"buffer": 0, "byteOffset": len(BUFFER), "byteLength": len(picture)}
    )
    document["images"] = [{"bufferView": 2, "mimeType": "image/png"}]

    (part,) = read_gltf(written(tmp_path, "a.glb", glb(document, BUFFER + picture))).parts

    assert part.places.tolist() == [[10, 0, 0], [12, 0, 0], [10, 2, 0]]
    assert isinstance(part.material.texture, Pixels)
    assert part.material.texture.data[0, 0].tolist() == [200, 100, 50, 255]


def test_a_buffer_may_be_a_file_beside_the_model(tmp_path):
    written(tmp_path, "my bytes.bin", BUFFER)

    document = changed(buffers=[{"byteLength": 68, "uri": "my%20bytes.bin"}])

    assert len(parts_of(tmp_path, document)) == 1


@pytest.mark.parametrize(
    ("transform", "expected"),
    [
        pytest.param({"translation": [1, 2, 3]}, [1, 2, 3], id="moved"),
        pytest.param({"rotation": [0, 0, 0.5**0.5, 0.5**0.5]}, [0, 1, 0], id="turned"),
        pytest.param({"scale": [3, 1, 1], "rotation": [0, 0, 1, 0]}, [-3, 0, 0], id="scaled first"),
        pytest.param({"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}, [5, 6, 7],
                     id="columns"),
    ],
)  # fmt: skip
def test_transforms_of_a_node(tmp_path, transform, expected):
    (part,) = parts_of(tmp_path, changed(nodes=[{"mesh": 0, **transform}]))

    point = part.places[0] if np.any(part.places[0]) else part.places[1]
    assert point.tolist() == pytest.approx(expected, abs=1e-6)


def test_a_mirror_turns_faces_around_and_keeps_normals_upright(tmp_path):
    normals = BUFFER + struct.pack("<9f", *(0, 0, 1) * 3)
    document = changed(nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])
    document["accessors"].append(document["accessors"][0] | {"bufferView": 2})
    document["bufferViews"].append({"buffer": 0, "byteOffset": 68, "byteLength": 36})
    document["buffers"] = [{"byteLength": 104}]
    document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 3

    (part,) = read_gltf(written(tmp_path, "a.glb", glb(document, normals))).parts

    assert part.places.tolist() == [[0, 1, 0], [-1, 0, 0], [0, 0, 0]]
    assert part.normals.tolist() == [[0, 0, 1]] * 3


def grid(mode, order):
    """Return a document with four points, (0..3, 0, 0), in a primitive of a mode."""
    binary = struct.pack("<12f", *[n for x in range(4) for n in (x, 0, 0)]) + bytes(order)
    return {
        "nodes": [{"mesh": 0}],
        "meshes": [
            {"primitives": [{"mode": mode, "attributes": {"POSITION": 0}, "indices": 1}]},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
            {"bufferView": 0, "byteOffset": 48, "componentType": 5121, "type": "SCALAR",
             "count": len(order)},
        ],
        "bufferViews": [{"buffer": 0, "byteLength": len(binary)}],
        "buffers": [{"byteLength": len(binary)}],
    }, binary  # fmt: skip


@pytest.mark.parametrize(
    ("mode", "triangles"),
    [(4, [[0, 1, 2]]), (5, [[0, 1, 2], [1, 3, 2]]), (6, [[1, 2, 0], [2, 3, 0]])],
)
def test_strips_and_fans_become_triangles(tmp_path, mode, triangles):
    (part,) = read_gltf(written(tmp_path, "a.glb", glb(*grid(mode, [0, 1, 2, 3])))).parts

    assert part.places[:, 0].reshape(-1, 3).tolist() == triangles


def test_lines_alone_are_a_warning(tmp_path):
    with pytest.warns(SketchWarning, match="has no faces"):
        assert read_gltf(written(tmp_path, "a.glb", glb(*grid(1, [0, 1])))).parts == []


def test_colours_of_vertices_are_fractions(tmp_path):
    document, binary = grid(4, [0, 1, 2])
    document["accessors"].append(
        {"bufferView": 1, "componentType": 5121, "normalized": True, "type": "VEC4", "count": 4}
    )
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": 16})
    document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2

    data = glb(document, binary + bytes([255, 55, 0, 128] * 4))
    (part,) = read_gltf(written(tmp_path, "a.glb", data)).parts

    assert part.colors.tolist() == [[255, 128, 0, 128]] * 3


def test_a_missing_picture_is_a_warning(tmp_path):
    document = json.loads((DATA / "triangle.gltf").read_text())

    with pytest.warns(SketchWarning, match=r"images\[0\]: there is no picture sign\.png"):
        (part,) = parts_of(tmp_path, document)

    assert part.material.texture is None


POSITION = {"bufferView": 0, "componentType": 5126, "type": "VEC3"}


@pytest.mark.parametrize(
    ("document", "message"),
    [
        pytest.param(changed(nodes=3), "nodes: there has to be a list.\n    Got 3", id="kind"),
        pytest.param(changed(scene=2), "scene: there has to be a number below 1", id="scene"),
        pytest.param(changed(nodes=[{"mesh": 7}]), "nodes[0].mesh: there has", id="mesh"),
        pytest.param(changed(nodes=[{"mesh": "x"}]), 'Got "x"', id="text"),
        pytest.param(changed(nodes=[{"children": [0]}]), "no other parent", id="cycle"),
        pytest.param(changed(nodes=[{"mesh": 0, "scale": [1]}]), "nodes[0].scale", id="scale"),
        pytest.param(changed(nodes=[{"mesh": 0, "scale": [1, 1, 1e99]}]), "can be drawn", id="big"),
        pytest.param(changed(buffers=[{"uri": "gone.bin"}]), "there is no file gone", id="file"),
        pytest.param(changed(buffers=[{"uri": "data:x"}]), "buffers[0].uri", id="no comma"),
        pytest.param(changed(buffers=[{"uri": "data:;base64,A"}]), "in base64", id="base64"),
        pytest.param(changed(buffers=[{}]), "buffers[0]: there has to be a uri", id="no chunk"),
        pytest.param(changed(bufferViews=[{"buffer": 0, "byteLength": 99}]), "68 bytes", id="view"),
        pytest.param(changed(accessors=[{**POSITION, "count": 10**12}]), "accessors[0]", id="huge"),
        pytest.param(changed(accessors=[{**POSITION, "count": 3, "type": "X"}]),
                     "numbers of another type, for meshes[0].primitives[0].attributes.POSITION",
                     id="type"),
        pytest.param(changed(accessors=[{**POSITION, "count": 3, "sparse": {}}]), "sparse",
                     id="sparse"),
        pytest.param(changed(extensionsRequired=["KHR_draco_mesh_compression"]),
                     "is compressed by KHR_draco_mesh_compression", id="compressed"),
    ],
)  # fmt: skip
def test_mistakes_are_told_with_their_place(tmp_path, document, message):
    with pytest.raises(SketchError) as caught:
        parts_of(tmp_path, document)

    assert message in caught.value.message


def test_an_index_of_no_vertex_is_refused(tmp_path):
    path = written(tmp_path, "a.glb", glb(*grid(4, [0, 1, 4])))

    with pytest.raises(SketchError, match=r"primitives\[0\]\.indices: there has to be indices"):
        read_gltf(path)


BINARY = glb(changed(buffers=[{"byteLength": 68}]))


@pytest.mark.parametrize(
    ("data", "message"),
    [
        pytest.param(b"", "is empty", id="empty"),
        pytest.param(b"{\n ?", "line 2, column 2: this is no JSON", id="json"),
        pytest.param(b"[1]", "an object in braces", id="list"),
        pytest.param(b"[" * 100_000, "is no JSON that can be read", id="deep"),
        pytest.param(b'{"a": "\xff"}', "is no JSON that can be read", id="no text"),
        pytest.param((DATA / "sign.png").read_bytes(), "it holds no JSON", id="picture"),
        pytest.param(BINARY[:-5], "the file ends, but should have", id="cut"),
        pytest.param(BINARY[:8], "with JSON is missing", id="no header"),
        pytest.param(BINARY[:4] + b"\1" + BINARY[5:], "only version 2", id="version"),
        pytest.param(BINARY[:12] + b"\xff\xff\xff\xff" + BINARY[16:], "byte 12", id="long part"),
        pytest.param(BINARY.replace(b"JSON", b"NOSJ"), "with JSON is missing", id="no json"),
    ],
)
def test_what_is_no_gltf_file_is_refused(tmp_path, data, message):
    with pytest.raises(SketchError) as caught:
        read_gltf(written(tmp_path, "a.glb", data))

    assert message in caught.value.message


def test_a_broken_picture_within_the_file_is_refused(tmp_path):
    document = json.loads((DATA / "triangle.gltf").read_text())
    document["images"] = [{"uri": "data:image/png;base64,iVBORw0KGgo="}]

    with pytest.raises(SketchError, match=r"images\[0\]: the picture is broken"):
        parts_of(tmp_path, document)
