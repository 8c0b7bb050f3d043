"""Corners of finished shapes, read and changed one by one."""

from __future__ import annotations

import pytest

from sketchkit.api.pvector import PVector
from sketchkit.core.constants import (
    ARC,
    BOX,
    CLOSE,
    ELLIPSE,
    GROUP,
    LINE,
    LINES,
    NORMAL,
    POINT,
    POINTS,
    POLYGON,
    QUADS,
    RECT,
    RGB,
    SPHERE,
    TRIANGLE,
    TRIANGLES,
)
from sketchkit.core.errors import SketchError
from sketchkit.draw.vertex import Layer


def triangle(canvas, kind=TRIANGLES):
    s = canvas.createShape()
    s.beginShape(kind)
    for place in ((20, 80, 1), (50, 15, 2), (80, 80, 3)):
        s.vertex(*place)
    s.endShape(CLOSE)
    return s


def shown(canvas, s, layer=Layer.FILLS):
    """Return the vertices that are drawn."""
    return s._up_to_date(canvas)[0].mesh.blocks[layer].positions.tolist()


class TestReading:
    def test_places_are_as_given(self, flat):
        s = triangle(flat)

        assert s.getVertexCount() == 3
        assert (s.getVertexX(1), s.getVertexY(1), s.getVertexZ(1)) == (50, 15, 2)
        assert s.getVertex(1) == PVector(50, 15, 2)

    def test_given_vector_is_filled(self, flat):
        v = PVector()

        assert triangle(flat).getVertex(2, v) is v
        assert tuple(v) == (80, 80, 3)

    def test_change_of_the_vector_does_not_move_the_corner(self, flat):
        s = triangle(flat)

        s.getVertex(0).x = 99

        assert s.getVertexX(0) == 20

    @pytest.mark.parametrize(
        ("kind", "numbers", "count"),
        [
            (RECT, (10, 20, 30, 40), 4),
            (POINT, (1, 2), 1),
            (LINE, (1, 2, 30, 40), 2),
            (TRIANGLE, (1, 2, 30, 4, 5, 60), 3),
            (ELLIPSE, (20, 15, 40, 30), 33),
            (ARC, (20, 15, 40, 30, 0.3, 4), 21),
            (BOX, (10,), 24),
            (SPHERE, (10,), 959),
        ],
        ids=["RECT", "POINT", "LINE", "TRIANGLE", "ELLIPSE", "ARC", "BOX", "SPHERE"],
    )
    def test_primitive_has_as_many_as_in_processing(self, deep, kind, numbers, count):
        s = deep.createShape(kind, *numbers)

        assert s.getVertexCount() == count

    def test_line_has_its_ends(self, flat):
        s = flat.createShape(LINE, 1, 2, 30, 40)

        assert [tuple(s.getVertex(i)) for i in range(2)] == [(1, 2, 0), (30, 40, 0)]

    def test_ellipse_ends_where_its_rim_began(self, flat):
        s = flat.createShape(ELLIPSE, 20, 15, 40, 30)

        rim = [s.getVertexX(i) for i in (0, 1, s.getVertexCount() - 1)]
        assert rim == [20, 40, 40]

    def test_corners_of_a_rectangle_go_clockwise(self, flat):
        s = flat.createShape(RECT, 10, 20, 30, 40)

        places = [(s.getVertexX(i), s.getVertexY(i)) for i in range(4)]
        assert places == [(10, 20), (40, 20), (40, 60), (10, 60)]

    def test_group_has_none_unless_children_count(self, flat):
        group = flat.createShape(GROUP)
        group.addChild(triangle(flat))
        group.addChild(flat.createShape(RECT, 0, 0, 9, 9))

        assert group.getVertexCount() == 0
        assert group.getVertexCount(True) == 7

    @pytest.mark.parametrize(
        ("index", "message"),
        [
            (3, "vertices 0 to 2.\n.*Got 3"),
            (-1, "vertices 0 to 2"),
            ("0", "index of a vertex first.\n.*Got text"),
            (None, "index of a vertex first"),
        ],
    )
    def test_index_beyond_is_told(self, flat, index, message):
        with pytest.raises(SketchError, match=message):
            triangle(flat).getVertex(index)

    def test_empty_shape_says_so(self, flat):
        with pytest.raises(SketchError, match="the shape has no vertices"):
            flat.createShape().getVertex(0)


@pytest.mark.parametrize("is_drawn", [False, True], ids=["before", "after it was drawn"])
class TestMoving:
    @pytest.mark.parametrize("place", [(1, 2, 3), (PVector(1, 2, 3),)], ids=["numbers", "vector"])
    def test_takes_numbers_or_a_vector(self, deep, is_drawn, place):
        s = triangle(deep)
        if is_drawn:
            deep.shape(s)

        s.setVertex(1, *place)

        assert tuple(s.getVertex(1)) == (1, 2, 3)
        assert shown(deep, s)[1] == [1, 2, 3]

    def test_without_z_it_is_zero(self, deep, is_drawn):
        s = triangle(deep)
        if is_drawn:
            deep.shape(s)

        s.setVertex(2, 7, 8)

        assert shown(deep, s)[2] == [7, 8, 0]

    @pytest.mark.parametrize("kind", [POLYGON, QUADS, LINES], ids=["polygon", "quads", "lines"])
    def test_of_every_kind_shows(self, flat, is_drawn, kind):
        s = flat.createShape()
        s.beginShape(kind)
        for x, y in ((10, 10), (40, 10), (40, 40), (10, 40)):
            s.vertex(x, y)
        s.endShape()
        if is_drawn:
            flat.shape(s)

        s.setVertex(0, -100, 10)

        assert min(x for x, _, _ in shown(flat, s)) < -90

    def test_point_takes_all_of_its_fan_along(self, deep, is_drawn):
        s = triangle(deep, POINTS)
        if is_drawn:
            deep.shape(s)
        before = shown(deep, s, Layer.POINTS)

        s.setVertex(0, 1, 2, 3)

        moved = shown(deep, s, Layer.POINTS)
        assert moved.count([1, 2, 3]) == before.count([20, 80, 1]) > 4


