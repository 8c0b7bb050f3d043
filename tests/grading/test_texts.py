from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.texts import visible, visible_line

ANY_TEXT = st.text(st.characters())  # with half pairs, controls, and what is no character


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("plain, Åsa 陈伟 🎈", "plain, Åsa 陈伟 🎈"),
        ("a\r\nb\tc\n", "a\nb\tc\n"),
        ("\x1b[31mred", "⟨U+001B⟩[31mred"),
        ("a\x00b\x7f", "a⟨U+0000⟩b⟨U+007F⟩"),
        ("\u202eexe.txt", "⟨U+202E⟩exe.txt"),
        ("\udc80", "⟨U+DC80⟩"),
        ("\U0010ffff", "⟨U+10FFFF⟩"),
        ("क\u200cष", "क\u200cष"),
    ],
    ids=["plain", "lines", "colours", "controls", "order", "half pair", "none", "joiner"],
)
def test_what_is_not_seen_gets_a_sign(text: str, expected: str) -> None:
    assert visible(text) == expected


def test_line_has_signs_for_its_breaks() -> None:
    assert visible_line("a\r\nb\tc") == "a⏎b⇥c"


@given(ANY_TEXT)
def test_every_text_can_be_encoded_and_stand_in_xml(text: str) -> None:
    shown = visible(text)
    element = ElementTree.Element("text", {"of": visible_line(text)})
    element.text = shown

    read = ElementTree.fromstring(ElementTree.tostring(element, encoding="utf-8"))

    assert (read.text or "") == shown
    assert read.get("of") == visible_line(text)


@given(ANY_TEXT)
def test_visible_text_stays_as_it_is(text: str) -> None:
    assert visible(visible(text)) == visible(text)
