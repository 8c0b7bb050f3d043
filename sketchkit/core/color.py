"""Colours: ints packed as 0xAARRGGBB, and how Processing makes and reads them.

A colour is an unsigned int, inside and in the sketch. Java's ints are signed, so colours computed
the Java way may be negative: they are understood wherever a colour is taken.

Processing computes colours in 32-bit floats and cuts off, so `f32` follows each of its steps.
"""

import math
import operator
import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, nearest, wrong_numbers
from sketchkit.core.float32 import ROUND, f32
from sketchkit.core.notices import warn_once

COMPONENTS = {c.RGB: "red, green, blue", c.HSB: "hue, saturation, brightness"}
USAGE = f"gray [, alpha] | {COMPONENTS[c.RGB]} [, alpha]"

_GRAY = {v: 0xFF000000 | v << 16 | v << 8 | v for v in range(256)}
_NUMBER = re.compile("(?P<prefix>0[xX]|#|)(?P<digits>[0-9a-fA-F]+)")
_HEX = re.compile("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})")


@dataclass(frozen=True, slots=True)
class ColorMode:
    """What the numbers of a colour mean: `colorMode()`.

    `model` is RGB or HSB; the maxima are those of red or hue, green or saturation, blue or
    brightness, and alpha.
    """

    model: int = c.RGB
    max1: float = 255.0
    max2: float = 255.0
    max3: float = 255.0
    max_alpha: float = 255.0
    is_plain: bool = field(init=False, repr=False, compare=False, default=True)

    def __post_init__(self) -> None:
        maxima = self.max1, self.max2, self.max3, self.max_alpha
        if not all(maximum > 0 for maximum in maxima):
            raise SketchError(
                "colorMode() takes ranges greater than 0.",
                got=", ".join(f"{maximum:g}" for maximum in maxima),
            )
        object.__setattr__(self, "is_plain", self.model == c.RGB and set(maxima) == {255})


def pack(mode: ColorMode, *args: Any, name: str = "color") -> int:  # noqa: ANN401 checked by use
    """Return the colour that the arguments of `color()`, `fill()` ... stand for.

    They are a gray, or three components in `mode`, and an alpha if need be; or a packed colour
    or a string, and an alpha if need be. One int is a gray as long as its highest byte is 0 and
    it is not above the first maximum: so Processing tells the two apart. Whole numbers in the
    usual mode take the short way.

    Parameters
    ----------
    mode : ColorMode
        What the numbers mean.
    *args : int, float or str
        As the sketch gave them.
    name : str
        The function that was called, for messages.

    Examples
    --------
    >>> hex(pack(ColorMode(), 204, 102, 0))
    '0xffcc6600'
    """
    try:
        if mode.is_plain:
            if len(args) == 3:
                r, g, b = args
                if r in _GRAY and g in _GRAY and b in _GRAY:
                    return _GRAY[r] & 0xFFFF0000 | _GRAY[g] & 0xFF00 | _GRAY[b] & 0xFF
            elif len(args) == 1 and args[0] in _GRAY:
                return _GRAY[args[0]]
        if len(args) > 2:
            return _pack_components(mode, *args)
        return _pack(mode, args, name)
    except (TypeError, ValueError):
        is_text = bool(args) and isinstance(args[0], str) and len(args) <= 2
        usage = "color [, alpha]" if is_text else in_model(mode.model, USAGE)
        raise wrong_numbers(name, args, usage) from None


def in_model(model: int, usage: str) -> str:
    """Return a usage with the components of RGB or HSB in place of those of RGB."""
    return usage.replace(COMPONENTS[c.RGB], COMPONENTS[model])


def to_packed(color: object, name: str = "color") -> int:
    """Return a colour that a sketch holds, signed or as a string, as an unsigned int."""
    if isinstance(color, str):
        return parse(color)
    try:
        packed = operator.index(color)  # type: ignore[arg-type]  # what has no index is told so
    except TypeError:
        raise wrong_numbers(name, (color,), "color") from None
    kept = packed & 0xFFFFFFFF
    if not -0x80000000 <= packed <= 0xFFFFFFFF:
        warn_once(
            "A colour has 32 bits, 0xAARRGGBB, and this number has more: as in Processing, "
            f"0x{kept:08X} is taken of it."
        )
    return kept


def unit_rgba(name: str, color: object) -> tuple[float, float, float, float]:
    """Return red, green, blue and alpha of a colour that a sketch holds, 0 to 1 each.

    Examples
    --------
    >>> unit_rgba("attribColor", "#FF0000")
    (1.0, 0.0, 0.0, 1.0)
    """
    packed = to_packed(color, name)
    red, green, blue, alpha = (packed >> shift & 255 for shift in (16, 8, 0, 24))
    return red / 255, green / 255, blue / 255, alpha / 255


def parse(text: str) -> int:
    """Return the colour that a string names: "#CC6600", "#80CC6600", "#C60" or "orange".

    Other numbers are read as Python Mode reads them: "0xCC6600" too is hexadecimal, "13395456" is
    decimal, and there are zeros in front of what is too short.

    Examples
    --------
    >>> hex(parse("#CC6600")), hex(parse("#80CC6600")), hex(parse("Orange"))
    ('0xffcc6600', '0x80cc6600', '0xffffa500')
    """
    if found := _HEX.fullmatch(text):
        digits = found[1]
        if len(digits) == 3:
            digits = "".join(2 * digit for digit in digits)
        return int(digits, 16) | (0 if len(digits) == 8 else 0xFF000000)
    names = web_colors()
    color = names.get(text.replace(" ", "").lower())
    if color is None:
        color = _as_number(text)
    if color is None:
        raise _unknown(text, names)
    return color


def red(mode: ColorMode, color: int) -> float:
    """Return the red part, on the mode's first scale."""
    return _part(color >> 16 & 255, mode.max1)


def green(mode: ColorMode, color: int) -> float:
    """Return the green part, on the mode's second scale."""
    return _part(color >> 8 & 255, mode.max2)


def blue(mode: ColorMode, color: int) -> float:
    """Return the blue part, on the mode's third scale."""
    return _part(color & 255, mode.max3)


def alpha(mode: ColorMode, color: int) -> float:
    """Return the alpha, on the mode's fourth scale."""
    return _part(color >> 24 & 255, mode.max_alpha)


def hue(mode: ColorMode, color: int) -> float:
    """Return the hue, on the mode's first scale; 0 for a gray."""
    return f32(rgb_to_hsb(color)[0] * mode.max1)


def saturation(mode: ColorMode, color: int) -> float:
    """Return the saturation, on the mode's second scale."""
    return f32(rgb_to_hsb(color)[1] * mode.max2)


def brightness(mode: ColorMode, color: int) -> float:
    """Return the brightness, on the mode's third scale."""
    return f32(rgb_to_hsb(color)[2] * mode.max3)


def lerp_color(start: int, stop: int, amount: float, model: int = c.RGB) -> int:
    """Return the colour `amount` of the way from `start` to `stop`; 0 and 1 are its limits.

    Each part is rounded. In HSB the hue goes the direct way, not around the circle.
    """
    t = f32(min(max(amount, 0.0), 1.0))
    if model == c.HSB:
        h, s, b = (_lerp(u, v, t) for u, v in zip(rgb_to_hsb(start), rgb_to_hsb(stop), strict=True))
        rgb = (int(f32(f32(part * 255.0) + 0.5)) for part in hsb_to_rgb(h, s, b))
    else:
        rgb = (_lerp_byte(start, stop, shift, t) for shift in (16, 8, 0))
    r, g, b = rgb
    return _lerp_byte(start, stop, 24, t) << 24 | r << 16 | g << 8 | b


def rgb_to_hsb(color: int) -> tuple[float, float, float]:
    """Return hue, saturation and brightness of a packed colour, each from 0 to 1."""
    r, g, b = color >> 16 & 255, color >> 8 & 255, color & 255
    high, low = max(r, g, b), min(r, g, b)
    if high == low:
        return 0.0, 0.0, f32(high / 255.0)
    to_r, to_g, to_b = (f32((high - part) / (high - low)) for part in (r, g, b))
    if r == high:
        sixth = f32(to_b - to_g)
    elif g == high:
        sixth = f32(f32(2.0 + to_r) - to_b)
    else:
        sixth = f32(f32(4.0 + to_g) - to_r)
    turn = f32(sixth / 6.0)
    return turn if turn >= 0 else f32(turn + 1.0), f32((high - low) / high), f32(high / 255.0)


