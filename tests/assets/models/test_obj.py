import numpy as np
import pytest

from sketchkit.assets.models.obj import read_obj
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.models.model_files import DATA, corners, written

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def parts_of(folder, text):
    return read_obj(written(folder, "a.obj", text)).parts


def error_of(folder, text):
    with pytest.raises(SketchError) as caught:
        parts_of(folder, text)
    return caught.value.message


def test_parts_are_runs_of_one_name_and_material():
    parts = read_obj(DATA / "house.obj").parts

    assert [(part.name, part.material.name, part.lengths.tolist()) for part in parts] == [
        ("house", "plaster", [3]),
        ("walls", "brick", [4, 3]),
        ("walls", "sign", [4]),
        ("roof", "sign", [3]),
        ("roof", "brick", [5]),
    ]


def test_faces_keep_their_corners_and_order():
    wall = read_obj(DATA / "house.obj").parts[1]

    assert corners(wall) == [
        [[0, 0, 0], [4, 0, 0], [4, -3, 0], [0, -3, 0]],
        [[0, 0, 0], [4, 0, 0], [4, -3, 0]],
    ]


def test_a_face_before_any_usemtl_has_the_first_material():
    assert read_obj(DATA / "house.obj").parts[0].material.diffuse == (0.9, 0.85, 0.8)


def test_v_of_textures_is_turned_over():
    sign = read_obj(DATA / "house.obj").parts[2]

    assert sign.uvs.tolist() == [[0, 1], [1, 1], [1, 0], [0, 0.75]]


def test_corners_without_a_normal_have_zeros_beside_those_with_one():
    wall = read_obj(DATA / "house.obj").parts[1]

    assert wall.normals.tolist() == [[0, 0, 0]] * 4 + [[0, 0, 1]] * 3
    assert wall.uvs is None


def test_arrays_have_the_promised_types():
    part = read_obj(DATA / "house.obj").parts[3]

    types = [part.places.dtype, part.normals.dtype, part.uvs.dtype, part.lengths.dtype]
    assert types == [np.float32, np.float32, np.float32, np.int64]


def test_without_materials_faces_are_gray(tmp_path):
    (part,) = parts_of(tmp_path, TRIANGLE + "f 1 2 3\n")

    assert part.material.name == "default"
    assert part.material.diffuse == (0.5, 0.5, 0.5)


def test_equal_runs_that_touch_are_one_part(tmp_path):
    text = TRIANGLE + "g a\nf 1 2 3\ng b\ng a\nf 3 2 1\n"

    assert [part.lengths.tolist() for part in parts_of(tmp_path, text)] == [[3, 3]]


@pytest.mark.parametrize(
    ("face", "order"),
    [
        pytest.param("f -3 -2 -1", [0, 1, 2], id="counted back"),
        pytest.param("f 1 -1 2", [0, 2, 1], id="both ways"),
        pytest.param("f 3 2 1 # back", [2, 1, 0], id="with a comment"),
        pytest.param("f 1 \\\n  2 3", [0, 1, 2], id="over two lines"),
        pytest.param("  f\t1   2 3  ", [0, 1, 2], id="with more space"),
        pytest.param("f 1/ 2// 3", [0, 1, 2], id="with idle slashes"),
    ],
)
def test_forms_of_faces(tmp_path, face, order):
    (part,) = parts_of(tmp_path, TRIANGLE + face + "\nv 9 9 9\n")

    assert part.places.tolist() == np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])[order].tolist()


