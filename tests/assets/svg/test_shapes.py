import pytest

from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.measures import Viewport
from sketchkit.assets.svg.shapes import SHAPES, Frame, read_frame
from sketchkit.core import constants as c


def rect(**attributes):
    return SHAPES["rect"](Element("rect", attributes, 1), Viewport(100, 100))


@pytest.mark.parametrize(
    ("radii", "radius"),
    [
        ({"rx": "2"}, (2,)),
        ({"ry": "2"}, (2,)),
        ({"rx": "2", "ry": "-1"}, (2,)),
        ({"rx": "auto"}, ()),
        ({"rx": "0", "ry": "3"}, ()),
        ({"rx": "50"}, (5,)),
    ],
)
def test_a_missing_radius_is_the_other_one_and_half_a_side_the_most(radii, radius):
    assert rect(width="10", height="10", **radii) == (c.RECT, (0, 0, 10, 10, *radius))


def test_two_radii_make_a_path():
    kind, outline = rect(width="20", height="10", rx="50")  # at most 10 and 5

    assert kind == c.PATH
    assert len(outline.vertices) == 16


@pytest.mark.parametrize("size", [{}, {"width": "0", "height": "3"}, {"width": "-1"}])
def test_a_rectangle_without_an_area_is_an_empty_group(size):
    assert rect(**size) == (c.GROUP, ())


def test_a_frame_has_the_size_that_another_element_gives():
    symbol = Element("symbol", {"viewBox": "0 0 10 10"}, 1)
    copy = Element("use", {"width": "20", "height": "25%"}, 1)

    frame = read_frame(symbol, copy, Viewport(100, 100))
    assert (frame.width, frame.height) == (20, 25)
    assert frame.matrix[:8] == (2, 0, 0, 0, 0, 2.5, 0, 0)


def test_a_frame_without_a_view_box_changes_nothing():
    svg = Element("svg", {"width": "20", "height": "30"}, 1)

    assert read_frame(svg, svg, Viewport()) == Frame(20, 30)


@pytest.mark.parametrize("box", ["1 2 3", "0 0 0 5", "0 0 5 -5"])
def test_a_view_box_needs_four_numbers_and_a_size(box):
    svg = Element("svg", {"viewBox": box}, 1)

    with pytest.raises(ValueError, match="viewBox takes four numbers"):
        read_frame(svg, svg, Viewport())


def test_a_negative_size_is_told():
    svg = Element("svg", {"width": "-5", "height": "5"}, 1)

    with pytest.raises(ValueError, match="the width, -5, and the height, 5, must not be negative"):
        read_frame(svg, svg, Viewport())
