import json
from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.reports.gradescope import gradescope
from sketchkit.grading.results import CheckResult, Comparison, Status, StudentResult
from tests.grading.reports.sample import HOSTILE, hostile_student

# What the documentation of the format has, and nothing else.
FIELDS = {
    "score": float,
    "output": str,
    "output_format": str,
    "test_output_format": str,
    "test_name_format": str,
    "stdout_visibility": str,
    "tests": list,
    "extra_data": dict,
}
TEST_FIELDS = {
    "score": float,
    "max_score": float,
    "status": str,
    "name": str,
    "name_format": str,
    "number": str,
    "output": str,
    "output_format": str,
    "visibility": str,
}
STUDENT = StudentResult(
    "Åsa",
    "Asa",
    Status.GRADED,
    checks=(
        CheckResult(
            "Box",
            "image",
            0.5,
            1.25,
            2.5,
            ("It is too dark.",),
            (
                Comparison("frame 1", reason="It is too dark."),
                Comparison("frame 30", reason="It is too small."),
            ),
        ),
        CheckResult("Loop", "source", 1.0, 1.0, 1.0),
    ),
    console="x = 1",
    remarks=("smooth() came late.",),
    is_deterministic=False,
    sandbox="bubblewrap",
)


def test_fields_are_those_of_the_format() -> None:
    result = gradescope(STUDENT, {"renderer": "cpu"})

    assert {name: type(value) for name, value in result.items()} == FIELDS
    for test in result["tests"]:
        assert {name: type(value) for name, value in test.items()} == TEST_FIELDS


def test_tests_have_marks_and_reasons_without_saying_one_twice() -> None:
    result = gradescope(STUDENT, {})
    box, loop = result["tests"]

    assert result["score"] == 2.25
    assert (box["score"], box["max_score"], box["status"]) == (1.25, 2.5, "failed")
    assert box["output"] == "It is too dark.\nframe 30: It is too small."
    assert (loop["score"], loop["max_score"], loop["status"]) == (1.0, 1.0, "passed")


def test_output_says_what_concerns_the_whole_submission() -> None:
    result = gradescope(STUDENT, {"renderer": "cpu"})

    assert "Draws the same in every run: no." in result["output"]
    assert "smooth() came late." in result["output"]
    assert "It printed:\nx = 1" in result["output"]
    assert "Sandbox: bubblewrap." in result["output"]
    assert result["extra_data"]["record"] == {"renderer": "cpu"}


def test_what_happened_is_said_first() -> None:
    refused = replace(STUDENT, status=Status.REFUSED, explanation="The archive is broken.")

    output = gradescope(replace(refused, checks=()), {})["output"]

    assert output.startswith("0 of 0 marks.\n\nThis sketch: refused. The archive is broken.")


@given(st.text(st.characters()) | st.sampled_from(HOSTILE))
def test_nothing_of_a_submission_is_taken_for_markup(text: str) -> None:
    result = gradescope(hostile_student(text), {text: text})

    formats = [result[name] for name in FIELDS if name.endswith("format")]
    formats += [test[name] for test in result["tests"] for name in test if name.endswith("format")]
    assert set(formats) == {"text"}
    assert json.loads(json.dumps(result, ensure_ascii=False).encode()) == result
