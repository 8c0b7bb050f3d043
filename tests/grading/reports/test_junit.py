from dataclasses import replace
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.reports.junit import NO_DATE, junit
from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult
from sketchkit.grading.texts import visible
from tests.grading.reports.sample import HOSTILE, hostile_student

COUNTS = ("tests", "failures", "errors", "skipped")
# What the schemas of Ant's task and of Jenkins both allow: attributes, all of which Ant requires,
# and children in their order.
SCHEMA: dict[str, tuple[set[str], tuple[str, ...]]] = {
    "testsuites": (set(), ("testsuite",)),
    "testsuite": (
        {"name", "package", "id", "hostname", "timestamp", "time", *COUNTS},
        ("properties", "testcase", "system-out", "system-err"),
    ),
    "properties": (set(), ("property",)),
    "property": ({"name", "value"}, ()),
    "testcase": ({"name", "classname", "time"}, ("skipped", "error", "failure")),
    "skipped": (set(), ()),
    "error": ({"type", "message"}, ()),
    "failure": ({"type", "message"}, ()),
    "system-out": (set(), ()),
    "system-err": (set(), ()),
}
CHECKS = (
    CheckResult("Box", "image", 0.5, 1.25, 2.5, ("It is too dark.", "It is small.")),
    CheckResult("Loop", "source", 1.0, 1.0, 1.0),
)
STUDENT = StudentResult("Åsa", "Asa", Status.GRADED, checks=CHECKS, console="x")


def read(result: ClassResult) -> Element:
    return ElementTree.fromstring(junit(result))


def suite_of(student: StudentResult, record: dict[str, str] | None = None) -> Element:
    suite = read(ClassResult("Boxes", (student,), record or {})).find("testsuite")
    assert suite is not None
    return suite


def assert_follows_schema(element: Element) -> None:
    attributes, children = SCHEMA[element.tag]
    assert set(element.keys()) == attributes
    places = [children.index(child.tag) for child in element]
    assert places == sorted(places)
    for child in element:
        assert_follows_schema(child)


def test_check_that_cost_marks_is_a_failure_with_its_reasons() -> None:
    box, loop = suite_of(STUDENT).findall("testcase")

    failure = box.find("failure")
    assert failure is not None
    assert failure.attrib == {"type": "image", "message": "1.25 of 2.5 marks"}
    assert failure.text == "It is too dark.\nIt is small."
    assert box.get("classname") == "Asa"
    assert list(loop) == []


def test_what_happened_to_the_whole_is_an_error_of_its_own_case() -> None:
    crashed = replace(STUDENT, status=Status.CRASHED, explanation="Its process was killed.")

    suite = suite_of(crashed)

    case = suite.find("testcase")
    assert case is not None
    assert case.get("name") == "the sketch runs"
    assert [error.get("message") for error in case] == ["Its process was killed."]
    assert (suite.get("tests"), suite.get("errors"), suite.get("failures")) == ("3", "1", "1")


def test_checks_that_the_grader_failed_at_are_skipped() -> None:
    suite = suite_of(replace(STUDENT, status=Status.FAILED))

    assert [child.tag for case in suite.iter("testcase") for child in case] == [
        "error",
        "skipped",
        "skipped",
    ]
    assert (suite.get("skipped"), suite.get("failures")) == ("2", "0")


def test_record_is_in_the_properties_and_no_date_in_the_suite() -> None:
    suite = suite_of(STUDENT, {"seed": "42"})

    facts = {fact.get("name"): fact.get("value") for fact in suite.iter("property")}
    assert facts["record: seed"] == "42"
    assert facts["deterministic"] == "not tried"
    assert suite.get("timestamp") == NO_DATE


@given(st.text(st.characters()) | st.sampled_from(HOSTILE))
def test_every_text_comes_back_and_the_schema_holds(text: str) -> None:
    result = ClassResult(text, (hostile_student(text), STUDENT), {text: text})

    root = read(result)

    assert_follows_schema(root)
    suite = root[0]
    assert (suite.findtext("system-out") or "") == visible(text)
    assert suite.get("name")
