import csv
import io
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.reports.spreadsheet import safe, table
from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult
from sketchkit.grading.texts import visible
from tests.grading.reports.sample import HOSTILE, hostile_class

ANY_TEXT = st.text(st.characters()) | st.sampled_from(HOSTILE)


def read(data: bytes) -> list[list[str]]:
    return list(csv.reader(io.StringIO(data.decode("utf-8-sig"), newline="")))


def student(**changes: object) -> StudentResult:
    checks = (
        CheckResult("Box", "image", 0.5, 1.25, 2.5),
        CheckResult("Loop", "source", 1.0, 1.0, 1.0),
    )
    made = StudentResult("Åsa", "Asa", Status.GRADED, checks=checks, is_deterministic=True)
    return replace(made, **changes)


def test_row_has_marks_of_all_checks() -> None:
    assert read(table(ClassResult("Boxes", (student(),)))) == [
        [
            *("name", "folder", "status", "marks", "out of", "check: Box", "check: Loop"),
            *("deterministic", "sandbox", "explanation"),
        ],
        ["Åsa", "Asa", "graded", "2.25", "3.5", "1.25", "1.0", "yes", "", ""],
    ]


def test_file_begins_as_excel_expects_utf_8() -> None:
    assert table(ClassResult("Boxes", ())).startswith(b'\xef\xbb\xbf"name",')


def test_name_with_a_semicolon_is_one_cell_where_these_separate_cells() -> None:
    data = table(ClassResult("Boxes", (student(name="a;=1+1"),))).decode("utf-8-sig")

    rows = list(csv.reader(io.StringIO(data, newline=""), delimiter=";"))

    assert [len(row) for row in rows] == [1, 1]


def test_marks_of_what_the_grader_failed_at_are_empty_not_zero() -> None:
    refused = student(status=Status.REFUSED, checks=())
    failed = student(status=Status.FAILED)

    _, *rows = read(table(ClassResult("Boxes", (student(), refused, failed))))

    assert rows[1][3:7] == ["0", "0", "", ""]
    assert rows[2][3:7] == ["", "", "", ""]


@pytest.mark.parametrize(
    "text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", " =1", "\uff1d1+1", "\n=1", "\r\n=1"]
)
def test_formula_is_a_text(text: str) -> None:
    assert safe(text).startswith("'")


@pytest.mark.parametrize("text", ["Åsa", "a=1", "", "'quoted'", "1-2"])
def test_harmless_text_is_left_alone(text: str) -> None:
    assert safe(text) == text


@given(ANY_TEXT)
def test_every_text_is_one_cell_that_no_spreadsheet_runs(text: str) -> None:
    hostile = student(name=text, explanation=text, sandbox=text)

    head, row = read(table(ClassResult(text, (hostile,), {text: text})))

    assert len(row) == len(head)
    for cell in (row[0], row[-1], row[-2]):
        assert cell in (visible(text), f"'{visible(text)}")
        assert not cell.lstrip().startswith(("=", "+", "-", "@"))


def test_names_of_checks_are_safe_too() -> None:
    rows = read(table(hostile_class()))

    assert all(len(row) == len(rows[0]) == 8 + len(HOSTILE) for row in rows)
    assert not any(cell.startswith(("=", "@", "\t")) for row in rows for cell in row)
