import pytest

from sketchkit.core.constants import BEZIER_VERTEX, POLYGON, TRIANGLES, VERTEX
from sketchkit.core.errors import SketchError


@pytest.fixture
def drop(flat):
    shape = flat.createShape()
    shape.beginShape()
    shape.vertex(30, 20)
    shape.bezierVertex(80, 0, 80, 75, 30, 75)
    shape.endShape()
    return shape


def test_vertices_are_counted_as_they_were_given(drop):
    assert drop.getVertexCount() == 4
    assert (drop.getVertex(2).x, drop.getVertex(2).y) == (80, 75)


def test_codes_of_a_curve(drop):
    assert drop.getVertexCodes() == [VERTEX, BEZIER_VERTEX]
    assert drop.getVertexCodeCount() == 2
    assert drop.getVertexCode(1) == BEZIER_VERTEX


@pytest.mark.parametrize("kind", [POLYGON, TRIANGLES])
def test_corners_alone_have_no_codes(flat, kind):
    shape = flat.createShape()
    with shape.beginShape(kind):
        for place in ((1, 2), (3, 4), (5, 1)):
            shape.vertex(*place)

    assert shape.getVertexCodes() == []


def test_code_that_is_not_there_is_told(drop):
    with pytest.raises(SketchError, match=r"getVertexCode\(\).* 0 to 1"):
        drop.getVertexCode(2)


def test_curve_follows_its_control_point(drop):
    before = drop._recorder.corner_array()["place"][10].tolist()

    drop.setVertex(1, 180, 0)

    after = drop._recorder.corner_array()["place"][10].tolist()
    assert after[0] - before[0] == pytest.approx(100 * 3 / 8)  # at t = 1/2 it counts 3/8
    assert drop.getVertex(1).x == 180


def test_setVertex_of_a_curve_checks_its_numbers(drop):
    with pytest.raises(SketchError, match="setVertex"):
        drop.setVertex(1, "a", 2)
