"""What the page of a class shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from sketchkit.grading.reports.charts import histogram
from sketchkit.grading.reports.figures import (
    check_names,
    check_of,
    has_marks,
    is_deterministic_in_words,
    plain,
)
from sketchkit.grading.reports.order import Placed, in_order, usual_marks
from sketchkit.grading.reports.pictures import thumbnail_uri
from sketchkit.grading.reports.student import check_mood, total_mood
from sketchkit.grading.results import ClassResult, Status, StudentResult


@dataclass(frozen=True)
class Cell:
    """A check of a submission: marks as they are shown, and as they are sorted by."""

    text: str
    value: str
    mood: str


UNKNOWN = Cell("-", "-1", "unknown")  # sorted below 0


@dataclass(frozen=True)
class Row:
    """A submission, as the template takes it."""

    name: str
    link: str
    marks: Cell
    checks: tuple[Cell, ...]
    status: str
    is_graded: bool
    deterministic: str
    thumbnail: str
    remarks: tuple[str, ...]


def class_values(result: ClassResult, folder: Path, links: Mapping[str, Path]) -> dict[str, object]:
    """Return what the template `class.html.j2` names; `links` has the pages by slug."""
    names = check_names(result)
    placed = in_order(result.students)
    middle, distance = usual_marks(result.students)
    possible = max((student.out_of for student in result.students), default=0.0)
    return {
        "title": result.title,
        "checks": names,
        "rows": [_row(item, names, folder, links[item.student.slug]) for item in placed],
        "standing_out": sum(bool(item.remarks) for item in placed),
        "graded": sum(student.status is Status.GRADED for student in result.students),
        "median": plain(middle),
        "possible": plain(possible),
        "distance": plain(distance),
        "bars": histogram(result.students),
        "record": result.record,
        "sandboxes": _sandboxes(result),
    }


def _sandboxes(result: ClassResult) -> list[str]:
    """Return the levels that submissions ran at, if the record does not say it for all."""
    levels = sorted({student.sandbox for student in result.students if student.sandbox})
    return [] if levels == [result.record.get("sandbox")] else levels


def _row(placed: Placed, names: tuple[str, ...], folder: Path, link: Path) -> Row:
    student = placed.student
    return Row(
        name=student.name,
        link=quote(link.as_posix()),
        marks=_cell(student.points, total_mood(student)) if has_marks(student) else UNKNOWN,
        checks=tuple(_check_cell(student, name) for name in names),
        status=student.status.value,
        is_graded=student.status is Status.GRADED,
        deterministic=is_deterministic_in_words(student),
        thumbnail=thumbnail_uri(folder, student.thumbnail),
        remarks=placed.remarks,
    )


def _check_cell(student: StudentResult, name: str) -> Cell:
    check = check_of(student, name)
    if check is None or not has_marks(student):
        return UNKNOWN
    return _cell(check.points, check_mood(check))


def _cell(points: float, shown_as: str) -> Cell:
    return Cell(plain(points), f"{points:.4f}", shown_as)
