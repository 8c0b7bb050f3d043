import pytest

from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.gradients import read_gradient
from sketchkit.assets.svg.measures import Viewport


def gradient(tag, attributes, *stops):
    children = [Element("stop", stop, 1) for stop in stops]
    return read_gradient(Element(tag, attributes, 1, children=children), Viewport(30, 40), str)


def test_a_linear_gradient_goes_from_point_to_point():
    found = gradient("linearGradient", {"x1": "50%", "y1": "2", "x2": "3", "y2": "25%"})

    assert (found.is_radial, found.geometry) == (False, (15, 2, 3, 10))


def test_a_radial_gradient_has_a_centre_and_a_radius():
    found = gradient("radialGradient", {"cx": "1", "cy": "2", "r": "3"})

    assert (found.is_radial, found.geometry) == (True, (1, 2, 3))


@pytest.mark.parametrize(
    ("tag", "geometry"), [("linearGradient", (12, 23, 12, 23)), ("radialGradient", (10, 20, 10))]
)
def test_a_gradient_is_transformed(tag, geometry):
    attributes = {"x1": "1", "y1": "1", "x2": "1", "y2": "1", "r": "5"}
    attributes["gradientTransform"] = "translate(10 20) scale(2 3)"

    assert gradient(tag, attributes).geometry == geometry


def test_stops_are_attributes_or_styles():
    found = gradient(
        "linearGradient",
        {},
        {"offset": "25%", "stop-color": "red", "stop-opacity": "0.5"},
        {"offset": "1", "style": "stop-color: #00f; stop-opacity:1"},
        {},
    )

    assert found.stops == ((0.25, 0x7FFF0000), (1, 0xFF0000FF), (0, 0xFF000000))
