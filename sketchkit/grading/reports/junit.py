"""`results.xml`: JUnit's form, for whatever shows the results of tests.

A suite for each submission, a case for each check. Elements, their order and their attributes are
those that the schemas of Ant's JUnit task and of Jenkins (junit-4, junit-10) have in common.
"""

from __future__ import annotations

from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from sketchkit.grading.reports.figures import (
    has_marks,
    is_deterministic_in_words,
    is_full,
    plain,
)
from sketchkit.grading.results import CheckResult, ClassResult, Status, StudentResult
from sketchkit.grading.texts import visible, visible_line

# The schemas demand a date. A real one would make each run's results differ.
NO_DATE = "1970-01-01T00:00:00"


def junit(result: ClassResult) -> bytes:
    """Return a class's results as XML.

    A check that cost marks is a failure. What happened to a submission as a whole is an error of
    a case of its own, "the sketch runs". Checks that the grader failed at are skipped.
    """
    root = Element("testsuites")
    for number, student in enumerate(result.students):
        _add_suite(root, number, student, result)
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _add_suite(root: Element, number: int, student: StudentResult, result: ClassResult) -> None:
    is_graded = student.status is Status.GRADED
    lost = [] if not has_marks(student) else [c for c in student.checks if not is_full(c)]
    suite = SubElement(
        root,
        "testsuite",
        name=visible_line(student.name).strip() or student.slug,
        package=visible_line(result.title).strip(),
        id=str(number),
        hostname="localhost",
        timestamp=NO_DATE,
        tests=str(len(student.checks) + (not is_graded)),
        failures=str(len(lost)),
        errors=str(int(not is_graded)),
        skipped=str(0 if has_marks(student) else len(student.checks)),
        time="0",
    )
    _add_properties(suite, student, result)
    if not is_graded:
        case = _add_case(suite, "the sketch runs", student)
        words = visible(student.explanation)
        error = SubElement(case, "error", type=student.status.value, message=words)
        error.text = words
    for check in student.checks:
        _add_check(suite, check, student)
    SubElement(suite, "system-out").text = visible(student.console)
    SubElement(suite, "system-err").text = visible("\n".join(student.remarks))


def _add_properties(suite: Element, student: StudentResult, result: ClassResult) -> None:
    properties = SubElement(suite, "properties")
    facts = {
        "assignment": result.title,
        "folder": student.slug,
        "marks": plain(student.points) if has_marks(student) else "",
        "out of": plain(student.out_of),
        "deterministic": is_deterministic_in_words(student),
        "sandbox": student.sandbox,
        **{f"record: {name}": text for name, text in result.record.items()},
    }
    for name, value in facts.items():
        SubElement(properties, "property", name=visible_line(name), value=visible_line(value))


def _add_check(suite: Element, check: CheckResult, student: StudentResult) -> None:
    case = _add_case(suite, check.name, student)
    if not has_marks(student):
        SubElement(case, "skipped")
    elif not is_full(check):
        marks = f"{plain(check.points)} of {plain(check.out_of)} marks"
        failure = SubElement(case, "failure", type=visible_line(check.kind), message=marks)
        failure.text = visible("\n".join(check.reasons))


def _add_case(suite: Element, name: str, student: StudentResult) -> Element:
    shown = visible_line(name)
    return SubElement(suite, "testcase", name=shown, classname=student.slug, time="0")
