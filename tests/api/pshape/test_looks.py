"""Colours, weights and materials of finished shapes."""

from __future__ import annotations

import numpy as np
import pytest

from sketchkit.core.constants import BOX, CLOSE, GROUP, P2D, QUADS, RECT, RGB, ROUND
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.backend import Backend
from tests.canvases import new_canvas

RED, GREEN, BLUE, WHITE = 0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFFFFFFFF


def plate(canvas, left=20):
    """Return a shape of corners, 40 pixels square, without an outline."""
    s = canvas.createShape()
    s.beginShape(QUADS)
    s.noStroke()
    for x, y in ((left, 20), (left + 40, 20), (left + 40, 60), (left, 60)):
        s.vertex(x, y)
    s.endShape()
    return s


@pytest.fixture
def canvas(backend: Backend):
    canvas = new_canvas(P2D, backend)
    canvas.background(0)
    canvas.noStroke()
    return canvas


def pixel(canvas, x=40, y=40):
    red, green, blue, _ = (int(value) for value in canvas.image_data()[y, x])
    return 0xFF000000 | red << 16 | green << 8 | blue


@pytest.mark.parametrize("is_drawn", [False, True], ids=["before", "after it was drawn"])
class TestColours:
    def show(self, canvas, s, is_drawn, change):
        """Draw a shape whose change comes before or after its first drawing."""
        if is_drawn:
            canvas.shape(s)
            canvas.background(0)
        change(s)
        canvas.shape(s)

    def test_fill_of_a_primitive(self, canvas, is_drawn):
        s = canvas.createShape(RECT, 20, 20, 40, 40)

        self.show(canvas, s, is_drawn, lambda s: s.setFill(RED))

        assert pixel(canvas) == RED
        assert s.getFill(0) == RED

    def test_fill_of_corners(self, canvas, is_drawn):
        self.show(canvas, plate(canvas), is_drawn, lambda s: s.setFill(RED))

        assert pixel(canvas) == RED

    def test_fill_of_one_corner(self, canvas, is_drawn):
        self.show(canvas, plate(canvas), is_drawn, lambda s: s.setFill(0, RED))

        picture = canvas.image_data()
        assert picture[20, 20, :3].tolist() == pytest.approx([255, 3, 3], abs=4)
        assert picture[59, 59, :3].tolist() == pytest.approx([255, 252, 252], abs=4)

    def test_fill_of_a_group(self, canvas, is_drawn):
        group = canvas.createShape(GROUP)
        group.addChild(plate(canvas, left=0))
        group.addChild(plate(canvas, left=50))

        self.show(canvas, group, is_drawn, lambda s: s.setFill("#0000FF"))

        assert [pixel(canvas, x) for x in (20, 70)] == [BLUE, BLUE]

    def test_no_fill_and_fill_again(self, canvas, is_drawn):
        s = canvas.createShape(RECT, 20, 20, 40, 40)
        s.setFill(RED)

        self.show(canvas, s, is_drawn, lambda s: s.setFill(False))
        without = pixel(canvas)
        s.setFill(True)
        canvas.shape(s)

        assert without == 0xFF000000
        assert pixel(canvas) == RED

    def test_colour_of_a_shape_that_is_not_filled_shows_later(self, canvas, is_drawn):
        s = canvas.createShape(RECT, 20, 20, 40, 40)
        s.setFill(False)

        self.show(canvas, s, is_drawn, lambda s: (s.setFill(GREEN), s.setFill(True)))

        assert pixel(canvas) == GREEN

    def test_stroke_and_weight(self, canvas, is_drawn):
        s = canvas.createShape(RECT, 20, 20, 40, 40)

        def change(s):
            s.setStroke(True)
            s.setStroke(GREEN)
            s.setStrokeWeight(6)

        self.show(canvas, s, is_drawn, change)

        assert [pixel(canvas, x) for x in (18, 21, 25)] == [GREEN, GREEN, WHITE]
        assert s.getStrokeWeight(0) == 6

    def test_stroke_that_the_sketch_had_put_off(self, canvas, is_drawn):
        canvas.stroke(0, 255, 0)
        canvas.noStroke()
        canvas.strokeWeight(6)
        s = canvas.createShape(RECT, 20, 20, 40, 40)

        self.show(canvas, s, is_drawn, lambda s: s.setStroke(True))

        assert [pixel(canvas, x) for x in (18, 21, 25)] == [GREEN, GREEN, WHITE]

    def test_tint_of_a_texture(self, canvas, is_drawn):
        picture = canvas.createImage(4, 4, RGB)
        picture.np_pixels[:] = 255
        s = canvas.createShape(RECT, 20, 20, 40, 40)
        s.setTexture(picture)

        self.show(canvas, s, is_drawn, lambda s: s.setTint(BLUE))
        tinted = pixel(canvas)
        s.setTint(False)
        canvas.shape(s)

        assert tinted == BLUE
        assert pixel(canvas) == WHITE

    def test_texture_is_put_on_and_taken_off(self, canvas, is_drawn):
        picture = canvas.createImage(4, 4, RGB)
        picture.np_pixels[:] = (0, 0, 255, 255)
        s = canvas.createShape(RECT, 20, 20, 40, 40)

        self.show(canvas, s, is_drawn, lambda s: s.setTexture(picture))
        covered = pixel(canvas)
        s.setTexture(None)
        canvas.shape(s)

        assert covered == BLUE
        assert pixel(canvas) == WHITE

    @pytest.mark.parametrize("radius", [(), (8,)], ids=["plain", "rounded"])
    def test_rectangle_with_a_texture_is_drawn(self, canvas, is_drawn, radius):
        picture = canvas.createImage(4, 4, RGB)
        picture.np_pixels[:] = (0, 0, 255, 255)
        s = canvas.createShape(RECT, 20, 20, 40, 40, *radius)

        self.show(canvas, s, is_drawn, lambda s: s.setTexture(picture))

        assert pixel(canvas) == BLUE


