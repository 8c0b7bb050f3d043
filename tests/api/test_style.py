"""Fill, stroke and the modes of shapes: what they hold for, and what they refuse."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import (
    ADD,
    BLEND,
    CENTER,
    CORNER,
    CORNERS,
    DIFFERENCE,
    HSB,
    JAVA2D,
    LEFT,
    RADIUS,
    SQUARE,
    TOP,
)
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from sketchkit.draw.pipeline import Blend
from tests.canvases import drawn, draws, fills, new_canvas, places

RED = [255, 0, 0, 255]


def color_of(canvas):
    """Return the colour in which a rectangle is filled now."""
    canvas.noStroke()
    canvas.rect(0, 0, 10, 10)
    return fills(canvas).colors[0].tolist()


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ((255, 0, 0), RED),
        ((128,), [128, 128, 128, 255]),
        ((128, 40), [128, 128, 128, 40]),
        ((10, 20, 30, 40), [10, 20, 30, 40]),
        ((127.9, 0.2, 300), [127, 0, 255, 255]),
        ((0xFFFF0000,), RED),
        ((0xFFFF0000, 100), [255, 0, 0, 100]),
        (("#FF0000",), RED),
        (("red",), RED),
        ((True,), [1, 1, 1, 255]),
    ],
    ids=str,
)
def test_fill_takes_every_way_to_write_a_color(flat, arguments, expected):
    flat.fill(*arguments)

    assert color_of(flat) == expected


def test_fill_reads_its_numbers_in_the_color_mode(flat):
    flat.colorMode(HSB, 360, 100, 100)
    flat.fill(120, 100, 100)

    assert color_of(flat) == [0, 255, 0, 255]


def test_fill_holds_for_what_is_drawn_after_it(flat):
    flat.noStroke()
    flat.rect(0, 0, 10, 10)
    flat.fill(255, 0, 0)
    flat.rect(0, 0, 10, 10)

    colors = fills(flat).colors[[0, 4]].tolist()

    assert colors == [[255] * 4, RED]


@pytest.mark.parametrize("name", ["fill", "stroke", "tint", "background"])
@pytest.mark.parametrize("arguments", [(None,), ("no such colour",), ([1, 2, 3],), (1, "2", 3)])
def test_what_makes_no_color_is_refused_by_name(flat, name, arguments):
    with pytest.raises(SketchError) as caught:
        getattr(flat, name)(*arguments)

    assert name in str(caught.value) or "colour" in str(caught.value)


@pytest.mark.parametrize(
    ("name", "wrong", "named"),
    [
        ("rectMode", 1.5, "CORNER, CORNERS, RADIUS or CENTER"),
        ("ellipseMode", "CENTER", "CORNER, CORNERS, RADIUS or CENTER"),
        ("imageMode", RADIUS, "CORNER, CORNERS or CENTER"),
        ("strokeCap", None, "ROUND, SQUARE or PROJECT"),
        ("strokeJoin", [], "MITER, BEVEL or ROUND"),
    ],
    ids=["rectMode", "ellipseMode", "imageMode", "strokeCap", "strokeJoin"],
)
def test_unknown_mode_is_refused_with_the_known_ones(flat, name, wrong, named):
    with pytest.raises(SketchError) as caught:
        getattr(flat, name)(wrong)

    assert f"{name}() takes {named}." in str(caught.value)


@pytest.mark.parametrize(
    ("name", "number", "taken"),
    [
        ("rectMode", LEFT, "CORNERS"),
        ("ellipseMode", 30, "CORNER"),
        ("strokeCap", 30, "SQUARE"),
        ("strokeJoin", SQUARE, "MITER"),
        ("textAlign", TOP, "LEFT"),
    ],
)
def test_a_number_that_is_no_mode_counts_as_in_processing(flat, name, number, taken):
    with pytest.warns(SketchWarning, match=f"{number} is taken for {taken}"):
        getattr(flat, name)(number)


def test_join_that_is_none_is_a_bevel_in_java2d():
    canvas = new_canvas(JAVA2D)

    with pytest.warns(SketchWarning, match="taken for BEVEL"):
        canvas.strokeJoin(30)


def test_mode_in_quotes_gets_a_hint(flat):
    with pytest.raises(SketchError, match="Write CENTER without quotes"):
        flat.rectMode("CENTER")


def test_mode_that_is_a_list_is_refused(flat):
    with pytest.raises(SketchError, match=r"rectMode\(\) takes CORNER"):
        flat.rectMode([1])


def test_stroke_weight_beyond_java_floats_is_told_with_the_shape(flat):
    flat.strokeWeight(1e40)

    with pytest.raises(SketchError, match=r"A number for strokeWeight\(\) is too large"):
        flat.square(1, 2, 3)


def test_components_are_named_as_the_color_mode_has_them(flat):
    flat.colorMode(HSB)

    with pytest.raises(SketchError, match="Got None for saturation"):
        flat.background(1, None, 3)


@pytest.mark.parametrize(
    ("mode", "corner"),
    [(CORNER, (40, 40)), (CORNERS, (20, 20)), (CENTER, (30, 30)), (RADIUS, (20, 20))],
    ids=["CORNER", "CORNERS", "CENTER", "RADIUS"],
)
def test_rect_mode_gives_the_numbers_their_meaning(flat, mode, corner):
    flat.noStroke()
    flat.rectMode(mode)
    flat.rect(40, 40, 20, 20)

    assert places(fills(flat))[0] == corner


@pytest.mark.parametrize("weight", ["3", None])
def test_weight_that_is_no_number_is_refused(flat, weight):
    with pytest.raises(SketchError, match=r"strokeWeight\(\) takes 1 number"):
        flat.strokeWeight(weight)


def test_blend_mode_without_a_gpu_rule_changes_nothing(flat):
    flat.blendMode(ADD)
    flat.blendMode(DIFFERENCE)
    flat.rect(0, 0, 9, 9)

    (draw,) = draws(drawn(flat))

    assert draw.pipeline.blend is Blend.ADD


class TestStack:
    def test_pop_takes_back_everything_that_push_style_saved(self, flat):
        flat.fill(255, 0, 0)
        flat.pushStyle()
        flat.fill(0, 0, 255)
        flat.rectMode(CENTER)
        flat.blendMode(ADD)
        flat.colorMode(HSB, 10)
        flat.popStyle()
        flat.noStroke()
        flat.rect(20, 20, 10, 10)
        commands = drawn(flat)

        assert places(next(iter(commands.blocks.values())))[0] == (20, 20)
        assert next(iter(commands.blocks.values())).colors[0].tolist() == RED
        assert draws(commands)[-1].pipeline.blend is Blend.BLEND
        assert flat.color(255) == 0xFFFFFFFF

    def test_block_takes_back_by_itself(self, flat):
        flat.fill(255, 0, 0)
        with flat.pushStyle():
            flat.fill(0, 0, 255)

        assert color_of(flat) == RED

    def test_error_within_a_block_is_told_as_it_is(self, flat):
        def fail_after_popping() -> None:
            with flat.pushStyle():
                flat.popStyle()
                raise ZeroDivisionError

        with pytest.raises(ZeroDivisionError):
            fail_after_popping()

    def test_pop_without_push_is_refused(self, flat):
        with pytest.raises(SketchError, match=r"popStyle\(\) without pushStyle\(\)"):
            flat.popStyle()

    def test_64_may_be_put_aside_and_no_more(self, flat):
        for _ in range(64):
            flat.pushStyle()

        with pytest.raises(SketchError, match=r"pushStyle\(\) was called 64 times"):
            flat.pushStyle()

    def test_blend_mode_of_the_stack_is_that_of_the_push(self, flat):
        flat.blendMode(ADD)
        with flat.push():
            flat.blendMode(BLEND)
        flat.rect(0, 0, 9, 9)

        assert draws(drawn(flat))[-1].pipeline.blend is Blend.ADD
