"""The gradients of an SVG file, as Processing reads them: in the drawing's own coordinates.

Where they are used, Processing's P2D and P3D do not draw them; its JAVA2D does.
"""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.assets.svg.colors import opacity_byte, read_color
from sketchkit.assets.svg.css import read_declarations
from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.measures import Remark, Viewport, length, transform
from sketchkit.core.matrix import transform_point


@dataclass(frozen=True, slots=True)
class Gradient:
    """Colours along a line, or from a centre outwards.

    `geometry` is x1, y1, x2, y2 or, of a radial one, cx, cy, r; `stops` are places from 0 to 1
    with their packed colours.
    """

    is_radial: bool
    geometry: tuple[float, ...]
    stops: tuple[tuple[float, int], ...]


def read_gradient(element: Element, viewport: Viewport, remark: Remark) -> Gradient:
    """Return the gradient of a <linearGradient> or <radialGradient>.

    Raises
    ------
    ValueError
        If a number or a colour in it is none.
    """
    is_radial = element.tag == "radialGradient"
    names = ("cx", "cy", "r") if is_radial else ("x1", "y1", "x2", "y2")
    a, b, *rest = (length(element.get(name) or "0", viewport.whole(name)) for name in names)
    if description := element.get("gradientTransform"):
        moved = transform(description, remark)
        end = (a + rest[0], b) if is_radial else (rest[0], rest[1])
        a, b, _ = transform_point(moved, a, b, 0.0)
        x, y, _ = transform_point(moved, *end, 0.0)
        rest = [x - a] if is_radial else [x, y]
    stops = tuple(_stop(child, remark) for child in element.children if child.tag == "stop")
    return Gradient(is_radial, (a, b, *rest), stops)


def _stop(element: Element, remark: Remark) -> tuple[float, int]:
    """Return the place of a stop, and its colour."""
    values = element.attributes | dict(read_declarations(element.attributes.get("style", "")))
    alpha = opacity_byte(values.get("stop-opacity", "1"))
    color = read_color(values.get("stop-color", "#000"), remark)
    return length(values.get("offset", "0"), 1.0), alpha << 24 | color
