"""What a student's page shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sketchkit.grading.reports.charts import CurveChart, curve_chart
from sketchkit.grading.reports.figures import (
    has_marks,
    is_deterministic_in_words,
    is_full,
    plain,
)
from sketchkit.grading.reports.pictures import picture_uri
from sketchkit.grading.results import CheckResult, Comparison, Status, StudentResult


@dataclass(frozen=True)
class Pair:
    """Two pictures beside each other, as the template takes them."""

    label: str
    submitted: str
    expected: str
    heat: str
    caption: str


@dataclass(frozen=True)
class Section:
    """A check, as the template takes it."""

    name: str
    kind: str
    points: str
    out_of: str
    percent: str
    mood: str
    reasons: tuple[str, ...]
    pairs: tuple[Pair, ...]
    curves: tuple[tuple[str, CurveChart], ...]


def student_values(
    student: StudentResult, title: str, record: Mapping[str, str], folder: Path
) -> dict[str, object]:
    """Return what the template `student.html.j2` names."""
    return {
        "title": title,
        "name": student.name,
        "marks": plain(student.points) if has_marks(student) else "-",
        "out_of": plain(student.out_of),
        "percent": _percent(student.points, student.out_of),
        "mood": total_mood(student),
        "status": student.status.value,
        "is_graded": student.status is Status.GRADED,
        "explanation": student.explanation,
        "is_deterministic": student.is_deterministic,
        "sections": [_section(check, folder) for check in student.checks],
        "remarks": student.remarks,
        "console": student.console,
        "facts": {
            **record,
            "sandbox": student.sandbox or record.get("sandbox", "") or "not known",
            "draws the same in every run": is_deterministic_in_words(student),
        },
    }


def check_mood(check: CheckResult) -> str:
    """Return what a check is drawn as: "full", "most", "some" or "none"."""
    return "full" if is_full(check) else _mood(check.score)


def total_mood(student: StudentResult) -> str:
    """Return what all of a submission's checks are drawn as."""
    if student.checks and all(is_full(check) for check in student.checks):
        return "full"
    return _mood(student.points / student.out_of if student.out_of > 0 else 0.0)


def _mood(score: float) -> str:
    return "none" if score <= 0 else "most" if score >= 0.5 else "some"


def _section(check: CheckResult, folder: Path) -> Section:
    charts = [(curve.name, curve_chart(curve)) for curve in check.curves]
    return Section(
        name=check.name,
        kind=check.kind,
        points=plain(check.points),
        out_of=plain(check.out_of),
        percent=_percent(check.points, check.out_of),
        mood=check_mood(check),
        reasons=check.reasons,
        pairs=tuple(_pair(comparison, folder) for comparison in check.comparisons),
        curves=tuple((name, chart) for name, chart in charts if chart),
    )


def _pair(comparison: Comparison, folder: Path) -> Pair:
    pictures = (comparison.submitted, comparison.expected, comparison.difference)
    submitted, expected, heat = (picture_uri(folder, picture) for picture in pictures)
    caption = comparison.reason or ("These are alike." if comparison.is_alike else "")
    lost = [
        picture.name
        for picture, uri in zip(pictures, (submitted, expected, heat), strict=True)
        if picture and not uri
    ]
    if lost:
        caption = f"{caption} These pictures can no longer be read: {', '.join(lost)}.".strip()
    return Pair(comparison.label, submitted, expected, heat, caption)


def _percent(points: float, out_of: float) -> str:
    share = points / out_of if out_of > 0 else 0.0
    return f"{100 * min(max(share, 0.0), 1.0):.1f}"
