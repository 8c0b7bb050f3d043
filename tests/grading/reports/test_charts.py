import math

import pytest

from sketchkit.grading.reports.charts import axis, curve_chart, histogram
from sketchkit.grading.results import CheckResult, Curve, Status, StudentResult

NAN = math.nan


def graded(points: float, out_of: float = 10.0, status: Status = Status.GRADED) -> StudentResult:
    checks = (CheckResult("all", "image", points / out_of, points, out_of),)
    return StudentResult("a", "a", status, checks=checks)


@pytest.mark.parametrize(
    ("start", "end", "labels"),
    [
        (1, 60, ("0", "10", "20", "30", "40", "50", "60")),
        (0, 1, ("0.0", "0.2", "0.4", "0.6", "0.8", "1.0")),
        (-3, 3, ("-3", "-2", "-1", "0", "1", "2", "3")),
        (5, 5, ("4.4", "4.6", "4.8", "5.0", "5.2", "5.4", "5.6")),
    ],
    ids=["frames", "tenths", "both signs", "one value"],
)
def test_axis_is_divided_by_round_numbers(
    start: float, end: float, labels: tuple[str, ...]
) -> None:
    assert axis(start, end).labels == labels


def test_point_lies_where_its_frame_and_value_say() -> None:
    # Frames 0 to 10 and values 0 to 10 fill the chart; y points down.
    curve = Curve("y", (0, 5, 10), (0.0, 2.5, 10.0), (0.0,) * 3, (10.0,) * 3)

    chart = curve_chart(curve)

    assert chart is not None
    assert chart.lines == ("0.00,100.00 50.00,75.00 100.00,0.00",)
    assert chart.bands == (
        "0.00,0.00 50.00,0.00 100.00,0.00 100.00,100.00 50.00,100.00 0.00,100.00",
    )
    assert chart.outside == ()
    assert chart.words == "frames 0 to 10: never outside of the band."


def test_line_is_broken_where_there_is_no_number() -> None:
    values = (0.0, 1.0, NAN, 3.0, math.inf, math.inf)
    curve = Curve("y", (0, 2, 4, 6, 8, 10), values, (0.0,) * 6, (10.0,) * 6)

    chart = curve_chart(curve)

    assert chart is not None
    assert [line.count(",") for line in chart.lines] == [2, 2]  # the second is a dot
    assert chart.gaps == (("20.00", "40.00"), ("60.00", "40.00"))
    assert chart.words.endswith("3 without a number.")


def test_curve_that_shoots_off_does_not_press_the_band_flat() -> None:
    curve = Curve("y", (0, 10), (0.0, 1e30), (0.0, 0.0), (10.0, 10.0))

    chart = curve_chart(curve)

    assert chart is not None
    assert chart.y_labels[0] == "25"  # one and a half heights of the band above it
    assert chart.outside == (("100.00", "0.00"),)
    assert len(chart.lines[0]) < 40


def test_curve_without_numbers_or_without_frames_is_no_fault() -> None:
    chart = curve_chart(Curve("y", (1, 2), (NAN, NAN), (NAN, NAN), (NAN, NAN)))

    assert chart is not None
    assert chart.lines == chart.bands == ()
    assert chart.gaps == (("0.00", "100.00"),)
    assert curve_chart(Curve("y", (), (), (), ())) is None


def test_histogram_counts_marks_in_ranges_of_one_width() -> None:
    bars = histogram([graded(points) for points in (0, 0.5, 3, 9.99, 10)])

    assert [bar.label for bar in bars] == [f"{n}-{n + 1}" for n in range(10)]
    assert [bar.count for bar in bars] == [2, 0, 0, 1, 0, 0, 0, 0, 0, 2]
    assert bars[0].height == 2 * bars[3].height


def test_histogram_leaves_out_what_the_grader_failed_at() -> None:
    assert sum(bar.count for bar in histogram([graded(3), graded(0, status=Status.FAILED)])) == 1


def test_class_without_marks_has_no_histogram() -> None:
    assert histogram([]) == ()
    assert histogram([StudentResult("a", "a", Status.REFUSED)]) == ()
