"""The expected colours are Processing's getFill() and getStroke(), but where it draws nothing."""

import pytest

from sketchkit.assets.svg.css import read_rules
from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.gradients import Gradient
from sketchkit.assets.svg.measures import Viewport
from sketchkit.assets.svg.styles import INITIAL, StyleReader
from sketchkit.core import constants as c

DAWN = Gradient(False, (0, 0, 1, 0), ())


def styled(*levels, sheet="", remarks=None):
    """Return the style of the innermost of elements that are given by their attributes."""
    remark = (remarks if remarks is not None else []).append
    top = Element("svg", {}, 1, children=[Element("style", {}, 1, sheet)])
    reader = StyleReader(read_rules(top), remark, Viewport(30, 40), {"dawn": DAWN})
    style = INITIAL
    for attributes in levels:
        style = reader.read(style, Element("path", attributes, 1))
    return style


def test_by_default_shapes_are_black_without_a_stroke():
    assert (INITIAL.fill, INITIAL.stroke, INITIAL.stroke_weight) == (0xFF000000, None, 1)
    assert (INITIAL.stroke_cap, INITIAL.stroke_join) == (c.SQUARE, c.MITER)


@pytest.mark.parametrize(
    ("attributes", "fill", "stroke"),
    [
        ({"style": "stroke:#00f;fill:none"}, None, 0xFF0000FF),
        ({"style": "fill:none;stroke:#0f0;stroke-opacity:0.5"}, None, 0x7F00FF00),
        ({"fill": "none", "stroke": "#f00"}, None, 0xFFFF0000),
        ({"fill-opacity": "0.3", "fill": "#f0f", "stroke": "blue"}, 0x4CFF00FF, 0xFF0000FF),
        ({"style": "fill-opacity:0.5;stroke:red"}, 0x7F000000, 0x7FFF0000),
        ({"opacity": "0.5", "stroke": "red"}, 0x7F000000, 0x7FFF0000),
        ({"opacity": "50%"}, 0x7F000000, None),
        ({"fill": "rgb(300, 20%, -5)"}, 0xFFFF3300, None),
        ({"fill": "inherit"}, 0xFF000000, None),
    ],
)
def test_colours_and_opacities(attributes, fill, stroke):
    style = styled(attributes)

    assert (style.fill, style.stroke) == (fill, stroke)


def test_opacities_replace_each_other():
    style = styled({"opacity": "0.5"}, {"opacity": "0.5"}, {"fill": "#fff", "fill-opacity": "1"})

    assert style.fill == 0xFFFFFFFF


@pytest.mark.parametrize("nothing", ["none", "url(#dawn)"])
def test_colours_after_no_colour_are_seen(nothing):
    style = styled({"opacity": "0.5"}, {"style": f"fill:{nothing};stroke:#000"}, {"fill": "red"})

    assert (style.fill, style.stroke) == (0x7FFF0000, 0x7F000000)


def test_a_gradient_is_kept_and_in_processing_not_seen():
    style = styled({"fill": "url(#dawn)", "stroke": "url(#dawn)"})

    assert (style.fill_gradient, style.stroke_gradient) == (DAWN, DAWN)
    assert (style.fill, style.stroke) == (0, 0)


def test_with_an_opacity_after_it_a_gradient_is_black():
    assert styled({"style": "fill:url(#dawn);fill-opacity:1"}).fill == 0xFF000000


def test_strokes():
    style = styled({"stroke-width": "2pt", "stroke-linecap": "round", "stroke-linejoin": "bevel"})

    assert (style.stroke_weight, style.stroke_cap, style.stroke_join) == (2.5, c.ROUND, c.BEVEL)
    assert styled({"stroke-linecap": "square"}).stroke_cap == c.PROJECT
    assert styled({"stroke-width": "10%"}).stroke_weight == pytest.approx(3.535534)


def test_a_cap_after_a_blank_is_passed_over_as_in_processing():
    style = styled({"style": "stroke-linecap: round; stroke-width: 3"})

    assert (style.stroke_cap, style.stroke_weight) == (c.SQUARE, 3)


def test_a_style_sheet_stands_between_attributes_and_style():
    sheet = "path{fill:red;stroke:red;stroke-linecap: round}"
    style = styled({"fill": "blue", "stroke": "blue", "style": "stroke:lime"}, sheet=sheet)

    assert (style.fill, style.stroke, style.stroke_cap) == (0xFFFF0000, 0xFF00FF00, c.ROUND)


def test_of_two_rules_the_more_precise_one_holds():
    sheet = "#me{fill:#111} .a.b{fill:#222} .a{fill:#333} path{fill:#444} *{fill:#555}"
    levels = [{}, {"class": "a"}, {"class": "b a"}, {"class": "a", "id": "me"}]

    fills = [styled(level, sheet=sheet).fill for level in levels]
    assert fills == [0xFF444444, 0xFF333333, 0xFF222222, 0xFF111111]


@pytest.mark.parametrize(
    ("attributes", "problem"),
    [
        ({"fill": "#12x"}, "'#12x' is no colour"),
        ({"fill": "rgb(1, 2)"}, r"'rgb\(1, 2\)' is no colour"),
        ({"opacity": "much"}, "'much' is no opacity: 0.5 is one"),
        ({"stroke-width": "bold"}, "'bold' is no length"),
    ],
)
def test_what_is_no_value_is_told(attributes, problem):
    with pytest.raises(ValueError, match=problem):
        styled(attributes)
