from importlib.resources import files

import pytest

from sketchkit.core.constants import BASELINE, CENTER, MODEL, SHAPE, TOP
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning

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


def test_a_font_is_set_at_its_own_size_or_another(flat):
    font = flat.createFont(BOLD, 30)

    flat.textFont(font)
    bold = flat.textWidth("Hello")
    flat.textFont(font, 60)

    assert (font.getName(), font.getSize()) == ("SourceSansPro-Bold", 30)
    assert flat.textWidth("Hello") == pytest.approx(2 * bold, abs=5)
    assert bold > 66  # of the regular face


def test_a_fonts_ascent_is_a_part_of_its_size(flat):
    font = flat.createFont("", 32)

    assert font.ascent() == pytest.approx(23 / 32)
    assert font.descent() == pytest.approx(7 / 32)


def test_a_font_of_the_system_is_replaced_with_a_remark(flat):
    with pytest.warns(SketchWarning, match="the default face takes its place"):
        font = flat.createFont("Comic Sans MS", 20)

    flat.textFont(font)
    assert flat.textWidth("Hello") == 44


@pytest.mark.parametrize("size", [0, -3])
def test_a_size_that_is_not_above_0_is_ignored_with_a_remark(flat, size):
    with pytest.warns(SketchWarning, match="has no effect"):
        flat.textSize(size)

    assert measures(flat) == (27, 9, 2)


@pytest.mark.parametrize("mode", [MODEL, SHAPE])
def test_text_modes_are_accepted(flat, mode):
    flat.textMode(mode)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.textSize("12"), "Got text for size"),
        (lambda g: g.textLeading(None), "Got None for leading"),
        (lambda g: g.textAlign(TOP), "takes LEFT, CENTER or RIGHT"),
        (lambda g: g.textAlign(CENTER, 5), "TOP, CENTER, BASELINE or BOTTOM"),
        (lambda g: g.textMode(99), "MODEL or SHAPE"),
        (lambda g: g.textFont("Arial"), "createFont"),
        (lambda g: g.createFont("a.ttf", "b"), "Got text for size"),
        (lambda g: g.createFont("a.ttf", 0), "a size above 0"),
        (lambda g: g.createFont("nowhere.ttf", 12), "no file nowhere.ttf"),
    ],
)
def test_mistakes_are_told(flat, call, message):
    with pytest.raises(SketchError, match=message):
        call(flat)
