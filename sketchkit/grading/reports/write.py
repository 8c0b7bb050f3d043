"""Write a class's results: a page for each submission, one of the class, and files for programs.

In the folder of results:

- `index.html`, `results.csv`, `results.json`, `results.xml` (JUnit): the class;
- `students/<slug>/report.html`: what a student may see, and nothing of others;
- `students/<slug>/results.json`: the same in Gradescope's form.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path

from sketchkit.assets.output import write_file
from sketchkit.grading.pages.writing import page
from sketchkit.grading.reports.gradescope import gradescope
from sketchkit.grading.reports.junit import junit
from sketchkit.grading.reports.overview import class_values
from sketchkit.grading.reports.spreadsheet import table
from sketchkit.grading.reports.student import student_values
from sketchkit.grading.results import ClassResult, StudentResult, to_json

_SURROGATE = re.compile("[\ud800-\udfff]")


def write_student(
    student: StudentResult, title: str, record: Mapping[str, str], folder: Path
) -> None:
    """Write a student's page, and the same for Gradescope.

    Parameters
    ----------
    student : StudentResult
    title : str
        The assignment's.
    record : mapping of str to str
        What it was made with, as in `ClassResult`.
    folder : Path
        Of the results: pictures' paths are relative to it.

    Raises
    ------
    SketchError
        If Jinja is not installed.
    """
    place = folder / student_folder(student)
    text = page("student.html.j2", **student_values(student, title, record, folder))
    write_file(place / "report.html", text.encode())
    write_file(place / "results.json", _json(gradescope(student, record)))


def write_class(result: ClassResult, folder: Path) -> None:
    """Write the overview of a class and its results as CSV, JSON and JUnit XML.

    Raises
    ------
    SketchError
        If Jinja is not installed.
    """
    links = {student.slug: student_folder(student) / "report.html" for student in result.students}
    text = page("class.html.j2", **class_values(result, folder, links))
    write_file(folder / "index.html", text.encode())
    write_file(folder / "results.csv", table(result))
    write_file(folder / "results.json", _json(to_json(result)))
    write_file(folder / "results.xml", junit(result))


def student_folder(student: StudentResult) -> Path:
    """Return where a student's files lie, relative to the results.

    Raises
    ------
    ValueError
        If its slug is no plain file name: that would lead elsewhere.
    """
    if not re.fullmatch(r"[A-Za-z0-9_-][A-Za-z0-9._-]*", student.slug):
        raise ValueError(f"a slug is a plain file name, not {student.slug!r}")
    return Path("students") / student.slug


def _json(content: object) -> bytes:
    """Return JSON that every reader takes: ASCII, and no half of a pair."""
    text = json.dumps(_without_surrogates(content), indent=1, allow_nan=False)
    return f"{text}\n".encode("ascii")


def _without_surrogates(content: object) -> object:
    match content:
        case str():
            return _SURROGATE.sub(lambda match: f"⟨U+{ord(match[0]):04X}⟩", content)
        case dict():
            return {
                _without_surrogates(key): _without_surrogates(item) for key, item in content.items()
            }
        case list():
            return [_without_surrogates(item) for item in content]
        case _:
            return content
