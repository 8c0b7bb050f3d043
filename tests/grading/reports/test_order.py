from dataclasses import replace

from sketchkit.grading.reports.order import in_order, usual_marks
from sketchkit.grading.results import CheckResult, Status, StudentResult


def student(name: str, points: float, status: Status = Status.GRADED) -> StudentResult:
    check = CheckResult("all", "image", points / 10, points, 10.0)
    return StudentResult(name, name, status, checks=(check,))


def names(students: list[StudentResult]) -> list[str]:
    return [placed.student.name for placed in in_order(students)]


def test_rest_is_in_order_of_names_whatever_their_case_and_accents() -> None:
    assert names([student(name, 8) for name in ("zoe", "Émile", "Bea", "eva")]) == [
        "Bea",
        "Émile",
        "eva",
        "zoe",
    ]


def test_what_happened_to_comes_first_and_the_gravest_of_it() -> None:
    unlike = replace(student("unlike", 8), is_deterministic=False)
    statuses = [Status.STOPPED, Status.CRASHED, Status.OVER_LIMIT, Status.REFUSED, Status.FAILED]
    happened = [student(status.name, 0, status) for status in statuses]

    assert names([student("a", 8), student("b", 8), unlike, *happened]) == [
        "FAILED",
        "REFUSED",
        "CRASHED",
        "OVER_LIMIT",
        "STOPPED",
        "unlike",
        "a",
        "b",
    ]


def test_far_is_three_and_a_half_scaled_median_distances() -> None:
    # Median 6, distances 2 1 1 0 0 1 2: median 1, so that 3.5 / 0.6745 = 5.189 is far.
    marks = [4, 5, 5, 6, 6, 7, 8]

    middle, distance = usual_marks([student(str(n), points) for n, points in enumerate(marks)])

    assert middle == 6
    assert abs(distance - 5.18903) < 1e-4


def test_far_marks_come_before_the_rest_the_farthest_first() -> None:
    # All others have 8: a tenth of the marks, 1, is the least that is far.
    usual = [student(name, 8) for name in "abcde"]

    placed = in_order([*usual, student("near", 7), student("low", 3), student("top", 9.5)])

    assert [item.student.name for item in placed[:2]] == ["low", "top"]
    assert [item.remarks for item in placed[:3]] == [
        ("marks far below the others",),
        ("marks far above the others",),
        (),
    ]


def test_marks_of_who_crashed_do_not_move_the_median() -> None:
    crashed = [student(f"c{n}", 0, Status.CRASHED) for n in range(5)]

    assert usual_marks([*crashed, student("a", 7), student("b", 9)])[0] == 8


def test_class_without_any_graded_has_an_order() -> None:
    assert names([student("b", 0, Status.FAILED), student("a", 0, Status.FAILED)]) == ["a", "b"]
    assert in_order([]) == ()
