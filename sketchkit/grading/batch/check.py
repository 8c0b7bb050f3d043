"""Trying an assignment: each of its references is handed in, twice, and so is an empty sketch."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.digest import digest_of
from sketchkit.grading.assignment.proof import free_marks, prove, unlike_evidence
from sketchkit.grading.assignment.references import sketch_of
from sketchkit.grading.batch.grade import prepare, setting_for
from sketchkit.grading.batch.judging import Task, judge_submission
from sketchkit.grading.batch.references import References, copy_files
from sketchkit.grading.batch.renders import Setting
from sketchkit.grading.intake.submission import Submission
from sketchkit.grading.results import StudentResult
from sketchkit.grading.sandbox.level import Level

EMPTY = "# This sketch does nothing.\n"
BARE = """\
def setup():
    size(100, 100)


def draw():
    background(255)
"""


class Findings(NamedTuple):
    """What was found out about an assignment, in sentences.

    Attributes
    ----------
    problems : list of str
        What is wrong; none if all is well.
    notes : list of str
        What may be meant: marks for a sketch that has `setup()` and `draw()`, and no more.
    """

    problems: list[str]
    notes: list[str]


def check(assignment: Assignment, level: Level) -> Findings:
    """Return what there is to say of an assignment.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    with tempfile.TemporaryDirectory() as folder:
        # Two folders, so that nothing of the first time is found again by the second.
        settings = [setting_for(assignment, Path(folder, name), level) for name in ("one", "two")]
        one, two = settings
        first, second = prepare(one), prepare(two)
        problems = list(dict.fromkeys(_problems(settings, first, second)))
        bare = _made_up("bare", BARE, one, first)
        return Findings(problems, list(free_marks(bare, "A sketch that only clears its picture")))


def _problems(settings: list[Setting], first: References, second: References) -> Iterator[str]:
    one, two = settings
    empty = _made_up("empty", EMPTY, one, first)
    assignment = one.assignment
    sketches = [name for name in assignment.references if sketch_of(assignment.folder / name)]
    if not sketches:
        yield from free_marks(empty)
    for name in sketches:
        yield from unlike_evidence(first.evidence[name], second.evidence[name])
        yield from prove(_handed_in(name, one, first), _handed_in(name, two, second), empty)


def _handed_in(name: str, setting: Setting, references: References) -> StudentResult:
    """Return the result of a reference, in the checks that accept it."""
    assignment = setting.assignment
    sketch = sketch_of(assignment.folder / name)
    assert sketch is not None
    folder = setting.workplace.staging / "submissions" / name
    is_alone = sketch == assignment.folder / name
    copy_files(sketch if is_alone else sketch.parent, folder)
    own = Submission(
        name, "reference", folder, PurePosixPath(sketch.name), digest=digest_of(folder, ["."])
    )
    result = judge_submission(Task(own, references.evidence, setting))
    accepted = {one.name for one in assignment.checks if name in one.references}
    return replace(result, checks=tuple(c for c in result.checks if c.name in accepted))


def _made_up(name: str, text: str, setting: Setting, references: References) -> StudentResult:
    """Return the result of a sketch that nobody has handed in."""
    folder = setting.workplace.staging / "submissions" / name
    folder.mkdir(parents=True)
    (folder / "sketch.py").write_text(text, encoding="utf-8")
    own = Submission(name, name, folder, PurePosixPath("sketch.py"), digest=name)
    return judge_submission(Task(own, references.evidence, setting))
