"""Camera, projections; numbers measured on Processing 4 where they are not plain."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.constants import (
    P3D,
)
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.canvases import deep_canvas, new_canvas, pipeline_of

inside = st.floats(-200, 300)


class TestDefault:
    @given(inside, inside)
    def test_point_at_depth_zero_lies_on_its_own_pixel(self, x, y):
        canvas = deep_canvas()

        assert canvas.screenX(x, y) == pytest.approx(x, abs=1e-3)
        assert canvas.screenY(x, y) == pytest.approx(y, abs=1e-3)

    def test_depth_of_the_canvas(self, deep):
        assert deep.screenZ(50, 50, 0) == pytest.approx(0.909, abs=1e-3)

    def test_projection_of_another_shape_of_canvas(self):
        canvas = new_canvas(P3D, size=(240, 200))

        projection = pipeline_of(canvas).projection

        assert projection[0] == pytest.approx(1.4434, abs=1e-4)
        assert projection[5] == pytest.approx(-1.7321, abs=1e-4)

    def test_what_is_farther_is_nearer_to_the_middle(self, deep):
        eye = 50 * math.sqrt(3)

        # Twice as far from the eye: half as far from the middle.
        assert deep.screenX(90, 50, -eye) == pytest.approx(70, abs=1e-3)

    def test_flat_canvas_has_a_pixel_for_a_pixel(self, flat):
        assert flat.screenX(30, 70) == pytest.approx(30, abs=1e-5)
        assert flat.screenY(30, 70) == pytest.approx(70, abs=1e-5)


class TestCamera:
    def test_looks_at_its_centre(self, deep):
        deep.camera(70, -60, 120, 10, 20, 30, 0, 1, 0)

        assert deep.screenX(10, 20, 30) == pytest.approx(50)
        assert deep.screenY(10, 20, 30) == pytest.approx(50)

    def test_up_runs_down_the_picture(self, deep):
        deep.camera(0, 0, 100, 0, 0, 0, 1, 0, 0)

        assert deep.screenY(20, 0, 0) > 50
        assert deep.screenX(20, 0, 0) == pytest.approx(50)

    def test_without_numbers_goes_back(self, deep):
        deep.camera(0, 0, 100, 0, 0, 0, 1, 0, 0)
        deep.camera()

        assert deep.screenX(30, 70) == pytest.approx(30, abs=1e-3)

    def test_stays_from_frame_to_frame(self, deep):
        deep.camera(0, 0, 100, 0, 0, 0, 0, 1, 0)
        deep.translate(20, 0)
        deep.end_frame()
        deep.begin_frame()

        assert deep.screenX(0, 0, 0) == pytest.approx(50)

    def test_is_moved_by_transforms_between_begin_and_end(self, deep):
        with deep.beginCamera():
            deep.translate(10, 0)

        assert deep.screenX(30, 70) == pytest.approx(40, abs=1e-3)
        assert deep.modelX(30, 70) == pytest.approx(30, abs=1e-3)

    def test_takes_what_was_transformed_before_into_it(self, deep):
        deep.translate(5, 0)
        with deep.beginCamera():
            deep.translate(10, 0)
        deep.end_frame()
        deep.begin_frame()

        assert deep.screenX(30, 70) == pytest.approx(45, abs=1e-3)

    def test_model_place_is_without_the_camera(self, deep):
        deep.camera(70, -60, 120, 10, 20, 30, 0, 1, 0)
        deep.translate(1, 2, 3)
        deep.rotateZ(math.pi / 2)

        place = deep.modelX(5, 0, 0), deep.modelY(5, 0, 0), deep.modelZ(5, 0, 0)

        assert place == pytest.approx((1, 7, 3), abs=1e-4)

    @pytest.mark.parametrize("count", [1, 8, 10])
    def test_takes_nine_numbers_or_none(self, deep, count):
        with pytest.raises(SketchError, match=r"camera\(\) takes 9 numbers"):
            deep.camera(*range(count))

    def test_eye_at_its_own_centre_draws_nothing_amiss(self, deep):
        deep.camera(1, 2, 3, 1, 2, 3, 0, 1, 0)
        deep.lights()
        deep.box(20)
        deep.ortho()
        deep.sphere(5)

        deep.end_frame()

        assert math.isfinite(deep.screenX(1, 2))


@pytest.mark.parametrize("name", ["screenX", "screenY", "screenZ", "modelX", "modelY", "modelZ"])
def test_place_that_is_no_number_is_named(deep, name):
    with pytest.raises(SketchError, match=rf"{name}\(\) takes 2 or 3 numbers") as caught:
        getattr(deep, name)("a", 2)

    assert "text for x" in str(caught.value)


class TestProjections:
    def test_ortho_keeps_sizes_at_every_depth(self, deep):
        deep.ortho()

        for z in (0, -80, 60):
            assert deep.screenX(30, 70, z) == pytest.approx(30, abs=1e-3)
            assert deep.screenY(30, 70, z) == pytest.approx(70, abs=1e-3)

    def test_ortho_by_its_sides(self, deep):
        deep.ortho(-10, 30, -8, 24)

        projection = pipeline_of(deep).projection

        assert projection[0] == pytest.approx(0.05)
        assert projection[3] == pytest.approx(-0.5)
        assert projection[5] == pytest.approx(-0.0625)
        assert projection[7] == pytest.approx(-0.5)

    def test_frustum_by_its_window(self, deep):
        deep.frustum(-10, 30, -8, 24, 40, 1200)

        projection = pipeline_of(deep).projection

        assert projection[2] == pytest.approx(0.5)
        assert projection[6] == pytest.approx(0.5)
        assert projection[5] == pytest.approx(-2.5)

    def test_perspective_opens_by_its_angle(self, deep):
        deep.perspective(math.pi / 2, 2, 1, 100)

        projection = pipeline_of(deep).projection

        assert projection[5] == pytest.approx(-1)  # tan(45 degrees)
        assert projection[0] == pytest.approx(0.5)

    @pytest.mark.parametrize("angle_and_aspect", [(0, 1), (1, 0)])
    def test_lens_without_an_angle_or_a_width_shows_nothing(self, backend, angle_and_aspect):
        canvas = new_canvas(P3D, backend)
        canvas.background(204)

        with pytest.warns(SketchWarning, match="shows nothing"):
            canvas.perspective(*angle_and_aspect, 10, 1000)
        canvas.translate(50, 50)
        canvas.box(30)
        canvas.line(0, 0, 20, 20)

        assert set(canvas.get().pixels) == {0xFFCCCCCC}

    def test_projection_stays_from_frame_to_frame(self, deep):
        deep.ortho()
        before = pipeline_of(deep).projection
        deep.begin_frame()

        assert pipeline_of(deep).projection == before

    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda g: g.perspective(1, 2), r"perspective\(\) takes"),
            (lambda g: g.perspective(1, "2", 3, 4), r"perspective\(\) takes"),
            (lambda g: g.ortho(1, 2, 3), r"ortho\(\) takes"),
            (lambda g: g.frustum(-1, 1, -1, 1, "2", 3), r"frustum\(\) takes 6 numbers"),
            (lambda g: g.frustum(1, 1, -1, 1, 2, 3), r"frustum\(\) needs sides"),
            (lambda g: g.frustum(-1, 1, -1, 1, 2, 2), r"frustum\(\) needs sides"),
            (lambda g: g.ortho(5, 5, 0, 1), r"ortho\(\) needs sides"),
            (lambda g: g.ortho(0, 1, 0, 1, 7, 7), r"ortho\(\) needs sides"),
            (lambda g: g.perspective(1, 1, 5, 5), r"perspective\(\) needs .* a far beyond it"),
        ],
    )
    def test_wrong_numbers_are_refused(self, deep, call, message):
        with pytest.raises(SketchError, match=message):
            call(deep)

    @pytest.mark.parametrize("name", ["perspective", "ortho"])
    def test_flat_canvas_says_that_it_has_none(self, flat, name):
        with pytest.warns(SketchWarning, match=rf"{name}\(\) works only in P3D"):
            getattr(flat, name)()
