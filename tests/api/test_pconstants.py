"""Constants by the name of a class, as Processing's own classes have them."""

from __future__ import annotations

import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.api.pconstants import PConstants
from sketchkit.api.pfont import PFont
from sketchkit.api.pimage import PImage
from sketchkit.api.pshader import PShader
from sketchkit.api.pshape.shape import PShape
from sketchkit.core import constants


@pytest.mark.parametrize("name", ["QUADS", "GROUP", "ARGB", "CLOSE", "HALF_PI", "P3D"])
def test_it_has_the_constant_of_that_name(name):
    assert getattr(PConstants, name) == getattr(constants, name)


@pytest.mark.parametrize("kind", [PGraphics, PFont, PImage, PShader, PShape])
def test_classes_have_what_processings_classes_take_over(kind):
    assert kind.TRIANGLE_STRIP == constants.TRIANGLE_STRIP


def test_shape_is_made_by_it(deep):
    group = deep.createShape(PShape.GROUP)
    group.addChild(deep.createShape(PShape.BOX, 20))

    assert group.getChildCount() == 1
