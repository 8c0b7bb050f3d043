"""SVG files to plain data: a tree of groups and shapes, as Processing's loadShape() reads them.

What Processing draws comes out the same. What it passes over (style sheets, <use>, colour names) is
read as the standard says; what neither draws is remarked upon.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from sketchkit.assets.svg.css import read_rules
from sketchkit.assets.svg.elements import MAX_DEPTH, Element, SvgError, read_elements
from sketchkit.assets.svg.gradients import read_gradient
from sketchkit.assets.svg.measures import Viewport, transform
from sketchkit.assets.svg.paths import Outline, rounded_rect
from sketchkit.assets.svg.shapes import SHAPES, lengths, read_frame
from sketchkit.assets.svg.styles import INITIAL, StyleReader, SvgStyle
from sketchkit.core import constants as c
from sketchkit.core import matrix
from sketchkit.core.errors import SketchError
from sketchkit.core.float32 import f32
from sketchkit.core.matrix import IDENTITY, Affine

MAX_COPIES = 100_000  # elements that <use> may add: a few lines could ask for billions

GROUPS = {"g", "defs", "a", "switch", "svg", "text"}
# Processing counts them among the children, and draws nothing.
EMPTY = {"linearGradient", "radialGradient", "font", "tspan"}
GRADIENTS = {"linearGradient", "radialGradient"}
SILENT = {"title", "desc", "metadata", "style", "script", "stop", "symbol"}

_ILLUSTRATOR = re.compile(r"_x([0-9A-Fa-f]{2})_")


@dataclass(frozen=True, slots=True)
class SvgNode:
    """A shape, or a group of them.

    `kind` is GROUP, RECT, ELLIPSE, LINE or PATH. `numbers` are left, top, width, height (of a RECT
    with round corners, their radius too), or the ends of a LINE; a PATH has an `outline` instead.
    `matrix` leads from here to the group around it. `style` is complete: what a group says is
    handed down already.
    """

    kind: int
    name: str | None = None
    matrix: Affine | None = None
    style: SvgStyle = INITIAL
    numbers: tuple[float, ...] = ()
    outline: Outline | None = None
    children: tuple[SvgNode, ...] = ()
    is_visible: bool = True


@dataclass(frozen=True, slots=True)
class Svg:
    """A drawing: its tree, its size in pixels, and sentences about what it loses."""

    root: SvgNode
    width: float
    height: float
    remarks: tuple[str, ...]


def load_svg(path: Path) -> Svg:
    """Return the drawing in an SVG file, which may be gzipped.

    Raises
    ------
    SketchError
        If it is none, or broken: with the line.
    """
    try:
        return _Reader(read_elements(path), path).svg()
    except SvgError as problem:
        where = f"{path}, line {problem.line}" if problem.line else f"{path}"
        raise SketchError(
            f"{where}: {problem}.", hint="Drawing programs write SVG files that can be read."
        ) from None


def outline_of(node: SvgNode) -> Outline | None:
    """Return the outline of a path, a rectangle or an ellipse, or None of what has no inside."""
    if node.kind not in (c.RECT, c.ELLIPSE):
        return node.outline
    left, top, width, height, *radius = node.numbers
    rx, ry = (width / 2, height / 2) if node.kind == c.ELLIPSE else (radius or [0.0]) * 2
    return rounded_rect((left, top, width, height), rx, ry)


class _Reader:
    """Makes nodes of the elements of one file."""

    def __init__(self, top: Element, path: Path) -> None:
        if top.tag != "svg":
            is_page = top.tag.lower() == "html"
            kind = "a web page" if is_page else f"a drawing that begins with <{top.tag}>"
            raise SvgError(f"it is {kind}, not an SVG file", top.line)
        self.top = top
        self.path = path
        self.line = top.line
        self.remarks: dict[str, None] = {}  # ordered, each once
        self.elements = {name: element for element in _all(top) if (name := element.get("id"))}
        self.used = {_target(element) for element in _all(top) if element.tag == "use"}
        self.copies_left = MAX_COPIES
        self.copying: list[Element] = []

    def svg(self) -> Svg:
        """Return the whole drawing."""
        with _within(self.top):
            frame = read_frame(self.top, self.top, Viewport())
        if frame.is_guessed:
            self._remark("The drawing has no width and height; 1 is taken for both.")
        self.viewport = Viewport(frame.width, frame.height)
        self.styles = StyleReader(read_rules(self.top), self._remark, self.viewport, {})
        root = self._group(self.top, INITIAL, frame.matrix, 0)
        return Svg(root, frame.width, frame.height, tuple(self.remarks))

    def _node(self, element: Element, style: SvgStyle, depth: int) -> SvgNode | None:
        """Return the node of an element, if it makes one."""
        self.line = element.line
        if depth > MAX_DEPTH:
            raise SvgError(f"more than {MAX_DEPTH} elements are nested", element.line)
        tag = element.tag
        if tag in SHAPES or tag in EMPTY:
            with _within(element):
                return self._shape(element, style)
        if tag == "use":
            return self._copy(element, style, depth)
        if tag in GROUPS:
            return self._inner_group(element, style, depth)
        if tag not in SILENT and ":" not in tag:
            self._remark(f"<{tag}> is not drawn.")
        return None

    def _inner_group(self, element: Element, style: SvgStyle, depth: int) -> SvgNode:
        if element.tag == "text":
            self._remark("<text> is not drawn; a drawing program can turn it into paths.")
        group = self._group(element, style, self._place(element), depth)
        if element.tag == "defs" and self.used & {child.get("id") for child in _all(element)}:
            return replace(group, is_visible=False)  # Processing draws it, but no <use> of it
        return group

    def _group(
        self, element: Element, style: SvgStyle, fitted: Affine | None, depth: int
    ) -> SvgNode:
        with _within(element):
            node = self._plain(element, style, fitted)
        nodes = [self._node(child, node.style, depth + 1) for child in element.children]
        return replace(node, children=tuple(node for node in nodes if node))

    def _plain(self, element: Element, style: SvgStyle, fitted: Affine | None = None) -> SvgNode:
        """Return an empty group with all that any element can have."""
        moved = element.get("transform")
        whole = transform(moved, self._remark) if moved else None
        if whole and fitted:
            whole = matrix.multiply(whole, fitted)
        return SvgNode(
            c.GROUP,
            _name(element),
            whole or fitted,
            self.styles.read(style, element),
            is_visible=element.get("display") != "none",
        )

    def _shape(self, element: Element, style: SvgStyle) -> SvgNode:
        node = self._plain(element, style)
        if element.tag in GRADIENTS and node.name:
            gradient = read_gradient(element, self.viewport, self._remark)
            self.styles.gradients[node.name] = gradient
        if element.tag in EMPTY:
            return node
        kind, content = SHAPES[element.tag](element, self.viewport)
        if isinstance(content, Outline):
            return replace(node, kind=kind, outline=content)
        return replace(node, kind=kind, numbers=tuple(map(f32, content)))

    def _copy(self, element: Element, style: SvgStyle, depth: int) -> SvgNode | None:
        """Return a group with a copy of what a <use> names; the copy has no names of its own."""
        target = self.elements.get(_target(element))
        if target is None:
            self._remark(f"<use> copies {_target(element)!r}, which is not there.")
            return None
        if target in self.copying:
            raise SvgError("<use> copies what it is part of", element.line)
        self.copies_left -= sum(1 for _ in _all(target))
        if self.copies_left < 0:
            raise SvgError(f"<use> makes more than {MAX_COPIES} copies", element.line)
        with _within(element):
            node = self._plain(element, style, self._place(element))
        self.copying.append(target)
        if target.tag == "symbol":
            placed = self._place(target, element)
            copied: SvgNode | None = self._group(target, node.style, placed, depth + 1)
        else:
            copied = self._node(target, node.style, depth + 1)
        self.copying.pop()
        return replace(node, children=(_nameless(copied),) if copied else ())

    def _place(self, element: Element, sized: Element | None = None) -> Affine | None:
        """Return where a drawing within the drawing, or a copy, is put.

        A symbol has the size that its copy is given: `sized`.
        """
        if element.tag not in ("svg", "symbol", "use"):
            return None
        with _within(element):
            placed = matrix.translate(IDENTITY, *lengths(element, self.viewport, "x", "y"))
            if element.tag == "use":
                return placed
            fitted = read_frame(element, sized or element, self.viewport).matrix
        return matrix.multiply(placed, fitted) if fitted else placed

    def _remark(self, sentence: str) -> None:
        self.remarks[f"{self.path.name}, line {self.line}: {sentence}"] = None


@contextmanager
def _within(element: Element) -> Iterator[None]:
    """Say of what goes wrong in which element, and in which line."""
    try:
        yield
    except SvgError:
        raise
    except ValueError as problem:
        raise SvgError(f"in <{element.tag}>, {problem}", element.line) from None


def _all(element: Element) -> Iterator[Element]:
    """Yield an element and all within."""
    yield element
    for child in element.children:
        yield from _all(child)


def _target(element: Element) -> str:
    """Return the name of what a <use> copies."""
    return (element.get("href") or element.get("xlink:href") or "").removeprefix("#")


def _name(element: Element) -> str | None:
    """Return an element's id; Illustrator writes what an id cannot hold as `_x20_`."""
    name = element.attributes.get("id")
    return name and _ILLUSTRATOR.sub(lambda found: chr(int(found[1], 16)), name)


def _nameless(node: SvgNode) -> SvgNode:
    return replace(node, name=None, children=tuple(map(_nameless, node.children)))