def hsb_to_rgb(h: float, s: float, b: float) -> tuple[float, float, float]:
    """Return red, green and blue from 0 to 1, of a hue, saturation and brightness from 0 to 1."""
    if s == 0:
        return b, b, b
    sixths = f32(f32(h - math.floor(h)) * 6.0)
    sector = int(sixths)
    f = f32(sixths - sector)
    p = f32(b * f32(1.0 - s))
    q = f32(b * f32(1.0 - f32(s * f)))
    t = f32(b * f32(1.0 - f32(s * f32(1.0 - f))))
    return ((b, t, p), (q, b, p), (p, b, t), (p, q, b), (t, p, b), (b, p, q))[sector]


@cache
def web_colors() -> dict[str, int]:
    """Return the colour names of the web (CSS), in small letters, with their packed colours."""
    words = _WEB_COLORS.split()
    return {
        name: int(digits, 16) | 0xFF000000
        for name, digits in zip(words[::2], words[1::2], strict=True)
    }


def _pack(mode: ColorMode, args: tuple[Any, ...], name: str) -> int:  # Any: checked by use
    first, *alpha = args
    if isinstance(first, str):
        return _with_alpha(mode, parse(first), *alpha)
    if not isinstance(first, float) and hasattr(first, "__index__"):
        packed = to_packed(first, name)
        if packed & 0xFF000000 or packed > mode.max1:
            return _with_alpha(mode, packed, *alpha)
    gray = _plain_byte(first) if mode.is_plain else int(f32(_unit(first, mode.max1) * 255.0))
    return _alpha_byte(mode, *alpha) << 24 | gray << 16 | gray << 8 | gray


def _pack_components(
    mode: ColorMode, v1: float, v2: float, v3: float, alpha: float | None = None
) -> int:
    if mode.is_plain:
        r, g, b = _plain_byte(v1), _plain_byte(v2), _plain_byte(v3)
    else:
        parts = _unit(v1, mode.max1), _unit(v2, mode.max2), _unit(v3, mode.max3)
        if mode.model == c.HSB:
            parts = hsb_to_rgb(*parts)
        r, g, b = (int(f32(part * 255.0)) for part in parts)
    return _alpha_byte(mode, alpha) << 24 | r << 16 | g << 8 | b


def _with_alpha(mode: ColorMode, color: int, alpha: float | None = None) -> int:
    """Return `color` made more transparent, as a packed colour with an alpha is."""
    if alpha is None or alpha == mode.max_alpha:
        return color
    return int(f32((color >> 24) * _unit(alpha, mode.max_alpha))) << 24 | color & 0xFFFFFF


def _alpha_byte(mode: ColorMode, alpha: float | None = None) -> int:
    if alpha is None:
        return 255
    if mode.max_alpha == 255:
        return _plain_byte(alpha)
    return int(f32(_unit(alpha, mode.max_alpha) * 255.0))


def _plain_byte(value: float) -> int:
    """Return a part on a scale of 255 as a byte, cut off; NaN gives 0.

    `f32(f32(value / 255) * 255)`, as Processing has it, is the same for every 32-bit float.
    """
    if value >= 255:
        return 255
    t = value * ROUND
    return int(t - (t - value)) if value > 0 else 0


def _unit(value: float, maximum: float) -> float:
    """Return `value` as a part of `maximum`, from 0 to 1, in 32-bit floats; NaN gives 0."""
    if value >= maximum:
        return 1.0
    return f32(f32(value) / f32(maximum)) if value > 0 else 0.0


def _part(byte: int, maximum: float) -> float:
    return float(byte) if maximum == 255 else f32(f32(byte / 255.0) * f32(maximum))


def _lerp(start: float, stop: float, t: float) -> float:
    return f32(start + f32(f32(stop - start) * t))


def _lerp_byte(start: int, stop: int, shift: int, t: float) -> int:
    return math.floor(_lerp(start >> shift & 255, stop >> shift & 255, t) + 0.5)


def _as_number(text: str) -> int | None:
    """Return the colour that a string is as one of Java's numbers, or None if it is none."""
    if not (found := _NUMBER.fullmatch(text)):
        return None
    digits = found["digits"]
    base = 16 if found["prefix"] else 8 if digits.startswith("0") and len(digits) > 1 else 10
    try:
        color = int(digits, base)
    except ValueError:
        return None
    if color > 0xFFFFFFFF:
        return None
    packed = color | (0 if len(digits) == 8 and base == 16 else 0xFF000000)
    if not (found["prefix"] and len(digits) in (6, 8)):
        meant = digits if len(digits) in (3, 6, 8) else "RRGGBB"
        warn_once(
            f'As in Processing, "{text}" is the colour #{packed & 0xFFFFFF:06X}. '
            f'The usual way to write one is "#{meant}".'
        )
    return packed


