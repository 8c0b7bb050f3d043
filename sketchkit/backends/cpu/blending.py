"""How a colour and what is there already make a new one, in 8 bits as graphics hardware has them.

The modes are Processing's for OpenGL (draw/pipeline.py, Blend). Alphas are added in every mode but
REPLACE. Sums stop at 255, differences at 0.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sketchkit.draw.pipeline import Blend
from sketchkit.draw.vertex import U8

U16 = NDArray[np.uint16]

OPAQUE = np.uint16(255)


def blend(mode: Blend, source: U8, destination: U8) -> U8:
    """Return source colours, (..., 4) straight RGBA, drawn over others."""
    if mode is Blend.REPLACE:
        return np.broadcast_to(source, destination.shape)
    source16, destination16 = source.astype(np.uint16), destination.astype(np.uint16)
    # Alpha once for each channel, and the rule for alpha too: long even rows are quicker.
    alpha = np.repeat(source16[..., 3:], 4, axis=-1)
    blended = _RULES[mode](source16, alpha, destination16).astype(np.uint8)
    blended[..., 3] = _sum(source16[..., 3], destination16[..., 3])
    return blended


def times(a: U16, b: U16) -> U16:
    """Return a * b / 255, rounded as Mesa does."""
    product = a * b
    return (product + (product >> 8) + np.uint16(128)) >> np.uint16(8)


def _sum(a: U16, b: U16) -> U16:
    total: U16 = np.minimum(a + b, OPAQUE)
    return total


def _over(source: U16, alpha: U16, destination: U16) -> U16:
    return _sum(times(source, alpha), times(destination, OPAQUE - alpha))


def _add(source: U16, alpha: U16, destination: U16) -> U16:
    return _sum(times(source, alpha), destination)


def _subtract(source: U16, alpha: U16, destination: U16) -> U16:
    return destination - np.minimum(times(source, alpha), destination)


def _lightest(source: U16, alpha: U16, destination: U16) -> U16:
    return np.maximum(source, destination)


def _darkest(source: U16, alpha: U16, destination: U16) -> U16:
    return np.minimum(source, destination)


def _exclude(source: U16, alpha: U16, destination: U16) -> U16:
    return _sum(times(source, OPAQUE - destination), times(destination, OPAQUE - source))


def _multiply(source: U16, alpha: U16, destination: U16) -> U16:
    return times(source, destination)


def _screen(source: U16, alpha: U16, destination: U16) -> U16:
    return _sum(times(source, OPAQUE - destination), destination)


# Colours of the source, its alpha, colours that are there.
_RULES: dict[Blend, Callable[[U16, U16, U16], U16]] = {
    Blend.BLEND: _over,
    Blend.ADD: _add,
    Blend.SUBTRACT: _subtract,
    Blend.LIGHTEST: _lightest,
    Blend.DARKEST: _darkest,
    Blend.EXCLUSION: _exclude,
    Blend.MULTIPLY: _multiply,
    Blend.SCREEN: _screen,
}
