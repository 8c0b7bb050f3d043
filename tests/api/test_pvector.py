"""Expected numbers were measured with Processing's PVector."""

import copy
import math
import operator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.api.chance import use_random
from sketchkit.api.pvector import PVector
from sketchkit.core.errors import SketchError
from sketchkit.core.rng import JavaRandom

number = st.floats(-1e3, 1e3)
vectors = st.builds(PVector, number, number, number)


@pytest.fixture
def v():
    return PVector(1, 2, 3)


@pytest.fixture
def w():
    return PVector(4, -5, 6)


def test_components_are_floats_and_z_may_be_left_out():
    assert [*map(type, PVector(1, 2))] == [float] * 3


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda v, w: v.add(w), (5, -3, 9)),
        (lambda v, w: v.add(5, 6), (6, 8, 3)),
        (lambda v, w: v.sub(w), (-3, 7, -3)),
        (lambda v, w: v.sub(1, 1, 1), (0, 1, 2)),
        (lambda v, w: v.mult(2), (2, 4, 6)),
        (lambda v, w: v.div(2), (0.5, 1, 1.5)),
        (lambda v, w: v.div(0), (math.inf,) * 3),
        (lambda v, w: v.lerp(w, 0.25), (1.75, 0.25, 3.75)),
        (lambda v, w: v.lerp(4, -5, 6, 0.25), (1.75, 0.25, 3.75)),
        (lambda v, w: v.set(5, 6), (5, 6, 0)),
        (lambda v, w: v.set([5, 6]), (5, 6, 0)),
        (lambda v, w: v.set(w), (4, -5, 6)),
        (lambda v, w: v.set(3, 4, 0).limit(2), (1.2, 1.6, 0)),
        (lambda v, w: v.set(3, 4, 0).limit(6), (3, 4, 0)),
        (lambda v, w: v.set(3, 4, 0).setMag(2), (1.2, 1.6, 0)),
        (lambda v, w: v.set(0, 0, 0).setMag(2), (0, 0, 0)),
        (lambda v, w: v.set(3, 4, 0).normalize(), (0.6, 0.8, 0)),
        (lambda v, w: v.set(0, 0, 0).normalize(), (0, 0, 0)),
        (lambda v, w: v.set(1, 0, 5).rotate(math.pi / 2), (0, 1, 5)),
        (lambda v, w: v.set(3, 4, 12).setHeading(0), (13, 0, 12)),
    ],
)
def test_a_method_changes_the_vector_and_returns_it(v, w, change, expected):
    result = change(v, w)

    assert result is v
    assert tuple(v) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (lambda v, w: PVector.add(v, w), (5, -3, 9)),
        (lambda v, w: PVector.sub(v, w), (-3, 7, -3)),
        (lambda v, w: PVector.mult(v, 2), (2, 4, 6)),
        (lambda v, w: PVector.div(v, 2), (0.5, 1, 1.5)),
        (lambda v, w: PVector.lerp(v, w, 0.25), (1.75, 0.25, 3.75)),
        (lambda v, w: PVector.cross(v, w), (27, 6, -13)),
        (lambda v, w: v.cross(w), (27, 6, -13)),
        (lambda v, w: v + w, (5, -3, 9)),
        (lambda v, w: v - w, (-3, 7, -3)),
        (lambda v, w: v * 2, (2, 4, 6)),
        (lambda v, w: 2 * v, (2, 4, 6)),
        (lambda v, w: v / 2, (0.5, 1, 1.5)),
        (lambda v, w: -v, (-1, -2, -3)),
        (lambda v, w: v.copy(), (1, 2, 3)),
        (lambda v, w: v.get(), (1, 2, 3)),
        (lambda v, w: copy.deepcopy(v), (1, 2, 3)),
        (lambda v, w: v.normalize(PVector()).setMag(PVector(), 14**0.5), (1, 2, 3)),
    ],
)
def test_the_class_and_operators_make_a_new_vector(v, w, make, expected):
    result = make(v, w)

    assert tuple(result) == pytest.approx(expected)
    assert (tuple(v), tuple(w)) == ((1, 2, 3), (4, -5, 6))


@pytest.mark.parametrize(
    ("measured", "expected"),
    [
        (lambda v, w: v.mag(), 14**0.5),
        (lambda v, w: abs(v), 14**0.5),
        (lambda v, w: v.magSq(), 14.0),
        (lambda v, w: v.dot(w), 12.0),
        (lambda v, w: v.dot(1, 2, 3), 14.0),
        (lambda v, w: PVector.dot(v, w), 12.0),
        (lambda v, w: v.dist(w), 67**0.5),
        (lambda v, w: PVector.dist(v, w), 67**0.5),
        (lambda v, w: PVector.angleBetween(v, w), 1.1966405),
        (lambda v, w: PVector.angleBetween(v, PVector()), 0.0),
        (lambda v, w: PVector.angleBetween(PVector(1, 0), PVector(-2, 0)), math.pi),
        (lambda v, w: PVector(-1, 1).heading(), 2.3561945),
    ],
)
def test_measures_are_processings(v, w, measured, expected):
    assert measured(v, w) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("change", "other", "expected"),
    [
        (operator.iadd, PVector(4, -5, 6), (5, -3, 9)),
        (operator.isub, PVector(4, -5, 6), (-3, 7, -3)),
        (operator.imul, 2, (2, 4, 6)),
        (operator.itruediv, 2, (0.5, 1, 1.5)),
    ],
)
def test_operators_with_assignment_change_the_vector(v, change, other, expected):
    assert change(v, other) is v
    assert tuple(v) == expected


