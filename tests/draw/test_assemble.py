"""The draw list: which draws, in which order, with what vertices."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import (
    ADD,
    DISABLE_DEPTH_TEST,
    ENABLE_DEPTH_SORT,
    ENABLE_STROKE_PERSPECTIVE,
    QUADS,
    RGB,
)
from sketchkit.draw.commands import Clear, Draw, Settle, Settling
from sketchkit.draw.layers import unpack_argb
from sketchkit.draw.pipeline import Blend, Clip, Program
from sketchkit.draw.vertex import Layer
from tests.canvases import drawn, draws, fills


def layers(commands):
    return [draw.layer for draw in draws(commands)]


def test_packed_colors_become_red_green_blue_alpha():
    packed = np.array([0x80FF4020, 0xFF000001])

    assert unpack_argb(packed).tolist() == [[0xFF, 0x40, 0x20, 0x80], [0, 0, 1, 0xFF]]


class TestOrder:
    def test_space_draws_fills_then_strokes_then_points(self, deep):
        deep.point(10, 10)
        deep.line(0, 0, 50, 50)
        deep.rect(10, 10, 20, 20)

        assert layers(drawn(deep)) == [Layer.FILLS, Layer.LINES, Layer.POINTS]

    def test_plane_draws_everything_as_it_comes(self, flat):
        flat.point(10, 10)
        flat.line(0, 0, 50, 50)
        flat.rect(10, 10, 20, 20)

        assert layers(drawn(flat)) == [Layer.FILLS]

    def test_each_section_of_space_draws_its_own_strokes(self, deep):
        deep.rect(10, 10, 20, 20)
        deep.hint(DISABLE_DEPTH_TEST)
        deep.rect(10, 10, 20, 20)

        assert layers(drawn(deep)) == [Layer.FILLS, Layer.LINES] * 2

    def test_sorted_fills_come_after_strokes(self, deep):
        deep.hint(ENABLE_DEPTH_SORT)
        deep.rect(10, 10, 20, 20)

        assert layers(drawn(deep)) == [Layer.LINES, Layer.FILLS]

    def test_sorted_fills_go_from_far_to_near(self, deep):
        deep.noStroke()
        deep.hint(ENABLE_DEPTH_SORT)
        for z in (0, -50, 20, -20):
            deep.beginShape(QUADS)
            for x, y in ((10, 10), (60, 10), (60, 60), (10, 60)):
                deep.vertex(x, y, z)
            deep.endShape()

        block = fills(deep)

        depths = block.positions[block.indices, 2].reshape(-1, 3)[:, 0]
        assert (np.diff(depths) >= 0).all()
        assert len(depths) == 8

    def test_rows_of_alternating_kinds_keep_their_order(self, flat):
        flat.noStroke()
        for red in range(6):
            flat.fill(red, 0, 0)
            (flat.circle if red % 2 else flat.square)(50, 50, 20)

        block = fills(flat)

        reds = block.colors[block.indices, 0]
        assert (np.diff(reds.astype(int)) >= 0).all()


class TestMerging:
    def test_draws_that_are_alike_are_one(self, flat):
        for i in range(5):
            flat.fill(40 * i)
            flat.strokeWeight(i)
            flat.translate(2, 3)
            flat.rect(10, 10, 20, 20)

        assert len(draws(drawn(flat))) == 1

    def test_another_texture_begins_a_draw(self, flat):
        first, second = (flat.createImage(4, 4, RGB) for _ in range(2))
        for picture in (first, first, second, first):
            flat.image(picture, 0, 0)

        textures = [draw.pipeline.texture for draw in draws(drawn(flat))]

        assert textures == [picture._texture() for picture in (first, second, first)]

    def test_draws_follow_each_other_without_gap(self, flat):
        flat.rect(10, 10, 20, 20)
        flat.blendMode(ADD)
        flat.rect(10, 10, 20, 20)
        commands = drawn(flat)

        first, second = draws(commands)

        assert first.first == 0
        assert second.first == first.count
        assert second.first + second.count == len(commands.blocks[Layer.FILLS].indices)


class TestWholeTarget:
    def test_background_takes_the_place_of_the_old_picture(self, flat):
        flat.background(10, 20, 30)

        commands = drawn(flat).commands

        assert commands[-1] == Clear(flat.target, (10, 20, 30, 255), depth=True)
        assert not any(isinstance(command, Settle) for command in commands)

    def test_frame_without_background_keeps_the_old_picture(self, flat):
        flat.rect(10, 10, 20, 20)

        kinds = [type(command) for command in drawn(flat).commands]

        assert kinds[-2:] == [Settle, Draw]

    def test_first_frame_keeps_the_picture_as_it_is(self, flat):
        settles = [c for c in drawn(flat).commands if isinstance(c, Settle)]

        assert [settle.how for settle in settles] == [Settling.KEEP]

    def test_background_between_shapes_stays_between(self, flat):
        flat.rect(10, 10, 20, 20)
        flat.background(0)
        flat.rect(10, 10, 20, 20)

        kinds = [type(command) for command in drawn(flat).commands]

        assert kinds[-3:] == [Draw, Clear, Draw]

    def test_nothing_drawn_makes_no_list(self, flat):
        drawn(flat)

        assert drawn(flat).commands == []


class TestPipelines:
    def test_lights_are_for_fills_alone(self, deep):
        deep.lights()
        deep.point(20, 20)
        deep.box(20)

        programs = [draw.pipeline.program for draw in draws(drawn(deep))]

        assert programs == [Program.LIT, Program.LINE, Program.POINT]

    @pytest.mark.parametrize("is_lit", [False, True], ids=["unlit", "lit"])
    def test_image_has_a_program_of_its_own(self, deep, is_lit):
        if is_lit:
            deep.lights()
        deep.image(deep.createImage(4, 4, RGB), 0, 0)

        (draw,) = draws(drawn(deep))

        expected = Program.TEXTURED_LIT if is_lit else Program.TEXTURED
        assert draw.pipeline.program is expected

    def test_plane_has_no_depth_and_space_has(self, flat, deep):
        tests = []
        for canvas in (flat, deep):
            canvas.noStroke()
            canvas.rect(0, 0, 9, 9)
            (draw,) = draws(drawn(canvas))
            tests.append(draw.pipeline.depth_test)

        assert tests == [False, True]

    def test_blend_mode_and_clip_go_along(self, flat):
        flat.blendMode(ADD)
        flat.clip(10, 20, 30, 40)
        flat.rect(0, 0, 9, 9)

        (draw,) = draws(drawn(flat))

        assert draw.pipeline.blend is Blend.ADD
        assert draw.pipeline.clip == Clip(10, 20, 30, 40)

    @pytest.mark.parametrize(
        ("parallel", "pull"), [(False, (0.999, 0.999, 0.999)), (True, (1, 1, 0.999))]
    )
    def test_strokes_are_pulled_toward_the_eye(self, deep, parallel, pull):
        if parallel:
            deep.ortho()
        deep.line(0, 0, 50, 50)

        (draw,) = draws(drawn(deep))

        assert draw.pipeline.line_scale == pull

    def test_stroke_perspective_goes_along(self, deep):
        deep.hint(ENABLE_STROKE_PERSPECTIVE)
        deep.line(0, 0, 50, 50)

        (draw,) = draws(drawn(deep))

        assert draw.pipeline.stroke_perspective


class TestVertices:
    def test_positions_are_in_eye_space(self, deep):
        deep.noStroke()
        deep.translate(30, 0, -5)
        deep.rect(20, 50, 10, 10)

        x, y, z = fills(deep).positions[0]

        assert (x, y) == (0, 0)  # the middle of the canvas
        assert z == pytest.approx(-5 - 50 * np.sqrt(3))  # the eye is 86.6 before it

    def test_normals_turn_by_the_inverse_transpose(self, deep):
        deep.lights()
        deep.noStroke()
        deep.scale(2, 1, 1)
        deep.normal(1, 1, 0)
        deep.rect(0, 0, 9, 9)

        x, y, z = fills(deep).normals[0]

        assert (x / y, z) == (0.5, 0)  # stretched along x, a slope leans less that way

    def test_triangles_of_a_bent_polygon_share_normals(self, deep):
        deep.lights()
        deep.noStroke()
        deep.beginShape()
        for place in ((0, 0, 0), (9, 1, 0), (8, 9, 0), (1, 8, 5)):
            deep.vertex(*place)
        deep.endShape()

        block = fills(deep)

        corners = zip(block.positions.tolist(), block.normals.tolist(), strict=True)
        normals = {(*place, *normal) for place, normal in corners}
        assert len(normals) == 4  # one for each point, of the six corners
        assert len({corner[3:] for corner in normals}) == 2

    def test_material_belongs_to_its_vertices(self, deep):
        deep.lights()
        deep.noStroke()
        deep.shininess(5)
        deep.fill(200, 0, 0)
        deep.rect(0, 0, 9, 9)
        deep.shininess(7)
        deep.ambient(0, 0, 90)
        deep.rect(0, 0, 9, 9)

        materials = fills(deep).materials

        assert materials.shininess.tolist() == [5] * 4 + [7] * 4
        assert materials.ambient[0].tolist() == [200, 0, 0, 255]  # follows the fill at first
        assert materials.ambient[4].tolist() == [0, 0, 90, 255]

    def test_columns_that_nobody_reads_are_not_made(self, deep):
        deep.noStroke()
        deep.rect(0, 0, 9, 9)

        block = fills(deep)

        assert block.uvs is block.normals is block.materials is None