def test_change_does_not_reach_back_to_what_was_drawn(canvas):
    s = plate(canvas)
    s.setFill(RED)
    canvas.shape(s)
    s.setFill(BLUE)
    canvas.shape(s, 50, 0)

    assert [pixel(canvas, x) for x in (30, 90)] == [RED, BLUE]


def test_corner_moved_between_two_drawings_is_where_it_was_in_the_first(canvas):
    s = plate(canvas, left=0)
    canvas.shape(s)
    s.setVertex(0, 40, 60)
    canvas.shape(s, 50, 0)

    assert [pixel(canvas, x, 24) for x in (3, 53)] == [WHITE, 0xFF000000]


def test_texture_shows_the_image_as_it_is_now(canvas):
    picture = canvas.createImage(4, 4, RGB)
    s = canvas.createShape(RECT, 0, 0, 40, 40)
    s.setTexture(picture)
    canvas.shape(s)
    picture.np_pixels[:] = (0, 255, 0, 255)
    picture.updatePixels()
    canvas.shape(s, 50, 0)

    assert [pixel(canvas, x, 20) for x in (20, 70)] == [0xFF000000, GREEN]


class TestStyleOfTheSketch:
    def test_is_taken_while_the_own_is_disabled(self, canvas):
        s = plate(canvas, left=0)
        s.setFill(RED)
        s.disableStyle()
        canvas.fill(0, 255, 0)
        canvas.shape(s)
        s.enableStyle()
        canvas.shape(s, 50, 0)

        assert [pixel(canvas, x) for x in (20, 70)] == [GREEN, RED]

    def test_is_asked_at_each_drawing(self, canvas):
        s = plate(canvas, left=0)
        s.disableStyle()
        canvas.fill(0, 255, 0)
        canvas.shape(s)
        canvas.fill(0, 0, 255)
        canvas.shape(s, 50, 0)

        assert [pixel(canvas, x) for x in (20, 70)] == [GREEN, BLUE]

    def test_has_no_fill_either(self, canvas):
        s = plate(canvas)
        s.disableStyle()
        canvas.noFill()
        canvas.shape(s)

        assert pixel(canvas) == 0xFF000000

    def test_goes_to_all_in_a_group(self, canvas):
        group = canvas.createShape(GROUP)
        for left in (0, 50):
            group.addChild(plate(canvas, left))
        group.getChild(0).setFill(RED)
        group.disableStyle()
        canvas.fill(0, 255, 0)
        canvas.shape(group)
        group.enableStyle()

        assert [pixel(canvas, x) for x in (20, 70)] == [GREEN, GREEN]
        assert group.getChild(0).getFill(0) == RED


