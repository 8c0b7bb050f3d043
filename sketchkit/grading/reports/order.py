"""In which order a class is looked at: who stands out comes first.

First come submissions that something happened to, then those whose marks lie far from the
others', then the rest by name.
"""

from __future__ import annotations

import statistics
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from sketchkit.grading.results import Status, StudentResult

# What a modified z-score over 3.5 says: for a normal distribution the median of distances from the
# median is 0.6745 of the standard deviation (Iglewicz and Hoaglin, How to Detect and Handle
# Outliers, 1993).
FAR = 3.5 / 0.6745
# In a class that nearly all did equally well the median distance is 0, and then every lost mark
# would stand out.
LEAST_DISTANCE = 0.1  # of the marks that are possible

# The gravest first.
INCIDENTS = (Status.FAILED, Status.REFUSED, Status.CRASHED, Status.OVER_LIMIT, Status.STOPPED)


@dataclass(frozen=True)
class Placed:
    """A submission in its place.

    Attributes
    ----------
    student : StudentResult
    remarks : tuple of str
        Why it stands out: "crashed", "differs from run to run", "marks far below the others".
    """

    student: StudentResult
    remarks: tuple[str, ...] = ()


def in_order(students: Sequence[StudentResult]) -> tuple[Placed, ...]:
    """Return submissions, those that stand out first, each with why it does."""
    middle, distance = usual_marks(students)

    def place(student: StudentResult) -> tuple[tuple[int, float, tuple[str, str]], Placed]:
        remarks = _incidents(student)
        away = student.points - middle if student.status is Status.GRADED else 0.0
        is_far = abs(away) > distance
        if is_far:
            remarks = (*remarks, f"marks far {'below' if away < 0 else 'above'} the others")
        return (_rank(student), -abs(away) if is_far else 0.0, _by_name(student)), Placed(
            student, remarks
        )

    return tuple(placed for _, placed in sorted(map(place, students), key=lambda item: item[0]))


def usual_marks(students: Sequence[StudentResult]) -> tuple[float, float]:
    """Return the median of the marks of those that were graded, and how far from it is far."""
    marks = [student.points for student in students if student.status is Status.GRADED]
    if not marks:
        return 0.0, 0.0
    middle = statistics.median(marks)
    spread = statistics.median(abs(points - middle) for points in marks)
    possible = max(student.out_of for student in students)
    return middle, max(FAR * spread, LEAST_DISTANCE * possible)


def _incidents(student: StudentResult) -> tuple[str, ...]:
    remarks = () if student.status is Status.GRADED else (student.status.value,)
    return (*remarks, "differs from run to run") if student.is_deterministic is False else remarks


def _rank(student: StudentResult) -> int:
    if student.status in INCIDENTS:
        return INCIDENTS.index(student.status)
    return len(INCIDENTS) if student.is_deterministic is False else len(INCIDENTS) + 1


def _by_name(student: StudentResult) -> tuple[str, str]:
    """Return what names are sorted by: letters without case and accents, then the name itself."""
    letters = unicodedata.normalize("NFKD", student.name).casefold()
    return "".join(c for c in letters if not unicodedata.combining(c)), student.name
