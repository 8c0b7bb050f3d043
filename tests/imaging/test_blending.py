import numpy as np
import pytest

from sketchkit.core import constants as c
from sketchkit.imaging.blending import BLEND_MODES, MODES, blended
from sketchkit.imaging.packing import to_argb, to_rgba

UNDER, OVER = 0xFF6496C8, 0x80C86432  # (100, 150, 200) and (200, 100, 50) of alpha 128


def blended_ints(under, over, mode):
    colors = (to_rgba(np.array([color], np.uint32)) for color in (under, over))
    return int(to_argb(blended(*colors, mode))[0])


@pytest.mark.parametrize(
    ("mode", "expected"),
    [  # from Processing
        (c.ADD, 0xFFC8C8E1),
        (c.MULTIPLY, 0xFF586776),
        (c.SCREEN, 0xFFA1ABCD),
        (c.OVERLAY, 0xFF808AB6),
        (c.DIFFERENCE, 0xFF6463AE),
        (c.EXCLUSION, 0xFF7A8DB9),
        (c.SOFT_LIGHT, 0xFF5182BA),
        (c.HARD_LIGHT, 0xFF8F858A),
        (c.DODGE, 0xFFB2C6E0),
        (c.BURN, 0xFF314A63),
        (c.REPLACE, OVER),
    ],
)
def test_half_transparent_over_opaque(mode, expected):
    assert blended_ints(UNDER, OVER, mode) == expected


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        (c.BLEND, 0xFFC86432),
        (c.SUBTRACT, 0xFF003296),
        (c.LIGHTEST, 0xFFC896C8),
        (c.DARKEST, 0xFF646432),
        (c.DIFFERENCE, 0xFF643296),
    ],
)
def test_opaque_over_opaque_is_the_plain_formula(mode, expected):
    assert blended_ints(UNDER, OVER | 0xFF000000, mode) == expected


@pytest.mark.parametrize("mode", sorted(BLEND_MODES - {c.REPLACE}))
def test_what_is_clear_changes_nothing(mode):
    assert blended_ints(UNDER, OVER & 0xFFFFFF, mode) == UNDER


@pytest.mark.parametrize("mode", sorted(BLEND_MODES))
def test_alphas_add_up(mode):
    alpha = blended_ints(0x40102030, 0x30405060, mode) >> 24

    assert alpha == (0x30 if mode == c.REPLACE else 0x70)


@pytest.mark.parametrize("mode", sorted(MODES))
def test_no_pair_of_values_leaves_the_range(mode):
    # Stored as bytes, values beyond it would wrap around.
    values = np.arange(256, dtype=np.int32)
    below = np.repeat(values[:, None, None], 3, axis=2)
    above = np.repeat(values[None, :, None], 3, axis=2)

    result = MODES[mode](below, above)

    assert result.min() >= 0
    assert result.max() <= 255