class TestMaterials:
    def test_of_the_whole_shape(self, deep):
        s = deep.createShape(BOX, 10)
        s.setAmbient(RED)
        s.setSpecular(GREEN)
        s.setEmissive(BLUE)
        s.setShininess(7)

        assert [s.getAmbient(0), s.getSpecular(0), s.getEmissive(0)] == [RED, GREEN, BLUE]
        assert s.getShininess(0) == 7

    def test_of_one_corner(self, deep):
        s = plate(deep)
        s.setEmissive(2, BLUE)
        s.setShininess(2, 7)

        assert [s.getEmissive(i) for i in range(3)] == [0xFF000000, 0xFF000000, BLUE]
        assert [s.getShininess(i) for i in range(3)] == [1, 1, 7]

    def test_ambient_colour_follows_the_fill_until_it_is_set(self, deep):
        s = deep.createShape(BOX, 10)
        s.setFill(RED)
        followed = s.getAmbient(0)
        s.setAmbient(GREEN)
        s.setFill(BLUE)

        assert (followed, s.getAmbient(0)) == (RED, GREEN)


class TestMistakes:
    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda s: s.setFill(), "setFill.* takes"),
            (lambda s: s.setFill(1, 2, 3), "setFill.* takes"),
            (lambda s: s.setFill("gren"), "no colour of this name"),
            (lambda s: s.setFill(9, RED), r"setFill\(\): the shape has vertices 0 to 3"),
            (lambda s: s.setFill("a", RED), "takes the index of a vertex first"),
            (lambda s: s.setStroke(-1, RED), r"setStroke\(\): the shape has vertices 0 to 3"),
            (lambda s: s.setStrokeWeight("3"), "setStrokeWeight.* takes"),
            (lambda s: s.setStrokeWeight(), "setStrokeWeight.* takes"),
            (lambda s: s.setStrokeJoin(99), "setStrokeJoin"),
            (lambda s: s.setTexture("photo.png"), "setTexture"),
            (lambda s: s.setShininess(), "setShininess.* takes"),
            (lambda s: s.setAmbient(1, 2, 3), "setAmbient.* takes"),
        ],
    )
    def test_are_told(self, flat, call, message):
        with pytest.raises(SketchError, match=message):
            call(plate(flat))

    @pytest.mark.parametrize("name", ["setFill", "setStroke", "setTint", "setAmbient"])
    def test_corner_of_a_primitive_cannot_be_changed(self, flat, name):
        s = flat.createShape(RECT, 0, 0, 9, 9)
        s.setTexture(flat.createImage(2, 2, RGB))

        with pytest.raises(SketchError, match=r"made with beginShape.*\n.*getTessellation"):
            getattr(s, name)(0, RED)

    @pytest.mark.parametrize(
        "call",
        [
            lambda s: s.setFill(RED),
            lambda s: s.setStroke(RED),
            lambda s: s.setStrokeWeight(2),
            lambda s: s.setTint(RED),
            lambda s: s.disableStyle(),
            lambda s: s.setTexture(None),
        ],
        ids=["setFill", "setStroke", "setStrokeWeight", "setTint", "disableStyle", "setTexture"],
    )
    def test_open_shape_says_what_to_write(self, flat, call):
        s = flat.createShape()
        s.beginShape()

        with pytest.raises(SketchError, match=r"after endShape\(\).\n.*fill\(\), stroke\(\)"):
            call(s)

    def test_number_that_cannot_be_seen_is_remarked(self, flat):
        with pytest.warns(SketchWarning, match=r"write setFill\(color\(128\)\)"):
            plate(flat).setFill(128)


def test_caps_and_joins_are_taken(flat):
    s = flat.createShape()
    s.beginShape()
    s.strokeWeight(10)
    for x, y in ((0, 0), (40, 0), (40, 40)):
        s.vertex(x, y)
    s.endShape(CLOSE)
    sharp = s._up_to_date(flat)[0].mesh.vertex_count

    s.setStrokeJoin(ROUND)

    assert s._up_to_date(flat)[0].mesh.vertex_count > sharp


def test_nothing_changes_when_a_colour_is_set_again(flat):
    s = plate(flat)
    s.setFill(RED)
    mesh = s._up_to_date(flat)[0].mesh
    version = mesh.version

    s.setFill(RED)

    assert s._up_to_date(flat)[0].mesh is mesh
    assert mesh.version == version
    assert np.array_equal(mesh.edits_since(version), [])
