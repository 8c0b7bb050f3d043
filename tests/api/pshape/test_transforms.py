"""Transforms of shapes, as far as the draw list shows them. Numbers are worked out by hand."""

from __future__ import annotations

import math

import pytest

from sketchkit.api.pmatrix import PMatrix2D
from sketchkit.core.constants import GROUP, JAVA2D, P2D, RECT
from sketchkit.core.errors import SketchError
from sketchkit.draw.commands import DrawMesh
from tests.canvases import drawn, new_canvas


def square(canvas):
    canvas.noStroke()
    return canvas.createShape(RECT, 0, 0, 10, 10)


def corner(canvas, shape, x=10.0, y=0.0):
    """Return where drawing a shape takes a point of it; the canvas itself is not moved."""
    canvas.shape(shape)
    found = [c for c in drawn(canvas).commands if isinstance(c, DrawMesh)]
    a, b, _, tx, c, d, _, ty, *_ = found[-1].modelview
    return pytest.approx((a * x + b * y + tx, c * x + d * y + ty), abs=1e-4)


@pytest.fixture
def moved_group(flat):
    """A group that was moved by 100, with a child at its origin, drawn once."""
    group = flat.createShape(GROUP)
    group.addChild(square(flat))
    group.translate(100, 0)
    flat.shape(group)
    return group


class TestAlone:
    def test_each_step_is_done_after_those_before(self, flat):
        s = square(flat)
        s.translate(10, 0)
        s.rotate(math.pi / 2)

        assert corner(flat, s) == (0, 20)

    def test_in_java2d_each_is_done_before(self):
        canvas = new_canvas(JAVA2D)
        s = square(canvas)
        s.translate(10, 0)
        s.rotate(math.pi / 2)

        assert corner(canvas, s) == (10, 10)

    def test_steps_add_up_between_drawings(self, flat):
        s = square(flat)
        s.translate(10, 0)
        flat.shape(s)
        s.scale(2)

        assert corner(flat, s) == (40, 0)

    def test_reset_undoes_all(self, flat):
        s = square(flat)
        s.translate(10, 0)
        s.rotate(1)
        flat.shape(s)

        s.resetMatrix()

        assert corner(flat, s) == (10, 0)

    def test_scale_takes_one_or_two_factors(self, flat):
        s = square(flat)
        s.scale(2, 3)
        s.scale(2)

        assert corner(flat, s, 10, 10) == (40, 60)

    @pytest.mark.parametrize("as_matrix", [False, True])
    def test_matrix_is_applied(self, flat, as_matrix):
        s = square(flat)
        numbers = (2, 0, 5, 0, 3, 7)
        s.applyMatrix(*([PMatrix2D(*numbers)] if as_matrix else numbers))

        assert corner(flat, s, 10, 10) == (25, 37)

    @pytest.mark.parametrize(
        ("name", "turned"), [("rotateX", (10, 0)), ("rotateY", (-10, 10)), ("rotateZ", (-10, -10))]
    )
    def test_turns_about_each_axis(self, deep, name, turned):
        deep.ortho()
        s = square(deep)
        getattr(s, name)(math.pi)

        found = corner(deep, s, 10, 10 if name != "rotateX" else 0)

        eye = corner(deep, square(deep), 0, 0).expected
        assert found == (eye[0] + turned[0], eye[1] + turned[1])

    def test_vertices_are_told_untransformed(self, flat):
        s = square(flat)
        s.translate(50, 50)

        assert (s.getVertex(0).x, s.getVertex(0).y) == (0, 0)

    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda s: s.translate("1", 2), "translate.* takes"),
            (lambda s: s.rotate(None), "rotate.* takes"),
            (lambda s: s.scale("2"), "scale.* takes"),
            (lambda s: s.applyMatrix(1, 2, 3), "applyMatrix"),
        ],
    )
    def test_mistakes_are_told(self, flat, call, message):
        with pytest.raises(SketchError, match=message):
            call(square(flat))


class TestInGroups:
    def test_child_moves_with_its_group(self, flat):
        outer, inner, s = flat.createShape(GROUP), flat.createShape(GROUP), square(flat)
        outer.addChild(inner)
        inner.addChild(s)
        s.translate(1, 0)
        inner.scale(2)
        outer.translate(0, 5)

        assert corner(flat, outer) == (22, 5)

    def test_child_drawn_alone_stays_where_its_group_has_it(self, moved_group, flat):
        assert corner(flat, moved_group.getChild(0)) == (110, 0)

    def test_but_not_in_java2d(self):
        canvas = new_canvas(JAVA2D)
        group = canvas.createShape(GROUP)
        group.addChild(square(canvas))
        group.translate(100, 0)

        assert corner(canvas, group.getChild(0)) == (10, 0)

    def test_early_step_of_a_child_comes_before_those_of_its_group(self, flat):
        group = flat.createShape(GROUP)
        group.addChild(square(flat))
        group.translate(100, 0)
        group.getChild(0).scale(2)

        assert corner(flat, group) == (120, 0)

    def test_late_step_of_a_child_comes_after_them(self, moved_group, flat):
        moved_group.getChild(0).scale(2)

        assert corner(flat, moved_group) == (220, 0)

    def test_late_steps_of_a_group_follow(self, moved_group, flat):
        moved_group.getChild(0).scale(2)
        moved_group.translate(0, 7)

        assert corner(flat, moved_group) == (220, 7)

    def test_late_reset_takes_the_steps_of_the_child_alone(self, moved_group, flat):
        child = moved_group.getChild(0)
        child.translate(1, 1)

        child.resetMatrix()

        assert corner(flat, moved_group) == (110, 0)

    @pytest.mark.parametrize(
        "change",
        [
            lambda group: group.addChild(group._new(group._family)),
            lambda group: group.getChild(0).setStroke(True),
        ],
        ids=["another child", "an outline"],
    )
    def test_tree_made_anew_has_no_late_steps(self, moved_group, flat, change):
        moved_group.getChild(0).scale(2)

        change(moved_group)

        assert corner(flat, moved_group) == (120, 0)

    def test_group_that_was_not_moved_has_none_either(self, flat):
        group = flat.createShape(GROUP)
        group.addChild(square(flat))
        flat.shape(group)
        group.getChild(0).scale(2)

        assert corner(flat, group) == (20, 0)

    def test_flattened_group_does_no_harm(self, flat):
        group = flat.createShape(GROUP)
        group.addChild(square(flat))
        group.scale(0)
        flat.shape(group)

        group.getChild(0).translate(5, 5)

        assert corner(flat, group) == (0, 0)


def test_canvas_of_each_kind_has_its_own_rule():
    assert new_canvas(P2D)._stage.is_java2d is False
    assert new_canvas(JAVA2D)._stage.is_java2d is True
