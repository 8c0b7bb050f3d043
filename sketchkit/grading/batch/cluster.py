"""Judging on a Dask cluster, whose workers need not see this computer's files.

A task travels as bytes, with its submission, the assignment and what the references show; back come
the result and its pictures. Workers have sketchkit, and a sandbox, of their own.
"""

from __future__ import annotations

import io
import tempfile
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from sketchkit.assets.output import write_file
from sketchkit.core.errors import SketchError
from sketchkit.grading.assignment.load import load
from sketchkit.grading.batch.judging import Judged, Task, judge_safely
from sketchkit.grading.batch.renders import Setting
from sketchkit.grading.batch.workplace import Workplace
from sketchkit.grading.evidence import Evidence
from sketchkit.grading.results import StudentResult
from sketchkit.grading.sandbox.level import Level, require
from sketchkit.grading.sandbox.probe import probe

CONNECT_S = 10


@dataclass(frozen=True)
class Common:
    """What all tasks of a batch share, as it travels.

    Attributes
    ----------
    assignment, renders : bytes
        Zip files: the assignment's folder, and the pictures of its references.
    references : dict of str to Evidence
        With places as they are where the batch was started.
    folder : str
        The folder of results there.
    level : Level
        The least that a worker must have.
    """

    assignment: bytes
    renders: bytes
    references: Mapping[str, Evidence]
    folder: str
    level: Level
    is_fresh: bool


@dataclass(frozen=True)
class Parcel:
    """A submission as it travels."""

    task: Task
    files: bytes


@dataclass(frozen=True)
class Answer:
    """A result as it travels, and its pictures by their places in the folder of results."""

    result: StudentResult
    files: bytes


class DaskExecutor:
    """Lets the workers of a cluster judge.

    Parameters
    ----------
    address : str
        Host and port of its scheduler.

    Raises
    ------
    SketchError
        If Dask is not installed, or the cluster cannot be reached.
    """

    def __init__(self, address: str) -> None:
        try:
            import distributed
        except ImportError:
            raise SketchError(
                "Dask is not installed.", hint="Install it: pip install 'sketchkit[cluster]'"
            ) from None
        self._dask: Any = distributed  # Any: it ships no types
        try:
            self._client = self._dask.Client(f"tcp://{address}", timeout=CONNECT_S)
        except (OSError, ValueError) as reason:
            raise SketchError(
                f"No Dask scheduler answers at {address}.",
                got=str(reason)[:200] or None,
                hint="Start one with: dask scheduler",
            ) from None

    def judge_all(self, tasks: Sequence[Task]) -> Iterator[Judged]:
        """Yield each submission's result as soon as it is known."""
        if not tasks:
            return
        workplace = tasks[0].setting.workplace
        common = self._client.scatter(_common(tasks[0]), broadcast=True, hash=False)
        futures = {
            self._client.submit(judge_parcel, _parcel(task), common, pure=False): task
            for task in tasks
        }
        for future in self._dask.as_completed(list(futures)):
            answer: Answer = future.result()
            _unpack(answer.files, workplace.folder)
            yield futures[future], answer.result


def judge_parcel(parcel: Parcel, common: Common) -> Answer:
    """Judge a submission, on whichever computer this is."""
    level = probe()
    require(level, common.level.strength)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _unpack(common.assignment, folder / "assignment")
        _unpack(parcel.files, folder / "submission")
        workplace = Workplace(folder / "results")
        _unpack(common.renders, workplace.folder)
        setting = Setting(load(folder / "assignment"), workplace, level, common.is_fresh)
        submission = parcel.task.submission
        if submission.folder is not None:
            submission = replace(submission, folder=folder / "submission")
        there = Path(common.folder)
        references = {
            key: _moved(evidence, there, workplace.folder)
            for key, evidence in common.references.items()
        }
        result = judge_safely(Task(submission, references, setting))
        pictures = [
            path
            for check in result.checks
            for comparison in check.comparisons
            for path in (comparison.submitted, comparison.difference)
        ]
        wanted = {path for path in [*pictures, result.thumbnail] if path is not None}
        return Answer(result, _packed(workplace.folder, wanted))


def _common(task: Task) -> Common:
    setting = task.setting
    assignment, folder = setting.assignment.folder, setting.workplace.folder
    pictures = {
        path.relative_to(folder)
        for evidence in task.references.values()
        for run in evidence.runs.values()
        for frames in (run.frames, *run.variants.values())
        for path in frames.values()
    }
    return Common(
        _packed(assignment, _files(assignment)),
        _packed(folder, pictures),
        dict(task.references),
        str(folder),
        setting.level,
        setting.is_fresh,
    )


def _parcel(task: Task) -> Parcel:
    """Return a task without what travels once for all."""
    folder = task.submission.folder
    files = b"" if folder is None else _packed(folder, _files(folder))
    return Parcel(replace(task, references={}), files)


def _files(folder: Path) -> set[Path]:
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def _packed(folder: Path, names: set[Path]) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name in sorted(names):
            archive.write(folder / name, name.as_posix())
    return data.getvalue()


def _unpack(data: bytes, folder: Path) -> None:
    """Lay out files that `_packed` has packed: ours, so their names are what they seem."""
    folder.mkdir(parents=True, exist_ok=True)
    if not data:
        return
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for name in archive.namelist():
            write_file(folder / name, archive.read(name))


def _moved(evidence: Evidence, there: Path, here: Path) -> Evidence:
    """Return evidence whose pictures lie elsewhere."""

    def moved(frames: Mapping[int, Path]) -> dict[int, Path]:
        return {number: here / path.relative_to(there) for number, path in frames.items()}

    return replace(
        evidence,
        runs={
            events: replace(
                run,
                frames=moved(run.frames),
                variants={name: moved(frames) for name, frames in run.variants.items()},
            )
            for events, run in evidence.runs.items()
        },
    )
