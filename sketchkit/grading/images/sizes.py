"""Pictures of different sizes: what can be said about them nevertheless."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from sketchkit.grading.images.explanations import Explanation
from sketchkit.grading.images.matching import residue
from sketchkit.grading.images.measuring import amount
from sketchkit.grading.images.transformations import QUARTERS

U8 = NDArray[np.uint8]

SAME_SHAPE = 0.02  # by so much the ratios of width to height may differ
# Of what there is to see in the picture, this much may be left. Scaled, edges never quite agree.
LEFT_AT_MOST = 0.2


def explain_size(submitted: U8, expected: U8) -> Explanation:
    """Return what is known about two pictures of different sizes; its name may be ""."""
    (height, width), (high, wide) = submitted.shape[:2], expected.shape[:2]
    sizes = f"Your picture is {width} x {height} pixels; {wide} x {high} is expected."
    for name, sentence, one, other in _guesses(submitted, expected):
        if _agree(one, other):
            return Explanation(name, f"{sizes} {sentence}")
    if (height, width) == (wide, high):
        return Explanation("", f"{sizes} Width and height are swapped.")
    return Explanation("", sizes)


def _guesses(submitted: U8, expected: U8) -> Iterator[tuple[str, str, U8, U8]]:
    """Yield a name, a sentence, and two pictures of one size that agree if it is true."""
    (height, width), (high, wide) = submitted.shape[:2], expected.shape[:2]
    if (height, width) == (wide, high):
        for name, opening, ending, change in QUARTERS:
            turned = np.ascontiguousarray(change(expected))
            yield name, f"{opening} {ending}.", submitted, turned
    if height <= high and width <= wide:
        yield (
            "cut off",
            "It is the left top part of the expected one.",
            submitted,
            expected[:height, :width],
        )
    if height >= high and width >= wide:
        yield (
            "too large",
            "The expected one is its left top part.",
            submitted[:high, :wide],
            expected,
        )
    if abs(width * high / (height * wide) - 1) <= SAME_SHAPE:
        size = min(width, wide), min(height, high)
        yield (
            "scaled",
            f"It is the expected one, scaled by {width / wide:.3g}.",
            _scaled(submitted, size),
            _scaled(expected, size),
        )


def _agree(one: U8, other: U8) -> bool:
    """Return whether two pictures agree about what there is to see, backgrounds not counted."""
    background = np.median(other.reshape(-1, 3), axis=0).astype(np.uint8)
    content = amount(residue(other, np.broadcast_to(background, other.shape)))
    left = amount(residue(one, other))
    return content.weight > 0 and left.weight <= LEFT_AT_MOST * content.weight


def _scaled(picture: U8, size: tuple[int, int]) -> U8:
    image = Image.fromarray(np.ascontiguousarray(picture))
    return np.asarray(image.resize(size, Image.Resampling.BILINEAR))
