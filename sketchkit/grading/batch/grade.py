"""Grading a class: references first, then each submission; whatever is known is on disk at once."""

from __future__ import annotations

import compileall
import json
import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sketchkit import __version__
from sketchkit.assets.output import write_file
from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.batch.executors import Executor
from sketchkit.grading.batch.judging import Task
from sketchkit.grading.batch.references import References, show_references
from sketchkit.grading.batch.renders import PACKAGE, Setting, code_digest, sha
from sketchkit.grading.batch.workplace import Workplace
from sketchkit.grading.intake.submission import Submission
from sketchkit.grading.reports.write import write_class, write_student
from sketchkit.grading.results import ClassResult, StudentResult, from_json, to_json
from sketchkit.grading.sandbox.level import Level

Judged = Callable[[StudentResult], None]


@dataclass(frozen=True)
class Batch:
    """A class that is to be graded.

    Attributes
    ----------
    setting : Setting
    submissions : sequence of Submission
    executor : Executor
    is_resumed : bool
        Whether results that an earlier batch has written are taken over.
    """

    setting: Setting
    submissions: Sequence[Submission]
    executor: Executor
    is_resumed: bool = False


def grade(batch: Batch, references: References, judged: Judged) -> ClassResult:
    """Judge all submissions of a class and write the reports.

    Parameters
    ----------
    batch : Batch
    references : References
        Of the same assignment, see `prepare`.
    judged : callable
        Called with each result as soon as it is on disk.

    Returns
    -------
    ClassResult
        The same, whichever results were taken over, and in whatever order the others came.
    """
    setting = batch.setting
    record = _record(setting, references)
    tasks = [Task(one, references.evidence, setting) for one in batch.submissions]
    results: dict[str, StudentResult] = {}
    waiting: list[Task] = []
    for task in tasks:
        kept = _kept(task, references) if batch.is_resumed else None
        if kept is None:
            waiting.append(task)
        else:
            results[task.submission.slug] = kept
            judged(kept)
    title = setting.assignment.title
    for task, result in batch.executor.judge_all(waiting):
        results[task.submission.slug] = result
        write_student(result, title, record, setting.workplace.folder)
        _keep(task, references, result)  # last: it stands for all of it
        judged(result)
    whole = ClassResult(title, tuple(results[task.submission.slug] for task in tasks), record)
    write_class(whole, setting.workplace.folder)
    return whole


def prepare(setting: Setting) -> References:
    """Make ready to grade: run the references.

    Raises
    ------
    SandboxError
        If nothing can be run here.
    """
    # Behind the wall nothing can be written: what is not compiled now is compiled in each process.
    compileall.compile_dir(PACKAGE, quiet=2)
    return show_references(setting)


def setting_for(
    assignment: Assignment, folder: Path, level: Level, *, is_fresh: bool = False
) -> Setting:
    """Return the circumstances for an assignment and a folder of results."""
    workplace = Workplace(folder.absolute())
    workplace.clear()
    return Setting(assignment, workplace, level, is_fresh)


def _record(setting: Setting, references: References) -> dict[str, str]:
    """Return what the results were made with."""
    assignment = setting.assignment
    return {
        "sketchkit": __version__,
        "python": platform.python_version(),
        "system": platform.platform(),
        "renderer": assignment.renderer,
        **_driver(references.renderer),
        "seed": str(assignment.seed),
        "sandbox": setting.level.in_words,
        "assignment": assignment.digest[:12],
    }


def _driver(renderer: Mapping[str, str]) -> dict[str, str]:
    """Return what says more of a renderer than its name."""
    words = {"renderer": "drawn by", "version": "driver"}
    return {words[name]: text for name, text in renderer.items() if name in words}


def _file(task: Task) -> Path:
    return task.setting.workplace.results / f"{task.submission.slug}.json"


def _key(task: Task, references: References) -> str:
    """Return what a result hangs on."""
    setting = task.setting
    shown = to_json(dict(references.evidence))
    about = [task.submission.name, task.submission.digest, task.submission.refusal]
    return sha([about, setting.assignment.digest, shown, setting.level.in_words, code_digest()])


def _keep(task: Task, references: References, result: StudentResult) -> None:
    content = {"key": _key(task, references), "result": to_json(result)}
    write_file(_file(task), json.dumps(content).encode())


def _kept(task: Task, references: References) -> StudentResult | None:
    """Return the result that an earlier batch has written, if it would be the same today."""
    try:
        content = json.loads(_file(task).read_bytes())
        if content["key"] != _key(task, references):
            return None
        return from_json(StudentResult, content["result"])
    except (OSError, ValueError, KeyError, TypeError):
        return None
