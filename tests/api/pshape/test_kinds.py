"""Kinds of shapes by the name of the class, as Processing's own classes have them."""

from __future__ import annotations

import pytest

from sketchkit.api.pshape.kinds import ShapeKinds
from sketchkit.api.pshape.shape import PShape
from sketchkit.core import constants

NAMES = [name for name in vars(ShapeKinds) if name.isupper()]


@pytest.mark.parametrize("name", NAMES)
def test_kind_is_the_constant_of_that_name(name):
    assert getattr(PShape, name) == getattr(constants, name)


def test_shape_is_made_by_it(deep):
    group = deep.createShape(PShape.GROUP)
    group.addChild(deep.createShape(PShape.BOX, 20))

    assert group.getChildCount() == 1
