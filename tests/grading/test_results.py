import json
import math
from pathlib import Path

import pytest

from sketchkit.grading.evidence import Evidence, RunEvidence, Trace
from sketchkit.grading.results import (
    CheckResult,
    ClassResult,
    Comparison,
    Curve,
    Status,
    StudentResult,
    from_json,
    to_json,
)

CLASS = ClassResult(
    "Boxes",
    (
        StudentResult(
            "Åsa B. (42)",
            "Asa-B-42",
            Status.OVER_LIMIT,
            "It needed more than 10 s.",
            (
                CheckResult(
                    "A box",
                    "image",
                    0.5,
                    2.0,
                    4.0,
                    ("It is too dark.",),
                    (Comparison("frame 1", Path("a/b.png"), None, None, 0.2, 0.9, 40, False),),
                    (Curve("x", (1, 2), (0.5, 1.0), (0.0, 0.0), (1.0, 2.0)),),
                ),
            ),
            is_deterministic=True,
            thumbnail=Path("a/b.png"),
        ),
    ),
    {"renderer": "cpu"},
)
EVIDENCE = Evidence(
    {
        "": RunEvidence(
            Status.GRADED,
            frames={1: Path("/frames/1.png")},
            traces={1: Trace({"box": 2}, nesting=1, shaders={"wave.vert": ("time",)})},
            values={"x": (1.0, 2.0)},
        )
    }
)


@pytest.mark.parametrize("value", [CLASS, EVIDENCE], ids=["results", "evidence"])
def test_what_is_written_as_json_can_be_read_again(value: ClassResult | Evidence) -> None:
    text = json.dumps(to_json(value))

    assert from_json(type(value), json.loads(text)) == value


def test_marks_are_the_sum_of_the_checks() -> None:
    (student,) = CLASS.students

    assert (student.points, student.out_of) == (2.0, 4.0)


def test_something_else_is_refused() -> None:
    with pytest.raises((KeyError, TypeError, ValueError)):
        from_json(ClassResult, {"title": "Boxes"})


def test_what_is_no_number_is_written_as_json_allows() -> None:
    curve = Curve("x", (1, 2), (math.nan, -math.inf), (0.0, 0.0), (1.0, math.inf))

    text = json.dumps(to_json(curve), allow_nan=False)

    read = from_json(Curve, json.loads(text))
    assert math.isnan(read.values[0])
    assert (read.values[1], read.high[1]) == (-math.inf, math.inf)
