"""The draw list as text."""

from __future__ import annotations

import numpy as np

from sketchkit.backends.listing import SHORTENED, ListingBackend, listing
from sketchkit.core.constants import P2D, RGB
from sketchkit.draw.resources import Target
from tests.canvases import drawn, new_canvas


def lines_of(canvas, **options):
    return listing(drawn(canvas), **options).splitlines()


def test_rect_in_the_plane(flat):
    flat.background(255)
    flat.noStroke()
    flat.fill(200, 80, 40, 128)
    flat.rect(10, 20, 30.5, 40)

    assert lines_of(flat)[1:] == [
        "Clear canvas 1: #FFFFFFFF, depth",
        "Draw canvas 1: 2 triangles of fills, FLAT, BLEND, no depth test, ortho x 0..100 y 0..100",
        "    0: 10 20 0  #C8502880",
        "    1: 41 20 0  #C8502880",
        "    2: 41 60 0  #C8502880",
        "    3: 10 60 0  #C8502880",
        "    triangles 0 1 2, 2 3 0",
    ]


def test_canvas_is_described_where_it_is_first_named(flat):
    flat.background(255)

    assert lines_of(flat)[0].startswith("Clear canvas 1 (100 x 100, 4 samples, top row first): ")


def test_depth_clip_and_perspective(deep):
    deep.noStroke()
    deep.clip(10, 20, 30, 40)
    deep.rect(0, 0, 9, 9)

    assert (
        "Draw canvas 1: 2 triangles of fills, FLAT, BLEND, depth, clip 30 x 40 at 10 20, "
        "perspective 60 deg 1:1 z 8.66..866.025"
    ) in lines_of(deep)


def test_lights_and_materials(deep):
    deep.lights()
    deep.noStroke()
    deep.fill(255, 0, 0)
    deep.resetMatrix()
    deep.rect(0, 0, 9, 9)

    lines = lines_of(deep)

    assert "    light ambient, at -50 -50 -86.603, ambient 0.5 0.5 0.5, falloff 1 0 0" in lines
    assert "    light directional, toward 0 0 -1, diffuse 0.5 0.5 0.5" in lines
    material = "ambient #FF0000  specular #7D7D7D  emissive #000000  shininess 1"
    assert f"    0: 0 0 0  #FF0000FF  normal 0 0 1  {material}" in lines
    assert "    1: 9 0 0  #FF0000FF  normal 0 0 1" in lines  # the same material


def test_texture_has_its_size_and_coordinates(flat):
    picture = flat.createImage(8, 4, RGB)
    flat.image(picture, 0, 0)
    flat.tint(9)
    flat.image(picture, 20, 0)

    lines = lines_of(flat)

    assert sum("texture 1 (8 x 4) CLAMP" in line for line in lines) == 1
    assert "    2: 8 4 0  #FFFFFFFF  uv 1 1" in lines


def test_stroke_in_space_has_its_direction(deep):
    deep.strokeWeight(6)
    deep.resetMatrix()
    deep.line(0, 0, 0, 10, 0, 0)

    assert "    0: 0 0 0  #000000FF  direction 10 0 0 3" in lines_of(deep)


def test_long_draw_is_shortened_to_what_it_lies_within(flat):
    flat.noStroke()
    flat.circle(50, 50, 20)

    lines = lines_of(flat)

    vertices = [line for line in lines if line.startswith("    ") and "#" in line]
    assert len(vertices) == SHORTENED
    assert "    and 9 more; all x 40..60, y 40..60, z 0..0" in lines  # 20 corners and the hub
    assert lines[-1].endswith(" and 8 more")


def test_full_list_is_not_shortened(flat):
    flat.noStroke()
    flat.circle(50, 50, 20)

    lines = lines_of(flat, is_full=True)

    assert sum("#" in line for line in lines if line.startswith("    ")) == 21
    assert "more" not in "".join(lines)


def test_same_drawing_gives_the_same_text():
    texts = []
    for _ in range(2):
        canvas = new_canvas(P2D)
        canvas.rotate(0.1)
        canvas.rect(10, 10, 20, 20)
        canvas.image(canvas.createImage(2, 2, RGB), 0, 0)
        texts.append(listing(drawn(canvas)))

    assert texts[0] == texts[1]


def test_numbers_have_three_decimals_and_no_negative_zero(flat):
    flat.noStroke()
    flat.rotate(0.1)
    flat.rect(-0.0001, 0, 1 / 3, 0)

    text = listing(drawn(flat))

    assert " -0 " not in text
    assert "0.332 0.033" in text  # cos and sin of 0.1, times a third


class TestBackend:
    def test_keeps_one_text_for_each_list(self):
        backend = ListingBackend()
        canvas = new_canvas(P2D, backend)
        canvas.end_frame()
        canvas.begin_frame()
        canvas.rect(0, 0, 9, 9)
        canvas.end_frame()

        assert len(backend.texts) == 2
        assert "Draw canvas 1" in backend.texts[1]

    def test_calls_a_target_by_the_same_name_in_every_list(self):
        backend = ListingBackend()
        for _ in range(2):
            canvas = new_canvas(P2D, backend)
            canvas.background(0)
            canvas.end_frame()
        canvas.background(0)
        canvas.end_frame()

        names = [text.split()[2] for text in backend.texts]

        assert names == ["1", "2", "2"]

    def test_reads_a_transparent_picture(self):
        picture = ListingBackend().read(Target(30, 20))

        assert picture.shape == (20, 30, 4)
        assert picture.dtype == np.uint8
        assert not picture.any()
