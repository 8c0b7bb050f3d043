"""createShape(), and what a shape takes between beginShape() and endShape()."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import (
    ARC,
    BOX,
    CENTER,
    CLOSE,
    ELLIPSE,
    GROUP,
    LINE,
    PATH,
    POINT,
    QUAD,
    QUADS,
    RECT,
    SPHERE,
    TRIANGLE,
    TRIANGLES,
)
from sketchkit.core.errors import SketchError
from sketchkit.draw.vertex import Layer

NUMBERS = {
    POINT: (10, 20),
    LINE: (10, 20, 30, 40),
    TRIANGLE: (10, 20, 40, 20, 30, 50),
    QUAD: (10, 20, 40, 20, 40, 50, 10, 50),
    RECT: (10, 20, 30, 40),
    ELLIPSE: (10, 20, 30, 40),
    ARC: (10, 20, 30, 40, 0, 2),
    BOX: (10, 20, 30),
    SPHERE: (10,),
}
NAMES = ("POINT", "LINE", "TRIANGLE", "QUAD", "RECT", "ELLIPSE", "ARC", "BOX", "SPHERE")
every_kind = pytest.mark.parametrize("kind", NUMBERS, ids=NAMES)


def places_of(s):
    return [tuple(s.getVertex(i)) for i in range(s.getVertexCount())]


def triangle(canvas):
    s = canvas.createShape()
    s.beginShape()
    s.vertex(20, 80)
    s.vertex(50, 15)
    s.vertex(80, 80)
    s.endShape(CLOSE)
    return s


class TestKinds:
    @every_kind
    def test_numbers_come_one_by_one_or_as_a_list(self, deep, kind):
        one_by_one = deep.createShape(kind, *NUMBERS[kind])
        as_list = deep.createShape(kind, list(NUMBERS[kind]))
        as_tuple = deep.createShape(kind, NUMBERS[kind])

        places = [places_of(s) for s in (one_by_one, as_list, as_tuple)]
        assert places[0] == places[1] == places[2]
        assert places[0]

    @every_kind
    def test_kind_and_family_are_told(self, deep, kind):
        s = deep.createShape(kind, *NUMBERS[kind])

        assert s.getKind() == kind
        assert s.getFamily() == s.PRIMITIVE
        assert s.getParams() == list(NUMBERS[kind])

    @pytest.mark.parametrize(
        ("args", "family"),
        [((), "GEOMETRY"), ((GROUP,), "GROUP"), ((PATH,), "PATH")],
        ids=["nothing", "GROUP", "PATH"],
    )
    def test_shapes_of_many_calls(self, flat, args, family):
        s = flat.createShape(*args)

        assert s.getFamily() == getattr(s, family)

    def test_rounded_rectangle_is_a_rect(self, flat):
        s = flat.createShape(RECT, 10, 20, 30, 40, 8)

        assert s.getKind() == RECT
        assert s.getVertexCount() > 4

    def test_style_and_modes_are_those_of_its_making(self, flat):
        flat.fill(255, 0, 0)
        flat.rectMode(CENTER)
        s = flat.createShape(RECT, 50, 50, 20, 10)
        flat.fill(0)
        flat.rectMode(0)

        assert s.getFill(0) == 0xFFFF0000
        assert [s.getVertexX(0), s.getVertexY(0)] == [40, 45]

    @pytest.mark.parametrize(
        ("args", "message"),
        [
            ((RECT, 1, 2, 3), "RECT|rect.* takes 4, 5 or 8 numbers.*\n.*Got 3"),
            ((ELLIPSE, 1, 2, 3), "ellipse.* takes 4 numbers"),
            ((BOX, 1, 2), "box.* takes 1 or 3 numbers"),
            ((SPHERE,), "sphere.* takes 1 number"),
            ((RECT, 1, 2, 3, "4"), "Got text for height"),
            ((RECT, [1, 2, 3]), "Got 3"),
            (("RECT", 1, 2, 3, 4), "createShape.* takes nothing, GROUP, or POINT, LINE"),
            ((77,), "createShape.* takes nothing, GROUP.*\n.*Got 77"),
            ((QUADS,), r"Got 17\..* s\.beginShape\(QUADS\)"),
            ((None,), "createShape"),
            (([RECT], 1), "createShape"),
        ],
    )
    def test_mistakes_are_told(self, flat, args, message):
        with pytest.raises(SketchError, match=message):
            flat.createShape(*args)


class TestBeginAndEnd:
    def test_block_ends_the_shape(self, flat):
        s = flat.createShape()
        with s.beginShape(TRIANGLES):
            s.vertex(0, 0)

        assert s.getKind() == TRIANGLES
        assert s.getVertexCount() == 1

    @pytest.mark.parametrize(("end", "expected"), [(CLOSE, True), (None, False)])
    def test_outline_is_closed_or_not(self, flat, end, expected):
        s = flat.createShape()
        s.beginShape()
        for x, y in ((0, 0), (9, 0), (9, 9)):
            s.vertex(x, y)
        s.endShape(end)

        assert s.isClosed() is expected

    def test_style_between_belongs_to_the_corners(self, flat):
        s = flat.createShape()
        s.beginShape()
        s.fill(255, 0, 0)
        s.vertex(0, 0)
        s.fill(0, 0, 255)
        s.vertex(9, 0)
        s.endShape()

        assert [s.getFill(i) for i in range(2)] == [0xFFFF0000, 0xFF0000FF]

    def test_style_between_does_not_reach_the_canvas(self, flat):
        s = flat.createShape()
        s.beginShape()
        s.fill(255, 0, 0)
        s.endShape()

        assert flat.createShape(RECT, 0, 0, 9, 9).getFill(0) == 0xFFFFFFFF

    @pytest.mark.parametrize("count", [7, 8, 9, 16, 17, 40])
    def test_texture_coordinates_outlast_the_growth_of_buffers(self, flat, count):
        s = flat.createShape()
        s.beginShape(TRIANGLES)
        for i in range(count):
            s.vertex(i, 2, i / 64, 0.5)
        s.endShape()

        assert [s.getTextureU(i) for i in range(count)] == [i / 64 for i in range(count)]
        assert [s.getTextureV(i) for i in range(count)] == [0.5] * count

    def test_holes_are_left_out(self, flat):
        s = flat.createShape()
        s.beginShape()
        s.noStroke()
        for x, y in ((0, 0), (40, 0), (40, 40), (0, 40)):
            s.vertex(x, y)
        s.beginContour()
        for x, y in ((10, 10), (10, 30), (30, 30), (30, 10)):
            s.vertex(x, y)
        s.endContour()
        s.endShape(CLOSE)

        block = s._up_to_date(flat)[0].mesh.blocks[Layer.FILLS]
        a, b, c = block.positions[block.indices].reshape(-1, 3, 3).transpose(1, 0, 2)
        assert np.abs(np.cross(b - a, c - a)[:, 2]).sum() / 2 == 40 * 40 - 20 * 20

    def test_group_has_no_vertices_of_its_own(self, flat):
        with pytest.raises(SketchError, match=r"beginShape.*createShape"):
            flat.createShape(GROUP).beginShape()

    def test_vertex_outside_is_told(self, flat):
        with pytest.raises(SketchError, match="between beginShape"):
            flat.createShape().vertex(1, 2)

    def test_shape_can_be_begun_again(self, flat):
        s = triangle(flat)

        s.beginShape()
        s.vertex(5, 5)
        s.endShape()

        assert s.getVertexCount() == 4

    def test_shape_says_what_it_is(self, flat):
        group = flat.createShape(GROUP)
        group.addChild(triangle(flat))

        assert repr(group) == "<PShape: a group of 1>"
        assert repr(triangle(flat)) == "<PShape: 3 vertices>"
        assert repr(flat.createShape(RECT, 0, 0, 9, 9)) == "<PShape: rect>"
