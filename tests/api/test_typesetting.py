from importlib.resources import files

import pytest

from sketchkit.core.constants import BASELINE, CENTER, JAVA2D, MODEL, SHAPE, TOP
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.canvases import new_canvas

BOLD = str(files("font_source_sans_pro") / "files" / "SourceSansPro-Bold.ttf")


def measures(canvas):
    return canvas.textWidth("Hello"), canvas.textAscent(), canvas.textDescent()


def test_at_first_the_default_face_at_12(flat):
    assert measures(flat) == (27, 9, 2)


def test_a_face_is_made_at_the_size_of_its_first_use(flat):
    flat.textSize(32)

    assert measures(flat) == (70, 23, 7)


def test_later_sizes_are_in_proportion(flat):
    flat.textWidth("")

    flat.textSize(64)

    assert measures(flat) == (141, 48, pytest.approx(10.6667, abs=1e-4))


def test_size_sets_the_leading(flat):
    flat.textLeading(50)

    flat.textSize(12)

    assert flat._typography.leading == pytest.approx(14.025)


def test_width_is_that_of_the_widest_line(flat):
    assert flat.textWidth("Hello\nHel\n") == 27
    assert flat.textWidth("") == 0
    assert flat.textWidth(3.14159) == flat.textWidth(" 3.142")


def test_align_across_alone_puts_the_baseline_back(flat):
    flat.textAlign(CENTER, TOP)
    flat.textAlign(CENTER)

    assert flat._typography.align_y == BASELINE


def test_a_style_takes_its_text_with_it(flat):
    flat.textSize(20)
    flat.pushStyle()
    flat.textFont(flat.createFont(BOLD, 30))
    flat.textAlign(CENTER)
    flat.popStyle()

    assert flat.textWidth("Hello") == 44


@pytest.mark.parametrize("size", [0, -3])
def test_a_size_that_is_not_above_0_is_ignored_with_a_remark(flat, size):
    with pytest.warns(SketchWarning, match="has no effect"):
        flat.textSize(size)

    assert measures(flat) == (27, 9, 2)


def test_a_leading_before_the_first_text_is_lost_as_in_processing(flat):
    flat.textLeading(50)
    flat.text("d", 0, 0)

    assert flat._typography.leading == pytest.approx(14.025)


def test_a_style_takes_the_mode_of_text_with_it(flat):
    flat.pushStyle()
    flat.textMode(SHAPE)
    flat.popStyle()

    assert flat._typography.mode == MODEL


def test_java2d_has_no_shapes_of_text():
    canvas = new_canvas(JAVA2D)

    with pytest.warns(SketchWarning, match="no effect in JAVA2D"):
        canvas.textMode(SHAPE)


def test_widths_in_java2d_are_fractions():
    canvas = new_canvas(JAVA2D)
    canvas.textSize(20)

    assert canvas.textWidth("a\tb") == pytest.approx(21.139968872070312)  # Processing's


def test_the_width_of_some_characters(flat):
    assert flat.textWidth(list("xHellox"), 1, 5) == flat.textWidth("Hello") == 27


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.textSize("12"), "Got text for size"),
        (lambda g: g.textLeading(None), "Got None for leading"),
        (lambda g: g.textAlign("TOP"), "takes LEFT, CENTER or RIGHT"),
        (lambda g: g.textAlign(CENTER, None), "TOP, CENTER, BASELINE or BOTTOM"),
        (lambda g: g.textMode(99), "MODEL or SHAPE"),
        (lambda g: g.textWidth(5, 0, 1), "textWidth"),
        (lambda g: g.textWidth(["a"], 0, 2), "a list that has 1"),
    ],
)
def test_mistakes_are_told(flat, call, message):
    with pytest.raises(SketchError, match=message):
        call(flat)
