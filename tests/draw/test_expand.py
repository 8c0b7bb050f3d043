"""Rows to vertices: which triangles a call of the sketch makes. Numbers by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.constants import (
    CENTER,
    CLOSE,
    MITER,
    P2D,
    P3D,
    PIE,
    QUADS,
    RADIUS,
    RGB,
    ROUND,
    SQUARE,
    TRIANGLES,
)
from sketchkit.draw.vertex import Layer
from tests.canvases import area, deep_canvas, drawn, draws, fills, flat_canvas, new_canvas, places

INSIDE = st.integers(5, 95)


def triangle_count(block):
    return len(block.indices) // 3


class TestFills:
    def test_rect_is_two_triangles(self, flat):
        flat.noStroke()
        flat.rect(10, 20, 30, 40)

        block = fills(flat)

        assert places(block) == [(10, 20), (40, 20), (40, 60), (10, 60)]
        assert block.indices.tolist() == [0, 1, 2, 2, 3, 0]

    def test_center_mode_spans_half_the_extent_each_side(self, flat):
        flat.noStroke()
        flat.rectMode(CENTER)
        flat.rect(50, 40, 30, 20)

        assert places(fills(flat)) == [(35, 30), (65, 30), (65, 50), (35, 50)]

    def test_each_rect_has_the_mode_it_was_drawn_in(self, flat):
        flat.noStroke()
        for mode in (RADIUS, CENTER, RADIUS):
            flat.rectMode(mode)
            flat.rect(50, 40, 10, 10)

        block = fills(flat)

        x = block.positions[block.indices, 0]  # in the order drawn, six corners each
        widths = np.ptp(x.reshape(3, 6), axis=1)
        assert widths.tolist() == [20, 10, 20]

    def test_fill_is_unpacked_to_rgba(self, flat):
        flat.noStroke()
        flat.fill(10, 20, 30, 40)
        flat.rect(0, 0, 5, 5)

        assert fills(flat).colors.tolist() == [[10, 20, 30, 40]] * 4

    def test_nothing_is_drawn_without_fill_and_stroke(self, flat):
        flat.noFill()
        flat.noStroke()
        flat.rect(10, 10, 20, 20)
        flat.circle(50, 50, 20)
        flat.line(0, 0, 9, 9)
        flat.point(5, 5)

        assert draws(drawn(flat)) == []

    def test_ellipse_is_a_fan_of_as_many_triangles_as_sides(self, flat):
        flat.noStroke()
        flat.circle(50, 50, 40)

        block = fills(flat)

        assert triangle_count(block) == 35  # int(2 pi 40 sqrt(2) / 10)
        assert places(block)[0] == (50, 50)

    def test_sides_of_an_ellipse_are_counted_on_the_screen(self, flat):
        flat.noStroke()
        flat.scale(2.5)
        flat.circle(20, 20, 40)

        assert triangle_count(fills(flat)) == 88  # as one of 100

    def test_far_circle_has_fewer_sides(self, deep):
        deep.noStroke()
        deep.translate(0, 0, -1000)
        deep.circle(50, 50, 40)

        assert triangle_count(fills(deep)) == 20

    def test_pie_covers_its_share_of_the_circle(self, flat):
        flat.noStroke()
        flat.arc(50, 50, 80, 80, 0, math.pi / 2, PIE)

        assert area(fills(flat)) == pytest.approx(math.pi * 40**2 / 4, rel=0.01)

    def test_vertex_colors_stay_with_their_vertices(self, flat):
        flat.noStroke()
        flat.beginShape(TRIANGLES)
        for red, (x, y) in enumerate([(0, 0), (9, 1), (3, 8)]):
            flat.fill(red, 0, 0)
            flat.vertex(x, y)
        flat.endShape()

        block = fills(flat)

        assert places(block) == [(0, 0), (9, 1), (3, 8)]
        assert block.colors[:, 0].tolist() == [0, 1, 2]

    def test_polygon_with_a_hole_covers_what_is_around_it(self, flat):
        flat.noStroke()
        flat.beginShape()
        for x, y in ((10, 10), (90, 10), (90, 90), (10, 90)):
            flat.vertex(x, y)
        flat.beginContour()
        for x, y in ((30, 30), (30, 70), (70, 70), (70, 30)):
            flat.vertex(x, y)
        flat.endContour()
        flat.endShape(CLOSE)

        assert area(fills(flat)) == pytest.approx(80 * 80 - 40 * 40)

    @given(st.lists(st.tuples(INSIDE, INSIDE), min_size=3, max_size=3))
    def test_triangle_covers_its_area(self, corners):
        canvas = flat_canvas()
        canvas.noStroke()
        canvas.rotate(0.001)  # not moved to whole pixels
        (ax, ay), (bx, by), (cx, cy) = corners
        canvas.triangle(ax, ay, bx, by, cx, cy)

        expected = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
        assert area(fills(canvas)) == pytest.approx(expected, abs=0.01)


class TestSnapping:
    """P2D moves shapes that lie along the axes to whole pixels, each corner up to the next."""

    def test_rect_moves_up_to_whole_pixels(self, flat):
        flat.noStroke()
        flat.rect(10.1, 20.5, 30, 40.2)

        assert places(fills(flat)) == [(11, 21), (41, 21), (41, 61), (11, 61)]

    def test_translation_and_scale_count_in(self, flat):
        flat.noStroke()
        flat.translate(0.25, 0)
        flat.scale(2)
        flat.rect(5, 5, 10, 10)

        assert places(fills(flat))[0] == (11, 10)

    def test_rotated_rect_stays(self, flat):
        flat.noStroke()
        flat.rotate(0.1)
        flat.rect(10.1, 20.5, 30, 40.2)

        assert all(x != round(x) for x, _ in places(fills(flat)))

    def test_rect_in_space_stays(self, deep):
        deep.noStroke()
        deep.rect(10.25, 20.5, 30, 40)

        block = fills(deep)

        assert block.positions[0, :2].tolist() == [10.25 - 50, 20.5 - 50]  # from the eye's axis

    def test_triangle_with_two_sides_along_the_axes_moves(self, flat):
        flat.noStroke()
        flat.triangle(10.5, 10.5, 30.5, 10.5, 10.5, 40.5)

        assert places(fills(flat)) == [(11, 11), (31, 11), (11, 41)]

    def test_triangle_aslant_stays(self, flat):
        flat.noStroke()
        flat.triangle(10.5, 10.5, 30.5, 12.5, 10.5, 40.5)

        assert places(fills(flat))[0] == (10.5, 10.5)

    def test_one_face_aslant_keeps_the_whole_shape(self, flat):
        flat.noStroke()
        flat.beginShape(QUADS)
        for x, y in ((1.5, 1.5), (9.5, 1.5), (9.5, 9.5), (1.5, 9.5)):
            flat.vertex(x, y)
        for x, y in ((21.5, 1.5), (29.5, 2.5), (29.5, 9.5), (21.5, 9.5)):
            flat.vertex(x, y)
        flat.endShape()

        assert places(fills(flat))[0] == (1.5, 1.5)

    @pytest.mark.parametrize("kind", [(), (QUADS,)], ids=["no kind", "QUADS"])
    def test_polygon_stays_and_quads_move(self, flat, kind):
        flat.noStroke()
        flat.beginShape(*kind)
        for x, y in ((1.5, 1.5), (9.5, 1.5), (9.5, 9.5), (1.5, 9.5)):
            flat.vertex(x, y)
        flat.endShape()

        expected = (2, 2) if kind else (1.5, 1.5)
        assert expected in places(fills(flat))

    def test_rounded_rect_stays(self, flat):
        flat.noStroke()
        flat.rect(10.5, 10.5, 30, 30, 0.0)

        assert (10.5, 10.5) in places(fills(flat))

    def test_line_of_weight_one_moves(self, flat):
        flat.line(20, 20, 60, 20)

        block = fills(flat)

        # Half a pixel either way, and beyond the ends, rounded up: row 20, columns 20 to 60.
        assert sorted(set(places(block))) == [(20, 20), (20, 21), (61, 20), (61, 21)]

    def test_line_of_weight_one_and_a_half_stays(self, flat):
        flat.strokeWeight(1.5)
        flat.line(20, 20, 60, 20)

        assert (19.25, 19.25) in places(fills(flat))


class TestStrokes:
    def test_outline_follows_its_fill_in_the_plane(self, flat):
        flat.fill(1, 0, 0)
        flat.stroke(2, 0, 0)
        flat.rect(10, 10, 20, 20)
        flat.fill(3, 0, 0)
        flat.stroke(4, 0, 0)
        flat.circle(60, 60, 20)

        block = fills(flat)

        reds = block.colors[block.indices, 0]
        changes = reds[np.flatnonzero(np.diff(reds, prepend=0))]
        assert changes.tolist() == [1, 2, 3, 4]

    def test_wide_outline_of_a_rect_is_a_frame(self, flat):
        flat.noFill()
        flat.strokeWeight(4)
        flat.stroke(0, 100)  # translucent: one outline, painted once
        flat.rect(20, 20, 40, 30)

        assert area(fills(flat)) == pytest.approx(44 * 34 - 36 * 26)

    def test_weight_zero_draws_no_stroke(self, flat):
        flat.strokeWeight(0)
        flat.noFill()
        flat.rect(20, 20, 40, 30)
        flat.line(0, 0, 50, 50)

        assert draws(drawn(flat)) == []

    def test_weight_is_scaled_with_the_matrix(self, flat):
        flat.strokeWeight(3)
        flat.strokeCap(SQUARE)
        flat.scale(2)
        flat.line(10, 20, 30, 20)

        assert area(fills(flat)) == pytest.approx(40 * 6)

    def test_stroke_in_space_keeps_its_weight_and_other_end(self, deep):
        deep.strokeWeight(6)
        deep.line(10, 20, 0, 30, 20, -40)

        block = drawn(deep).blocks[Layer.LINES]

        assert block.directions.tolist() == [
            [20, 0, -40, 3],
            [20, 0, -40, -3],
            [-20, 0, 40, -3],
            [-20, 0, 40, 3],
        ]

    def test_cap_and_join_change_nothing_in_space(self):
        blocks = []
        for cap, join in ((ROUND, MITER), (SQUARE, ROUND)):
            canvas = deep_canvas()
            canvas.strokeWeight(6)
            canvas.strokeCap(cap)
            canvas.strokeJoin(join)
            canvas.rect(10, 10, 20, 20)
            blocks.append(drawn(canvas).blocks[Layer.LINES])

        np.testing.assert_array_equal(blocks[0].positions, blocks[1].positions)

    def test_stroke_of_each_vertex_is_kept(self, flat):
        flat.noFill()
        flat.beginShape()
        for red, x in ((10, 10), (20, 40), (30, 70)):
            flat.stroke(red, 0, 0)
            flat.vertex(x, 50)
        flat.endShape()

        assert set(fills(flat).colors[:, 0].tolist()) == {10, 20, 30}

    def test_two_vertices_are_no_polygon(self, flat):
        flat.beginShape()
        flat.vertex(10, 10)
        flat.vertex(50, 50)
        flat.endShape()

        assert draws(drawn(flat)) == []


class TestPoints:
    def test_round_point_is_a_polygon_of_20_sides_or_more(self, flat):
        flat.strokeWeight(10)
        flat.point(50, 40)

        block = fills(flat)

        assert triangle_count(block) == 20
        assert area(block) == pytest.approx(math.pi * 25, rel=0.02)

    def test_square_cap_makes_square_points(self, flat):
        flat.strokeCap(SQUARE)
        flat.strokeWeight(10)
        flat.point(50, 40)

        assert area(fills(flat)) == 100

    def test_point_in_space_has_offsets_from_one_place(self, deep):
        deep.strokeCap(SQUARE)
        deep.strokeWeight(8)
        deep.point(60, 40, -10)

        block = drawn(deep).blocks[Layer.POINTS]

        assert len(set(places(block))) == 1
        assert block.offsets.tolist() == [[0, 0], [-4, -4], [4, -4], [4, 4], [-4, 4]]


class TestSolids:
    def test_box_is_twelve_triangles_and_six_rings(self, deep):
        deep.box(10)

        blocks = drawn(deep).blocks

        assert triangle_count(blocks[Layer.FILLS]) == 12
        assert triangle_count(blocks[Layer.LINES]) == 6 * 4 * 2

    def test_box_has_its_three_sizes(self, deep):
        deep.noStroke()
        deep.resetMatrix()
        deep.box(10, 20, 30)

        extent = np.ptp(fills(deep).positions, axis=0)

        assert extent.tolist() == [10, 20, 30]

    def test_sphere_has_the_detail_it_was_drawn_in(self, deep):
        deep.noStroke()
        for detail in (6, 12, 6):
            deep.sphereDetail(detail)
            deep.sphere(10)

        commands = drawn(deep)

        assert sum(draw.count for draw in draws(commands)) == 3 * 2 * (6 * 5 + 12 * 11 + 6 * 5)


class TestImages:
    def test_image_covers_its_own_size_with_the_whole_texture(self, flat):
        flat.image(flat.createImage(8, 4, RGB), 10, 20)

        block = fills(flat)

        assert places(block) == [(10, 20), (10, 24), (18, 24), (18, 20)]
        assert block.uvs.tolist() == [[0, 0], [0, 1], [1, 1], [1, 0]]

    def test_part_of_an_image_is_a_part_of_its_texture(self, flat):
        flat.image(flat.createImage(8, 4, RGB), 10, 20, 16, 16, 2, 1, 6, 4)

        assert fills(flat).uvs.tolist() == [[0.25, 0.25], [0.25, 1], [0.75, 1], [0.75, 0.25]]

    def test_tint_is_the_color_of_an_image_and_fill_is_not(self, flat):
        picture = flat.createImage(8, 4, RGB)
        flat.fill(255, 0, 0)
        flat.tint(0, 100, 200, 50)
        flat.image(picture, 0, 0)

        assert fills(flat).colors[0].tolist() == [0, 100, 200, 50]

    @pytest.mark.parametrize("renderer", [P2D, P3D], ids=["P2D", "P3D"])
    def test_flat_shapes_beside_an_image_have_no_texture(self, renderer):
        canvas = new_canvas(renderer)
        canvas.noStroke()
        canvas.rect(0, 0, 5, 5)
        canvas.image(canvas.createImage(8, 4, RGB), 10, 20)
        canvas.rect(0, 0, 5, 5)

        textures = [draw.pipeline.texture is not None for draw in draws(drawn(canvas))]

        assert textures == [False, True, False]
