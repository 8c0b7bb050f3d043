"""What the calls of colours refuse; the colours themselves are tested in `core/test_color.py`."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import HSB
from sketchkit.core.errors import SketchError


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.colorMode(HSB, "a"), "text for max:"),
        (lambda g: g.colorMode(HSB, 360, "a", 100), "text for max2:"),
        (lambda g: g.colorMode("HSB"), "Write HSB without quotes"),
        (lambda g: g.colorMode(HSB, 0), "ranges greater than 0"),
        (lambda g: g.lerpColor(0, 255, "a"), "text for amount:"),
        (lambda g: g.lerpColor("red", "blue", None), "None for amount:"),
        (lambda g: g.color("red", "a"), "text for alpha:"),
        (lambda g: g.color(), "red, green, blue"),
    ],
)
def test_wrong_arguments_are_named(flat, call, message):
    with pytest.raises(SketchError) as caught:
        call(flat)

    assert message in str(caught.value)


def test_refused_color_mode_changes_nothing(flat):
    with pytest.raises(SketchError):
        flat.colorMode(HSB, "a")

    assert flat.color(255, 0, 0) == 0xFFFF0000


class TestPartsOfInts:
    """An int that a sketch holds is packed, however small; measured with Processing."""

    def test_a_transparent_pixel_has_no_alpha(self, flat):
        assert [flat.alpha(0), flat.red(128), flat.blue(128)] == [0, 0, 128]

    def test_between_small_ints_alpha_stays_nothing(self, flat):
        assert flat.lerpColor(0, 100, 0.5) == 50
        assert flat.lerpColor(255, flat.color(255, 0, 0), 0.5) == 0x80800080

    def test_a_fraction_is_cut_off(self, flat):
        assert flat.lerpColor(0, 100.9, 0.5) == 50
