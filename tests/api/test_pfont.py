import pytest

from sketchkit.api.pfont import PFont
from sketchkit.core.errors import SketchError
from sketchkit.core.style import Typeface
from tests.api.test_font_choice import BOLD, vlw

__all__ = ["vlw"]  # a fixture


def test_a_font_knows_its_name_and_size(flat):
    font = flat.createFont(BOLD, 30.4)

    assert (font.getName(), font.getSize(), font.getDefaultSize()) == ("SourceSansPro-Bold", 30, 30)
    assert font.isSmooth()
    assert repr(font) == "<PFont SourceSansPro-Bold, 30>"
    assert flat.createFont("", 12).getName() == "Source Sans Pro"


def test_measures_are_parts_of_the_size(flat):
    font = flat.createFont("", 32)

    assert font.ascent() == pytest.approx(23 / 32)
    assert font.descent() == pytest.approx(7 / 32)
    assert font.width("H") == pytest.approx(21 / 32)


def test_fonts_of_the_computer_are_listed(flat, monkeypatch):
    monkeypatch.setattr("sketchkit.api.pfont.font_names", lambda: ["Serif", "Sans"])

    assert PFont.list() == ["Serif", "Sans"]


def test_points_lie_along_the_outlines(flat):
    points = flat.createFont("", 100).textToPoints("I", 10, 90, sampleFactor=0.25)

    sides = [p for p in points if round(p.x, 1) in (19.0, 27.3)]
    ends = [p for p in points if round(p.y, 1) in (90.0, 24.4)]
    assert len(points) == 37  # the letter is 8.3 wide and 65.6 high
    assert {(p.x, p.y) for p in [*sides, *ends]} == {(p.x, p.y) for p in points}


def test_finer_samples_are_more_points(flat):
    font = flat.createFont("", 100)

    coarse, fine = (len(font.textToPoints("as", 0, 0, 50, factor)) for factor in (0.1, 0.4))

    assert fine == pytest.approx(4 * coarse, rel=0.1)


def test_the_points_of_each_letter_follow_the_pen(flat):
    font = flat.createFont("", 100)

    alone, second = font.textToPoints("H", 0, 0), font.textToPoints("HH", 0, 0)

    assert len(second) == 2 * len(alone)
    assert second[-1].x - alone[-1].x == font.width("H") * 100


def test_a_letter_as_a_shape(flat):
    shape = flat.createFont("", 100).getShape("H")

    places = {(round(v.x, 1), round(v.y, 1)) for v in map(shape.getVertex, range(12))}
    assert shape.getVertexCount() == 12
    assert {y for _, y in places} == {-65.6, -38.1, -30.9, 0}


def test_less_detail_is_fewer_vertices(flat):
    font = flat.createFont("", 100)

    assert font.getShape("s", 10).getVertexCount() < font.getShape("s", 1).getVertexCount()


@pytest.mark.parametrize("method", ["textToPoints", "getShape"])
def test_a_bitmap_font_has_no_outlines(flat, vlw, method):
    font = flat.loadFont(vlw)

    with pytest.raises(SketchError, match=f"{method}\\(\\) needs outlines"):
        getattr(font, method)(*("d", 1, 2)[: 3 if method == "textToPoints" else 1])


@pytest.mark.parametrize("numbers", [("a", 2), (1, None), (1, 2, "x"), (1, 2, 10, 0)])
def test_numbers_that_are_none_are_told(flat, numbers):
    font = PFont(flat, Typeface(), 20)

    with pytest.raises(SketchError, match="textToPoints"):
        font.textToPoints("d", *numbers)
