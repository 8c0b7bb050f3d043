"""What may have been done to a picture: each turns the expected picture into what it would be then.

Those with a number in them (gamma, brightness) find it from the two pictures. A number explains
little where it was fitted to two colours alone, so each asks for more colours than it has numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

U8 = NDArray[np.uint8]
F64 = NDArray[np.float64]
Change = Callable[[U8], U8]

ENOUGH_VALUES = 200_000  # to fit a number to
# A colour counts when this share of all values has it: edges are mixtures, and do not.
COMMON = 0.004
LEVEL = 8  # values at a time make a level: 0..7, 8..15, ...
AS_IT_IS = "Your picture is"
TOO_SMALL = 0.03  # a gamma or a factor nearer to 1 than that changes nothing that is seen


class Transformation(NamedTuple):
    """Something that may have been done to the expected picture.

    Attributes
    ----------
    name : str
        A short one: "flipped in y".
    opening, ending : str
        A sentence: "Turned upside down, your picture is", "the expected one".
    change : callable
        From the expected picture to what it would be.
    """

    name: str
    opening: str
    ending: str
    change: Change


def _undone(name: str, how: str, change: Change) -> Transformation:
    return Transformation(name, f"{how}, your picture is", "the expected one", change)


def _permuted(*order: int) -> Change:
    return lambda picture: picture[..., list(order)]


def _greys(picture: U8) -> U8:
    """Return the greys that filter(GRAY) makes."""
    grey = (picture @ np.array([77, 151, 28], np.uint32)) >> 8
    return np.repeat(grey[..., None].astype(np.uint8), 3, axis=2)


def _inverted(picture: U8) -> U8:
    return 255 - picture


MIRRORS = (
    _undone("flipped in y", "Turned upside down", lambda picture: picture[::-1]),
    _undone("mirrored in x", "Mirrored left to right", lambda picture: picture[:, ::-1]),
    _undone("turned by 180 degrees", "Turned by 180 degrees", lambda picture: picture[::-1, ::-1]),
)
# Of square pictures, and of those whose width and height are swapped.
QUARTERS = (
    _undone("turned by 90 degrees", "Turned back by 90 degrees", lambda p: np.rot90(p, -1)),
    _undone("turned by -90 degrees", "Turned on by 90 degrees", lambda p: np.rot90(p, 1)),
    _undone("x and y swapped", "With x and y swapped", lambda p: p.transpose(1, 0, 2)),
)
COLORS = (
    _undone("red and blue swapped", "With red and blue swapped", _permuted(2, 1, 0)),
    _undone("red and green swapped", "With red and green swapped", _permuted(1, 0, 2)),
    _undone("green and blue swapped", "With green and blue swapped", _permuted(0, 2, 1)),
    _undone(
        "colours rotated",
        "With its green taken for red, its blue for green and its red for blue",
        _permuted(2, 0, 1),
    ),
    _undone(
        "colours rotated",
        "With its blue taken for red, its red for green and its green for blue",
        _permuted(1, 2, 0),
    ),
    _undone("colours inverted", "With its colours inverted", _inverted),
    Transformation("greyscale", AS_IT_IS, "the expected one in greys", _greys),
)


def places(expected: U8) -> Iterator[Transformation]:
    """Yield what may have been done to the places of a picture's parts, the simplest first."""
    yield from MIRRORS
    if expected.shape[0] == expected.shape[1]:
        yield from QUARTERS


def colors(submitted: U8, expected: U8) -> Iterator[Transformation]:
    """Yield what may have been done to colours, the simplest first; both are of one size."""
    yield from COLORS
    levels = _levels(submitted, expected)
    yield from _gammas(*levels)
    yield from _brightnesses(*levels)


def both(place: Transformation, paint: Transformation) -> Transformation:
    """Return one after the other, as one."""
    opening = place.opening
    if paint.opening != AS_IT_IS:
        also = paint.opening[0].lower() + paint.opening[1:]
        opening = f"{place.opening.removesuffix(', your picture is')} and {also}"
    return Transformation(
        f"{place.name}, {paint.name}",
        opening,
        paint.ending,
        lambda picture: paint.change(place.change(picture)),
    )


def _levels(submitted: U8, expected: U8) -> tuple[F64, F64]:
    """Return values that are common in the expected picture and what they have become: medians."""
    step = max(1, expected.size // ENOUGH_VALUES) | 1  # odd: all rows and columns take their turn
    before, after = expected.reshape(-1)[::step], submitted.reshape(-1)[::step]
    order = np.argsort(before // LEVEL, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(before[order] // LEVEL)) + 1)
    common = [group for group in groups if len(group) >= COMMON * len(before)]
    pairs = [(np.median(before[group]), np.median(after[group])) for group in common]
    inside = [pair for pair in pairs if 0 < pair[1] < 255]  # what was cut off tells nothing
    first, second = np.array(inside).reshape(-1, 2).T
    return first, second


def _gammas(before: F64, after: F64) -> Iterator[Transformation]:
    is_usable = (before > 4) & (before < 251)
    if is_usable.sum() < 2:
        return
    exponents = np.log(after[is_usable] / 255) / np.log(before[is_usable] / 255)
    fitted = float(np.median(exponents))
    if abs(fitted - 1) < TOO_SMALL:
        return
    yield _gamma("a gamma of 2.2", lambda value: value**2.2)
    yield _gamma("a gamma of 1/2.2", lambda value: value ** (1 / 2.2))
    yield _gamma("sRGB taken for linear light", _to_linear)
    yield _gamma("linear light taken for sRGB", _to_srgb)
    yield _gamma(f"a gamma of {fitted:.2f}", lambda value: value**fitted)


def _gamma(what: str, curve: Callable[[F64], F64]) -> Transformation:
    return _undone("gamma", f"With {what} undone", _by_table(curve))


def _brightnesses(before: F64, after: F64) -> Iterator[Transformation]:
    """Yield a factor, something added, and both."""
    if len(before) < 2:
        return
    is_bright = before > 16
    if is_bright.sum() >= 2:
        factor = float(np.median(after[is_bright] / before[is_bright]))
        if abs(factor - 1) >= TOO_SMALL:
            yield _brightness(f"every colour times {factor:.2f}", factor, 0)
    added = round(float(np.median(after - before)))
    if added:
        what = (
            f"{added} added to every colour" if added > 0 else f"{-added} taken from every colour"
        )
        yield _brightness(what, 1, added)
    if len(before) >= 4:
        factor, added = np.polyfit(before, after, 1)
        if factor > TOO_SMALL:
            sign = "plus" if added >= 0 else "less"
            what = f"every colour times {factor:.2f}, {sign} {abs(round(added))}"
            yield _brightness(what, float(factor), float(added))


def _brightness(what: str, factor: float, added: float) -> Transformation:
    ending = f"the expected one with another brightness, {what}"
    curve = _by_table(lambda value: value * factor + added / 255)
    return Transformation("brightness", AS_IT_IS, ending, curve)


def _by_table(curve: Callable[[F64], F64]) -> Change:
    """Return a change that takes each value, 0..1, through a curve."""
    table = np.rint(np.clip(curve(np.arange(256) / 255), 0, 1) * 255).astype(np.uint8)
    return lambda picture: table[picture]


def _to_linear(value: F64) -> F64:
    return np.where(value > 0.04045, ((value + 0.055) / 1.055) ** 2.4, value / 12.92)


def _to_srgb(value: F64) -> F64:
    return np.where(value > 0.0031308, 1.055 * value ** (1 / 2.4) - 0.055, value * 12.92)
