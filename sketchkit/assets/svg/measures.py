"""The numbers of an SVG file: lengths with units, lists of numbers, transforms.

They are rounded to 32 bits, as Processing has them. Its transforms are not all the standard's:
what it draws wrongly is drawn so here too, and the file's author is told.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sketchkit.core import matrix
from sketchkit.core.float32 import f32
from sketchkit.core.matrix import IDENTITY, Affine

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
# Processing's: 90 to the inch. Today's standard has 96.
PIXELS = {"": 1.0, "px": 1.0, "pt": 1.25, "pc": 15.0, "mm": 3.543307, "cm": 35.43307, "in": 90.0}
PIXELS |= {"em": 16.0, "rem": 16.0, "ex": 8.0}  # of the usual font: icons are sized so
LARGEST = 1e30  # sums and small multiples of it still fit into 32 bits

# The attributes whose percentages are of the width, and of the height
ACROSS = {"x", "x1", "x2", "cx", "rx", "width"}
DOWN = {"y", "y1", "y2", "cy", "ry", "height"}

_LENGTH = re.compile(rf"({NUMBER})\s*([a-z]*|%)")
_NUMBERS = re.compile(NUMBER)
_TRANSFORM = re.compile(r"[\s,]*(\w+)\s*\(([^()]*)\)")

Remark = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Viewport:
    """The size of the drawing, which percentages refer to."""

    width: float = 100.0  # those of the drawing's own size: Processing takes 100% as 100 pixels
    height: float = 100.0

    @property
    def diagonal(self) -> float:
        """What percentages of a circle's radius or a weight refer to."""
        return f32(math.sqrt(f32((self.width**2 + self.height**2) / 2)))

    def whole(self, name: str) -> float:
        """Return what percentages of an attribute refer to."""
        if name in ACROSS:
            return self.width
        return self.height if name in DOWN else self.diagonal


def length(text: str, whole: float) -> float:
    """Return a length in pixels; percentages are of `whole`.

    Raises
    ------
    ValueError
        If it is no number, or its unit is unknown.
    """
    found = _LENGTH.fullmatch(text.strip())
    unit = found[2] if found else None
    if found and unit == "%":
        return finite(f32(whole * f32(float(found[1]) / 100)))
    if not found or unit not in PIXELS:
        raise ValueError(f"{text!r} is no length: 10, 10px, 10mm or 10% is one")
    return finite(f32(f32(float(found[1])) * f32(PIXELS[unit])))


def numbers(text: str) -> list[float]:
    """Return the numbers in a list of them; between them are commas or blanks.

    Raises
    ------
    ValueError
        If there is something else in it.
    """
    if rest := _NUMBERS.sub(" ", text).replace(",", " ").strip():
        raise ValueError(f"{rest.split()[0]!r} is among the numbers {shortened(text)!r}")
    return [finite(f32(float(found))) for found in _NUMBERS.findall(text)]


def finite(value: float) -> float:
    """Return a number.

    Raises
    ------
    ValueError
        If 32 bits might not hold what is computed from it.
    """
    if not abs(value) <= LARGEST:
        raise ValueError(f"a number is too large: {LARGEST:g} is the most")
    return value


def shortened(text: str) -> str:
    """Return a text as a message shows it."""
    text = " ".join(text.split())
    return text if len(text) <= 40 else f"{text[:37]}..."


def transform(text: str, remark: Remark) -> Affine:
    """Return the transform that an attribute describes.

    Parameters
    ----------
    text : str
        `translate(10, 20) scale(2)`: the last one reaches the shape first.
    remark : function
        Is told, in a sentence, what Processing reads otherwise than other programs.

    Raises
    ------
    ValueError
        If it is none.
    """
    whole, end = IDENTITY, 0
    for found in _transforms(text):
        name, arguments = found[1], numbers(found[2])
        if len(arguments) not in COUNTS.get(name, ()):
            raise ValueError(f"{shortened(found[0].strip(' ,'))!r} is no transform")
        if turned := _REMARKS.get((name, len(arguments))):
            remark(f"{shortened(found[0].strip(' ,'))} {turned}, as in Processing.")
        whole = matrix.multiply(whole, _SINGLE[name](*arguments))
        end = found.end()
    if text[end:].strip(" \t\r\n,"):
        raise ValueError(f"{shortened(text[end:].strip())!r} is no transform")
    return tuple(map(finite, whole))


def _transforms(text: str) -> Iterator[re.Match[str]]:
    """Yield what looks like transforms, one right after the other."""
    end = 0
    while found := _TRANSFORM.match(text, end):
        yield found
        end = found.end()


def _matrix(a: float, b: float, c: float, d: float, e: float, f: float) -> Affine:
    return (a, c, 0.0, e, b, d, 0.0, f, 0.0, 0.0, 1.0, 0.0)


def _translate(x: float, y: float | None = None) -> Affine:
    return matrix.translate(IDENTITY, x, x if y is None else y)


def _scale(x: float, y: float | None = None) -> Affine:
    return matrix.scale(IDENTITY, x, x if y is None else y)


def _rotate(angle: float, *centre: float) -> Affine:
    """Turn as Processing does: by radians, and around a centre with x and y exchanged."""
    if not centre:
        return matrix.rotate_z(IDENTITY, angle)
    x, y = centre
    return matrix.translate(matrix.rotate_z(_matrix(0, 1, 1, 0, x, y), angle), -x, -y)


def _skew_x(angle: float) -> Affine:
    """Lean over by degrees; in Processing the shape is flattened until it cannot be seen."""
    return matrix.shear_x(IDENTITY, math.radians(angle))


def _skew_y(angle: float) -> Affine:
    return matrix.shear_y(IDENTITY, math.radians(angle))


_SINGLE: dict[str, Callable[..., Affine]] = {
    "matrix": _matrix,
    "translate": _translate,
    "scale": _scale,
    "rotate": _rotate,
    "skewX": _skew_x,
    "skewY": _skew_y,
}
COUNTS = {
    "matrix": (6,),
    "translate": (1, 2),
    "scale": (1, 2),
    "rotate": (1, 3),
    "skewX": (1,),
    "skewY": (1,),
}
_REMARKS = {
    ("translate", 1): "moves down as far as to the right",
    ("rotate", 1): "turns by radians",
    ("rotate", 3): "turns by radians, with x and y exchanged",
}
