"""A class of sixty, graded as an instructor would: by the command, in a process of its own."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from sketchkit.grading.results import ClassResult, StudentResult, from_json
from sketchkit.grading.sandbox.level import Level
from tests.grading.class_of_sixty.assignment import SECRET, write_assignment
from tests.grading.class_of_sixty.submissions import CASES, Case

SECRET_VARIABLE = "SKETCHKIT_TEST_SECRET"
MARK = "owned-by-a-sketch"  # the file that hostile sketches try to leave behind


@dataclass(frozen=True)
class Graded:
    """What a class's grading has left behind."""

    folder: Path
    result: ClassResult
    run: subprocess.CompletedProcess[str]

    def of(self, case: Case) -> StudentResult:
        return next(student for student in self.result.students if student.name == case.name)


def hand_in(folder: Path, case: Case, way: int) -> None:
    """Hand a sketch in as a file, as a folder or as a zip file."""
    name = "sketch.py"
    match way % 3:
        case 0:
            (folder / f"{case.name}.py").write_text(case.text, encoding="utf-8")
        case 1:
            (folder / case.name).mkdir()
            (folder / case.name / name).write_text(case.text, encoding="utf-8")
        case _:
            with zipfile.ZipFile(folder / f"{case.name}.zip", "w") as archive:
                archive.writestr(f"{case.name[:20]}/{name}", case.text)


def grade(assignment: Path, submissions: Path, out: Path, *options: str) -> list[str]:
    """Return the command that grades."""
    places = [str(assignment), str(submissions), "--out", str(out)]
    return [sys.executable, "-m", "sketchkit", "grade", *places, "--workers", "2", *options]


@pytest.fixture(scope="module")
def graded(walled: Level, tmp_path_factory: pytest.TempPathFactory) -> Graded:
    top = tmp_path_factory.mktemp("class")
    assignment, submissions = write_assignment(top / "assignment"), top / "submissions"
    submissions.mkdir()
    for way, case in enumerate(CASES):
        hand_in(submissions, case, way)
    environment = {**os.environ, SECRET_VARIABLE: "do not tell"}
    command = grade(assignment, submissions, top / "results")
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr[-3000:]
    content = json.loads((top / "results" / "results.json").read_text())
    return Graded(top / "results", from_json(ClassResult, content), run)


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_everybody_gets_what_is_due(graded: Graded, case: Case) -> None:
    student = graded.of(case)

    words = [student.explanation, student.console]
    words += [reason for check in student.checks for reason in check.reasons]
    lowest, highest = case.marks
    assert lowest <= student.points <= highest, words
    assert student.status in case.status, words
    assert case.said in "\n".join(words)


def test_nobody_is_lost(graded: Graded) -> None:
    with (graded.folder / "results.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))

    assert len(rows) == len(graded.result.students) == len(CASES)
    for student in graded.result.students:
        assert (graded.folder / "students" / student.slug / "report.html").is_file()


def test_level_of_the_sandbox_is_told_first(graded: Graded) -> None:
    assert graded.run.stderr.startswith("Sandbox: ")
    assert all(student.sandbox in graded.run.stderr for student in graded.result.students)


def test_nothing_that_was_to_be_hidden_was_found(graded: Graded) -> None:
    printed = "\n".join(student.console for student in graded.result.students)

    for word in ("FOUND", "do not tell", "CONNECTED", "root:", "LOADED", SECRET):
        assert word not in printed
    assert "SECRET None" in printed


def test_nothing_was_written_outside(graded: Graded) -> None:
    places = [Path("/"), Path("/usr"), Path("/etc"), Path("/tmp"), Path.home()]

    assert [place for place in places if (place / MARK).exists()] == []
    assert list(graded.folder.rglob(MARK)) == []


def test_nothing_is_left_running(graded: Graded) -> None:
    assert [line for line in running() if str(graded.folder) in line] == []


def test_what_differs_from_time_to_time_is_marked(graded: Graded) -> None:
    wavering = [s.name for s in graded.result.students if s.is_deterministic is False]

    assert wavering == ["Not the same twice"]


def running() -> Iterator[str]:
    """Yield the command lines of all processes."""
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            yield entry.read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue
