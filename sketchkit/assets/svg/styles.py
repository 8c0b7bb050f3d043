"""The colours and strokes of an SVG file, handed down from group to child as Processing does.

What Processing draws is drawn the same, even where the standard has it otherwise: opacities
replace each other instead of multiplying, and a stroke takes its alpha from the fill. In one thing
it is corrected: after `fill:none` Processing makes the colours that follow transparent, so that
they are not seen at all; here they are.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from sketchkit.assets.svg.colors import opacity_byte, read_color
from sketchkit.assets.svg.css import Declarations, Rule, read_declarations
from sketchkit.assets.svg.elements import Element
from sketchkit.assets.svg.gradients import Gradient
from sketchkit.assets.svg.measures import Remark, Viewport, length
from sketchkit.core import constants as c

BLACK = 0xFF000000
UNSEEN = 0x00000000  # what Processing's P2D and P3D fill with instead of a gradient
CAPS = {"butt": c.SQUARE, "round": c.ROUND, "square": c.PROJECT}
JOINS = {"miter": c.MITER, "round": c.ROUND, "bevel": c.BEVEL}
# In the order in which Processing reads attributes
PROPERTIES = (
    "opacity",
    "stroke",
    "stroke-opacity",
    "stroke-width",
    "stroke-linejoin",
    "stroke-linecap",
    "fill",
    "fill-opacity",
)


@dataclass(frozen=True, slots=True)
class SvgStyle:
    """How a shape looks: packed colours, or None for no fill or stroke."""

    fill: int | None = BLACK
    stroke: int | None = None
    stroke_weight: float = 1.0
    stroke_cap: int = c.SQUARE
    stroke_join: int = c.MITER
    fill_gradient: Gradient | None = None
    stroke_gradient: Gradient | None = None
    alpha: int = 255  # of the fill, also while there is none: the colours that follow get it


INITIAL = SvgStyle()


@dataclass(slots=True)
class StyleReader:
    """Reads the styles of one file."""

    rules: list[Rule]
    remark: Remark
    viewport: Viewport
    gradients: dict[str, Gradient]  # those that came so far

    def read(self, style: SvgStyle, element: Element) -> SvgStyle:
        """Return the style of an element within something of the style given.

        Raises
        ------
        ValueError
            If one of its values is none.
        """
        own = read_declarations(element.attributes.get("style", ""))
        for name, value in (*_attributes(element), *self._ruled(element), *own):
            if name in PROPERTIES and value.strip() != "inherit":
                style = self._with(style, name, value)
        return style

    def _ruled(self, element: Element) -> Declarations:
        """Return what the style sheet says; a sheet's order is no one's intention."""
        values = dict(
            pair for rule in self.rules if rule.fits(element) for pair in rule.declarations
        )
        return [(name, values[name].strip()) for name in PROPERTIES if name in values]

    def _with(self, style: SvgStyle, name: str, value: str) -> SvgStyle:
        match name:
            case "opacity" | "fill-opacity" | "stroke-opacity":
                return _with_alpha(style, name, opacity_byte(value))
            case "stroke-width":
                return replace(style, stroke_weight=length(value, self.viewport.diagonal))
            # A blank before these two, and Processing passes over them.
            case "stroke-linejoin":
                return replace(style, stroke_join=JOINS.get(value, style.stroke_join))
            case "stroke-linecap":
                return replace(style, stroke_cap=CAPS.get(value, style.stroke_cap))
            case _:
                return self._with_paint(style, is_fill=name == "fill", text=value.strip())

    def _with_paint(self, style: SvgStyle, *, is_fill: bool, text: str) -> SvgStyle:
        gradient, color = None, None
        if text.startswith("url(#"):
            gradient, color = self.gradients.get(text[5:-1]), UNSEEN
            if gradient is None:
                self.remark(f"{text} is no gradient that stands before it, and is not drawn.")
        elif text != "none":
            color = style.alpha << 24 | read_color(text, self.remark)
        if is_fill:
            return replace(style, fill=color, fill_gradient=gradient)
        return replace(style, stroke=color, stroke_gradient=gradient)


def _attributes(element: Element) -> Iterable[tuple[str, str]]:
    return ((name, element.attributes[name]) for name in PROPERTIES if name in element.attributes)


def _with_alpha(style: SvgStyle, name: str, alpha: int) -> SvgStyle:
    if name != "stroke-opacity":
        style = replace(style, fill=_faded(style.fill, alpha), alpha=alpha)
    if name != "fill-opacity":
        style = replace(style, stroke=_faded(style.stroke, alpha))
    return style


def _faded(color: int | None, alpha: int) -> int | None:
    return None if color is None else alpha << 24 | color & 0xFFFFFF
