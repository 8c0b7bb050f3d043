"""Curves check what they are given in the call itself."""

from __future__ import annotations

import pytest

from sketchkit.core.errors import SketchError


@pytest.mark.parametrize("name", ["bezierPoint", "bezierTangent", "curvePoint", "curveTangent"])
@pytest.mark.parametrize("wrong", ["a", None, [1]], ids=["text", "None", "list"])
def test_coordinate_that_is_no_number_is_named(flat, name, wrong):
    with pytest.raises(SketchError, match=rf"{name}\(\) takes 5 numbers: a, b, c, d, t") as caught:
        getattr(flat, name)(wrong, 1, 2, 3, 0)

    assert " for a: " in str(caught.value)


def test_point_between_texts_is_refused_at_the_ends_too(flat):
    with pytest.raises(SketchError, match="text for a"):
        flat.bezierPoint("a", "b", "c", "d", 1)


def test_tightness_that_is_no_number_is_refused(flat):
    with pytest.raises(SketchError, match=r"curveTightness\(\) takes 1 number"):
        flat.curveTightness("a")


def test_bezier_goes_from_its_first_point_to_its_last(flat):
    ends = flat.bezierPoint(5, 20, 80, 95, 0), flat.bezierPoint(5, 20, 80, 95, 1)

    assert ends == (5, 95)
