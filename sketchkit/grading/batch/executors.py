"""Who judges: processes of this computer, or the workers of a Dask cluster."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import Protocol

from sketchkit.core.errors import SketchError
from sketchkit.grading.batch.cluster import DaskExecutor
from sketchkit.grading.batch.judging import Judged, Task, judge_safely, unjudged
from sketchkit.grading.results import Status, StudentResult
from sketchkit.grading.sandbox import kernel

CLUSTER = "dask://"
MOST_TRIES = 2  # of a submission during which the grader's own process has ended


class Executor(Protocol):
    """Judges submissions, in whatever order."""

    def judge_all(self, tasks: Sequence[Task]) -> Iterator[Judged]:
        """Yield each submission's result as soon as it is known."""


class LocalExecutor:
    """Judges in processes of this computer.

    Parameters
    ----------
    workers : int
    judge : callable
        What they do with each task.
    """

    def __init__(self, workers: int, judge: Callable[[Task], StudentResult] | None = None) -> None:
        self._workers = workers
        self._judge = judge or judge_safely

    def judge_all(self, tasks: Sequence[Task]) -> Iterator[Judged]:
        """Yield each submission's result as soon as it is known.

        If a process ends by itself, all that were under way are lost with the pool. Each is then
        judged in a pool of its own, so that the one to blame costs no other one its result.
        """
        lost: list[Task] = []
        yield from self._in_one_pool(tasks, self._workers, lost)
        for task in lost:
            for _ in range(MOST_TRIES - 1):
                still_lost: list[Task] = []
                yield from self._in_one_pool([task], 1, still_lost)
                if not still_lost:
                    break
            else:
                explanation = "The grader's own process ended while it judged this submission."
                yield task, unjudged(task, Status.FAILED, explanation)

    def _in_one_pool(
        self, tasks: Sequence[Task], workers: int, lost: list[Task]
    ) -> Iterator[Judged]:
        """Yield results; tasks that were lost with the pool are added to a list."""
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(
            min(workers, len(tasks)) or 1, context, _end_with_parent, (os.getpid(),)
        )
        try:
            futures: dict[Future[StudentResult], Task] = {
                pool.submit(self._judge, task): task for task in tasks
            }
            for future in as_completed(futures):
                try:
                    yield futures[future], future.result()
                except BrokenProcessPool:
                    lost.append(futures[future])
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def _end_with_parent(parent: int) -> None:
    """Let a worker end when the grader does, even if that is killed; leave Ctrl+C to the grader."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if not sys.platform.startswith("linux"):
        return
    with contextlib.suppress(OSError):
        kernel.prctl(kernel.PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(1)


def open_executor(where: str | None, workers: int) -> Executor:
    """Return who is meant by `--executor`; without it, this computer.

    Raises
    ------
    SketchError
        If nobody is, or cannot be reached.
    """
    if where is None:
        return LocalExecutor(workers)
    if not where.startswith(CLUSTER):
        raise SketchError("An executor is written dask://host:port.", got=repr(where))
    return DaskExecutor(where.removeprefix(CLUSTER))
