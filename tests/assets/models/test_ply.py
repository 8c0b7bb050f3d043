import struct

import pytest

from sketchkit.assets.models.ply import read_ply
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.models.model_files import DATA, corners, written

PLACES = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
XYZ = "property float x\nproperty float y\nproperty float z\n"
LIST = "property list uchar int vertex_index\n"


def header(order, faces, vertices=4, more=""):
    return (
        f"ply\nformat {order} 1.0\nelement vertex {vertices}\n{XYZ}{more}"
        f"element face {faces}\n{LIST}end_header\n"
    ).encode()


def binary(order, faces):
    mark = "<" if "little" in order else ">"
    rows = b"".join(struct.pack(mark + "3f", *place) for place in PLACES)
    for face in faces:
        rows += struct.pack(f"{mark}B{len(face)}i", len(face), *face)
    return header(order, len(faces)) + rows


def error_of(folder, data):
    with pytest.raises(SketchError) as caught:
        read_ply(written(folder, "a.ply", data))
    return caught.value.message


def test_text_keeps_faces_of_any_number_of_corners():
    (part,) = read_ply(DATA / "panel.ply").parts

    assert corners(part) == [
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
        [[1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [0, 1, 0]],
    ]


def test_text_has_colours_and_texture_places_with_v_turned_over():
    (part,) = read_ply(DATA / "panel.ply").parts

    assert part.colors[:2].tolist() == [[255, 0, 0, 255], [0, 255, 0, 255]]
    assert part.uvs[[0, 6]].tolist() == [[0, 1], [0, 0.75]]
    assert part.normals is None


@pytest.mark.parametrize("order", ["binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize("faces", [[(0, 1, 2), (0, 2, 3)], [(0, 1, 2), (0, 1, 2, 3), (3, 2)]])
def test_bytes_are_read_in_either_order_with_lists_alike_or_not(tmp_path, order, faces):
    (part,) = read_ply(written(tmp_path, "a.ply", binary(order, faces))).parts

    assert [len(face) for face in faces] == part.lengths.tolist()
    assert part.places.tolist() == [list(PLACES[place]) for face in faces for place in face]


@pytest.mark.parametrize(
    ("kind", "value", "expected"),
    [("uchar", "200", 200), ("float", "0.5", 128), ("ushort", "65535", 255)],
)
def test_colours_of_faces_and_of_other_numbers(tmp_path, kind, value, expected):
    names = "".join(f"property {kind} {name}\n" for name in ("red", "green", "blue", "alpha"))
    text = header("ascii", 1).replace(b"end_header", names.encode() + b"end_header")
    rows = f"0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 {' '.join([value] * 4)}\n"

    (part,) = read_ply(written(tmp_path, "a.ply", text + rows.encode())).parts

    assert part.colors.tolist() == [[expected] * 4] * 3


def test_normals_come_with_the_vertices(tmp_path):
    names = "".join(f"property float n{axis}\n" for axis in "xyz")
    rows = "0 0 0 0 0 1\n1 0 0 0 1 0\n1 1 0 nan nan nan\n3 0 1 2\n"

    data = header("ascii", 1, 3, names) + rows.encode()
    (part,) = read_ply(written(tmp_path, "a.ply", data)).parts

    assert part.normals.tolist() == [[0, 0, 1], [0, 1, 0], [0, 0, 0]]


def test_a_picture_that_a_comment_names_is_the_texture(tmp_path):
    written(tmp_path, "wood.png", b"picture")
    data = (DATA / "panel.ply").read_bytes().replace(b"comment a", b"comment TextureFile wood.png")
    data = data.replace(b" square and a pentagon, by hand", b"")

    (part,) = read_ply(written(tmp_path, "a.ply", data)).parts

    assert part.material.texture == tmp_path / "wood.png"
    assert part.material.diffuse == (1, 1, 1)


def test_points_alone_are_a_warning(tmp_path):
    data = header("ascii", 0, 1) + b"0 0 0\n"

    with pytest.warns(SketchWarning, match="has no faces"):
        assert read_ply(written(tmp_path, "a.ply", data)).parts == []


TEXT = header("ascii", 1) + b"0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n"  # the data begins in line 10


@pytest.mark.parametrize(
    ("data", "message"),
    [
        pytest.param(b"", "is empty", id="empty"),
        pytest.param(b"hello", "its first line is not ply", id="letter"),
        pytest.param(b"ply\nformat ascii 1.0\n", "line 2: the header has no end", id="no end"),
        pytest.param(b"ply\nend_header\n", "does not say the format", id="no format"),
        pytest.param(TEXT.replace(b"ascii", b"klingon"), "line 2: 'format kl", id="format"),
        pytest.param(TEXT.replace(b"float x", b"half x"), "line 4: 'property half x'", id="type"),
        pytest.param(TEXT.replace(b" 4\n", b" -4\n"), "line 3: 'element vertex -4'", id="count"),
        pytest.param(TEXT.replace(b"1 1 0", b"1 a 0"), "line 12: 'a' is no number", id="word"),
        pytest.param(TEXT.replace(b"1 1 0", b"1 inf 0"), "line 12: a vertex is at no", id="inf"),
        pytest.param(TEXT.replace(b"1 1 0", b"1 1"), "line 12: there are fewer", id="short row"),
        pytest.param(TEXT.replace(b"3 0 1 2", b"4 0 1 2"), "line 14: there are fewer", id="list"),
        pytest.param(TEXT.replace(b"3 0 1 2", b"-1 0"), "line 14: there are fewer", id="below 0"),
        pytest.param(TEXT.replace(b"3 0 1 2", b"3 0 1 4"), "line 14: it has vertex 4", id="range"),
        pytest.param(TEXT[:-8], "line 13: the file ends after 0 of 1 rows of 'face'", id="cut"),
        pytest.param(TEXT.replace(b"float y", b"float b"), "no x, y and z", id="no y"),
        pytest.param(
            TEXT.replace(b"vertex 4", b"vertex 999999999999"), "after 5 of 999999999999", id="huge"
        ),
    ],
)
def test_mistakes_are_told_with_their_line(tmp_path, data, message):
    assert message in error_of(tmp_path, data)


GOOD = binary("binary_little_endian", [(0, 1, 2), (0, 1, 2, 3)])


@pytest.mark.parametrize(
    ("data", "message"),
    [
        pytest.param(GOOD[:-1], "the file ends after 1 of 2 rows of 'face'", id="cut face"),
        pytest.param(GOOD[:-40], "the file ends after 3 of 4 rows of 'vertex'", id="cut vertex"),
        pytest.param(
            GOOD.replace(b"face 2", b"face 99999999999"), "2 of 99999999999 rows", id="many faces"
        ),
        pytest.param(
            GOOD.replace(b"vertex 4", b"vertex 99999999999"), "of 99999999999 rows", id="many"
        ),
        pytest.param(GOOD[:-4] + b"\x09\0\0\0", "face 2: it has vertex 9", id="range"),
        pytest.param(
            GOOD.replace(b"list uchar", b"list char").replace(b"\x03\0\0\0\0", b"\xfd\0\0\0\0"),
            "a list has a length below 0",
            id="below 0",
        ),
    ],
)
def test_mistakes_in_bytes_are_told(tmp_path, data, message):
    assert message in error_of(tmp_path, data)
