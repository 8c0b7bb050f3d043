"""`results.csv`: a row for each submission, for a spreadsheet.

UTF-8 with a byte order mark, without which Excel takes names for its own code page. In Python:
`open(path, encoding="utf-8-sig", newline="")`.
"""

from __future__ import annotations

import csv
import io

from sketchkit.grading.reports.figures import (
    check_names,
    check_of,
    has_marks,
    is_deterministic_in_words,
)
from sketchkit.grading.results import ClassResult, StudentResult
from sketchkit.grading.texts import visible

# A cell that begins so is run as a formula by some spreadsheet; the last four are wide forms that
# are taken for the first four.
FORMULA_STARTS = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")

Cell = str | float


def table(result: ClassResult) -> bytes:
    """Return a class's results as a CSV file.

    Marks that are not known are left empty: of a submission that the grader failed at, and of
    a check that was not made.
    """
    file = io.StringIO()
    # Where lists are separated by ";", as in German, a bare text would become several cells.
    writer = csv.writer(file, quoting=csv.QUOTE_NONNUMERIC)
    for row in rows(result):
        writer.writerow([safe(cell) if isinstance(cell, str) else cell for cell in row])
    return file.getvalue().encode("utf-8-sig")


def rows(result: ClassResult) -> list[list[Cell]]:
    """Return the table's head and its rows, in the order of the class."""
    names = check_names(result)
    head: list[Cell] = [
        *("name", "folder", "status", "marks", "out of"),
        *(f"check: {name}" for name in names),
        *("deterministic", "sandbox", "explanation"),
    ]
    return [head, *(_row(student, names) for student in result.students)]


def safe(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula; what cannot be seen has a sign.

    An apostrophe before it is what spreadsheets themselves write for "this is text".
    """
    shown = visible(text)
    is_risky = shown.lstrip().startswith(FORMULA_STARTS) or shown.startswith(("\t", "\n"))
    return f"'{shown}" if is_risky else shown


def _row(student: StudentResult, names: tuple[str, ...]) -> list[Cell]:
    is_known = has_marks(student)
    checks = [check_of(student, name) for name in names]
    return [
        *(student.name, student.slug, student.status.value),
        *((_number(student.points), _number(student.out_of)) if is_known else ("", "")),
        *(_number(check.points) if check and is_known else "" for check in checks),
        *(is_deterministic_in_words(student), student.sandbox, student.explanation),
    ]


def _number(value: float) -> float:
    return round(value, 4)
