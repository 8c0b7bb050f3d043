"""What is expected here was told by Processing's own tables for the same file."""

from __future__ import annotations

import re
from math import isnan
from pathlib import Path

import pytest

from sketchkit.api.data.tables.table import Table
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.api.sketch import Sketch
from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch

PEOPLE = """name,age,height
Anna,12,1.52
"Ben ""B"" Smith, Jr.",9,

Cleo, 30 ,abc
"multi
line",7.9,2
"""


@pytest.fixture
def sketch(tmp_path: Path) -> Sketch:
    (tmp_path / "people.csv").write_text(PEOPLE)
    (tmp_path / "ragged.tsv").write_bytes(b"\xef\xbb\xbfa\tb\n1\t2\n3\n4\t5\t6\n")
    made = new_sketch(folder=tmp_path)
    made.take_over()
    return made


@pytest.fixture
def people(sketch: Sketch) -> Table:
    return sketch.loadTable("people.csv", "header")


def test_cells_are_text_and_numbers(people: Table) -> None:
    assert (people.getRowCount(), people.getColumnCount()) == (5, 3)
    assert people.getString(1, 0) == 'Ben "B" Smith, Jr.'
    assert (people.getString(1, "height"), people.getString(2, 0), people.getString(2, 1)) == (
        *("", ""),
        None,
    )
    assert [people.getInt(row, "age") for row in range(5)] == [12, 9, 0, 0, 7]
    assert (people.getFloat(0, "height"), people.getFloat(3, "age")) == (1.52, 30)
    assert isnan(people.getFloat(1, "height"))
    assert isnan(people.getFloat(3, "height"))


def test_rows_are_found(people: Table) -> None:
    assert people.findRow("9", "age").getString("name") == 'Ben "B" Smith, Jr.'
    assert people.findRow("zzz", "age") is None
    assert len(people.findRows("", "height")) == 1
    assert people.matchRow("eo$", "name").getInt("age") == 0
    assert people.matchRowIndices("n", "name") == [0, 1, 4]


def test_rows_that_match_are_all_found(people: Table) -> None:
    assert [row.getInt("age") for row in people.matchRows("n", "name")] == [12, 9, 7]
    assert people.matchRows("zzz", "name") == []

    found = people.matchRowIterator("n", "name")

    assert (next(found).getString("name"), next(found).getInt("age")) == ("Anna", 9)
    assert [row.getInt("age") for row in found] == [7]


def test_rows_and_columns_are_removed(people: Table) -> None:
    people.removeRow(1)
    people.removeColumn("age")
    people.removeColumn(0)

    assert (people.getRowCount(), people.getColumnTitles()) == (4, ["height"])
    assert people.getStringColumn("height") == ["1.52", None, "abc", "2"]

    people.clearRows()

    assert (people.getRowCount(), people.getColumnCount()) == (0, 1)
    assert people.addRow(["3"]).getInt("height") == 3


def test_row_knows_its_columns(people: Table) -> None:
    row = people.getRow(0)

    assert isinstance(row, TableRow)
    assert [row.getColumnTitle(place) for place in range(row.getColumnCount())] == [
        *("name", "age"),
        "height",
    ]
    assert Table([row]).getRow(0).getColumnTitle(1) == "age"


def test_rows_are_taken_as_the_items_of_a_list(people: Table) -> None:
    assert (people[0]["name"], people[-1].getInt("age")) == ("Anna", 7)
    assert [row.getInt("age") for row in people[:2]] == [12, 9]
    assert repr(Table([{"a": 1}])) == "Table of 1 row, 1 column"


def test_row_of_a_table_without_titles_has_none() -> None:
    table = Table()
    table.setString(0, 1, "x")

    assert table.getRow(0).getColumnTitle(1) is None


def test_rows_are_sorted_as_processing_leaves_them(people: Table) -> None:
    people.trim()

    people.sort("name")
    assert people.getStringColumn("name") == [
        *("", "Anna", 'Ben "B" Smith, Jr.', "Cleo"),
        "multi\nline",
    ]
    people.sortReverse("age")
    assert people.getStringColumn("age") == ["9", "7.9", "30", "12", None]


def test_columns_have_types(people: Table) -> None:
    people.setColumnType("age", "int")
    people.setColumnType("height", Table.FLOAT)
    people.setColumnType("name", "category")

    assert people.getColumnTypes() == [Table.CATEGORY, Table.INT, Table.FLOAT]
    assert (people.getString(3, "age"), people.getInt(4, "age")) == ("0", 7)
    assert (people.getString(3, "height"), people.getString(0, "height")) == (None, "1.52")
    assert (people.getInt(2, "name"), people.getString(2, "name")) == (2, "")


def test_cells_beyond_the_end_make_the_table_grow(people: Table) -> None:
    people.setInt(9, "age", 4)
    people.setString(0, "new", "x")

    assert (people.getRowCount(), people.getString(8, "age"), people.getColumnCount()) == (
        *(10, None),
        4,
    )


