"""loadShape() of models: their faces, as shapes and drawn as one."""

import numpy as np
import pytest

from sketchkit.core.constants import P3D, POLYGON, QUADS, TRIANGLES
from sketchkit.core.errors import SketchError
from tests.assets.models.model_files import DATA
from tests.canvases import new_canvas

CYAN, YELLOW, WHITE = 0xFF00FFFF, 0xFFFFFF00, 0xFFFFFFFF
TENT = """mtllib tent.mtl
v 0 0 0
v 4 0 0
v 4 3 0
v 0 3 0
v 2 5 1
usemtl cloth
f 1 2 3 4
f 4 3 5
f 1 2 3
usemtl floor
f 1 2 3 5 4
"""
MATERIALS = "newmtl cloth\nKd 1 0.5 0\nnewmtl floor\nKd 0 0 1\n"
# The same triangle in the formats that Processing does not read
PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
30 0 0
0 40 0
3 0 1 2
"""
STL = """solid t
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 30 0 0
vertex 0 40 0
endloop
endfacet
endsolid t
"""
OBJ = "v 0 0 0\nv 30 0 0\nv 0 40 0\nf 1 2 3\n"


@pytest.fixture
def tent(tmp_path, deep):
    (tmp_path / "tent.obj").write_text(TENT)
    (tmp_path / "tent.mtl").write_text(MATERIALS)
    return deep.loadShape(str(tmp_path / "tent.obj"))


def test_faces_are_children_in_the_order_of_the_file(tent):
    faces = tent.getChildren()

    assert tent.getChildCount() == 4
    assert [face.getKind() for face in faces] == [QUADS, TRIANGLES, TRIANGLES, POLYGON]
    assert [face.getVertexCount() for face in faces] == [4, 3, 3, 5]
    assert tent.getVertexCount(True) == 15
    assert (faces[1].getVertex(2).x, faces[1].getVertex(2).z) == (2, 1)


def test_diffuse_colour_is_the_fill(tent):
    assert tent.getChild(0).getFill(0) == 0xFFFF7F00
    assert tent.getChild(3).getFill(0) == 0xFF0000FF


def test_size_is_that_of_all_vertices(tent):
    assert (tent.width, tent.height, tent.depth) == (4, 5, 1)


def test_faces_of_one_material_are_drawn_at_once(deep, tent):
    tent.getChild(0).getVertex(0)  # looking at a face changes nothing

    assert len(tent._drawn(deep)) == 2


@pytest.mark.parametrize("is_asked_before", [True, False], ids=["faces first", "colour first"])
def test_colour_of_the_whole_holds_for_the_faces(tent, is_asked_before):
    if is_asked_before:
        tent.getChild(1)
    tent.setFill(CYAN)

    tent.getChild(2).setFill(YELLOW)

    assert [face.getFill(0) for face in tent.getChildren()] == [CYAN, CYAN, YELLOW, CYAN]


def test_faces_changed_one_by_one_are_drawn_so(deep, tent):
    tent.getChild(1).setFill(CYAN)
    tent.getChild(0).setVertex(0, -7, 0, 0)
    parts = [part.mesh.blocks[part.layer] for part, _ in tent._drawn(deep)]

    colors = np.vstack([block.colors for block in parts])
    assert [0, 255, 255, 255] in colors.tolist()
    assert min(block.positions[:, 0].min() for block in parts) == -7


def test_stroke_that_is_switched_on_needs_a_weight(deep, tent):
    tent.setStroke(True)
    assert tent.getChild(0).getStrokeWeight(0) == 0

    tent.setStrokeWeight(2)

    assert tent.getChild(0).getStrokeWeight(0) == 2


def test_look_of_the_sketch_reaches_all_faces(deep, tent):
    tent.getChild(0)
    tent.disableStyle()
    deep.fill(CYAN)

    deep.shape(tent)

    assert {face.getFill(0) for face in tent.getChildren()} == {CYAN}


def test_texture_lies_beside_the_model(deep):
    house = deep.loadShape(str(DATA / "house.obj"))

    sources = [face._texture_source for face in house.getChildren()]

    assert [source is not None for source in sources].count(True) == 2
    assert len({id(source) for source in sources if source is not None}) == 1  # loaded once


@pytest.mark.parametrize(("name", "text"), [("t.ply", PLY), ("t.stl", STL), ("t.OBJ", OBJ)])
def test_every_format_is_drawn_alike(deep, tmp_path, name, text):
    (tmp_path / name).write_text(text)

    model = deep.loadShape(str(tmp_path / name))

    assert model.getChildCount() == 1
    (part, _) = model._drawn(deep)[0]
    assert part.mesh.blocks[part.layer].positions.tolist() == [[0, 0, 0], [30, 0, 0], [0, 40, 0]]


@pytest.mark.parametrize("name", ["triangle.gltf", "panel.ply", "wedge.stl", "house.obj"])
def test_files_of_every_kind_show(backend, name):
    canvas = new_canvas(P3D, backend)
    canvas.background(0)
    model = canvas.loadShape(str(DATA / name))
    corner = model.getChild(0).getVertex(0)
    canvas.translate(50, 50)
    canvas.scale(40 / max(model.width, model.height, model.depth))

    canvas.shape(model, -corner.x, -corner.y, -corner.z)

    assert (canvas.image_data()[..., :3].max(axis=2) > 0).mean() > 0.02


def test_other_files_are_refused(deep, tmp_path):
    (tmp_path / "scene.blend").write_text("BLENDER")

    with pytest.raises(SketchError, match="OBJ, PLY, STL, GLTF or GLB"):
        deep.loadShape(str(tmp_path / "scene.blend"))
