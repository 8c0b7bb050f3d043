"""Expected numbers are Processing's (PGraphicsOpenGL.modelview and .projection), or NumPy's."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core import matrix as mat

number = st.floats(-10, 10)
affines = st.tuples(*[number] * 12)
mat4s = st.tuples(*[number] * 16)


def square(m):
    """Return an Affine or a Mat4 as a 4x4 array."""
    return np.array(m if len(m) == 16 else mat.to_mat4(m)).reshape(4, 4)


def test_changes_follow_processing_number_by_number():
    m = mat.translate(mat.IDENTITY, 1, 2, 3)
    m = mat.rotate_z(mat.rotate_y(mat.rotate_x(m, 0.3), 0.4), 0.5)
    m = mat.shear_y(mat.shear_x(mat.scale(m, 2, 3, 4), 0.1), 0.2)

    m = mat.rotate_axis(m, 0.7, 1, 2, 3)

    assert m == pytest.approx(
        (
            *(-0.01801312, -1.20899403, 2.05496693, 1.0),
            *(2.93828702, 0.97020066, -0.53477108, 2.0),
            *(-0.41939813, 2.07598877, 3.08919883, 3.0),
        ),
        abs=1e-6,
    )


@pytest.mark.parametrize(
    ("change", "args"),
    [
        (mat.translate, (1, 2, 3)),
        (mat.scale, (2, 3, 4)),
        (mat.rotate_x, (0.3,)),
        (mat.rotate_y, (0.3,)),
        (mat.rotate_z, (0.3,)),
        (mat.rotate_axis, (0.3, 1, 2, 3)),
        (mat.shear_x, (0.3,)),
        (mat.shear_y, (0.3,)),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
@given(m=affines)
def test_a_change_is_a_product_from_the_right(change, args, m):
    alone = change(mat.IDENTITY, *args)

    assert change(m, *args) == pytest.approx(mat.multiply(m, alone), abs=1e-9)


def test_translate_and_scale_of_two_numbers_leave_z():
    m = mat.scale(mat.translate(mat.IDENTITY, 5, 6), 2, 3)

    assert mat.transform_point(m, 1, 1, 7) == (7, 9, 7)


@pytest.mark.parametrize("length", [0.0, 0.0001], ids=["zero", "too short"])
def test_rotation_about_an_axis_without_length_changes_nothing(length):
    assert mat.rotate_axis(mat.IDENTITY, 0.5, length, 0, 0) == mat.IDENTITY


def test_axis_of_any_other_length_is_made_a_unit():
    short = mat.rotate_axis(mat.IDENTITY, 0.5, 0.003, 0, 0)

    assert short == pytest.approx(mat.rotate_x(mat.IDENTITY, 0.5))


@given(affines, affines)
def test_multiply_is_the_matrix_product(m, n):
    np.testing.assert_allclose(square(mat.multiply(m, n)), square(m) @ square(n), atol=1e-9)


@given(mat4s, mat4s)
def test_multiply4_is_the_matrix_product(m, n):
    np.testing.assert_allclose(square(mat.multiply4(m, n)), square(m) @ square(n), atol=1e-9)


def test_inverse_undoes_a_transform():
    m = mat.rotate_axis(mat.translate(mat.scale(mat.IDENTITY, 2, 3, 4), 1, 2, 3), 0.7, 1, 2, 3)

    undone = mat.multiply(m, mat.inverse(m))

    assert undone == pytest.approx(mat.IDENTITY, abs=1e-12)


def test_inverse4_undoes_a_projection():
    m = mat.multiply4(mat.perspective(1.0, 1.5, 2, 200), mat.to_mat4(mat.rotate_y(mat.IDENTITY, 1)))

    undone = mat.multiply4(m, mat.inverse4(m))

    assert undone == pytest.approx(mat.IDENTITY4, abs=1e-12)


def test_what_flattens_space_has_no_inverse():
    flat = mat.scale(mat.IDENTITY, 1, 0, 1)

    assert mat.inverse(flat) is None
    assert mat.inverse4(mat.to_mat4(flat)) is None


@given(mat4s)
def test_determinant4_is_numpys(m):
    assert mat.determinant4(m) == pytest.approx(np.linalg.det(square(m)), rel=1e-6, abs=1e-6)


@given(mat4s)
def test_transpose4_exchanges_rows_and_columns(m):
    np.testing.assert_array_equal(square(mat.transpose4(m)), square(m).T)


@given(affines, number, number, number)
def test_transform_point_and_transform4_agree(m, x, y, z):
    assert mat.transform4(mat.to_mat4(m), x, y, z) == pytest.approx(
        (*mat.transform_point(m, x, y, z), 1.0)
    )


@pytest.mark.parametrize(
    ("eye", "centre", "up", "expected"),
    [
        (
            *((10, 20, 30), (1, 2, 3), (0, 1, 0)),
            (
                *(0.94868326, 0, -0.31622773, 0),
                *(-0.16903083, 0.84515423, -0.50709254, 0),
                *(0.26726124, 0.53452247, 0.80178374, -37.4165726),
            ),
        ),
        (
            *((10, 20, 30), (1, 2, 3), (0.3, 1, -0.5)),
            (
                *(0.93968201, -0.32888871, -0.0939682, 0),
                *(0.21346952, 0.77853584, -0.5901804, 0),
                *(0.26726124, 0.53452247, 0.80178374, -37.4165726),
            ),
        ),
        (*((0, 10, 0), (0, 0, 0), (0, 1, 0)), (0,) * 8 + (0, 1, 0, -10)),
        (*((5, 5, 5), (5, 5, 5), (0, 1, 0)), (0,) * 12),
    ],
    ids=["upright", "tilted", "up along the view", "nowhere"],
)
def test_look_at_is_processings_camera(eye, centre, up, expected):
    assert mat.look_at(eye, centre, up) == pytest.approx(expected, abs=2e-6)


def test_look_at_of_the_default_camera_only_moves():
    eye_z = 25 / math.tan(math.pi / 6)

    m = mat.look_at((25, 25, eye_z), (25, 25, 0), (0, 1, 0))

    assert m == pytest.approx((1, 0, 0, -25, 0, 1, 0, -25, 0, 0, 1, -43.30126953), abs=1e-5)


@pytest.mark.parametrize(
    ("projection", "expected"),
    [
        (
            mat.perspective(1.0, 1.5, 2, 200),
            [1.2203252, 0, 0, 0, 0, -1.8304877, 0, 0, 0, 0, -1.020202, -4.0404038, 0, 0, -1, 0],
        ),
        (
            mat.ortho(-10, 30, -8, 24, 1, 100),
            [0.05, 0, 0, -0.5, 0, -0.0625, 0, -0.5, 0, 0, -0.020202, -1.020202, 0, 0, 0, 1],
        ),
        (
            mat.frustum(-10, 30, -8, 24, 40, 1200),
            [2, 0, 0.5, 0, 0, -2.5, 0.5, 0, 0, 0, -1.0689656, -82.7586212, 0, 0, -1, 0],
        ),
    ],
    ids=["perspective", "ortho", "frustum"],
)
def test_projections_are_processings_with_y_turned_over(projection, expected):
    assert projection == pytest.approx(expected, abs=1e-6)