def test_lines_may_have_more_cells_than_titles(sketch: Sketch) -> None:
    table = sketch.loadTable("ragged.tsv", "header")

    assert table.getColumnTitles() == ["a", "b", None]
    assert (table.getString(1, 1), table.getString(2, 2)) == (None, "6")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("o.csv", PEOPLE.replace("\n\nCleo, 30 ", '\n,,\nCleo," 30 "')),
        (
            "o.tsv",
            'name\tage\theight\nAnna\t12\t1.52\nBen "B" Smith, Jr.\t9\t\n\t\t\n'
            "Cleo\t 30 \tabc\nmulti\nline\t7.9\t2\n",
        ),
    ],
)
def test_saved_file_is_that_of_processing(
    sketch: Sketch, people: Table, tmp_path: Path, name: str, text: str
) -> None:
    assert sketch.saveTable(people, name)

    assert (tmp_path / name).read_bytes().decode() == text


def test_new_table_is_filled_row_by_row() -> None:
    table = Table()
    table.addColumn("id", Table.INT)
    table.addColumn("x")
    row = table.addRow()
    row.setInt("id", 5)
    row["x"] = 2.5
    table.addRow(row)
    table.insertRow(1, [7, "ins"])

    assert table.getIntColumn("id") == [5, 7, 5]
    assert [(r["id"], r["x"]) for r in table] == [(5, "2.5"), (7, "ins"), (5, "2.5")]
    assert table.getTally("x") == {"2.5": 2, "ins": 1}
    assert table.getIntDict("x", "id") == {"2.5": 5, "ins": 7}


def test_cells_are_cleaned() -> None:
    table = Table([{"t": " banana "}, {"t": "can"}, {"t": ""}])

    table.trim()
    table.replace("can", "pan")
    table.replaceAll("(n)a", "$1-")
    table.removeTokens("b")

    assert table.getStringColumn(0) == ["an-n-", "pan"]


def test_titles_and_types_come_from_another_file(sketch: Sketch, tmp_path: Path) -> None:
    (tmp_path / "types.tsv").write_text("who\tstring\nyears\tint\n")
    (tmp_path / "bare.csv").write_text("Ida,12\nBen,x\n")

    table = sketch.loadTable("bare.csv", "dictionary=types.tsv")

    assert [(row["who"], row["years"]) for row in table.rows()] == [("Ida", 12), ("Ben", 0)]


@pytest.mark.parametrize(
    ("call", "problem"),
    [
        (lambda t: t.getInt(0, "heigth"), "people.csv has no column 'heigth'.\n.*'height'"),
        (lambda t: t.getRow(0).getInt("ag"), "Do you mean 'age'"),
        (lambda t: t.getString(77, 0), "no row 77.*\n.*Its rows are 0 to 4"),
        (lambda t: t.getString(0, 3), "Its columns are 0 to 2"),
        (lambda t: t.setInt(0, "new", 3), "no column 'new'"),
        (lambda t: t.setInt(0, "age", "x"), "takes a whole number"),
        (lambda t: t.setString(0, "age", 3), r"str\(3\)"),
        (lambda t: t.setColumnType("age", "integer"), "Table.STRING, INT"),
        (lambda t: t.matchRow("(", "age"), "regular expression"),
        (lambda t: t.matchRows("n", "nmae"), "Do you mean 'name'"),
        (lambda t: t[5], "no row 5"),
        (lambda t: t[-6], "no row -6"),
        (lambda t: t["age"], r"getStringColumn\('age'\) gives a column"),
        (lambda t: t.removeRow(5), "no row 5.*\n.*Its rows are 0 to 4"),
        (lambda t: t.removeColumn(3), "Its columns are 0 to 2"),
        (lambda t: t.getRow(0).getColumnTitle(3), "Its columns are 0 to 2"),
        (lambda t: t.save("o.txt"), '"csv", "tsv" or "html"'),
        (lambda t: Table().getInt(0, "a"), "has no titles"),
    ],
)
def test_mistakes_are_told(people: Table, call, problem: str) -> None:
    with pytest.raises(SketchError) as caught:
        call(people)

    assert re.search(problem, caught.value.message)


@pytest.mark.parametrize(
    ("name", "options", "problem"),
    [
        ("people.csv", "haeder", "Do you mean 'header'"),
        ("people.ods", None, "Save it as CSV"),
        ("people.txt", None, 'Write "csv" for commas'),
        ("peple.csv", None, "Do you mean 'people.csv'"),
        ("wrong.csv", "header", r"wrong\.csv, line 2, column 3: A quote is opened"),
    ],
)
def test_file_that_cannot_be_read_is_told(
    sketch: Sketch, tmp_path: Path, name: str, options: str | None, problem: str
) -> None:
    (tmp_path / "wrong.csv").write_text('a,b\n1,"2"x\n')

    with pytest.raises(SketchError) as caught:
        sketch.loadTable(name, options)

    assert re.search(problem, caught.value.message)


def test_text_stays_text_in_a_column_of_numbers_only_if_its_type_is_changed() -> None:
    table = Table([{"n": 1}])
    table.setColumnType("n", Table.INT)

    with pytest.raises(SketchError, match="cannot hold text"):
        table.setString(0, "n", "x")

    table.setColumnType("n", Table.STRING)
    table.setString(0, "n", "x")
    assert table.getString(0, "n") == "x"
