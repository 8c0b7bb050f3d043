import base64
import hashlib
import html
import json
import math
import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.errors import SketchError
from sketchkit.grading.pages import writing
from sketchkit.grading.reports.overview import class_values
from sketchkit.grading.reports.student import student_values
from sketchkit.grading.reports.write import write_class, write_student
from sketchkit.grading.results import ClassResult, from_json
from sketchkit.grading.texts import visible
from tests.grading.reports.sample import (
    HOSTILE,
    RECORD,
    TITLE,
    hostile_class,
    hostile_student,
    make_class,
)

# What may load something or lead somewhere.
ADDRESSES = {"src", "href", "srcset", "action", "formaction", "data", "poster", "xlink:href"}
EMPTY = {"meta", "img", "input", "br", "link", "hr"}


class Page(HTMLParser):
    """What a page is made of: its elements, and its text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.words: list[str] = []
        self._open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, {name: value or "" for name, value in attrs}))
        if tag not in EMPTY:
            self._open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, {name: value or "" for name, value in attrs}))

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag  # what is opened is closed, in its order

    def handle_data(self, data: str) -> None:
        if not {"script", "style"} & set(self._open):
            self.words.append(data)

    def attributes(self, tag: str) -> Iterator[dict[str, str]]:
        return (attributes for name, attributes in self.elements if name == tag)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> tuple[ClassResult, Path]:
    folder = tmp_path_factory.mktemp("results")
    result = make_class(folder)
    write_class(result, folder)
    for student in result.students:
        write_student(student, result.title, result.record, folder)
    return result, folder


def every_page(folder: Path) -> list[str]:
    return [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.html"))]


def student_page(text: str) -> str:
    values = student_values(hostile_student(text), text, {text: text}, Path("none"))
    return writing.page("student.html.j2", **values)


def class_page(text: str) -> str:
    result = ClassResult(text, (hostile_student(text),), {text: text})
    values = class_values(result, Path("none"), {"hostile": Path("students/hostile/report.html")})
    return writing.page("class.html.j2", **values)


def shape(page: Page) -> list[tuple[str, list[str]]]:
    """Return elements and the names of their attributes."""
    return [(tag, sorted(attributes)) for tag, attributes in page.elements]


def test_pages_load_nothing_and_lead_nowhere_else(written: tuple[ClassResult, Path]) -> None:
    _, folder = written
    files = {path.relative_to(folder).as_posix() for path in folder.rglob("*")}

    for text in every_page(folder):
        page = Page(text)
        found = [
            value for _, attributes in page.elements for name, value in attributes.items()
            if name in ADDRESSES
        ]  # fmt: skip
        leading = [v for v in found if not v.startswith(("data:image/png;", "data:image/webp;"))]
        assert all(value.startswith("#check-") or value in files for value in leading)
        assert (
            not {"link", "iframe", "object", "embed", "base", "form"} & dict(page.elements).keys()
        )
        assert not re.search(r"@import|url\(", text)


def test_page_allows_its_own_script_and_style_alone(written: tuple[ClassResult, Path]) -> None:
    for text in every_page(written[1]):
        policies = [
            attributes["content"]
            for attributes in Page(text).attributes("meta")
            if attributes.get("http-equiv") == "Content-Security-Policy"
        ]
        allowed = dict(rule.split(" ", 1) for rule in policies[0].split("; "))
        for element in ("script", "style"):
            (inside,) = re.findall(f"<{element}>(.*?)</{element}>", text, re.DOTALL)
            digest = base64.b64encode(hashlib.sha256(inside.encode()).digest()).decode()
            assert allowed[f"{element}-src"] == f"'sha256-{digest}'"
        assert allowed["default-src"] == "'none'"
        assert allowed["img-src"] == "data:"
        # The policy forbids what stands in attributes.
        assert not any(
            name.startswith("on") or name == "style"
            for _, attributes in Page(text).elements
            for name in attributes
        )


@given(st.text(st.characters()) | st.sampled_from(HOSTILE))
def test_no_text_becomes_an_element_or_an_attribute(text: str) -> None:
    text = f"x{text}"  # what is empty has no element of its own
    for make in (student_page, class_page):
        page = Page(make(text))

        assert shape(page) == shape(Page(make("plain")))
        assert visible(text).strip() in "".join(page.words)


def test_student_page_shows_what_was_found_out(written: tuple[ClassResult, Path]) -> None:
    text = (written[1] / "students/student-04/report.html").read_text(encoding="utf-8")

    words = " ".join("".join(Page(text).words).split())

    for expected in (
        "Dara O'Neill",
        "4.75 of 10 marks",
        "The ball leaves its path in frames 21 to 40: it falls too fast.",
        "frames 1 to 60: 20 outside of the band.",
        "smooth() was called after something had been drawn.",
        "bubblewrap: no network, no files but its own",
        "renderer cpu",
        "seed 42",
        "draws the same in every run yes",
    ):
        assert expected in words
    assert text.count("data:image/png") == 6


def test_student_page_says_that_runs_differ(written: tuple[ClassResult, Path]) -> None:
    text = (written[1] / "students/student-11/report.html").read_text(encoding="utf-8")

    assert "Two runs of this sketch drew different pictures." in text


def test_picture_that_is_missing_is_said_to_be(written: tuple[ClassResult, Path]) -> None:
    text = (written[1] / "students/stopped/report.html").read_text(encoding="utf-8")

    assert "It stopped in frame 17." in text
    assert "No picture was drawn." in text


def test_picture_that_was_lost_is_named(written: tuple[ClassResult, Path], tmp_path: Path) -> None:
    (student,) = (s for s in written[0].students if s.name == "Dara O'Neill")

    write_student(student, TITLE, RECORD, tmp_path)

    text = (tmp_path / "students" / student.slug / "report.html").read_text(encoding="utf-8")
    assert "can no longer be read" in text


def test_student_sees_nothing_of_others(written: tuple[ClassResult, Path]) -> None:
    result, folder = written

    for student in result.students:
        place = folder / "students" / student.slug
        for path in (place / "report.html", place / "results.json"):
            text = path.read_text(encoding="utf-8")
            assert not any(
                f"students/{other.slug}" in text or visible(other.name) in html.unescape(text)
                for other in result.students
                if other is not student
            )


def test_overview_has_all_with_those_that_stand_out_first(
    written: tuple[ClassResult, Path],
) -> None:
    result, folder = written
    page = Page((folder / "index.html").read_text(encoding="utf-8"))

    links = [attributes["href"] for attributes in page.attributes("a")]
    rows = [link for link in links if link.startswith("students/")]

    assert rows[:5] == [
        f"students/{slug}/report.html"
        for slug in ("failed", "refused", "script", "stopped", "student-11")
    ]
    assert rows[: len(result.students)] == rows[len(result.students) :]  # cards, then the table
    assert all((folder / link).is_file() for link in links)
    assert len(list(page.attributes("img"))) == sum(
        student.thumbnail is not None for student in result.students
    )


def test_overview_of_a_large_class_is_small(tmp_path: Path) -> None:
    result = make_class(tmp_path)
    many = [
        replace(student, name=f"{student.name} {n}", slug=f"{student.slug}-{n}")
        for n in range(17)
        for student in result.students
    ]

    write_class(replace(result, students=tuple(many)), tmp_path)

    assert len(many) > 300
    assert (tmp_path / "index.html").stat().st_size < 3_000_000


def test_json_can_be_read_back(written: tuple[ClassResult, Path]) -> None:
    result, folder = written

    content = json.loads((folder / "results.json").read_text(), parse_constant=pytest.fail)

    read = from_json(ClassResult, content)
    values = [
        [v for s in r.students for c in s.checks for k in c.curves for v in k.values]
        for r in (result, read)
    ]
    assert all(a == b or (math.isnan(a) and math.isnan(b)) for a, b in zip(*values, strict=True))
    assert [replace(s, checks=()) for s in read.students] == [
        replace(s, checks=()) for s in result.students
    ]


def test_hostile_class_is_written_so_that_all_can_be_read(tmp_path: Path) -> None:
    result = hostile_class()

    write_class(result, tmp_path)
    for student in result.students:
        write_student(student, result.title, result.record, tmp_path)

    for path in tmp_path.rglob("*.json"):
        json.loads(path.read_text(encoding="ascii"))
        assert "\\ud800" not in path.read_text()
    assert len(ElementTree.parse(tmp_path / "results.xml").getroot()) == len(HOSTILE)
    for text in every_page(tmp_path):
        Page(text)


@pytest.mark.parametrize("slug", ["..", ".hidden", "a/b", "a\\b", "", "é", "a\n"])
def test_folder_of_a_student_cannot_lie_elsewhere(slug: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="slug"):
        write_student(hostile_student("a", slug), TITLE, RECORD, tmp_path)

    assert list(tmp_path.iterdir()) == []


def test_without_jinja_it_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    writing._renderer.cache_clear()

    with pytest.raises(SketchError, match=r"sketchkit\[grade\]"):
        write_class(hostile_class(), tmp_path)
