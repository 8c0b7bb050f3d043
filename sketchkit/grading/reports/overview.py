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
    is_full,
    plain,
)
from sketchkit.grading.reports.order import Placed, in_order, usual_marks
from sketchkit.grading.reports.pictures import thumbnail_uri
from sketchkit.grading.reports.student import mood
from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult


@dataclass(frozen=True)
class Cell:
    """A check of a submission: marks as they are shown, and as they are sorted by."""

    text: str
    value: str
    mood: str


@dataclass(frozen=True)
class Row:
    """A submission, as the template takes it."""

    name: str
    link: str
    marks: Cell
    out_of: str
    checks: tuple[Cell, ...]
    status: str
    is_graded: bool
    deterministic: str
    seconds: str
    thumbnail: str
    remarks: tuple[str, ...]


def class_values(
    result: ClassResult, folder: Path, links: Mapping[str, Path]
) -> dict[str, object]:
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
        "sandboxes": sorted({student.sandbox for student in result.students if student.sandbox}),
    }


def _row(placed: Placed, names: tuple[str, ...], folder: Path, link: Path) -> Row:
    student = placed.student
    is_known = has_marks(student)
    share = student.points / student.out_of if student.out_of > 0 else 0.0
    is_all = bool(student.checks) and all(is_full(check) for check in student.checks)
    return Row(
        name=student.name,
        link=quote(link.as_posix()),
        marks=(
            Cell(plain(student.points), _value(student.points), "full" if is_all else mood(min(share, 0.99)))
            if is_known
            else UNKNOWN
        ),
        out_of=plain(student.out_of),
        checks=tuple(_cell(check_of(student, name), student) for name in names),
        status=student.status.value,
        is_graded=student.status is Status.GRADED,
        deterministic=is_deterministic_in_words(student),
        seconds=f"{student.seconds:.1f}",
        thumbnail=thumbnail_uri(folder, student.thumbnail),
        remarks=placed.remarks,
    )


UNKNOWN = Cell("–", "-1", "unknown")  # sorted below 0


def _cell(check: CheckResult | None, student: StudentResult) -> Cell:
    if check is None or not has_marks(student):
        return UNKNOWN
    shown = "full" if is_full(check) else mood(min(check.score, 0.99))
    return Cell(plain(check.points), _value(check.points), shown)


def _value(number: float) -> str:
    return f"{number:.4f}"
