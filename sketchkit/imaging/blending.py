"""One picture over another, in the modes of `blend()` and `blendColor()`.

All is done in whole numbers, as in Processing, so that each bit is the same, oddities too. The
modes of `blendMode()` are fewer, and the renderers'.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sketchkit.core import constants as c

U8 = NDArray[np.uint8]
I32 = NDArray[np.int32]
Formula = Callable[[I32, I32], I32]


def blended(under: U8, over: U8, mode: int) -> U8:
    """Return the colours, (..., 4), that `over` makes of those below it."""
    if mode == c.REPLACE:
        return over.copy()
    below, above = under[..., :3].astype(np.int32), over[..., :3].astype(np.int32)
    alphas = over[..., 3:].astype(np.int32)
    weights = alphas + (alphas >= 127)  # of 256: so 255 is all of it
    if mode in WEIGHTED_FIRST:
        colors = WEIGHTED_FIRST[mode](below, above * weights >> 8)
    else:
        colors = below * (256 - weights) + MODES[mode](below, above) * weights >> 8
    result = np.empty_like(under)
    result[..., :3] = colors
    result[..., 3:] = np.minimum(under[..., 3:] + alphas, 255)
    return result


def _exclusion(below: I32, above: I32) -> I32:
    return below + above - (above * (below + (below >= 127)) >> 7)


def _screen(below: I32, above: I32) -> I32:
    return below + above - _multiply(below, above)


def _multiply(below: I32, above: I32) -> I32:
    return above * (below + 1) >> 8


def _hard_light(below: I32, above: I32) -> I32:
    dark = above * (below + 1) >> 7
    light = (255 * 128 - (256 - below) * (255 - above)) >> 7
    chosen: I32 = np.where(above < 128, dark, light)
    return chosen


def _overlay(below: I32, above: I32) -> I32:
    return _hard_light(above, below)


def _soft_light(below: I32, above: I32) -> I32:
    """Return Pegtop's formula, with what is above gray.

    Processing reads the blue of what is above for all three parts. It adds 1 to what is below
    where that is under 7: a 0x has been lost before 7F.
    """
    gray: I32 = above[..., 2:]
    lifted: I32 = below + (gray < 7)
    bent: I32 = 255 * lifted * (lifted + 1) - 2 * gray * lifted * lifted
    return (512 * gray * below + bent) >> 16


def _dodge(below: I32, above: I32) -> I32:
    return _at_most_255((below << 8) // (256 - above))


def _burn(below: I32, above: I32) -> I32:
    """Return the formula for a gray above: Processing reads its blue for all three parts."""
    gray = above[..., 2:]
    return 255 - _at_most_255((255 - below << 8) // (1 + gray))


def _at_most_255(values: I32) -> I32:
    cut: I32 = np.minimum(values, 255)
    return cut


# What a mode makes of two colours, which then is mixed with what is below.
MODES: dict[int, Formula] = {
    c.BLEND: lambda _below, above: above,
    c.LIGHTEST: np.maximum,
    c.DARKEST: np.minimum,
    c.DIFFERENCE: lambda below, above: np.abs(below - above),
    c.EXCLUSION: _exclusion,
    c.MULTIPLY: _multiply,
    c.SCREEN: _screen,
    c.OVERLAY: _overlay,
    c.HARD_LIGHT: _hard_light,
    c.SOFT_LIGHT: _soft_light,
    c.DODGE: _dodge,
    c.BURN: _burn,
}

# The modes in which alpha makes what is above smaller, before it is taken.
WEIGHTED_FIRST: dict[int, Formula] = {
    c.ADD: lambda below, above: _at_most_255(below + above),
    c.SUBTRACT: lambda below, above: np.maximum(below - above, 0),
}

BLEND_MODES = frozenset((c.REPLACE, *MODES, *WEIGHTED_FIRST))
