import numpy as np
import pytest

from sketchkit.core.constants import ADD, JAVA2D, P2D, P3D, SHAPE
from sketchkit.draw.pipeline import Blend, Program
from tests.api.test_text import corners
from tests.canvases import area, drawn, draws, fills, new_canvas


def image_rows(canvas):
    """Return how many rows of its image the one letter has that was drawn."""
    commands = drawn(canvas)
    (draw,) = draws(commands)
    (block,) = commands.blocks.values()
    v = block.uvs[:, 1]
    return round(float(v.max() - v.min()) * draw.pipeline.texture.height)


@pytest.mark.parametrize(("times", "rows"), [(0.5, 9), (1, 9), (1.4, 9), (2, 17), (4, 34)])
def test_letters_are_drawn_anew_where_a_transform_enlarges_them(times, rows):
    canvas = new_canvas(P2D)
    canvas.scale(times)

    canvas.text("d", 5, 20)

    assert image_rows(canvas) == rows  # ascents at 12, 24 and 48


def test_letters_are_drawn_anew_where_they_are_near():
    canvas = new_canvas(P3D)
    eye = 50 * 3**0.5

    canvas.text("d", 50, 50, eye / 2)

    assert image_rows(canvas) == 17


def test_a_later_size_enlarges_letters_as_in_processing(flat):
    flat.text("d", 0, 0)
    drawn(flat)
    flat.textSize(24)

    flat.text("d", 50, 50)

    assert image_rows(flat) == 9


def test_a_page_that_is_enlarged_is_one_draw(flat):
    for times in (2, 3, 4, 6):
        flat.resetMatrix()
        flat.scale(times)
        flat.text("page", 2, 14)

    assert len(draws(drawn(flat))) == 1


def test_shapes_of_letters_are_filled_without_an_outline_or_an_image(flat):
    flat.textMode(SHAPE)
    flat.textSize(100)

    flat.text("I", 10, 90)

    commands = drawn(flat)
    (draw,) = draws(commands)
    (block,) = commands.blocks.values()
    assert draw.pipeline.program is Program.FLAT
    assert block.positions[:, 1].min() == pytest.approx(90 - 65.6, abs=0.02)
    assert area(block) == pytest.approx(8.3 * 65.6, rel=0.01)


def test_a_hole_in_a_letter_is_none_of_its_shape(flat):
    flat.textMode(SHAPE)
    flat.textSize(100)
    flat.text("o", 0, 0)

    block = fills(flat)

    x, y, _ = (np.ptp(column) for column in block.positions.T)
    assert area(block) < 0.5 * x * y


def test_shapes_of_letters_obey_noFill_and_keep_the_stroke(flat):
    flat.textMode(SHAPE)
    flat.noFill()
    flat.text("d", 10, 50)
    assert not drawn(flat).blocks

    flat.line(0, 0, 50, 50)
    assert drawn(flat).blocks


def test_java2d_puts_letters_at_whole_pixels():
    canvas = new_canvas(JAVA2D)

    canvas.text("d", 10.4, 20.5)
    canvas.text("d", 10.5, 20.4)

    assert corners(canvas) == [(10, 12), (11, 11)]


@pytest.mark.parametrize(("size", "rows"), [(12, 10), (24, 18), (48, 35)])
def test_java2d_makes_letters_at_each_size(size, rows):
    canvas = new_canvas(JAVA2D)
    canvas.text("", 0, 0)
    canvas.textSize(size / 2)
    canvas.scale(2)

    canvas.text("d", 10, 20)

    assert image_rows(canvas) == pytest.approx(rows, abs=1)


def test_java2d_turns_letters_about_their_point():
    canvas = new_canvas(JAVA2D)
    canvas.translate(50, 50)
    canvas.rotate(np.pi / 2)

    canvas.text("d", 10, 0)

    left, top = corners(canvas)[0]
    assert left == pytest.approx(59.0, abs=1.1)
    assert top == pytest.approx(60.0, abs=1.1)


def test_java2d_blends_text_as_all_else():
    canvas = new_canvas(JAVA2D)
    canvas.blendMode(ADD)

    canvas.text("d", 10, 20)

    assert [draw.pipeline.blend for draw in draws(drawn(canvas))] == [Blend.ADD]


@pytest.mark.parametrize("times", [0, 1e-4, 1000, -1])
@pytest.mark.parametrize("renderer", [P2D, P3D, JAVA2D])
def test_any_transform_is_survived(renderer, times):
    canvas = new_canvas(renderer)
    canvas.scale(times)

    canvas.text("any text", 1, 2)

    drawn(canvas)


@pytest.mark.parametrize("renderer", [P2D, JAVA2D])
def test_text_nowhere_is_survived(renderer):
    canvas = new_canvas(renderer)

    canvas.text("any text", float("nan"), 2)

    drawn(canvas)
