"""Sizes, what lies inside, and the triangles that a shape is drawn with."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import (
    BOX,
    CLOSE,
    ELLIPSE,
    GROUP,
    LINE,
    P2D,
    P3D,
    POINT,
    RECT,
    SPHERE,
    TRIANGLE,
    TRIANGLES,
)
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from tests.canvases import new_canvas


def sizes(s):
    return (s.getWidth(), s.getHeight(), s.getDepth())


class TestSizes:
    @pytest.mark.parametrize(
        ("kind", "numbers", "expected"),
        [  # from Processing
            (BOX, (20, 30, 40), (20, 30, 40)),
            (SPHERE, (20,), (40, 40, 39.7809)),
            (RECT, (5, 6, 30, 20), (30, 20, 0)),
            (ELLIPSE, (5, 6, 30, 20), (29.9994, 19.8054, 0)),
        ],
        ids=["BOX", "SPHERE", "RECT", "ELLIPSE"],
    )
    def test_are_those_of_the_vertices(self, deep, kind, numbers, expected):
        s = deep.createShape(kind, *numbers)

        assert sizes(s) == pytest.approx(expected, abs=1e-4)
        assert (s.width, s.height, s.depth) == sizes(s)

    def test_follow_transforms_of_the_shape(self, deep):
        s = deep.createShape(BOX, 20, 30, 40)
        s.translate(100, 0)
        s.scale(2)

        assert sizes(s) == (40, 60, 80)

    def test_of_a_group_are_those_of_all_children(self, deep):
        group = deep.createShape(GROUP)
        child = deep.createShape(RECT, 0, 0, 10, 10)
        child.translate(20, 5)
        group.addChild(child)
        group.addChild(deep.createShape(BOX, 10))

        assert sizes(group) == (35, 20, 10)

    def test_in_the_plane_the_outline_counts(self, flat):
        flat.strokeWeight(4)

        assert flat.createShape(RECT, 0, 0, 30, 20).getWidth() == 34

    def test_of_nothing_are_0(self, flat):
        assert sizes(flat.createShape()) == (0, 0, 0)
        assert sizes(flat.createShape(GROUP)) == (0, 0, 0)


class TestContains:
    @pytest.fixture
    def bay(self, flat):
        """A shape with a bay between x = 20 and 40 that is open below."""
        s = flat.createShape()
        s.beginShape()
        for x, y in ((0, 0), (60, 0), (60, 60), (40, 60), (40, 20), (20, 20), (20, 60), (0, 60)):
            s.vertex(x, y)
        s.endShape(CLOSE)
        return s

    @pytest.mark.parametrize(
        ("place", "expected"),
        [
            ((30, 10), True),
            ((10, 50), True),
            ((30, 50), False),
            ((70, 10), False),
            ((-1, 5), False),
        ],
    )
    def test_follows_the_outline(self, bay, place, expected):
        assert bay.contains(*place) is expected

    def test_does_not_follow_transforms(self, bay):
        bay.translate(500, 0)

        assert bay.contains(30, 10)

    def test_of_nothing_is_false(self, flat):
        assert not flat.createShape().contains(0, 0)

    @pytest.mark.parametrize("kind", [RECT, GROUP], ids=["primitive", "group"])
    def test_is_refused_where_there_is_no_outline(self, flat, kind):
        s = flat.createShape(kind, *((0, 0, 9, 9) if kind == RECT else ()))

        with pytest.raises(SketchError, match=r"contains.*made with beginShape"):
            s.contains(1, 1)


def rounded(canvas):
    canvas.noStroke()
    return canvas.createShape(RECT, 0, 0, 40, 30, 6)


def group(canvas):
    canvas.noStroke()
    whole = canvas.createShape(GROUP)
    child = canvas.createShape(RECT, 0, 0, 20, 20)
    child.translate(10, 10)
    whole.addChild(child)
    whole.addChild(canvas.createShape(ELLIPSE, 30, 30, 20, 20))
    return whole


def picture_of(canvas, s):
    canvas.background(235)
    canvas.shape(s, 20, 20)
    return canvas.image_data()[:, :, :3]


MADE = {
    "RECT": lambda g: g.createShape(RECT, 0, 0, 40, 30),
    "ELLIPSE": lambda g: g.createShape(ELLIPSE, 20, 15, 40, 30),
    "TRIANGLE": lambda g: g.createShape(TRIANGLE, 0, 30, 20, 0, 40, 30),
    "LINE": lambda g: g.createShape(LINE, 0, 0, 40, 30),
    "POINT": lambda g: g.createShape(POINT, 10, 10),
    "rounded RECT": rounded,
    "GROUP": group,
}


class TestTessellation:
    @pytest.mark.parametrize(
        ("name", "expected"),
        [  # from Processing, weight 3; fills before lines
            ("RECT", [6, 8]),
            ("ELLIPSE", [93, 62]),
            ("TRIANGLE", [3, 6]),
            ("LINE", 2),
            ("POINT", 1),
            ("rounded RECT", 246),
            ("GROUP", 66),
        ],
    )
    def test_has_as_many_corners_as_in_processing(self, deep, name, expected):
        deep.strokeWeight(3)

        made = MADE[name](deep).getTessellation()

        if isinstance(expected, list):
            assert [child.getVertexCount() for child in made.getChildren()] == expected
        else:
            assert made.getVertexCount() == expected

    @pytest.mark.parametrize("style", ["noStroke", "noFill", "neither"])
    @pytest.mark.parametrize("name", MADE)
    def test_looks_the_same_whatever_the_sketchs_style(self, backend: Backend, name, style):
        canvas = new_canvas(P2D, backend)
        canvas.strokeWeight(3)
        canvas.fill(200, 100, 0)
        s = MADE[name](canvas)
        if style != "neither":
            getattr(canvas, style)()

        made = s.getTessellation()

        pictures = [picture_of(canvas, drawing) for drawing in (s, made)]
        assert (pictures[0] != 235).any()
        assert (pictures[0] == pictures[1]).all()

    @pytest.mark.parametrize("style", ["stroke", "noStroke"])
    @pytest.mark.parametrize("name", ["LINE", "POINT", "rounded RECT", "GROUP"])
    def test_looks_the_same_in_space_but_for_joins(self, backend: Backend, name, style):
        canvas = new_canvas(P3D, backend)
        canvas.strokeWeight(3)
        s = MADE[name](canvas)
        if style == "noStroke":
            canvas.noStroke()

        made = s.getTessellation()

        pictures = [picture_of(canvas, drawing) for drawing in (s, made)]
        assert (pictures[0] != 235).any()
        assert (pictures[0] == pictures[1]).all()

    def test_can_be_changed_corner_by_corner(self, flat):
        flat.noStroke()
        made = flat.createShape(RECT, 0, 0, 40, 30).getTessellation()

        made.setVertex(0, -10, -10)

        assert made.getKind() == TRIANGLES
        assert made.getVertexX(0) == -10

    def test_holds_what_the_transforms_have_made(self, flat):
        flat.noStroke()
        s = flat.createShape(RECT, 0, 0, 40, 30)
        s.translate(100, 0)

        made = s.getTessellation()

        assert min(made.getVertexX(i) for i in range(6)) == 100

    def test_of_nothing_is_empty(self, flat):
        assert flat.createShape().getTessellation().getVertexCount() == 0
