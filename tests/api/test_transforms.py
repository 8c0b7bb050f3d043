"""The current matrix: numbers by hand, and how transforms compose."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.api.pmatrix import PMatrix2D
from sketchkit.core.constants import JAVA2D
from sketchkit.core.errors import SketchError
from tests.canvases import deep_canvas, flat_canvas, new_canvas

numbers = st.floats(-100, 100)
angles = st.floats(-7, 7)
factors = st.floats(0.1, 10)
close = {"rel": 1e-6, "abs": 1e-6}


def place(canvas, x, y, z=0.0):
    """Return where the matrix puts a point."""
    m = canvas.getMatrix()
    return (
        m.m00 * x + m.m01 * y + m.m02 * z + m.m03,
        m.m10 * x + m.m11 * y + m.m12 * z + m.m13,
        m.m20 * x + m.m21 * y + m.m22 * z + m.m23,
    )


@pytest.mark.parametrize(
    ("transform", "expected"),
    [
        (lambda g: g.translate(10, 20), (13, 24, 5)),
        (lambda g: g.translate(10, 20, 30), (13, 24, 35)),
        (lambda g: g.scale(2), (6, 8, 10)),
        (lambda g: g.scale(2, 3), (6, 12, 5)),
        (lambda g: g.scale(2, 3, 4), (6, 12, 20)),
        (lambda g: g.rotate(math.pi / 2), (-4, 3, 5)),
        (lambda g: g.rotateZ(math.pi / 2), (-4, 3, 5)),
        (lambda g: g.rotateX(math.pi / 2), (3, -5, 4)),
        (lambda g: g.rotateY(math.pi / 2), (5, 4, -3)),
        (lambda g: g.rotate(math.pi / 2, 0, 0, 9), (-4, 3, 5)),
        (lambda g: g.rotate(math.tau / 3, 1, 1, 1), (5, 3, 4)),
        (lambda g: g.shearX(math.pi / 4), (7, 4, 5)),
        (lambda g: g.shearY(math.pi / 4), (3, 7, 5)),
        (lambda g: g.applyMatrix(1, 2, 3, 4, 5, 6), (14, 38, 5)),
        (lambda g: g.applyMatrix(1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9, 0, 0, 0, 1), (10, 12, 14)),
    ],
)
def test_transform_moves_the_point_3_4_5(flat, transform, expected):
    transform(flat)

    assert place(flat, 3, 4, 5) == pytest.approx(expected)


def test_what_is_applied_last_reaches_the_point_first(flat):
    flat.translate(10, 0)
    flat.scale(2)

    assert place(flat, 3, 0) == (16, 0, 0)


@given(numbers, numbers, numbers, numbers)
def test_two_translations_are_their_sum(a, b, c, d):
    canvas = flat_canvas()
    canvas.translate(a, b)
    canvas.translate(c, d)

    assert place(canvas, 0, 0) == pytest.approx((a + c, b + d, 0), **close)


@given(angles, angles, numbers, numbers)
def test_two_rotations_are_their_sum(first, second, x, y):
    stepwise, at_once = flat_canvas(), flat_canvas()
    stepwise.rotate(first)
    stepwise.rotate(second)
    at_once.rotate(first + second)

    assert place(stepwise, x, y) == pytest.approx(place(at_once, x, y), rel=1e-4, abs=1e-4)


@given(st.sampled_from(["rotateX", "rotateY", "rotateZ"]), angles, numbers, numbers, numbers)
def test_rotation_keeps_lengths(name, angle, x, y, z):
    canvas = flat_canvas()
    getattr(canvas, name)(angle)

    assert math.hypot(*place(canvas, x, y, z)) == pytest.approx(math.hypot(x, y, z), **close)


@given(angles, factors, numbers, numbers)
def test_undoing_in_reverse_order_leads_back(angle, factor, x, y):
    canvas = flat_canvas()
    canvas.translate(x, y)
    canvas.rotate(angle)
    canvas.scale(factor)
    canvas.scale(1 / factor)
    canvas.rotate(-angle)
    canvas.translate(-x, -y)

    assert place(canvas, 7, -9) == pytest.approx((7, -9, 0), abs=1e-3)


@given(angles)
def test_axis_may_have_any_length(angle):
    canvas, other = flat_canvas(), flat_canvas()
    canvas.rotate(angle, 1, -2, 3)
    other.rotate(angle, 20, -40, 60)

    assert place(canvas, 3, 4, 5) == pytest.approx(place(other, 3, 4, 5), **close)


class TestStack:
    def test_pop_goes_back_to_the_push(self, flat):
        flat.translate(5, 6)
        flat.pushMatrix()
        flat.rotate(1)
        flat.popMatrix()

        assert place(flat, 0, 0) == (5, 6, 0)

    def test_block_goes_back_by_itself(self, flat):
        with flat.pushMatrix():
            flat.translate(5, 6)

        assert place(flat, 0, 0) == (0, 0, 0)

    def test_push_and_pop_do_matrix_and_style(self, flat):
        with flat.push():
            flat.translate(5, 6)
            flat.fill(1)

        assert place(flat, 0, 0) == (0, 0, 0)

    def test_pop_without_push_is_refused(self, flat):
        with pytest.raises(SketchError, match=r"popMatrix\(\) without pushMatrix\(\)"):
            flat.popMatrix()

    def test_pop_of_both_without_push_is_refused(self, flat):
        with pytest.raises(SketchError, match=r"without push"):
            flat.pop()

    def test_32_may_be_put_aside_and_no_more(self, flat):
        for _ in range(32):
            flat.pushMatrix()

        with pytest.raises(SketchError, match=r"pushMatrix\(\) was called 32 times"):
            flat.pushMatrix()

    def test_next_frame_begins_without_transforms_and_with_an_empty_stack(self, flat):
        flat.translate(5, 6)
        flat.pushMatrix()
        flat.end_frame()
        flat.begin_frame()

        assert place(flat, 0, 0) == (0, 0, 0)
        with pytest.raises(SketchError):
            flat.popMatrix()


def test_reset_puts_the_origin_at_the_eye(deep):
    deep.translate(5, 6)
    deep.resetMatrix()

    assert place(deep, 1, 2, 3) == (1, 2, 3)


def test_matrix_that_was_got_can_be_set(deep):
    deep.rotateY(0.5)
    kept = deep.getMatrix()
    deep.translate(9, 9)
    deep.setMatrix(kept)

    assert place(deep, 1, 2, 3) == pytest.approx(place_after(lambda g: g.rotateY(0.5), 1, 2, 3))


def place_after(transform, *point):
    canvas = deep_canvas()
    transform(canvas)
    return place(canvas, *point)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.translate("5", 6), r"translate\(\) takes 2 or 3 numbers"),
        (lambda g: g.rotate(None), r"rotate\(\) takes 1 or 4 numbers"),
        (lambda g: g.rotateX("1"), r"rotateX\(\) takes 1 number"),
        (lambda g: g.scale("2"), r"scale\(\) takes 1, 2 or 3 numbers"),
        (lambda g: g.shearX([1]), r"shearX\(\) takes 1 number"),
        (lambda g: g.applyMatrix(1, 2, 3), r"applyMatrix\(\) takes a PMatrix, or 6 or 16 numbers"),
    ],
)
def test_what_is_no_number_is_refused(flat, call, message):
    with pytest.raises(SketchError, match=message):
        call(flat)


def test_matrix_of_java2d_is_one_of_the_plane() -> None:
    canvas = new_canvas(JAVA2D)
    canvas.translate(40, 20)

    matrix = canvas.getMatrix()

    assert isinstance(matrix, PMatrix2D)
    assert (matrix.m02, matrix.m12) == (40, 20)


def test_getMatrix_fills_a_plane_matrix_where_there_is_no_depth() -> None:
    canvas = flat_canvas()
    canvas.translate(40, 20)
    matrix = PMatrix2D()

    assert canvas.getMatrix(matrix) is matrix
    assert (matrix.m02, matrix.m12) == (40, 20)


def test_plane_matrix_has_no_room_for_that_of_p3d() -> None:
    with pytest.raises(SketchError, match=r"getMatrix\(\) fills a PMatrix3D"):
        deep_canvas().getMatrix(PMatrix2D())


def test_resetMatrix_drops_the_camera_until_popMatrix() -> None:
    canvas = deep_canvas()

    canvas.pushMatrix()
    canvas.resetMatrix()
    without = canvas.modelX(1, 2, 3)
    canvas.popMatrix()
    canvas.translate(10, 0)

    assert without == 1  # measured with Processing: the camera is the identity as well
    assert canvas.modelX(1, 2, 3) == pytest.approx(11)
