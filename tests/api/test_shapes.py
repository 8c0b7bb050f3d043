"""shape(), shapeMode(), and what drawing a shape costs."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import (
    BOX,
    CENTER,
    CORNER,
    CORNERS,
    DISABLE_STROKE_PERSPECTIVE,
    ELLIPSE,
    ENABLE_STROKE_PERSPECTIVE,
    GROUP,
    JAVA2D,
    P2D,
    P3D,
    POINTS,
    QUADS,
    RECT,
    RGB,
    SPHERE,
    TRIANGLES,
)
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import DrawMesh
from sketchkit.draw.vertex import Layer
from tests.canvases import drawn, new_canvas

MANY = 99_999  # corners: whole triangles


def plate(canvas, left=10, top=20, width=40, height=30):
    canvas.noStroke()
    return canvas.createShape(RECT, left, top, width, height)


def mesh_draws(canvas):
    return [command for command in drawn(canvas).commands if isinstance(command, DrawMesh)]


def extent(canvas, s, *place):
    """Return left, top, right and bottom of where a shape comes on a flat canvas."""
    canvas.shape(s, *place)
    (draw,) = mesh_draws(canvas)
    positions = draw.part.mesh.blocks[Layer.FILLS].positions
    matrix = np.array(draw.modelview).reshape(3, 4)
    places = positions @ matrix[:2, :3].T + matrix[:2, 3]
    return pytest.approx([*places.min(axis=0), *places.max(axis=0)], abs=1e-3)


class TestPlace:
    def test_without_numbers_is_where_it_was_made(self, flat):
        assert extent(flat, plate(flat)) == [10, 20, 50, 50]

    def test_two_numbers_move_it(self, flat):
        assert extent(flat, plate(flat), 5, 7) == [15, 27, 55, 57]

    def test_four_numbers_stretch_it(self, flat):
        assert extent(flat, plate(flat, 0, 0), 5, 7, 80, 15) == [5, 7, 85, 22]

    def test_stretching_takes_its_origin_along(self, flat):
        assert extent(flat, plate(flat), 0, 0, 80, 30) == [20, 20, 100, 50]

    def test_matrix_of_the_sketch_counts_and_stays(self, flat):
        flat.translate(100, 0)
        before = flat._modelview

        assert extent(flat, plate(flat), 5, 7) == [115, 27, 155, 57]
        assert flat._modelview == before

    def test_three_numbers_have_a_depth(self, deep):
        deep.shape(plate(deep), 0, 0, -30)
        deep.shape(plate(deep), 0, 0)

        first, second = (draw.modelview[11] for draw in mesh_draws(deep))
        assert first - second == -30

    def test_six_numbers_stretch_it_in_space(self, deep):
        deep.noStroke()
        deep.shape(deep.createShape(BOX, 10), 0, 0, 0, 20, 30, 40)

        (draw,) = mesh_draws(deep)
        assert [draw.modelview[i] for i in (0, 5, 10)] == [2, 3, 4]

    def test_what_is_flat_is_not_stretched_to_infinity(self, flat):
        flat.noStroke()
        s = flat.createShape()
        s.beginShape(TRIANGLES)
        for x in (0, 10, 20):
            s.vertex(x, 5)
        s.endShape()

        assert extent(flat, s, 0, 0, 40, 40) == [0, 5, 40, 5]


class TestMode:
    @pytest.mark.parametrize(
        ("mode", "place", "expected"),
        [
            pytest.param(CORNER, (5, 7), [15, 27, 55, 57], id="CORNER"),
            pytest.param(CENTER, (), [-10, 5, 30, 35], id="CENTER without numbers"),
            pytest.param(CENTER, (5, 7), [-5, 12, 35, 42], id="CENTER moves by half its size"),
            pytest.param(CENTER, (40, 30, 80, 30), [20, 35, 100, 65], id="CENTER with a size"),
            pytest.param(CORNERS, (5, 7), [15, 27, 55, 57], id="CORNERS moves as CORNER"),
            pytest.param(CORNERS, (0, 0, 80, 30), [20, 20, 100, 50], id="CORNERS"),
        ],
    )
    def test_gives_the_numbers_their_meaning(self, flat, mode, place, expected):
        flat.shapeMode(mode)

        assert extent(flat, plate(flat), *place) == expected

    def test_is_kept_by_push_and_pop(self, flat):
        flat.pushStyle()
        flat.shapeMode(CENTER)
        flat.popStyle()

        assert extent(flat, plate(flat), 5, 7) == [15, 27, 55, 57]

    def test_unknown_one_counts_as_corner(self, flat):
        flat.shapeMode(CENTER)

        with pytest.warns(
            SketchWarning, match=r"shapeMode.*CORNER.*CENTER; 77 is taken for CORNER"
        ):
            flat.shapeMode(77)

        assert extent(flat, plate(flat), 5, 7) == [15, 27, 55, 57]


class TestMistakes:
    @pytest.mark.parametrize(
        ("other", "got"), [("box", "text: 'box'"), (None, "None"), (3, "a number"), (RECT, "")]
    )
    def test_something_else_is_no_shape(self, flat, other, got):
        with pytest.raises(SketchError, match=rf"shape\(\) takes a shape first.\n.*Got {got}"):
            flat.shape(other)

    @pytest.mark.parametrize("place", [(1,), (1, 2, 3, 4, 5), ("1", 2), (1, None), (1, 2, 3, "4")])
    def test_numbers_have_to_fit(self, flat, place):
        with pytest.raises(SketchError, match=r"shape.* takes"):
            flat.shape(plate(flat), *place)

    def test_open_shape_is_refused(self, flat):
        s = flat.createShape()
        s.beginShape()
        s.vertex(1, 2)

        with pytest.raises(SketchError, match=r"shape\(\) belongs after endShape\(\)"):
            flat.shape(s)


class TestWhatIsDrawn:
    def test_hidden_shape_is_not(self, flat):
        s = plate(flat)
        s.setVisible(False)
        flat.shape(s)

        assert mesh_draws(flat) == []

    def test_empty_shape_draws_nothing(self, flat):
        flat.shape(flat.createShape())
        flat.shape(flat.createShape(GROUP))

        assert mesh_draws(flat) == []

    @pytest.mark.parametrize(("renderer", "count"), [(P2D, 2), (P3D, 2), (JAVA2D, 1)])
    def test_hidden_child_is_drawn_with_its_group_but_in_java2d(self, renderer, count):
        canvas = new_canvas(renderer)
        group = canvas.createShape(GROUP)
        for _ in range(2):
            group.addChild(plate(canvas))
        group.getChild(0).setVisible(False)
        canvas.shape(group)

        assert len(mesh_draws(canvas)) == count

    def test_group_in_space_draws_fills_then_lines_then_points(self, deep):
        group = deep.createShape(GROUP)
        dots = deep.createShape()
        dots.beginShape(POINTS)
        dots.vertex(1, 1)
        dots.endShape()
        group.addChild(dots)
        for _ in range(2):
            group.addChild(deep.createShape(RECT, 0, 0, 9, 9))
        deep.shape(group)

        layers = [draw.part.layer for draw in mesh_draws(deep)]
        assert layers == [Layer.FILLS] * 2 + [Layer.LINES] * 2 + [Layer.POINTS]

    def test_lines_are_as_much_thicker_as_the_shape_is_scaled(self, deep):
        s = deep.createShape(BOX, 10)
        deep.shape(s)
        s.scale(3)
        deep.shape(s)

        lines = [draw.part for draw in mesh_draws(deep) if draw.part.layer is Layer.LINES]
        assert [part.weight_scale for part in lines] == pytest.approx([1, 3])

    def test_hint_for_strokes_does_not_reach_back_to_a_shape(self, deep):
        s = deep.createShape(BOX, 10)
        deep.shape(s)
        deep.hint(ENABLE_STROKE_PERSPECTIVE)
        deep.shape(s)
        deep.hint(DISABLE_STROKE_PERSPECTIVE)

        lines = [draw.pipeline for draw in mesh_draws(deep) if draw.part.layer is Layer.LINES]
        assert [pipeline.stroke_perspective for pipeline in lines] == [False, True]

    def test_lines_are_not_thicker_under_a_scale_of_the_sketch(self, deep):
        deep.scale(3)
        deep.shape(deep.createShape(BOX, 10))

        assert {draw.part.weight_scale for draw in mesh_draws(deep)} == {1}


def mosaic(canvas, count=MANY):
    """Return a shape of many triangles."""
    s = canvas.createShape()
    s.beginShape(TRIANGLES)
    s.noStroke()
    for i in range(count):
        s.vertex(i % 300 / 3, i % 2 * 20)
    s.endShape()
    return s


class TestWhatIsSent:
    def sent(self, canvas):
        """Return how many vertices drawing what is recorded sends."""
        stats = canvas._renderer.stats
        before = stats.vertices
        canvas.end_frame()
        return stats.vertices - before

    @pytest.fixture
    def shape(self, deep):
        """A shape that was drawn, and sent, before."""
        s = mosaic(deep)
        deep.shape(s)
        assert self.sent(deep) == MANY
        return s

    def test_nothing_when_it_is_drawn_again(self, deep, shape):
        deep.shape(shape)
        deep.shape(shape, 10, 10)

        assert self.sent(deep) == 0

    def test_nothing_when_it_is_moved(self, deep, shape):
        shape.rotate(0.1)
        deep.translate(5, 5)
        deep.shape(shape)

        assert self.sent(deep) == 0

    def test_ten_when_ten_corners_are_moved(self, deep, shape):
        for i in range(0, MANY, 10_000):
            shape.setVertex(i, 0, 0, i % 7)
        deep.shape(shape)

        assert self.sent(deep) == 10

    def test_ten_when_ten_corners_are_coloured(self, deep, shape):
        for i in range(500, 510):
            shape.setFill(i, 0xFFFF0000)
        deep.shape(shape)

        assert self.sent(deep) == 10

    def test_only_what_has_changed_since_it_was_sent(self, deep, shape):
        shape.setVertex(5, 0, 0, 0)
        deep.shape(shape)
        self.sent(deep)
        shape.setVertex(70_000, 0, 0, 0)
        deep.shape(shape)

        assert self.sent(deep) == 1

    def test_change_of_a_child_does_not_send_the_others(self, deep):
        group = deep.createShape(GROUP)
        for _ in range(3):
            group.addChild(mosaic(deep, 999))
        deep.shape(group)
        self.sent(deep)
        group.getChild(1).setVertex(0, 0, 0, 0)
        deep.shape(group)

        assert self.sent(deep) == 1


DRAWINGS = {
    "lit solids": lambda g: (
        g.lights(),
        g.shape(g.createShape(SPHERE, 20), 30, 30),
        g.shape(g.createShape(BOX, 30), 75, 60),
    ),
    "texture": lambda g: textured(g),
    "points": lambda g: points(g),
}


def textured(g):
    picture = g.createImage(8, 8, RGB)
    picture.np_pixels[::2, ::2] = (255, 120, 0, 255)
    s = g.createShape()
    s.beginShape(QUADS)
    s.texture(picture)
    s.tint(200, 255, 120)
    for x, y in ((10, 10), (80, 20), (85, 90), (20, 70)):
        s.vertex(x, y, x / 10, y / 10)
    s.endShape()
    g.shape(s)


def points(g):
    s = g.createShape()
    s.beginShape(POINTS)
    s.strokeWeight(9)
    for i in range(5):
        s.stroke(50 * i, 0, 200)
        s.vertex(20 * i + 5, 30 + 8 * i)
    s.endShape()
    s.scale(1.2)
    g.shape(s)


@pytest.mark.parametrize("name", DRAWINGS)
def test_renderers_agree(name, gl_backend: Backend):
    pictures = []
    for backend in (CpuBackend(), gl_backend):
        canvas = new_canvas(P3D, backend)
        canvas.background(235)
        DRAWINGS[name](canvas)
        pictures.append(canvas.image_data().astype(int))

    assert (pictures[0] != 235).any()
    assert (np.abs(pictures[0] - pictures[1]).max(axis=2) <= 2).mean() > 0.999


def test_what_is_drawn_before_and_after_keeps_its_order(backend: Backend):
    canvas = new_canvas(P2D, backend)
    canvas.noStroke()
    canvas.background(0)
    canvas.fill(255, 0, 0)
    canvas.rect(0, 0, 60, 60)
    canvas.fill(0, 255, 0)
    canvas.shape(canvas.createShape(ELLIPSE, 50, 50, 60, 60))
    canvas.fill(0, 0, 255)
    canvas.rect(50, 50, 50, 50)

    picture = canvas.image_data()
    colors = [picture[y, x, :3].tolist() for x, y in ((5, 5), (45, 45), (60, 60))]
    assert colors == [[255, 0, 0], [0, 255, 0], [0, 0, 255]]
