import subprocess
import sys

import pytest

from sketchkit.assets.fonts.letters import BLANK, check_font, letters_of
from sketchkit.core.errors import SketchError
from sketchkit.core.style import Typeface

DEFAULT = letters_of(Typeface())


@pytest.mark.parametrize("character", ["\t", "\r", "\n", "\u2028"])
def test_control_characters_take_no_room_and_show_nothing(character):
    assert DEFAULT.advance(character, 12, is_hinted=True) == 0
    assert DEFAULT.shape(character, 12, is_hinted=True) is BLANK


def test_a_space_takes_room_and_shows_nothing():
    assert DEFAULT.advance(" ", 12, is_hinted=True) == 2
    assert DEFAULT.shape(" ", 12, is_hinted=True) is BLANK


@pytest.mark.parametrize("character", ["\u4e2d", "\u05e9", "\U0001f600", "\x01"])
def test_what_the_font_lacks_leaves_a_gap_in_p2d_and_shows_a_sign_in_java2d(character):
    assert DEFAULT.shape(character, 20, is_hinted=True) is None
    assert DEFAULT.advance(character, 20, is_hinted=True) == 13  # Processing's textWidth()
    assert DEFAULT.shape(character, 20, is_hinted=False).mask.any()


@pytest.mark.parametrize("character", "\u00e9\u00df\u03a9\u0416\u20ac\ufb01\u2026")
def test_letters_of_many_scripts_are_there(character):
    assert DEFAULT.shape(character, 20, is_hinted=True).mask.any()


def test_widths_without_hints_are_fractions():
    # Processing's textWidth("a") and of what the font lacks, in JAVA2D at 20 pixels.
    assert DEFAULT.advance("a", 20, is_hinted=False) == pytest.approx(10.079986572265625)
    assert DEFAULT.advance("\u4e2d", 20, is_hinted=False) == pytest.approx(13.059982299804688)


def test_pairs_of_letters_are_kerned():
    assert DEFAULT.kerning("T", "o", 100) < -5
    assert DEFAULT.kerning("H", "H", 100) == 0


def test_a_choice_of_characters_leaves_out_the_others():
    chosen = letters_of(Typeface("", True, frozenset("ab")))

    assert chosen.shape("a", 20, is_hinted=True) is not None
    assert chosen.shape("c", 20, is_hinted=True) is None
    assert chosen.made_at_once == "ab"


def test_letters_that_are_not_smooth_have_two_levels():
    rough = letters_of(Typeface("", False, None))

    assert set(rough.shape("g", 20, is_hinted=True).mask.ravel().tolist()) == {0, 255}


@pytest.mark.parametrize("size", [0.01, 0.4, 70_000.0, 1e9])
def test_there_are_letters_of_every_size(size):
    assert DEFAULT.shape("a", size, is_hinted=True).mask.size
    assert DEFAULT.advance("a", size, is_hinted=True) >= 0


def test_what_is_no_font_is_told(tmp_path):
    path = tmp_path / "letters.ttf"
    path.write_text("abc")

    with pytest.raises(SketchError, match=r"letters\.ttf cannot be read"):
        check_font(str(path))


def test_letters_look_the_same_in_a_sketch_that_uses_pillow_s_fonts_itself():
    program = """
import sketchkit.api.graphics
{imported}
from sketchkit.assets.fonts.letters import letters_of
from sketchkit.core.style import Typeface
print(letters_of(Typeface()).shape("%", 14, is_hinted=True).mask.tolist())
"""
    with_pillow, without = (
        subprocess.check_output([sys.executable, "-c", program.format(imported=imported)])
        for imported in ("from PIL import ImageFont", "")
    )

    assert with_pillow == without
