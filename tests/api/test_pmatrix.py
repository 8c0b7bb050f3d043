"""Expected numbers were measured with Processing's PMatrix3D and PMatrix2D."""

import numpy as np
import pytest

from sketchkit.api.pmatrix import PMatrix2D, PMatrix3D
from sketchkit.api.pvector import PVector
from sketchkit.core.errors import SketchError


@pytest.fixture
def solid():
    m = PMatrix3D()
    m.translate(1, 2, 3)
    m.rotateX(0.3)
    m.rotateY(0.4)
    m.rotateZ(0.5)
    m.scale(2, 3, 4)
    m.shearX(0.1)
    m.shearY(0.2)
    m.rotate(0.7, 1, 2, 3)
    return m


@pytest.fixture
def flat():
    m = PMatrix2D()
    m.translate(1, 2)
    m.rotate(0.3)
    m.scale(2, 3)
    return m


def near(*numbers):
    return pytest.approx(numbers, abs=2e-6)


def test_changes_in_space_add_up(solid):
    assert solid.get([]) == near(
        *(-0.01801312, -1.20899403, 2.05496693, 1, 2.93828702, 0.97020066, -0.53477108, 2),
        *(-0.41939813, 2.07598877, 3.08919883, 3, 0, 0, 0, 1),
    )


def test_changes_in_the_plane_add_up(flat):
    assert flat.get([]) == near(1.91067302, -0.88656068, 1, 0.59104043, 2.86600947, 2)


def test_determinant_is_the_growth_of_volume(solid, flat):
    assert (solid.determinant(), flat.determinant()) == near(24, 6)


def test_invert_undoes_a_matrix(solid, flat):
    assert solid.invert()
    assert flat.invert()

    assert solid.get([])[:4] == near(0.17113842, 0.33337134, -0.05613314, -0.66948164)
    assert flat.get([])[3:] == near(-0.09850674, 0.3184455, -0.53838426)


def test_invert_of_what_flattens_is_false_and_changes_nothing():
    m = PMatrix3D()
    m.scale(0, 1, 1)

    assert not m.invert()
    assert m.m00 == 0


def test_transpose_exchanges_rows_and_columns(solid):
    before = solid.m23

    solid.transpose()

    assert (solid.m32, solid.m23) == (before, 0)


def test_pre_apply_multiplies_from_the_left(solid, flat):
    solid.preApply(PMatrix3D(*range(1, 17)))
    flat.preApply(1, 2, 3, 4, 5, 6)

    assert solid.get([])[:4] == pytest.approx([4.60036659, 6.95937347, 10.25302124, 18])
    assert flat.get([]) == near(3.09275389, 4.84545803, 8, 10.59789467, 10.7838048, 20)


def test_apply_multiplies_from_the_right(flat):
    flat.apply(1, 2, 3, 4, 5, 6)

    assert flat.get([]) == pytest.approx(
        [-1.63556969, -0.61145711, 1.41265488, 12.05507851, 15.51212883, 20.96917725]
    )


def test_mult_moves_a_point(solid, flat):
    assert tuple(solid.mult(PVector(1, 2, 3))) == near(4.7288995, 5.27437496, 16.00017548)
    assert tuple(flat.mult(PVector(1, 2, 9))) == near(1.13755167, 8.32305908, 0)


def test_mult_fills_a_target(solid):
    target = PVector()

    assert solid.mult(PVector(1, 2, 3), target) is target


def test_single_coordinates_of_a_moved_point(solid, flat):
    x, y, z, w = (f(1, 2, 3) for f in (solid.multX, solid.multY, solid.multZ, solid.multW))

    assert (x, y, z, w) == near(4.7288995, 5.27437496, 16.00017548, 1)
    assert (solid.multX(1, 2), solid.multY(1, 2)) == near(-1.436001, 6.87868834)
    assert (flat.multX(1, 2), flat.multY(1, 2)) == near(1.13755167, 8.32305908)


def test_shear_in_the_plane_is_that_of_space_where_processing_is_wrong(flat):
    solid = PMatrix3D(flat)

    flat.shearX(0.3)
    solid.shearX(0.3)

    assert flat.get([]) == near(*PMatrix2D(flat).get([]))
    assert (flat.m01, flat.m11) == near(solid.m01, solid.m11)


@pytest.mark.parametrize(
    "source",
    [(1, 2, 3, 4, 5, 6), ([1, 2, 3, 4, 5, 6],), (PMatrix2D(1, 2, 3, 4, 5, 6),)],
    ids=["numbers", "list", "matrix"],
)
def test_six_numbers_are_a_transform_of_the_plane(source):
    assert PMatrix3D(*source).get([]) == [1, 2, 0, 3, 4, 5, 0, 6, 0, 0, 1, 0, 0, 0, 0, 1]


def test_reset_makes_the_identity(solid):
    solid.reset()

    assert solid == PMatrix3D()


def test_get_makes_a_copy(solid):
    copy = solid.get()

    copy.translate(1, 0)

    assert copy != solid


def test_get_fills_a_list_of_the_right_length(flat):
    target = [0.0] * 6

    assert flat.get(target) is target
    assert target == [flat.m00, flat.m01, flat.m02, flat.m10, flat.m11, flat.m12]


def test_print_is_processings(capsys, solid):
    solid.print()

    assert capsys.readouterr().out.splitlines()[:2] == [
        "-0.0180 -1.2090  2.0550  1.0000",
        " 2.9383  0.9702 -0.5348  2.0000",
    ]


@pytest.mark.parametrize(
    ("kind", "source"),
    [
        (PMatrix2D, (1, 2)),
        (PMatrix2D, tuple(range(16))),
        (PMatrix2D, (PMatrix3D(),)),
        (PMatrix3D, tuple(range(12))),
        (PMatrix3D, ("abcdef",)),
    ],
    ids=["2", "16 into 2D", "3D into 2D", "12", "text"],
)
def test_wrong_sources_are_told(kind, source):
    with pytest.raises(SketchError, match=rf"^{kind.__name__}'s set\(\) takes 6"):
        kind(*source)


def test_plane_matrix_cannot_turn_in_space() -> None:
    with pytest.raises(SketchError, match=r"stays in the plane: it has no rotateX\(\)"):
        PMatrix2D().rotateX(0.5)


def test_numpy_reads_rows() -> None:
    plane = np.asarray(PMatrix2D(1, 2, 3, 4, 5, 6), dtype=np.float32)

    assert plane.dtype == np.float32
    assert plane.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert np.asarray(PMatrix3D()).tolist() == np.eye(4).tolist()


def test_numbers_can_be_unpacked() -> None:
    a, b, x, c, d, y = PMatrix2D(1, 2, 3, 4, 5, 6)

    assert (a, b, x, c, d, y) == (1, 2, 3, 4, 5, 6)
