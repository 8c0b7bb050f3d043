"""The numbers are those of Processing."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.blending import blend
from sketchkit.draw.pipeline import Blend


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (Blend.BLEND, (150, 125, 125)),
        (Blend.ADD, (200, 200, 225)),
        (Blend.SUBTRACT, (0, 100, 175)),
        (Blend.LIGHTEST, (200, 150, 200)),
        (Blend.DARKEST, (100, 100, 50)),
        (Blend.EXCLUSION, (144, 132, 172)),
        (Blend.MULTIPLY, (78, 59, 39)),
        (Blend.SCREEN, (222, 191, 211)),
        (Blend.REPLACE, (200, 100, 50)),
    ],
    ids=lambda value: value.name.lower() if isinstance(value, Blend) else "",
)
def test_modes(mode: Blend, expected: tuple[int, ...]) -> None:
    source = np.array([200, 100, 50, 128], np.uint8)
    there = np.array([100, 150, 200, 255], np.uint8)

    blended = blend(mode, source, there)

    assert tuple(blended[:3]) == expected


@pytest.mark.parametrize(("alpha", "expected"), [(128, (228, 100, 100)), (127, (227, 100, 100))])
def test_red_over_grey(alpha: int, expected: tuple[int, ...]) -> None:
    there = np.array([200, 200, 200, 255], np.uint8)

    blended = blend(Blend.BLEND, np.array([255, 0, 0, alpha], np.uint8), there)

    assert tuple(blended[:3]) == expected


@pytest.mark.parametrize("mode", [mode for mode in Blend if mode is not Blend.REPLACE])
def test_alphas_are_added(mode: Blend) -> None:
    source = np.array([[9, 9, 9, 100], [9, 9, 9, 200]], np.uint8)
    there = np.array([[9, 9, 9, 100], [9, 9, 9, 100]], np.uint8)

    assert blend(mode, source, there)[:, 3].tolist() == [200, 255]


def test_replace_takes_the_alpha_too() -> None:
    source, there = np.array([1, 2, 3, 4], np.uint8), np.array([9, 9, 9, 9], np.uint8)

    assert blend(Blend.REPLACE, source, there).tolist() == [1, 2, 3, 4]
