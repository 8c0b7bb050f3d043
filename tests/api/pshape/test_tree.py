"""Groups: what goes in, what is found."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import ELLIPSE, GROUP, P2D, P3D, RECT
from sketchkit.core.errors import SketchError
from tests.canvases import new_canvas


@pytest.fixture
def group(flat):
    return flat.createShape(GROUP)


def square(canvas, name=None):
    s = canvas.createShape(RECT, 0, 0, 10, 10)
    if name is not None:
        s.setName(name)
    return s


class TestChildren:
    def test_come_in_the_order_in_which_they_were_added(self, flat, group):
        shapes = [square(flat) for _ in range(3)]
        for s in shapes:
            group.addChild(s)

        assert group.getChildren() == shapes
        assert [group.getChild(i) for i in range(3)] == shapes
        assert group.getChildCount() == 3
        assert [group.getChildIndex(s) for s in shapes] == [0, 1, 2]

    def test_can_be_put_between_others(self, flat, group):
        first, second, between = (square(flat) for _ in range(3))
        group.addChild(first)
        group.addChild(second)

        group.addChild(between, 1)

        assert group.getChildren() == [first, between, second]

    def test_know_their_parent(self, flat, group):
        s = square(flat)
        assert s.getParent() is None

        group.addChild(s)

        assert s.getParent() is group

    def test_are_removed_by_index(self, flat, group):
        first, second = square(flat), square(flat)
        group.addChild(first)
        group.addChild(second)

        group.removeChild(0)

        assert group.getChildren() == [second]
        assert first.getParent() is None

    def test_list_of_children_is_a_copy(self, flat, group):
        group.addChild(square(flat))

        group.getChildren().clear()

        assert group.getChildCount() == 1

    def test_stranger_has_no_index(self, flat, group):
        assert group.getChildIndex(square(flat)) == -1


class TestNames:
    def test_child_is_found_by_name(self, flat, group):
        door = square(flat, "door")
        group.addChild(door)

        assert group.getChild("door") is door
        assert door.getName() == "door"

    def test_descendant_is_found_too(self, flat, group):
        inner, door = flat.createShape(GROUP), square(flat, "door")
        inner.addChild(door)
        group.addChild(inner)

        assert group.getChild("door") is door

    def test_name_given_later_is_found(self, flat, group):
        door = square(flat)
        group.addChild(door)

        door.setName("door")

        assert group.getChild("door") is door

    def test_unknown_name_is_none(self, flat, group):
        group.addChild(square(flat, "door"))

        assert group.getChild("window") is None

    def test_whole_tree_is_searched_from_a_child(self, flat, group):
        door, window = square(flat, "door"), square(flat, "window")
        group.addChild(door)
        group.addChild(window)

        assert door.findChild("window") is window

    def test_second_name_is_known_in_the_whole_tree(self, flat, group):
        inner, door = flat.createShape(GROUP), square(flat)
        group.addChild(inner)
        inner.addChild(door)

        inner.addName("entrance", door)

        assert group.getChild("entrance") is door


class TestMistakes:
    def test_only_groups_have_children(self, flat):
        with pytest.raises(SketchError, match=r"addChild\(\) belongs to a group"):
            square(flat).addChild(square(flat))

    @pytest.mark.parametrize(
        ("other", "got"), [("square", "text"), (None, "None"), (3, "a number")]
    )
    def test_only_shapes_are_children(self, group, other, got):
        with pytest.raises(SketchError, match=f"takes a PShape.\n.*Got {got}"):
            group.addChild(other)

    def test_group_is_not_in_itself(self, group):
        with pytest.raises(SketchError, match="into itself"):
            group.addChild(group)

    def test_group_is_not_in_its_descendant(self, flat, group):
        inner = flat.createShape(GROUP)
        group.addChild(inner)

        with pytest.raises(SketchError, match="into itself"):
            inner.addChild(group)

    @pytest.mark.parametrize(("index", "has"), [(2, "from 0 to 1"), (-1, "from 0 to 1")])
    def test_index_beyond_the_children_says_how_many_there_are(self, flat, group, index, has):
        group.addChild(square(flat))
        group.addChild(square(flat))

        with pytest.raises(SketchError, match=has):
            group.getChild(index)

    def test_empty_group_says_so(self, group):
        with pytest.raises(SketchError, match=r"It has none.\n.*removeChild\(0\)"):
            group.removeChild(0)

    def test_index_is_a_number(self, group):
        with pytest.raises(SketchError, match="takes an index or a name"):
            group.getChild(None)


class TestProperties:
    def test_visibility_is_kept(self, flat):
        s = square(flat)

        s.setVisible(False)

        assert not s.isVisible()

    @pytest.mark.parametrize(("renderer", "is_deep"), [(P2D, False), (P3D, True)])
    def test_dimensions_are_those_of_the_canvas(self, renderer, is_deep):
        s = new_canvas(renderer).createShape(ELLIPSE, 0, 0, 9, 9)

        assert (s.is3D(), s.is2D()) == (is_deep, not is_deep)
