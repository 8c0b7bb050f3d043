import math

import numpy as np
import pytest

from sketchkit.libraries.peasycam.rotation import X_AXIS, Y_AXIS, Z_AXIS, Rotation, between

QUARTER = math.pi / 2
ANGLES = [(0.3, -0.8, 1.9), (-2.5, 1.2, 0.1), (0.0, 0.0, 3.0)]


def matrix(x: float, y: float, z: float) -> np.ndarray:
    """Return Rx Ry Rz, written out."""
    (cx, sx), (cy, sy), (cz, sz) = ((math.cos(a), math.sin(a)) for a in (x, y, z))
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return about_x @ about_y @ about_z


@pytest.mark.parametrize(
    ("axis", "vector", "turned"),
    [(Z_AXIS, X_AXIS, Y_AXIS), (X_AXIS, Y_AXIS, Z_AXIS), (Y_AXIS, Z_AXIS, X_AXIS)],
)
def test_quarter_turn_takes_an_axis_to_the_next(axis, vector, turned) -> None:
    assert Rotation.about(axis, QUARTER).turn(vector) == pytest.approx(turned)


@pytest.mark.parametrize("angles", ANGLES)
def test_three_angles_turn_as_the_product_of_three_matrices(angles) -> None:
    turned = Rotation.of_angles(*angles).turn((1, 2, 3))

    assert turned == pytest.approx(matrix(*angles) @ (1, 2, 3))


@pytest.mark.parametrize("angles", [ANGLES[0], ANGLES[1], (0.4, QUARTER, 0.7)])
def test_angles_describe_the_same_rotation(angles) -> None:
    rotation = Rotation.of_angles(*angles)
    x, y, z = rotation.angles()
    again = Rotation.of_angles(x, y, z)
    if angles[1] == QUARTER:  # then in the order y, x, z
        about_x, about_y = Rotation.about(X_AXIS, x), Rotation.about(Y_AXIS, y)
        again = about_y.after(about_x.after(Rotation.about(Z_AXIS, z)))

    assert again.turn((1, 2, 3)) == pytest.approx(rotation.turn((1, 2, 3)))


def test_half_of_a_turn_is_half_its_angle() -> None:
    half = between(Rotation(), Rotation.about(Y_AXIS, 1.0), 0.5)

    assert half == pytest.approx(Rotation.about(Y_AXIS, 0.5))


def test_the_shorter_way_round_is_taken() -> None:
    start, end = Rotation.about(Z_AXIS, 0.2), Rotation.about(Z_AXIS, 2 * math.pi - 0.2)

    middle = between(start, end, 0.5)

    assert middle.turn(X_AXIS) == pytest.approx(X_AXIS)


def test_nearly_equal_rotations_are_mixed_without_dividing_by_nothing() -> None:
    assert between(Rotation(), Rotation.about(X_AXIS, 1e-9), 0.5) == pytest.approx(
        Rotation(), abs=1e-8
    )