def test_a_target_takes_the_result_even_if_it_is_an_operand(v, w):
    result = PVector.sub(v, w, w)

    assert result is w
    assert tuple(w) == (-3, 7, -3)


@given(vectors, vectors)
def test_both_forms_of_add_agree(a, b):
    assert PVector.add(a, b) == a + b == a.copy().add(b)


@given(vectors, st.floats(0.1, 1e3))
def test_limit_never_leaves_a_longer_vector(v, maximum):
    assert v.limit(maximum).mag() <= maximum * (1 + 1e-12)


@given(vectors, vectors)
def test_cross_is_at_right_angles_to_both(a, b):
    product = a.cross(b)

    assert product.dot(a) == pytest.approx(0, abs=1e-4 * (1 + product.mag()))


def test_a_vector_is_a_sequence_of_three(v):
    assert (len(v), v[0], v[-1], [*v], v.array()) == (3, 1, 3, [1, 2, 3], [1, 2, 3])


def test_get_fills_a_list_as_far_as_it_goes(v):
    target = [0, 0]

    assert v.get(target) is target
    assert target == [1, 2]


def test_equal_components_make_equal_vectors(v):
    assert v == PVector(1, 2, 3)
    assert v != PVector(1, 2)
    assert v != (1, 2, 3)


def test_a_vector_cannot_be_a_key_for_it_can_change(v):
    with pytest.raises(TypeError, match="unhashable"):
        hash(v)


def test_text_is_processings_and_repr_makes_it_again(v):
    assert str(v) == "[ 1.0, 2.0, 3.0 ]"
    assert eval(repr(v)) == v


@pytest.mark.parametrize("other", [0.0, 1, (1, 2, 3), "x", None], ids=str)
def test_only_vectors_can_be_added(v, other):
    with pytest.raises(TypeError):
        v + other
    with pytest.raises(TypeError):
        other + v


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda v: v.add(3), "add() takes a PVector, or 2 or 3 numbers.\n    Got add(3)."),
        (lambda v: v.add(None), "add() takes a PVector, or 2 or 3 numbers.\n    Got add(None)."),
        (lambda v: v.mult(v), "mult() takes a number.\n    Got mult(PVector(1.0, 2.0, 3.0))."),
        (lambda v: v.div("2"), "div() takes a number.\n    Got div('2')."),
        (lambda v: v.lerp(1, 2, 3), "lerp() takes a PVector or 3 numbers, and an amount.\n"),
        (lambda v: v.dist(3), "dist() takes a PVector.\n"),
        (lambda v: v.cross(3), "cross() takes a PVector.\n"),
        (lambda v: v.dot(3), "dot() takes a PVector or 3 numbers.\n"),
        (lambda v: v.setMag("2"), "setMag() takes a length.\n"),
        (lambda v: PVector(v), "PVector() takes 2 or 3 numbers: x, y [, z].\n"),
        (lambda v: PVector.add(v, 3), "PVector.add() takes two PVectors.\n"),
        (lambda v: PVector.mult(3, v), "PVector.mult() takes a PVector first.\n"),
        (lambda v: PVector.angleBetween(v, 3), "angleBetween() takes two PVectors.\n"),
    ],
)
def test_wrong_arguments_are_told(v, call, message):
    with pytest.raises(SketchError) as caught:
        call(v)

    assert caught.value.message.startswith(message)


def test_a_students_own_kind_of_vector_works(v):
    class Boid(PVector):
        def __init__(self):
            super().__init__(1, 2)
            self.name = "a"

        def add(self, *args):
            self.name = "b"
            return super().add(*args)

    boid = Boid()

    boid.add(v)

    assert (boid.name, tuple(boid)) == ("b", (2, 4, 3))
    assert tuple(boid + v) == (3, 6, 6)


def test_random_vectors_follow_the_sketchs_seed():
    use_random(JavaRandom(3))

    flat = [PVector.random2D() for _ in range(4)]
    solid = [PVector.random3D(), PVector.random3D()]

    assert tuple(flat[0]) == pytest.approx((-0.11873917, -0.99292547, 0), abs=1e-7)
    assert tuple(flat[3]) == pytest.approx((0.34021908, -0.94034618, 0), abs=1e-7)
    assert tuple(solid[1]) == pytest.approx((0.11254348, -0.98221499, 0.15029192), abs=1e-7)


def test_random_and_from_angle_fill_a_target(v, w):
    assert PVector.random2D(v) is v
    assert PVector.random3D(v, object()) is v
    assert PVector.fromAngle(0, w) is w
    assert tuple(w) == (1, 0, 0)


@pytest.mark.parametrize("multiply", [operator.mul, operator.imul])
def test_two_vectors_have_no_product_as_in_python_mode(v, w, multiply):
    with pytest.raises(SketchError, match=r"a\.dot\(b\) is the dot product"):
        multiply(v, w)


def test_it_can_have_attributes_of_its_own(v):
    v.speed = 5

    assert v.speed == 5
    assert tuple(v.copy()) == tuple(v)


def test_a_method_of_one_vector_can_be_hidden_as_in_python_mode(v, w):
    v.add = 3
    w.add(v)

    assert v.add == 3
