from importlib.resources import files

import pytest

from sketchkit.api import font_choice
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import SketchWarning
from tests.assets.fonts.test_vlw import font as vlw_bytes

BOLD = str(files("font_source_sans_pro") / "files" / "SourceSansPro-Bold.ttf")


@pytest.fixture
def computer(monkeypatch):
    """A computer whose only font is called Boldface."""
    monkeypatch.setattr(font_choice, "font_file", {"Boldface": BOLD}.get)


@pytest.fixture
def vlw(tmp_path):
    path = tmp_path / "Some-24.vlw"
    path.write_bytes(vlw_bytes())
    return str(path)


def test_a_font_is_set_at_its_own_size_or_another(flat):
    font = flat.createFont(BOLD, 30)

    flat.textFont(font)
    bold = flat.textWidth("Hello")
    flat.textFont(font, 60)

    assert bold == 71  # as in Processing
    assert flat.textWidth("Hello") == 138


def test_the_own_size_of_a_font_is_whole_as_in_processing(flat):
    flat.textFont(flat.createFont(BOLD, 12.5))

    assert (flat.textAscent(), flat.textDescent(), flat.textWidth("Hello")) == (9, 3, 31)


def test_a_fonts_letters_are_made_at_its_size(flat):
    flat.textFont(flat.createFont(BOLD, 50), 25)

    assert flat.textAscent() == 17.5  # 35 at 50, in Processing


@pytest.mark.parametrize("name", ["", "Source Sans Pro"])
def test_the_default_face_has_a_name(flat, name):
    flat.textFont(flat.createFont(name, 20))

    assert flat.textWidth("Hello") == 44


def test_a_font_of_the_computer_is_used_with_a_remark(flat, computer):
    with pytest.warns(SketchWarning, match="uses a font of this computer"):
        font = flat.createFont("Boldface", 30)

    flat.textFont(font)
    assert flat.textWidth("Hello") == 71


def test_a_font_that_the_computer_lacks_is_replaced_with_a_remark(flat, computer):
    with pytest.warns(SketchWarning, match="the default face takes its place"):
        font = flat.createFont("Comic Sans MS", 20)

    flat.textFont(font)
    assert flat.textWidth("Hello") == 44


def test_a_choice_of_characters_is_all_that_is_drawn(flat):
    flat.textFont(flat.createFont("", 20, True, ["H", "e"]))

    assert len(flat._set_face().line("Hello").quads) == 2
    assert flat.textWidth("Hello") == 44


@pytest.mark.parametrize("maker", ["loadFont", "createFont"])
def test_a_bitmap_font_has_one_size_that_others_enlarge(flat, vlw, maker):
    font = flat.loadFont(vlw) if maker == "loadFont" else flat.createFont(vlw, 10)

    flat.textFont(font)
    assert (flat.textWidth("dd"), flat.textAscent(), flat.textDescent()) == (8, 3, 1)

    flat.textSize(48)
    assert (flat.textWidth("dd"), flat.textAscent(), flat.textDescent()) == (16, 6, 2)


def test_what_a_bitmap_font_lacks_takes_no_room(flat, vlw):
    flat.textFont(flat.loadFont(vlw))

    assert flat.textWidth("d x") == 4
    assert len(flat._set_face().line("dxd").quads) == 2


def test_a_loaded_file_of_outlines_is_made_for_its_first_size(flat):
    font = flat.loadFont(BOLD)

    flat.textFont(font, 30)

    assert flat.textWidth("Hello") == 71
    assert flat._typography.design_size == 30


def test_a_size_of_a_font_that_is_not_above_0_is_ignored_with_a_remark(flat):
    with pytest.warns(SketchWarning, match="has no effect"):
        flat.textFont(flat.createFont("", 20), -1)

    assert flat.textWidth("Hello") == 44


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.textFont("Arial"), "createFont"),
        (lambda g: g.createFont("a.ttf", "b"), "Got text for size"),
        (lambda g: g.createFont("a.ttf", 0), "a size above 0"),
        (lambda g: g.createFont("nowhere.ttf", 12), "no file nowhere.ttf"),
        (lambda g: g.loadFont("nowhere.vlw"), "no file nowhere.vlw"),
    ],
)
def test_mistakes_are_told(flat, call, message):
    with pytest.raises(SketchError, match=message):
        call(flat)
