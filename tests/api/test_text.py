import numpy as np
import pytest

from sketchkit.core.constants import (
    ADD,
    BASELINE,
    BOTTOM,
    CENTER,
    CORNERS,
    LEFT,
    P3D,
    RADIUS,
    RIGHT,
    TOP,
)
from sketchkit.core.errors import SketchError
from sketchkit.draw.pipeline import Blend
from tests.canvases import drawn, draws, fills, new_canvas


def corners(canvas):
    """Return left and top of each letter, in the order written, and forget them."""
    positions = fills(canvas).positions.reshape(-1, 4, 3)[:, 0, :2]
    return [tuple(place) for place in positions.tolist()]


# "d" is 7 wide at 12 pixels; its mask begins at the pen and 9 above the baseline.


def test_text_begins_at_its_point_on_the_baseline(flat):
    flat.text("dd", 10, 20)

    assert corners(flat) == [(10, 11), (17, 11)]


@pytest.mark.parametrize(
    ("across", "down", "place"),
    [
        pytest.param(LEFT, BASELINE, (50, 41), id="left, baseline"),
        pytest.param(CENTER, BASELINE, (47, 41), id="centre: 46.5, rounded up"),
        pytest.param(RIGHT, BASELINE, (43, 41), id="right"),
        pytest.param(LEFT, TOP, (50, 50), id="top"),
        pytest.param(LEFT, CENTER, (50, 46), id="middle: 45.5, rounded up"),
        pytest.param(LEFT, BOTTOM, (50, 39), id="bottom"),
    ],
)
def test_alignment_at_a_point(flat, across, down, place):
    flat.textAlign(across, down)

    flat.text("d", 50, 50)

    assert corners(flat) == [place]


@pytest.mark.parametrize(
    ("down", "tops"),
    [(BASELINE, [41, 61]), (TOP, [50, 70]), (CENTER, [36, 56]), (BOTTOM, [19, 39])],
)
def test_lines_are_aligned_all_together(flat, down, tops):
    flat.textSize(12)
    flat.textAlign(LEFT, down)
    flat.textLeading(20)

    flat.text("d\nd", 50, 50)

    assert [top for _, top in corners(flat)] == tops


def test_lines_follow_at_the_leading_of_the_size(flat):
    flat.text("d\n\nd", 50, 50)

    # (9 + 2) * 1.275 is 14.025, twice: 28.05, and P2D rounds up.
    assert [top for _, top in corners(flat)] == [41, 70]


@pytest.mark.parametrize(
    ("mode", "numbers"),
    [(None, (10, 20, 40, 60)), (CORNERS, (50, 80, 10, 20)), (CENTER, (30, 50, 40, 60)),
     (RADIUS, (30, 50, 20, 30))],
)  # fmt: skip
def test_a_box_is_read_as_a_rectangle(flat, mode, numbers):
    if mode is not None:
        flat.rectMode(mode)

    flat.text("dddd dddd", *numbers)

    assert corners(flat)[::4] == [(10, 20), (10, 35)]


@pytest.mark.parametrize(
    ("across", "down", "first"),
    [
        (LEFT, TOP, (10, 20)),
        (LEFT, BASELINE, (10, 20)),
        (CENTER, TOP, (27, 20)),
        (RIGHT, TOP, (43, 20)),
        (LEFT, CENTER, (10, 46)),  # 20 + 9 + (60 - 9) / 2 is the baseline: 54.5
        (LEFT, BOTTOM, (10, 69)),
    ],
)
def test_alignment_in_a_box(flat, across, down, first):
    flat.textAlign(across, down)

    flat.text("d", 10, 20, 40, 60)

    assert corners(flat) == [first]


def test_lines_that_do_not_fit_are_left_out(flat):
    flat.text("d d d d", 10, 10, 10, 26)  # 9 + 2 + 14.025 for two lines

    assert len(corners(flat)) == 2


@pytest.mark.parametrize(
    ("what", "shown"),
    [
        (42, "42"),
        (np.int32(7), "7"),
        (3.14159, " 3.142"),
        (-2.5, "-2.500"),
        (np.float32(0.5), " 0.500"),
        ("x", "x"),
        (True, "True"),
        (None, "None"),
        ([1, 2], "[1, 2]"),
    ],
)
def test_values_are_shown_as_processing_does(flat, what, shown):
    flat.text(what, 10, 50)
    got = corners(flat)
    flat.text(shown, 10, 50)

    assert got == corners(flat)


def test_text_is_in_the_fill_colour_whatever_the_tint(flat):
    flat.fill(10, 20, 30, 40)
    flat.tint(255, 0, 0)

    flat.text("d", 50, 50)

    assert (fills(flat).colors == (10, 20, 30, 40)).all()


def test_a_page_is_one_draw(flat):
    for y in range(12, 100, 12):
        flat.textSize(8 + y / 10)
        flat.text("the quick brown fox", 0, y)

    assert len(draws(drawn(flat))) == 1


def test_text_is_blended_whatever_the_mode(flat):
    flat.blendMode(ADD)
    flat.text("d", 50, 50)
    flat.rect(10, 10, 10, 10)

    first, *others = draws(drawn(flat))

    assert first.pipeline.blend is Blend.BLEND
    assert {draw.pipeline.blend for draw in others} == {Blend.ADD}


def test_some_characters_of_a_list(flat):
    flat.text(list("xddx"), 1, 3, 10, 20)
    some = corners(flat)
    flat.text(np.frombuffer(b"xddx", np.uint8).tolist(), 1, 3, 10, 20)

    assert some == corners(flat) == [(10, 11), (17, 11)]


def test_a_box_of_negative_size_is_the_same_box(flat):
    flat.text("dddd dddd", 50, 80, -40, -60)

    assert corners(flat)[::4] == [(10, 20), (10, 35)]


def test_a_box_without_room_shows_nothing(flat):
    flat.text("d", 10, 10, 3, 50)
    flat.text("d", 10, 10, 50, 5)

    assert not drawn(flat).blocks


def test_z_moves_text_in_space_alone():
    solid, flat = new_canvas(P3D), new_canvas("P2D")
    for canvas in (solid, flat):
        canvas.text("d", 50, 50, 30)
        canvas.text("d", 50, 50)

    depths = fills(solid).positions[::4, 2]

    assert depths[0] - depths[1] == pytest.approx(30)
    assert (fills(flat).positions[:, 2] == 0).all()


def test_blanks_are_not_drawn(flat):
    flat.text(" \t\r", 50, 50)
    flat.text("", 50, 50)

    assert not drawn(flat).blocks


def test_a_thousand_letters_find_room(flat):
    flat.text("d" * 5000, 0, 50)

    assert len(corners(flat)) == 5000


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("a", "b", 3), "Got text for x"),
        (("a", 1, None), "Got None for y"),
        (("a", 1, 2, 3, "4"), "Got text for height"),
        (("a", 1, 2, 3, 4, 5), "takes"),
        ((["a", "b"], 0, 3, 10, 10), "a list that has 2"),
        ((["a", "b"], 0, 1, 10, 10, 0, 0), "takes"),
        (("a", 1e40, 2), "text\\(\\) is too large"),
    ],
)
def test_mistakes_are_told(flat, arguments, message):
    with pytest.raises(SketchError, match=message):
        flat.text(*arguments)
