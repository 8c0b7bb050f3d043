"""Canvases out of sight: what lasts on them, what they show, in which order."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import BOX, JAVA2D, P2D, P3D, RECT
from sketchkit.core.errors import SketchError
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import Settle
from tests.api.sketches import new_sketch
from tests.canvases import drawn, new_canvas

RED, GREEN, BLUE, BLACK = (255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (0, 0, 0, 255)
NOTHING = (0, 0, 0, 0)


@pytest.fixture
def canvas(backend: Backend):
    canvas = new_canvas(P2D, backend)
    canvas.background(0)
    return canvas


@pytest.fixture
def pg(canvas):
    pg = canvas.offscreen(40, 40, P2D, 4)
    pg.noStroke()
    return pg


def pixel(canvas, x=20, y=20):
    return tuple(canvas.image_data()[y, x].tolist())


class TestMaking:
    @pytest.mark.parametrize(
        ("args", "is_3d", "is_java2d"),
        [
            ((), False, True),
            ((JAVA2D,), False, True),
            ((P2D,), False, False),
            ((P3D,), True, False),
        ],
        ids=["nothing", "JAVA2D", "P2D", "P3D"],
    )
    def test_renderer_is_java2d_unless_it_is_named(self, args, is_3d, is_java2d):
        pg = new_sketch().createGraphics(30, 20, *args)

        assert (pg._stage.is_3d, pg._stage.is_java2d) == (is_3d, is_java2d)
        assert (pg.width, pg.height) == (30, 20)

    def test_fraction_of_a_size_is_cut_off(self):
        pg = new_sketch().createGraphics(30.9, 20.9, P2D)

        assert (pg.width, pg.height) == (30, 20)

    def test_edges_are_as_smooth_as_the_sketchs(self):
        sketch = new_sketch()
        smooth = sketch.createGraphics(9, 9, P2D).target.samples
        sketch.noSmooth()
        hard = sketch.createGraphics(9, 9, P2D).target.samples

        assert (smooth, hard) == (4, 1)

    @pytest.mark.parametrize(("name", "samples"), [("noSmooth", 1), ("smooth", 4)])
    def test_its_own_edges_can_be_chosen(self, pg, name, samples):
        getattr(pg, name)()

        assert pg.target.samples == samples

    def test_but_not_once_it_was_drawn_on(self, pg):
        pg.beginDraw()
        pg.endDraw()
        pg.noSmooth()

        assert pg.target.samples == 4

    @pytest.mark.parametrize(
        ("args", "message"),
        [
            ((30, "20"), "createGraphics.*\n.*Got text for height"),
            ((30, float("inf")), "createGraphics"),
            ((0, 20), "at least 1"),
            ((30, -1), "at least 1"),
            ((None, 20), "createGraphics"),
            ((30, 20, "P4D"), r"renderer of createGraphics\(\) is P2D or P3D"),
        ],
    )
    def test_mistakes_are_told(self, args, message):
        with pytest.raises(SketchError, match=message):
            new_sketch().createGraphics(*args)


class TestWhatLasts:
    def test_transparent_at_first(self, pg):
        pg.beginDraw()
        pg.endDraw()

        assert pixel(pg) == NOTHING

    def test_what_was_drawn_stays_without_background(self, pg):
        for x, color in ((0, 0xFFFF0000), (20, 0xFF00FF00)):
            pg.beginDraw()
            pg.fill(color)
            pg.rect(x, 0, 20, 40)
            pg.endDraw()

        assert [pixel(pg, x) for x in (5, 35)] == [RED, GREEN]

    def test_soft_edge_drawn_twice_stays_soft(self, pg):
        for _ in range(3):
            pg.beginDraw()
            pg.beginShape()
            for x, y in ((0, 10.5), (40, 10.5), (40, 40), (0, 40)):
                pg.vertex(x, y)
            pg.endShape()
            pg.endDraw()

        assert pixel(pg, 20, 10)[3] == 128  # the samples stay, not their mean

    def test_style_stays(self, pg):
        pg.beginDraw()
        pg.fill(255, 0, 0)
        pg.endDraw()
        pg.beginDraw()
        pg.rect(0, 0, 40, 40)
        pg.endDraw()

        assert pixel(pg) == RED

    def test_matrix_begins_anew(self, pg):
        pg.beginDraw()
        pg.translate(30, 30)
        pg.pushMatrix()
        pg.endDraw()
        pg.beginDraw()

        assert (pg.screenX(0, 0), pg.screenY(0, 0)) == (0, 0)
        with pytest.raises(SketchError, match="popMatrix"):
            pg.popMatrix()

    def test_lights_begin_anew_and_camera_stays(self, canvas):
        pg = canvas.offscreen(40, 40, P3D, 4)
        pg.beginDraw()
        pg.lights()
        pg.camera(0, 0, 50, 0, 0, 0, 0, 1, 0)
        pg.endDraw()
        pg.beginDraw()

        assert pg._stage.lights is None
        assert pg.screenX(0, 0, 0) == pytest.approx(20)

    def test_style_of_the_window_is_another(self, canvas, pg):
        pg.beginDraw()
        pg.fill(255, 0, 0)
        pg.translate(20, 0)
        pg.endDraw()

        assert canvas._fill == 0xFFFFFFFF
        assert canvas.screenX(0, 0) == 0

    def test_nothing_settles_the_old_picture(self, pg):
        pg.beginDraw()
        pg.rect(0, 0, 9, 9)
        pg.endDraw()

        commands = drawn(pg).commands
        assert not any(isinstance(c, Settle) and c.target is pg.target for c in commands)

    def test_depth_stays_until_background(self, canvas):
        pg = canvas.offscreen(40, 40, P3D, 4)
        pg.noStroke()
        colors = []
        for z, color in ((10, 0xFFFF0000), (-10, 0xFF00FF00)):
            pg.beginDraw()
            pg.fill(color)
            pg.translate(0, 0, z)
            pg.rect(-20, -20, 90, 90)
            pg.endDraw()
            colors.append(pixel(pg))
        pg.beginDraw()
        pg.background(0)
        pg.translate(0, 0, -10)
        pg.rect(-20, -20, 90, 90)
        pg.endDraw()

        assert [*colors, pixel(pg)] == [RED, RED, GREEN]


class TestBeginAndEnd:
    def test_block_ends_it(self, pg):
        with pg.beginDraw():
            pg.translate(9, 0)
        with pg.beginDraw():
            assert pg.screenX(0, 0) == 0

    def test_canvas_itself_is_such_a_block(self, pg):
        with pg as drawn:
            pg.translate(9, 0)
        with pg:
            assert pg.screenX(0, 0) == 0
        assert drawn is pg

    def test_beginning_twice_does_nothing(self, pg):
        pg.beginDraw()
        pg.translate(9, 0)
        pg.beginDraw()

        assert pg.screenX(0, 0) == pytest.approx(9)

    def test_the_windows_own_canvas_is_begun_already(self, canvas):
        canvas.translate(9, 0)
        canvas.beginDraw()
        canvas.endDraw()

        assert canvas.screenX(0, 0) == pytest.approx(9)


class TestOrder:
    def paint(self, pg, gray):
        pg.beginDraw()
        pg.background(gray)
        pg.endDraw()

    def test_each_use_shows_the_canvas_as_it_was_then(self, canvas, pg):
        for i, gray in enumerate((50, 150, 250)):
            self.paint(pg, gray)
            canvas.image(pg, 30 * i, 0, 30, 30)

        assert [pixel(canvas, 15 + 30 * i, 15)[0] for i in range(3)] == [50, 150, 250]

    def test_texture_of_a_shape_does_too(self, canvas, pg):
        s = canvas.createShape(RECT, 0, 0, 30, 30)
        s.setStroke(False)
        s.setTexture(pg)
        for i, gray in enumerate((50, 150, 250)):
            self.paint(pg, gray)
            canvas.shape(s, 30 * i, 0)

        assert [pixel(canvas, 15 + 30 * i, 15)[0] for i in range(3)] == [50, 150, 250]

    def test_canvas_in_itself_shows_what_was_there(self, pg):
        pg.beginDraw()
        pg.background(255, 0, 0)
        pg.fill(0, 0, 255)
        pg.rect(0, 0, 20, 40)
        pg.image(pg, 20, 0, 20, 40)
        pg.endDraw()

        assert [pixel(pg, x) for x in (10, 25, 35)] == [BLUE, BLUE, RED]

    def test_one_canvas_shows_on_another(self, canvas, pg):
        other = canvas.offscreen(40, 40, P3D, 4)
        self.paint(pg, 200)
        other.beginDraw()
        other.background(0)
        other.image(pg, 10, 10, 20, 20)
        other.endDraw()

        assert [pixel(other, x)[0] for x in (5, 20)] == [0, 200]

    def test_window_goes_on_where_it_was(self, canvas, pg):
        canvas.noStroke()
        canvas.fill(255, 0, 0)
        canvas.rect(0, 0, 50, 100)
        self.paint(pg, 200)
        canvas.rect(50, 0, 50, 100)

        assert [pixel(canvas, x) for x in (20, 70)] == [RED, RED]


class TestShownOnTheWindow:
    def test_transparent_parts_let_it_through(self, canvas, pg):
        pg.beginDraw()
        pg.fill(0, 255, 0)
        pg.rect(0, 0, 20, 40)
        pg.endDraw()
        canvas.background(255, 0, 0)
        canvas.image(pg, 0, 0)

        assert [pixel(canvas, x) for x in (10, 30)] == [GREEN, RED]

    def test_tint_colours_it(self, canvas, pg):
        pg.beginDraw()
        pg.background(255)
        pg.endDraw()
        canvas.tint(0, 0, 255)
        canvas.image(pg, 0, 0)

        assert pixel(canvas) == BLUE

    def test_upper_row_is_up(self, canvas, pg):
        pg.beginDraw()
        pg.background(0)
        pg.fill(255, 0, 0)
        pg.rect(0, 0, 40, 10)
        pg.endDraw()
        canvas.image(pg, 0, 0)

        assert [pixel(canvas, 20, y) for y in (5, 35)] == [RED, BLACK]
        assert [pixel(pg, 20, y) for y in (5, 35)] == [RED, BLACK]

    def test_shapes_of_the_window_can_be_drawn_on_it(self, canvas):
        pg = canvas.offscreen(40, 40, P3D, 4)
        cube = new_canvas(P3D).createShape(BOX, 20)
        cube.setFill(0xFFFF0000)
        cube.setStroke(False)
        pg.beginDraw()
        pg.shape(cube, 20, 20)
        pg.endDraw()

        assert pixel(pg) == RED
        assert pixel(pg, 2, 2) == NOTHING