@pytest.mark.parametrize("faces", ["f 1/1/2 2/1/1 3/2/2", "f 1/1/2 2/1/1 3/2/2\nf 1 2 3"])
def test_corners_written_alike_or_not_read_the_same(tmp_path, faces):
    (part,) = parts_of(tmp_path, TRIANGLE + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\n" + faces)

    assert part.uvs[:3].tolist() == [[0, 1], [0, 1], [1, 0]]
    assert part.normals[:3].tolist() == [[1, 0, 0], [0, 0, 1], [1, 0, 0]]


def test_two_numbers_are_place_and_normal_in_a_file_without_texture_places(tmp_path):
    (part,) = parts_of(tmp_path, TRIANGLE + "vn 0 0 1\nf 1/1 2/1 3/1\n")

    assert part.normals.tolist() == [[0, 0, 1]] * 3
    assert part.uvs is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param("v 1 2\n", "line 4: there have to be 3 numbers", id="short"),
        pytest.param("v 1 2 x\n", "line 4: 'x' is no number", id="no number"),
        pytest.param("vn 0 nan 0\nf 1 2 3", "line 4: 'nan' is no number", id="nan"),
        pytest.param("v 1 2 1e99\n", "line 4: '1e99' is no number", id="too large"),
        pytest.param("v 1,5 2 3\n", "have a point, not a comma", id="comma"),
        pytest.param("f 1 2 3\nf 1 2 4\n", "line 5: the face has vertex (v) 4", id="range"),
        pytest.param("f 0 1 2\n", "They are counted from 1", id="zero"),
        pytest.param("f 1 2 -4\n", "line 4: the face has vertex (v) -4", id="back"),
        pytest.param("f 1 2 9999999999999999999\n", "line 4: the face has", id="huge"),
        pytest.param("\n\nf 1 two 3\n", "line 6: 'two' is no corner", id="word"),
        pytest.param("f 1.0 2 3\n", "'1.0' is no corner", id="decimal"),
        pytest.param("f 1/1/1/1 2 3\n", "'1/1/1/1' is no corner", id="four numbers"),
        pytest.param("f /1 2 3\n", "'/1' is no corner", id="no vertex"),
        pytest.param("vt 0 0\nf 1/2 2 3\n", "line 5: the face has texture place", id="uv"),
        pytest.param("vn 0 0 1\nf 1//2 2 3\n", "line 5: the face has normal (vn) 2", id="normal"),
    ],
)
def test_mistakes_are_told_with_file_and_line(tmp_path, text, message):
    told = error_of(tmp_path, TRIANGLE + text + ("" if "f" in text else "f 1 2 3\n"))

    assert "a.obj, line" in told
    assert message in told


@pytest.mark.parametrize(
    ("data", "message"),
    [
        pytest.param("", "is empty", id="empty"),
        pytest.param(" \n\n", "is empty", id="blank"),
        pytest.param((DATA / "sign.png").read_bytes(), "byte 8: this is no text", id="picture"),
        pytest.param("Dear Sir,\n", "no line begins with v or f", id="letter"),
    ],
)
def test_what_is_no_obj_file_is_refused(tmp_path, data, message):
    assert message in error_of(tmp_path, data)


@pytest.mark.filterwarnings("error")
def test_a_missing_library_is_a_warning_with_its_line(tmp_path):
    path = written(tmp_path, "a.obj", "#\nmtllib gone.mtl\nusemtl red\n" + TRIANGLE + "f 1 2 3\n")

    with pytest.warns(SketchWarning, match=r"a\.obj, line 2: there is no file gone\.mtl") as told:
        model = read_obj(path)

    assert len(told) == 1
    assert model.parts[0].material.name == "default"


def test_a_material_that_no_library_has_is_a_warning_and_the_first_one_is_used(tmp_path):
    written(tmp_path, "a.mtl", "newmtl red\nKd 1 0 0\n")
    path = written(tmp_path, "a.obj", "mtllib a.mtl\nusemtl rde\n" + TRIANGLE + "f 1 2 3\n")

    with pytest.warns(SketchWarning, match="line 2: no MTL file has a material 'rde'"):
        model = read_obj(path)

    assert model.parts[0].material.name == "red"


def test_names_of_files_and_materials_may_have_spaces(tmp_path):
    written(tmp_path, "my house.mtl", "newmtl dark red\nKd 0.5 0 0\nnewmtl dark blue\n")
    text = "mtllib my house.mtl\nusemtl dark red\n" + TRIANGLE + "f 1 2 3\n"

    assert parts_of(tmp_path, text)[0].material.diffuse == (0.5, 0, 0)


def test_a_library_from_another_computer_is_found_beside_the_model(tmp_path):
    written(tmp_path, "a.mtl", "newmtl red\nKd 1 0 0\n")
    text = "mtllib C:\\Models\\a.mtl\nusemtl red\n" + TRIANGLE + "f 1 2 3\n"

    assert parts_of(tmp_path, text)[0].material.name == "red"


def test_places_alone_are_a_model_without_parts(tmp_path):
    with pytest.warns(SketchWarning, match="has no faces"):
        assert parts_of(tmp_path, TRIANGLE) == []