def _unknown(text: str, names: dict[str, int]) -> SketchError:
    if text.startswith("#"):
        hint = 'Write "#RRGGBB" or, with alpha first, "#AARRGGBB".'
    else:
        similar = nearest(text, names)
        hint = (
            f'Did you mean "{similar}"?' if similar else 'Write "#CC6600", or a name like "orange".'
        )
    return SketchError("There is no colour of this name.", got=repr(text), hint=hint)


_WEB_COLORS = """
aliceblue F0F8FF antiquewhite FAEBD7 aqua 00FFFF aquamarine 7FFFD4 azure F0FFFF beige F5F5DC
bisque FFE4C4 black 000000 blanchedalmond FFEBCD blue 0000FF blueviolet 8A2BE2 brown A52A2A
burlywood DEB887 cadetblue 5F9EA0 chartreuse 7FFF00 chocolate D2691E coral FF7F50
cornflowerblue 6495ED cornsilk FFF8DC crimson DC143C cyan 00FFFF darkblue 00008B darkcyan 008B8B
darkgoldenrod B8860B darkgray A9A9A9 darkgreen 006400 darkgrey A9A9A9 darkkhaki BDB76B
darkmagenta 8B008B darkolivegreen 556B2F darkorange FF8C00 darkorchid 9932CC darkred 8B0000
darksalmon E9967A darkseagreen 8FBC8F darkslateblue 483D8B darkslategray 2F4F4F
darkslategrey 2F4F4F darkturquoise 00CED1 darkviolet 9400D3 deeppink FF1493 deepskyblue 00BFFF
dimgray 696969 dimgrey 696969 dodgerblue 1E90FF firebrick B22222 floralwhite FFFAF0
forestgreen 228B22 fuchsia FF00FF gainsboro DCDCDC ghostwhite F8F8FF gold FFD700 goldenrod DAA520
gray 808080 green 008000 greenyellow ADFF2F grey 808080 honeydew F0FFF0 hotpink FF69B4
indianred CD5C5C indigo 4B0082 ivory FFFFF0 khaki F0E68C lavender E6E6FA lavenderblush FFF0F5
lawngreen 7CFC00 lemonchiffon FFFACD lightblue ADD8E6 lightcoral F08080 lightcyan E0FFFF
lightgoldenrodyellow FAFAD2 lightgray D3D3D3 lightgreen 90EE90 lightgrey D3D3D3 lightpink FFB6C1
lightsalmon FFA07A lightseagreen 20B2AA lightskyblue 87CEFA lightslategray 778899
lightslategrey 778899 lightsteelblue B0C4DE lightyellow FFFFE0 lime 00FF00 limegreen 32CD32
linen FAF0E6 magenta FF00FF maroon 800000 mediumaquamarine 66CDAA mediumblue 0000CD
mediumorchid BA55D3 mediumpurple 9370DB mediumseagreen 3CB371 mediumslateblue 7B68EE
mediumspringgreen 00FA9A mediumturquoise 48D1CC mediumvioletred C71585 midnightblue 191970
mintcream F5FFFA mistyrose FFE4E1 moccasin FFE4B5 navajowhite FFDEAD navy 000080 oldlace FDF5E6
olive 808000 olivedrab 6B8E23 orange FFA500 orangered FF4500 orchid DA70D6 palegoldenrod EEE8AA
palegreen 98FB98 paleturquoise AFEEEE palevioletred DB7093 papayawhip FFEFD5 peachpuff FFDAB9
peru CD853F pink FFC0CB plum DDA0DD powderblue B0E0E6 purple 800080 rebeccapurple 663399
red FF0000 rosybrown BC8F8F royalblue 4169E1 saddlebrown 8B4513 salmon FA8072 sandybrown F4A460
seagreen 2E8B57 seashell FFF5EE sienna A0522D silver C0C0C0 skyblue 87CEEB slateblue 6A5ACD
slategray 708090 slategrey 708090 snow FFFAFA springgreen 00FF7F steelblue 4682B4 tan D2B48C
teal 008080 thistle D8BFD8 tomato FF6347 turquoise 40E0D0 violet EE82EE wheat F5DEB3 white FFFFFF
whitesmoke F5F5F5 yellow FFFF00 yellowgreen 9ACD32
"""
