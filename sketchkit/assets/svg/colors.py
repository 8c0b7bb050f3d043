"""The colours of an SVG file, with Processing's arithmetic."""

from __future__ import annotations

import re

from sketchkit.assets.svg.measures import NUMBER, Remark, finite
from sketchkit.core.color import web_colors
from sketchkit.core.float32 import f32

_HEX = re.compile(r"#([0-9a-f]{3}|[0-9a-f]{6})")
_RGB = re.compile(r"rgba?\(([^()]*)\)")
_AMOUNT = re.compile(rf"({NUMBER})(%?)")


def read_color(text: str, remark: Remark) -> int:
    """Return red, green and blue of a colour, packed without alpha; black for an unknown name.

    Raises
    ------
    ValueError
        If its digits cannot be read.
    """
    text = text.strip().lower()
    if text in web_colors():
        return web_colors()[text] & 0xFFFFFF
    if found := _HEX.fullmatch(text):
        digits = found[1]
        return int(digits if len(digits) == 6 else "".join(2 * digit for digit in digits), 16)
    if found := _RGB.fullmatch(text):
        return _components(text, found[1])
    if text.startswith(("#", "rgb")):
        raise ValueError(f"{text!r} is no colour: #c60, #cc6600 or rgb(204, 102, 0) is one")
    remark(f"The colour {text!r} is not known, and black.")
    return 0


def opacity_byte(text: str) -> int:
    """Return an opacity as an alpha from 0 to 255, cut off as Processing does.

    Raises
    ------
    ValueError
        If it is no number.
    """
    found = _AMOUNT.fullmatch(text.strip())
    if not found:
        raise ValueError(f"{text.strip()!r} is no opacity: 0.5 is one")
    share = float(found[1]) / (100 if found[2] else 1)
    return int(min(max(f32(f32(finite(share)) * 255.0), 0.0), 255.0))


def _components(text: str, inside: str) -> int:
    """Return a colour of three numbers or percentages; percentages are cut off, not rounded."""
    parts = [_AMOUNT.fullmatch(part) for part in inside.replace(",", " ").replace("/", " ").split()]
    if len(parts) not in (3, 4) or not all(parts):
        raise ValueError(f"{text!r} is no colour: rgb(204, 102, 0) is one")
    packed = 0
    for part in filter(None, parts[:3]):
        value = 255 * f32(float(part[1]) / 100) if part[2] else float(part[1])
        packed = packed << 8 | int(min(max(f32(value), 0.0), 255.0))
    return packed
