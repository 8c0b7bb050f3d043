"""Running a job in the sandbox, and waiting until nothing of it is left."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Iterator

from sketchkit.grading.sandbox import bare, bubblewrap
from sketchkit.grading.sandbox.channels import Channels, open_channels
from sketchkit.grading.sandbox.job import MEGABYTE, Ending, Exceeded, Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.watch import Console, Watched, watch

OUT_OF_MEMORY = ("MemoryError", "bad_alloc", "out of memory", "Cannot allocate memory")

KILLED = (9, 24)  # SIGKILL, SIGXCPU: how the kernel ends what takes too much time
NEARLY = 0.7  # of that time: the limit is counted in coarser steps than what is told afterwards


def run(job: Job, level: Level) -> Ending:
    """Run a job behind all walls of a level, and return how it ended.

    When it returns, no process of the job is left, and its own folders are gone.

    Raises
    ------
    SandboxError
        If the sandbox could not be set up: nothing of the job was run then.
    """
    if level.refusal:
        raise SandboxError(level.refusal)
    _check_readable(job, level)
    with open_channels(job) as channels:
        console = Console(channels.heard, job.limits.console_kb * 1024)
        try:
            watched = _watched(job, level, channels, console)
        except SandboxError as reason:
            channels.close_ours()
            raise SandboxError(f"{reason} {console.text()}".strip()) from None
        return _ending(job, watched, console, _written(channels))


def _watched(job: Job, level: Level, channels: Channels, console: Console) -> Watched:
    """Start a job and wait for its end, whichever way that comes."""
    start = bubblewrap.started if level.bubblewrap else bare.started
    with start(job, level, channels) as running:
        channels.close_ours()
        watched = watch(running, console, job.limits)
    if not channels.is_ready():
        how = f"status {watched.status}, {watched.wall_s:.1f} s"
        raise SandboxError(f"The sandbox could not be set up ({how}).")
    return watched


def _check_readable(job: Job, level: Level) -> None:
    """Make sure that what a job is given is there, and that it will be able to read it."""
    is_someone_else = level.bubblewrap and bubblewrap.has_spare_users()
    for place in job.readable.values():
        try:
            mode = place.stat().st_mode
        except OSError as reason:
            raise SandboxError(f"A job cannot be given {place}: {reason.strerror}.") from None
        needed = stat.S_IROTH | (stat.S_IXOTH if stat.S_ISDIR(mode) else 0)
        if is_someone_else and mode & needed != needed:
            raise SandboxError(
                f"The job runs as another user, who may not read {place}. "
                f"Allow it with: chmod o+rX {place}"
            )


def _written(channels: Channels) -> int:
    """Return how much a job wrote, and make its output readable for the next job.

    The job may have changed who may read it.
    """
    if channels.output is None:
        return 0
    with contextlib.suppress(AttributeError):  # Windows has no fchmod before Python 3.13
        os.fchmod(channels.output, 0o644)
    return os.fstat(channels.output).st_size


def _ending(job: Job, watched: Watched, console: Console, written: int) -> Ending:
    text = console.text()
    signal = _signal(watched.status)
    return Ending(
        code=watched.status if signal is None else None,
        signal=signal,
        exceeded=watched.exceeded or next(_exceeded(job, watched, written, text), None),
        cpu_s=watched.cpu_s,
        wall_s=watched.wall_s,
        console=text,
        limits=job.limits,
    )


def _signal(status: int) -> int | None:
    """Return which signal a status tells of, as Python (-9) or as bubblewrap (137) tells it."""
    number = -status if status < 0 else status - 128
    return number if 0 < number < 65 else None


def _exceeded(job: Job, watched: Watched, written: int, text: str) -> Iterator[Exceeded]:
    """Yield the limits that a job ran into by itself."""
    is_killed = _signal(watched.status) in KILLED
    if is_killed and watched.cpu_s >= NEARLY * job.limits.cpu_s:
        yield Exceeded.CPU
    if written >= job.limits.output_mb * MEGABYTE:
        yield Exceeded.OUTPUT
    # The system only says that there is no more; what follows from that, the job has printed.
    if watched.status != 0 and any(words in text for words in OUT_OF_MEMORY):
        yield Exceeded.MEMORY
