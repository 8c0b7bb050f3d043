from math import pi, sqrt

import pytest

from sketchkit.core.matrix import (
    IDENTITY,
    look_at,
    ortho,
    perspective,
    rotate_y,
    rotate_z,
    scale,
    translate,
)
from sketchkit.geometry.enlargement import enlargement

SCREEN = 200, 100
FLAT = ortho(0, 200, -100, 0, -1, 1)
EYE = 50 / (1 / sqrt(3))  # of P3D: it sees 100 pixels in 60 degrees
CAMERA = look_at((100, 50, EYE), (100, 50, 0), (0, 1, 0))
LENS = perspective(pi / 3, 2, EYE / 10, EYE * 10)


@pytest.mark.parametrize(
    ("modelview", "expected"),
    [
        pytest.param(IDENTITY, 1, id="none"),
        pytest.param(scale(IDENTITY, 4, 4), 4, id="scaled"),
        pytest.param(scale(IDENTITY, 2, 3), 3, id="the longer axis"),
        pytest.param(rotate_z(scale(IDENTITY, 2, 2), 1), 2, id="turned"),
        pytest.param(translate(IDENTITY, 30, -20), 1, id="moved"),
        pytest.param(scale(IDENTITY, -2, 2), 2, id="mirrored"),
    ],
)
def test_on_a_flat_canvas(modelview, expected):
    assert enlargement(modelview, FLAT, SCREEN, 17, 3) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("z", "expected"), [(0, 1), (EYE / 2, 2), (-EYE, 0.5), (2 * EYE, 1)], ids=str
)
def test_in_space_what_is_nearer_is_larger(z, expected):
    modelview = translate(CAMERA, 0, 0, z)

    assert enlargement(modelview, LENS, SCREEN, 30, 70) == pytest.approx(expected, rel=1e-5)


def test_on_a_turned_plane_it_depends_on_the_place():
    turned = rotate_y(translate(CAMERA, 100, 50), 0.5)

    nearer, farther = (enlargement(turned, LENS, SCREEN, x, 0) for x in (-60, 60))

    assert nearer > 1.2
    assert farther < 0.9