class TestOutline:
    def test_in_space_stays_once_it_was_drawn(self, deep):
        s = triangle(deep)
        deep.shape(s)
        before = shown(deep, s, Layer.LINES)

        s.setVertex(1, 0, 0, 0)

        assert shown(deep, s, Layer.LINES) == before


class TestNormals:
    def test_made_from_the_face_until_it_is_set(self, deep):
        s = triangle(deep)
        s.setVertex(1, 50, 15, 0)
        s.setVertex(0, 20, 80, 0)
        s.setVertex(2, 80, 80, 0)

        made = tuple(s.getNormal(1))
        s.setNormal(1, 0.6, 0, 0.8)

        assert made == pytest.approx((0, 0, 1))
        assert tuple(s.getNormal(1)) == pytest.approx((0.6, 0, 0.8))
        assert tuple(s.getNormal(0)) == pytest.approx((0, 0, 1))

    def test_given_ones_are_told(self, deep):
        s = deep.createShape()
        s.beginShape(TRIANGLES)
        s.normal(0, 1, 0)
        for x, y in ((0, 0), (9, 0), (9, 9)):
            s.vertex(x, y)
        s.endShape()

        assert (s.getNormalX(2), s.getNormalY(2), s.getNormalZ(2)) == (0, 1, 0)

    def test_set_after_drawing_changes_its_vertex_alone(self, deep):
        s = triangle(deep)
        deep.lights()
        deep.shape(s)
        mesh = s._up_to_date(deep)[0].mesh
        before = mesh.blocks[Layer.FILLS].normals.copy()

        s.setNormal(1, 1, 0, 0)

        after = s._up_to_date(deep)[0].mesh.blocks[Layer.FILLS].normals
        assert after[1].tolist() == [1, 0, 0]
        assert after[2] / abs(after[2]).max() == pytest.approx(before[2] / abs(before[2]).max())


class TestTextureCoordinates:
    @pytest.mark.parametrize("is_drawn", [False, True], ids=["before", "after it was drawn"])
    def test_are_in_pixels_of_the_image(self, flat, is_drawn):
        picture = flat.createImage(20, 40, RGB)
        s = flat.createShape()
        s.beginShape(TRIANGLES)
        s.texture(picture)
        for x, y in ((0, 0), (9, 0), (9, 9)):
            s.vertex(x, y, x, y)
        s.endShape()
        if is_drawn:
            flat.shape(s)

        s.setTextureUV(1, 10, 30)

        assert (s.getTextureU(1), s.getTextureV(1)) == (0.5, 0.75)
        uvs = s._up_to_date(flat)[0].mesh.blocks[Layer.FILLS].uvs
        assert uvs[1].tolist() == [0.5, 0.75]

    def test_are_from_0_to_1_in_normal_mode(self, flat):
        s = triangle(flat)
        s.setTextureMode(NORMAL)

        s.setTextureUV(1, 0.25, 0.5)

        assert (s.getTextureU(1), s.getTextureV(1)) == (0.25, 0.5)

    def test_come_with_a_texture_that_is_put_on_later(self, flat):
        s = flat.createShape()
        s.beginShape(TRIANGLES)
        for x, y in ((0, 0), (9, 0), (9, 9)):
            s.vertex(x, y, x, y)
        s.endShape()

        s.setTexture(flat.createImage(18, 36, RGB))

        assert (s.getTextureU(2), s.getTextureV(2)) == (0.5, 0.25)

    def test_of_a_rectangle_are_its_corners(self, flat):
        s = flat.createShape(RECT, 0, 0, 9, 9)

        found = [(s.getTextureU(i), s.getTextureV(i)) for i in range(4)]
        assert found == [(0, 0), (1, 0), (1, 1), (0, 1)]


class TestMistakes:
    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda s: s.setVertex(0), "setVertex.* takes"),
            (lambda s: s.setVertex(0, 1), "setVertex.* takes"),
            (lambda s: s.setVertex(0, 1, "2"), "setVertex.* takes"),
            (lambda s: s.setVertex(0, 1, 2, 3, 4), "setVertex.* takes"),
            (lambda s: s.setVertex(3, 1, 2), r"setVertex\(\): the shape has vertices 0 to 2"),
            (lambda s: s.setNormal(0, 1, None, 2), "setNormal.* takes"),
            (lambda s: s.setNormal(5, 1, 1, 2), r"setNormal\(\): the shape has vertices"),
            (lambda s: s.setTextureUV(0, "1", 2), "setTextureUV.* takes"),
        ],
    )
    def test_are_told(self, flat, call, message):
        with pytest.raises(SketchError, match=message):
            call(triangle(flat))

    @pytest.mark.parametrize("kind", [RECT, GROUP], ids=["primitive", "group"])
    def test_only_given_corners_are_moved(self, flat, kind):
        s = flat.createShape(kind, *((0, 0, 9, 9) if kind == RECT else ()))

        with pytest.raises(SketchError, match="shapes made with beginShape"):
            s.setVertex(0, 1, 2)

    def test_open_shape_cannot_be_changed(self, flat):
        s = flat.createShape()
        s.beginShape()
        s.vertex(0, 0)

        with pytest.raises(SketchError, match=r"setVertex\(\) belongs after endShape"):
            s.setVertex(0, 1, 1)
