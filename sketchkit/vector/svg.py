"""A page as an SVG file."""

from __future__ import annotations

import base64
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from itertools import groupby

import numpy as np

from sketchkit.assets.output import picture_bytes
from sketchkit.core import constants as c
from sketchkit.draw.pipeline import Blend, Clip
from sketchkit.vector.page import (
    IDENTITY,
    Ellipse,
    Ink,
    Item,
    Mark,
    Matrix,
    Outline,
    Page,
    Path,
    Picture,
    Rect,
    path_of,
    scaled,
)

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
CAPS = {c.SQUARE: "butt", c.ROUND: "round", c.PROJECT: "square"}
JOINS = {c.MITER: "miter", c.ROUND: "round", c.BEVEL: "bevel"}
MITER_LIMIT = "10"  # as on the canvas
BLENDS = {
    Blend.ADD: "plus-lighter",
    Blend.LIGHTEST: "lighten",
    Blend.DARKEST: "darken",
    Blend.EXCLUSION: "exclusion",
    Blend.MULTIPLY: "multiply",
    Blend.SCREEN: "screen",
}
POINTS = {"M": 1, "L": 1, "C": 3, "Z": 0}  # that a letter of a path takes


def svg_bytes(page: Page) -> bytes:
    """Return the file; the same page gives the same bytes."""
    ET.register_namespace("", SVG)
    ET.register_namespace("xlink", XLINK)
    size = {"width": str(page.width), "height": str(page.height)}
    root = ET.Element(f"{{{SVG}}}svg", size | {"viewBox": f"0 0 {page.width} {page.height}"})
    _Writer(root).write(page, root)
    ET.indent(root)
    data: bytes = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    return data + b"\n"


class _Writer:
    """Writes items into a tree, and clips in front of it, each once."""

    def __init__(self, root: ET.Element) -> None:
        self._root = root
        self._clips: dict[object, str] = {}

    def write(self, page: Page, parent: ET.Element) -> None:
        for clip, items in groupby(page.items, key=lambda item: item.setting.clip):
            # A clip lies on the page, so it is not an attribute of what has a matrix of its own.
            group = parent if clip is None else self._clipped(parent, clip, path_of(Rect(*clip)))
            for item in items:
                element = self._element(item, group)
                if blend := BLENDS.get(item.setting.blend):
                    element.set("style", f"mix-blend-mode:{blend}")

    def _element(self, item: Item, parent: ET.Element) -> ET.Element:
        match item:
            case Mark():
                tag, numbers = _shape(item.outline)
                attributes = numbers | _paint(item.ink) | _transform(item.matrix)
                return _add(parent, tag, attributes)
            case Picture():
                return self._picture(item, parent)

    def _picture(self, picture: Picture, parent: ET.Element) -> ET.Element:
        image, within = picture.image, picture.within
        if within is not None:
            parent = self._clipped(parent, picture, within)
        if isinstance(image, Page):
            matrix = scaled(picture.matrix, image.width, image.height)
            opacity = {} if picture.opacity == 1 else {"opacity": number(picture.opacity)}
            group = _add(parent, "g", _transform(matrix) | opacity)
            whole = Clip(0, 0, image.width, image.height)
            self.write(image, self._clipped(group, whole, path_of(Rect(*whole))))
            return group
        height, width, _ = image.shape
        png = base64.b64encode(picture_bytes(image, ".png")).decode("ascii")
        return _add(
            parent,
            "image",
            {"width": str(width), "height": str(height), "preserveAspectRatio": "none"}
            | _transform(scaled(picture.matrix, width, height))
            | {f"{{{XLINK}}}href": f"data:image/png;base64,{png}"},
        )

    def _clipped(self, parent: ET.Element, key: object, path: Path) -> ET.Element:
        """Return a group that is cut to a path."""
        name = self._clips.get(key)
        if name is None:
            name = self._clips[key] = f"clip{len(self._clips) + 1}"
            definition = _add(self._root, "clipPath", {"id": name})
            _add(definition, "path", {"d": path_data(path)})
        return _add(parent, "g", {"clip-path": f"url(#{name})"})


def _add(parent: ET.Element, tag: str, attributes: dict[str, str]) -> ET.Element:
    return ET.SubElement(parent, f"{{{SVG}}}{tag}", attributes)


def _shape(outline: Outline) -> tuple[str, dict[str, str]]:
    """Return which element an outline is, and its numbers."""
    match outline:
        case Rect(x, y, width, height):
            return "rect", _numbers(x=x, y=y, width=width, height=height)
        case Ellipse(x, y, rx, ry):
            return "ellipse", _numbers(cx=x, cy=y, rx=rx, ry=ry)
        case Path("ML", points):
            (x1, y1), (x2, y2) = points.tolist()
            return "line", _numbers(x1=x1, y1=y1, x2=x2, y2=y2)
        case _:
            return "path", {"d": path_data(outline)}


def path_data(path: Path) -> str:
    """Return a path as the letters and numbers of SVG."""
    return " ".join(_segments(path))


def _segments(path: Path) -> Iterator[str]:
    numbers = iter(path.points.ravel().tolist())
    for letter in path.letters:
        yield letter + " ".join(number(next(numbers)) for _ in range(2 * POINTS[letter]))


def _paint(ink: Ink) -> dict[str, str]:
    attributes = _color("fill", ink.fill)
    if ink.stroke < 0:
        return attributes
    join = JOINS[ink.join]
    attributes |= _color("stroke", ink.stroke) | {
        "stroke-width": number(ink.weight),
        "stroke-linecap": CAPS[ink.cap],
        "stroke-linejoin": join,
    }
    if ink.join == c.MITER:
        attributes["stroke-miterlimit"] = MITER_LIMIT
    return attributes


def _color(name: str, color: int) -> dict[str, str]:
    if color < 0:
        return {name: "none"}
    attributes = {name: f"#{color & 0xFFFFFF:06x}"}
    alpha = color >> 24
    if alpha < 255:
        attributes[f"{name}-opacity"] = number(alpha / 255)
    return attributes


def _transform(matrix: Matrix) -> dict[str, str]:
    if matrix == IDENTITY:
        return {}
    return {"transform": f"matrix({' '.join(map(number, matrix))})"}


def _numbers(**values: float) -> dict[str, str]:
    return {name: number(value) for name, value in values.items()}


def number(value: float) -> str:
    """Return a number as a file has it: the shortest that is the same in 32 bits.

    Examples
    --------
    >>> number(12.0), number(0.1), number(-0.0)
    ('12', '0.1', '0')
    """
    return np.format_float_positional(np.float32(value) + np.float32(0), trim="-")
