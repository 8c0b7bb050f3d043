import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.data.delimited import read_csv, read_tsv, write_csv, write_html
from sketchkit.data.malformed import MalformedError
from sketchkit.data.text_files import decoded, lines_of

CELLS = st.text(st.characters(exclude_characters="\r", exclude_categories=["Cs"]), max_size=6)


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        pytest.param("a,b\n1,2", [["a", "b"], ["1", "2"]], id="no newline at the end"),
        pytest.param("a,\r\n,b\r\n", [["a", ""], ["", "b"]], id="blank cells, Windows' line ends"),
        pytest.param("a\n\nb\n", [["a"], [""], ["b"]], id="blank line"),
        pytest.param('"a ""b"", c",9\n', [['a "b", c', "9"]], id="quotes in quotes"),
        pytest.param('"a\nb",c', [["a\nb", "c"]], id="line end in quotes"),
        pytest.param('"a "b" c",d', [['a "b" c', "d"]], id="single quotes within quotes"),
        pytest.param('a ""b"",c', [['a "b"', "c"]], id="doubled quotes without quotes"),
        pytest.param("", [], id="nothing"),
    ],
)
def test_cells_are_those_of_processing(text: str, rows: list[list[str]]) -> None:
    assert read_csv(text) == rows


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        ('a,b\n1,"2', (2, 3), "opened and not closed"),
        ('a,b\n1,2"3', (2, 4), "must stand in quotes"),
    ],
)
def test_wrong_quote_is_told_with_its_place(
    text: str, place: tuple[int, int], problem: str
) -> None:
    with pytest.raises(MalformedError, match=problem) as caught:
        read_csv(text)

    assert (caught.value.line, caught.value.column) == place


@given(st.lists(st.lists(CELLS, min_size=1, max_size=4), max_size=5))
def test_what_is_written_is_read_again(rows: list[list[str]]) -> None:
    assert read_csv(write_csv(rows)) == rows


def test_tabs_separate_and_quotes_mean_nothing() -> None:
    assert read_tsv('a\t"b"\n\nc') == [["a", '"b"'], [""], ["c"]]


def test_page_has_no_markup_of_the_cells() -> None:
    assert "<td>&lt;b&gt;</td>" in write_html(None, [["<b>"]])


def test_lines_end_as_java_ends_them() -> None:
    assert lines_of("a\rb\r\nc\u2028d\x0be") == ["a", "b", "c\u2028d\x0be"]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_marks_at_the_beginning_are_understood(encoding: str) -> None:
    assert decoded("K\u00f6ln".encode(encoding)) == ("K\u00f6ln", True)
