import pytest

from sketchkit.data.wrapping import wrap


@pytest.mark.parametrize(
    ("text", "width", "lines"),
    [
        pytest.param("one two three", 8, ["one two", "three"], id="at spaces"),
        pytest.param("one two", 7, ["one", "two"], id="a line is narrower than the box"),
        pytest.param("a\n\nb", 9, ["a", "", "b"], id="newlines, empty lines too"),
        pytest.param("one  two", 6, ["one ", "two"], id="spaces before a break stay"),
        pytest.param("one    two", 5, ["one ", "two"], id="spaces after a break go"),
        pytest.param("abcdefghij", 4, ["abcd", "efgh", "ij"], id="within a long word"),
        pytest.param("ab abcdefghi k", 5, ["ab", "abcde", "fghi", "k"], id="word after word"),
        pytest.param("abcd", 4, ["abc", "d"], id="a word as wide as the box is cut"),
        pytest.param("x" * 30, 10, ["x" * 9, *["x" * 10] * 2, "x"], id="a very long word"),
        pytest.param("ab cd", 0, [], id="no room at all"),
        pytest.param("", 10, [""], id="nothing"),
        pytest.param("a\nbcd", 1, [], id="the text ends where nothing fits"),
    ],
)
def test_lines(text, width, lines):
    assert wrap(text, width, len) == lines
