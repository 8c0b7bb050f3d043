"""PGraphics as a sketch may write it."""

from __future__ import annotations

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.core.errors import SketchError


def test_one_without_a_size_is_a_graphics_that_is_not_drawn_on():
    canvas = PGraphics()

    assert isinstance(canvas, PGraphics)
    with pytest.raises(
        SketchError, match=r"nothing to draw on.\n.*createGraphics\(width, height\)"
    ):
        canvas.rect(0, 0, 10, 10)


def test_an_unknown_attribute_is_told_as_python_tells_it(flat):
    with pytest.raises(AttributeError, match="'PGraphics' object has no attribute 'colour'"):
        _ = flat.colour
