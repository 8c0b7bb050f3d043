"""The simple shapes of an SVG file as numbers, and the frames that drawings stand in."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.measures import Viewport, finite, length, numbers
from sketchkit.assets.svg.paths import Outline, read_path, read_points, rounded_rect
from sketchkit.core import constants as c
from sketchkit.core import matrix
from sketchkit.core.matrix import IDENTITY, Affine

Content: TypeAlias = tuple[int, tuple[float, ...] | Outline]  # kind; numbers or outline


class Frame(NamedTuple):
    """The size of a drawing in pixels, and the matrix that fits its own coordinates in."""

    width: float
    height: float
    matrix: Affine | None = None
    is_guessed: bool = False


def read_frame(element: Element, sized: Element, viewport: Viewport) -> Frame:
    """Return the frame of a drawing, whose size another element may give.

    Without a width or a height it has the size of its own coordinates, from the `viewBox`; where
    these begin does not count then.

    Raises
    ------
    ValueError
        If a number is wrong.
    """
    given = sized.get("width"), sized.get("height")
    box = numbers(element.get("viewBox") or "")
    if len(box) not in (0, 4) or (box and min(box[2:]) <= 0):
        raise ValueError("viewBox takes four numbers: left, top, width and height")
    if not given[0] or not given[1]:
        return Frame(box[2], box[3]) if box else Frame(1.0, 1.0, is_guessed=True)
    width, height = length(given[0], viewport.width), length(given[1], viewport.height)
    if width < 0 or height < 0:
        raise ValueError(f"the width, {width:g}, and the height, {height:g}, must not be negative")
    if not box:
        return Frame(width, height)
    scaled = matrix.scale(IDENTITY, finite(width / box[2]), finite(height / box[3]))
    return Frame(width, height, matrix.translate(scaled, -box[0], -box[1]))


def _rect(element: Element, viewport: Viewport) -> Content:
    left, top, width, height = rect = lengths(element, viewport, "x", "y", "width", "height")
    if width <= 0 or height <= 0:
        return c.GROUP, ()
    rx, ry = _radius(element, "rx", viewport), _radius(element, "ry", viewport)
    rx, ry = min(ry if rx < 0 else rx, width / 2), min(rx if ry < 0 else ry, height / 2)
    if rx <= 0 or ry <= 0:
        return c.RECT, rect
    if rx == ry:
        return c.RECT, (left, top, width, height, rx)
    return c.PATH, rounded_rect(rect, rx, ry)


def _radius(element: Element, name: str, viewport: Viewport) -> float:
    """Return the radius of a rectangle's corners; below 0, if it is to be the other one."""
    text = element.get(name)
    return -1.0 if text in (None, "", "auto") else length(text, viewport.whole(name))


def _image(element: Element, viewport: Viewport) -> Content:
    """Return the place of a picture: Processing's P2D fills it with the fill."""
    return c.RECT, lengths(element, viewport, "x", "y", "width", "height")


def _circle(element: Element, viewport: Viewport) -> Content:
    x, y, radius = lengths(element, viewport, "cx", "cy", "r")
    return c.ELLIPSE, (x - radius, y - radius, radius * 2, radius * 2)


def _ellipse(element: Element, viewport: Viewport) -> Content:
    x, y, rx, ry = lengths(element, viewport, "cx", "cy", "rx", "ry")
    return c.ELLIPSE, (x - rx, y - ry, rx * 2, ry * 2)


def _line(element: Element, viewport: Viewport) -> Content:
    return c.LINE, lengths(element, viewport, "x1", "y1", "x2", "y2")


def _polygon(element: Element, _viewport: Viewport) -> Content:
    return c.PATH, read_points(element.get("points") or "", is_closed=True)


def _polyline(element: Element, _viewport: Viewport) -> Content:
    return c.PATH, read_points(element.get("points") or "", is_closed=False)


def _path(element: Element, _viewport: Viewport) -> Content:
    return c.PATH, read_path(element.get("d") or "")


def lengths(element: Element, viewport: Viewport, *names: str) -> tuple[float, ...]:
    """Return attributes in pixels, 0 where there are none."""
    return tuple(length(element.get(name) or "0", viewport.whole(name)) for name in names)


SHAPES: dict[str, Callable[[Element, Viewport], Content]] = {
    "rect": _rect,
    "image": _image,
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "polygon": _polygon,
    "polyline": _polyline,
    "path": _path,
}
