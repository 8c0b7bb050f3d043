"""beginShape() to endShape(): what belongs where."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import CLOSE, IMAGE, LINES, NORMAL, QUADS, REPEAT, RGB, TRIANGLES
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.resources import Wrap
from tests.canvases import drawn, draws, fills, places

TRIANGLE = ((10, 10), (50, 12), (20, 40))


def draw_triangle(canvas, kind=TRIANGLES, mode=None):
    canvas.beginShape(kind)
    for x, y in TRIANGLE:
        canvas.vertex(x, y)
    canvas.endShape(mode)


class TestOutsideOfAShape:
    @pytest.mark.parametrize(
        ("name", "arguments"),
        [
            ("vertex", (1, 2)),
            ("vertex", (1, 2, 3, 4, 5)),
            ("bezierVertex", (1, 2, 3, 4, 5, 6)),
            ("quadraticVertex", (1, 2, 3, 4)),
            ("curveVertex", (1, 2)),
            ("beginContour", ()),
            ("endContour", ()),
        ],
    )
    def test_call_belongs_between_begin_and_end(self, flat, name, arguments):
        with pytest.raises(SketchError) as caught:
            getattr(flat, name)(*arguments)

        assert f"{name}() belongs between beginShape() and endShape()" in str(caught.value)

    def test_end_without_begin_is_refused(self, flat):
        with pytest.raises(SketchError, match=r"endShape\(\) without beginShape\(\)"):
            flat.endShape()

    def test_vertex_after_the_end_is_refused(self, flat):
        draw_triangle(flat)

        with pytest.raises(SketchError, match=r"vertex\(\) belongs between"):
            flat.vertex(1, 2)


class TestWithinAShape:
    def test_second_begin_is_refused(self, flat):
        flat.beginShape()

        with pytest.raises(SketchError, match=r"beginShape\(\) inside of a shape"):
            flat.beginShape()

    def test_unknown_kind_is_refused(self, flat):
        with pytest.raises(SketchError, match=r"beginShape\(\) takes .*TRIANGLES"):
            flat.beginShape(99)

    def test_unknown_end_leaves_it_open(self, flat):
        flat.beginShape()

        with pytest.warns(SketchWarning, match=r"endShape\(\) takes CLOSE or nothing; 99"):
            flat.endShape(99)

    def test_contour_in_a_contour_is_refused(self, flat):
        flat.beginShape()
        flat.beginContour()

        with pytest.raises(SketchError, match=r"beginContour\(\) inside of a contour"):
            flat.beginContour()

    def test_end_of_no_contour_is_refused(self, flat):
        flat.beginShape()

        with pytest.raises(SketchError, match=r"endContour\(\) without beginContour\(\)"):
            flat.endContour()

    @pytest.mark.parametrize(
        ("name", "arguments"), [("bezierVertex", range(6)), ("quadraticVertex", range(4))]
    )
    def test_curve_needs_a_vertex_to_start_from(self, flat, name, arguments):
        flat.beginShape()

        with pytest.raises(SketchError, match="needs a vertex to start from"):
            getattr(flat, name)(*arguments)

    @pytest.mark.parametrize(
        ("name", "arguments"),
        [("bezierVertex", range(6)), ("quadraticVertex", range(4)), ("curveVertex", range(2))],
    )
    def test_curve_belongs_into_a_shape_without_a_kind(self, flat, name, arguments):
        flat.beginShape(LINES)
        flat.vertex(0, 0)

        with pytest.raises(SketchError, match="without a kind"):
            getattr(flat, name)(*arguments)

    @pytest.mark.parametrize("arguments", [("1", 2), (1, None), (1, 2, 3, 4, 5, 6), (1, 2, "3")])
    def test_vertex_refuses_what_is_no_place(self, flat, arguments):
        flat.beginShape()

        with pytest.raises(SketchError, match=r"vertex\(\) takes 2, 3, 4 or 5 numbers"):
            flat.vertex(*arguments)

    def test_curve_with_a_number_missing_is_refused(self, flat):
        flat.beginShape()
        flat.vertex(0, 0)

        with pytest.raises(SketchError, match=r"bezierVertex\(\) takes 6 or 9 numbers"):
            flat.bezierVertex(1, 2, 3, 4, 5)


def test_block_ends_the_shape(flat):
    flat.noStroke()
    with flat.beginShape(TRIANGLES):
        for x, y in TRIANGLE:
            flat.vertex(x, y)

    assert places(fills(flat)) == list(TRIANGLE)


def test_shape_without_vertices_draws_nothing(flat):
    flat.beginShape()
    flat.endShape(CLOSE)

    assert draws(drawn(flat)) == []


@pytest.mark.parametrize(("mode", "segments"), [(None, 2), (CLOSE, 3)], ids=["open", "CLOSE"])
def test_close_draws_the_outline_back(flat, mode, segments):
    flat.noFill()
    flat.beginShape()
    for x, y in TRIANGLE:
        flat.vertex(x, y)
    flat.endShape(mode)

    assert len(fills(flat).positions) == 4 * segments


def test_four_numbers_are_a_place_and_texture_coordinates(flat):
    picture = flat.createImage(10, 20, RGB)
    flat.noStroke()
    flat.beginShape(TRIANGLES)
    flat.texture(picture)
    for (x, y), (u, v) in zip(TRIANGLE, ((0, 0), (5, 0), (10, 20)), strict=True):
        flat.vertex(x, y, u, v)
    flat.endShape()

    assert fills(flat).uvs.tolist() == [[0, 0], [0.5, 0], [1, 1]]


def test_five_numbers_have_a_depth_too(deep):
    picture = deep.createImage(10, 20, RGB)
    deep.resetMatrix()
    deep.noStroke()
    deep.textureMode(NORMAL)
    deep.beginShape(TRIANGLES)
    deep.texture(picture)
    for x, y in TRIANGLE:
        deep.vertex(x, y, -7, 0.25, 0.75)
    deep.endShape()

    block = fills(deep)

    assert block.positions[:, 2].tolist() == [-7] * 3
    assert block.uvs.tolist() == [[0.25, 0.75]] * 3


def test_texture_mode_is_that_of_the_vertex(flat):
    picture = flat.createImage(10, 20, RGB)
    flat.noStroke()
    flat.beginShape(TRIANGLES)
    flat.texture(picture)
    for mode, (x, y) in zip((NORMAL, IMAGE, NORMAL), TRIANGLE, strict=True):
        flat.textureMode(mode)
        flat.vertex(x, y, 1, 1)
    flat.endShape()

    u = fills(flat).uvs[:, 0]

    assert u.tolist() == pytest.approx([1, 0.1, 1])


def test_texture_coordinates_without_a_texture_are_ignored(flat):
    flat.noStroke()
    flat.beginShape(TRIANGLES)
    for x, y in TRIANGLE:
        flat.vertex(x, y, 1, 1)
    flat.endShape()

    block = fills(flat)

    assert places(block) == list(TRIANGLE)
    assert block.uvs is None


def test_texture_takes_an_image(flat):
    flat.beginShape()

    with pytest.raises(SketchError, match=r"texture\(\) takes an image"):
        flat.texture("photo.png")


def test_texture_wrap_goes_along(flat):
    picture = flat.createImage(4, 4, RGB)
    flat.textureWrap(REPEAT)
    flat.image(picture, 0, 0)

    (draw,) = draws(drawn(flat))

    assert draw.pipeline.wrap is Wrap.REPEAT


class TestNormals:
    def test_shape_without_normals_gets_one_for_each_face(self, deep):
        deep.lights()
        deep.noStroke()
        deep.beginShape(QUADS)
        for x, y, z in ((0, 0, 0), (9, 0, 0), (9, 9, 9), (0, 9, 9)):  # leans back by 45 degrees
            deep.vertex(x, y, z)
        deep.endShape()

        normals = fills(deep).normals

        for normal in normals.tolist():
            assert normal == pytest.approx([0, -(0.5**0.5), 0.5**0.5], abs=1e-6)

    def test_one_normal_holds_for_the_vertices_after_it(self, deep):
        deep.lights()
        deep.noStroke()
        deep.beginShape(TRIANGLES)
        deep.vertex(0, 0)
        deep.normal(1, 0, 0)
        deep.vertex(9, 0)
        deep.vertex(0, 9)
        deep.endShape()

        assert fills(deep).normals.tolist() == [[0, 0, 1], [1, 0, 0], [1, 0, 0]]

    def test_each_shape_starts_afresh(self, deep):
        deep.lights()
        deep.noStroke()
        deep.normal(1, 0, 0)
        draw_triangle(deep)

        assert fills(deep).normals.tolist() == [[0, 0, 1]] * 3

    def test_normal_holds_for_flat_shapes_that_follow(self, deep):
        deep.lights()
        deep.noStroke()
        deep.normal(0, 1, 0)
        deep.rect(0, 0, 9, 9)

        assert fills(deep).normals.tolist() == [[0, 1, 0]] * 4
