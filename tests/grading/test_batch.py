"""Batches: taken up after a kill, scored again without rendering, judged by a cluster."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

from sketchkit.grading.batch import executors
from sketchkit.grading.batch.executors import LocalExecutor, open_executor
from sketchkit.grading.batch.judging import Task, judge_safely
from sketchkit.grading.batch.references import lay_data
from sketchkit.grading.results import Status, StudentResult
from tests.grading.class_of_sixty.assignment import write_assignment
from tests.grading.class_of_sixty.submissions import BROKEN, RIGHT, SLIGHTLY_WRONG
from tests.grading.test_class_of_sixty import grade, hand_in

pytestmark = pytest.mark.usefixtures("walled")

CASES = [RIGHT[0], SLIGHTLY_WRONG[0], BROKEN[0]]
CHECKS = """\
title = "Two boxes"
{more}
[[checks]]
kind = "image"
points = 6
frames = "1,3"
"""


def test_data_of_an_assignment_win_whatever_lies_in_their_way(tmp_path: Path) -> None:
    given, own = tmp_path / "given", tmp_path / "own"
    for name in ("a.txt", "b/c.txt", "d.txt"):
        (given / name).parent.mkdir(parents=True, exist_ok=True)
        (given / name).write_text("given")
    (own / "data" / "d.txt").mkdir(parents=True)
    (own / "data" / "b").write_text("a file where a folder is to be")
    (own / "data" / "mine.txt").write_text("mine")
    whole = tmp_path / "whole"
    whole.mkdir()
    (whole / "data").write_text("a file")

    for folder in (own, whole):
        lay_data(given, folder / "data")
        assert [(folder / "data" / n).read_text() for n in ("a.txt", "b/c.txt", "d.txt")] == [
            "given"
        ] * 3

    assert (own / "data" / "mine.txt").read_text() == "mine"


class Class:
    """A small class, and its grading."""

    def __init__(self, folder: Path) -> None:
        self.assignment = write_assignment(folder / "assignment", CHECKS.format(more=""))
        self.submissions = folder / "submissions"
        self.out = folder / "results"
        self.submissions.mkdir()
        for way, case in enumerate(CASES):
            hand_in(self.submissions, case, way)

    def copy(self, folder: Path) -> Class:
        """Return the same class, with its results so far, in another folder."""
        other = Class(folder)
        shutil.copytree(self.out, other.out)
        return other

    def command(self, *options: str) -> list[str]:
        return grade(self.assignment, self.submissions, self.out, *options)

    def run(self, *options: str) -> None:
        subprocess.run(self.command(*options), check=True, capture_output=True)

    def files(self) -> dict[str, bytes]:
        """Return what a user sees of the results."""
        names = ["results.csv", "results.json", "results.xml", "index.html"]
        reports = sorted(self.out.glob("students/*/*"))
        return {
            str(path.relative_to(self.out)): path.read_bytes()
            for path in [*(self.out / name for name in names), *reports]
        }

    def renders(self) -> dict[str, int]:
        """Return when each render was made."""
        return {
            path.parent.name: path.stat().st_mtime_ns
            for path in self.out.glob("cache/renders/*/outcome.json")
        }


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Class:
    one = Class(tmp_path_factory.mktemp("undisturbed"))
    one.run()
    return one


def waited_for(what: str, is_so: object, seconds: float = 120) -> None:
    """Wait until something is so."""
    end = time.monotonic() + seconds
    while not is_so():  # type: ignore[operator]
        assert time.monotonic() < end, what
        time.sleep(0.05)


@pytest.mark.parametrize("after", [0, 1])
def test_batch_that_was_killed_is_taken_up_again(
    undisturbed: Class, tmp_path: Path, after: int
) -> None:
    disturbed = Class(tmp_path)
    batch = subprocess.Popen(
        disturbed.command(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    kept = disturbed.out / "cache" / "results"
    waited_for("results", lambda: len(list(kept.glob("*.json"))) >= after)
    family = descendants(batch.pid)
    batch.send_signal(signal.SIGKILL)
    batch.wait()
    waited_for("workers to end", lambda: not any(is_running(pid) for pid in family))
    before = {path.name: path.stat().st_mtime_ns for path in kept.glob("*.json")}

    disturbed.run("--resume")

    assert without_places(disturbed) == without_places(undisturbed)
    now = {path.name: path.stat().st_mtime_ns for path in kept.glob("*.json")}
    assert {name: now[name] for name in before} == before


def descendants(pid: int) -> list[int]:
    """Return the processes that a process has started, and those that these have."""
    parents: dict[int, list[int]] = {}
    for entry in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            fields = entry.read_text().rpartition(")")[2].split()
            parents.setdefault(int(fields[1]), []).append(int(entry.parent.name))
    found = [pid]
    for one in found:  # it grows meanwhile
        found += parents.get(one, [])
    return found[1:]


def is_running(pid: int) -> bool:
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def without_places(one: Class) -> dict[str, bytes]:
    """Return the files of a class's results, without what is different by nature: its folder."""
    place = str(one.out.parent).encode()
    return {name: data.replace(place, b"") for name, data in one.files().items()}


