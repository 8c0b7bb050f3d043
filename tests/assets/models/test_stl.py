import struct

import pytest

from sketchkit.assets.models.stl import read_stl
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.models.model_files import DATA, written

FACET = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)


def binary(*facets, count=None, header=b"made by hand"):
    return header.ljust(80, b" ") + struct.pack("<I", count or len(facets)) + b"".join(facets)


def test_text_gives_triangles_with_their_normals():
    (part,) = read_stl(DATA / "wedge.stl").parts

    assert part.name == "wedge one"
    assert part.lengths.tolist() == [3, 3]
    assert part.places[:3].tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


def test_a_normal_that_is_no_number_is_none():
    (part,) = read_stl(DATA / "wedge.stl").parts

    assert part.normals.tolist() == [[0, 0, 1]] * 3 + [[0, 0, 0]] * 3


def test_a_normal_too_large_for_32_bits_is_none(tmp_path):
    text = (DATA / "wedge.stl").read_bytes().replace(b"0 0 1\n", b"0 0 1e99\n")

    assert read_stl(written(tmp_path, "a.stl", text)).parts[0].normals is None


def test_a_file_written_as_most_are_reads_like_one_that_is_not(tmp_path):
    text = (DATA / "wedge.stl").read_bytes().replace(b"-nan -nan -nan", b"0 1 0")
    other = text.replace(b"outer", b"OUTER")

    usual, unusual = (read_stl(written(tmp_path, "a.stl", data)).parts[0] for data in (text, other))

    assert usual.name == unusual.name == "wedge one"
    assert usual.places.tolist() == unusual.places.tolist()
    assert usual.normals.tolist() == unusual.normals.tolist() == [[0, 0, 1]] * 3 + [[0, 1, 0]] * 3


def test_two_solids_are_two_parts(tmp_path):
    text = (DATA / "wedge.stl").read_bytes()

    parts = read_stl(written(tmp_path, "a.stl", text + text.replace(b"one", b"two"))).parts

    assert [part.name for part in parts] == ["wedge one", "wedge two"]


@pytest.mark.parametrize("header", [b"made by hand", b"solid"])
def test_bytes_give_the_same_whatever_the_header_says(tmp_path, header):
    (part,) = read_stl(written(tmp_path, "a.stl", binary(FACET, FACET, header=header))).parts

    assert part.lengths.tolist() == [3, 3]
    assert part.places[3:].tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert part.normals.tolist() == [[0, 0, 1]] * 6


def test_no_triangles_are_a_warning(tmp_path):
    with pytest.warns(SketchWarning, match="has no faces"):
        assert read_stl(written(tmp_path, "a.stl", binary())).parts == []


NAN_FACET = struct.pack("<12fH", 0, 0, 1, 0, 0, float("nan"), 1, 0, 0, 0, 1, 0, 0)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        pytest.param(binary(FACET, FACET[:-1]), "byte 183: the file ends after 1 of 2", id="cut"),
        pytest.param(binary(FACET, count=2**32 - 1), "1 of 4294967295 triangles", id="huge"),
        pytest.param(binary(FACET, NAN_FACET), "byte 134: a corner is at no place", id="nan"),
        pytest.param(b"hello", "is no STL file", id="letter"),
        pytest.param(b"", "is empty", id="empty"),
        pytest.param("solid a\nfacet normal 0 0 1\nvertex 0 0", "line 3: there have", id="row"),
        pytest.param("solid a\nvertex 0 0 0\nvertex 0 b 0\nvertex 0 0 0\n"
                     "facet normal 0 0 1\n", "line 1: a facet has to have three", id="early"),
        pytest.param("solid a\nfacet normal 0 0 1\nvertex 0 b 0\nvertex 0 0 0\nvertex 0 0 0\n"
                     "endsolid", "line 3: 'b' is no number", id="word"),
        pytest.param("solid a\nfacet normal 0 0 1\nvertex 0 0 0\nendsolid", "line 2: a facet has "
                     "to have three corners.\n    Got 1", id="corner"),
        pytest.param("solid a\nfacet normal 0 0 1\n", "line 2: the file ends", id="no end"),
        pytest.param("solid a\nfaces\n", "line 2: 'faces' is no word", id="other word"),
    ],
)  # fmt: skip
def test_mistakes_are_told_with_line_or_byte(tmp_path, data, message):
    with pytest.raises(SketchError) as caught:
        read_stl(written(tmp_path, "a.stl", data))

    assert message in caught.value.message