def test_other_tolerance_scores_again_without_rendering(undisturbed: Class, tmp_path: Path) -> None:
    one = undisturbed.copy(tmp_path)
    before, files = one.renders(), one.files()

    (one.assignment / "assignment.toml").write_text(CHECKS.format(more="").replace("6", "12"))
    one.run()

    assert one.renders() == before
    assert one.files() != files
    assert ",12" in one.files()["results.csv"].decode("utf-8-sig").replace("12.0", "12")


def test_fresh_batch_renders_anew(undisturbed: Class, tmp_path: Path) -> None:
    one = undisturbed.copy(tmp_path)
    before = one.renders()

    one.run("--fresh")

    after = one.renders()
    assert after.keys() == before.keys()
    assert all(after[key] > before[key] for key in before)


def test_changed_submission_is_rendered_again(undisturbed: Class, tmp_path: Path) -> None:
    one = undisturbed.copy(tmp_path)
    before = one.renders()

    path = next(one.submissions.glob("*.py"))
    path.write_text(path.read_text(encoding="utf-8") + "\n# changed\n", encoding="utf-8")
    one.run("--resume")

    assert len(one.renders()) == len(before) + 1


def test_cluster_gives_the_same_results(undisturbed: Class, tmp_path: Path) -> None:
    from distributed import LocalCluster

    one = Class(tmp_path)
    with LocalCluster(
        n_workers=1, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster:
        one.run("--executor", cluster.scheduler_address.replace("tcp://", "dask://"))

    assert without_places(one) == without_places(undisturbed)


@pytest.mark.parametrize("where", ["ray://here", "localhost", "dask://127.0.0.1:1"])
def test_executor_that_is_none_is_told(where: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sketchkit.grading.batch.cluster.CONNECT_S", 0.2)

    with pytest.raises(executors.SketchError):
        open_executor(where, 1)


def end_process(task: Task) -> StudentResult:
    """Stand for a judge whose process ends while it judges one submission."""
    if task.submission.name == "fatal":
        os._exit(9)
    return judge_safely(task)


def tasks(names: list[str]) -> list[Task]:
    from sketchkit.grading.assignment.assignment import Assignment
    from sketchkit.grading.batch.renders import Setting
    from sketchkit.grading.batch.workplace import Workplace
    from sketchkit.grading.intake.submission import Submission
    from sketchkit.grading.sandbox.level import Level

    setting = Setting(Assignment(Path(), "A"), Workplace(Path("/nowhere")), Level())
    return [Task(Submission(name, name, refusal="It is empty."), {}, setting) for name in names]


def test_process_that_ends_costs_no_other_submission_its_result() -> None:
    executor = LocalExecutor(2, end_process)

    found = {
        task.submission.name: result.status
        for task, result in executor.judge_all(tasks(["a", "b", "fatal", "c", "d"]))
    }

    assert found == {
        "a": Status.REFUSED,
        "b": Status.REFUSED,
        "fatal": Status.FAILED,
        "c": Status.REFUSED,
        "d": Status.REFUSED,
    }
