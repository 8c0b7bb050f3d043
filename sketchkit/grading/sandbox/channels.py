"""What connects a job with the grader: its output, what it prints, its word that it is ready."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field

from sketchkit.grading.sandbox.job import Job
from sketchkit.grading.sandbox.plan import Plan


@dataclass
class Channels:
    """File descriptors.

    Attributes
    ----------
    output : int or None
        Of the file that the job appends to.
    heard, console : int
        The ends of a pipe: what the job prints to `console` is read from `heard`. Whoever reads
        it closes it.
    listening, ready : int
        The ends of another: the job says at `ready` that its walls are up.
    """

    output: int | None
    heard: int
    console: int
    listening: int
    ready: int
    _is_open: bool = field(default=True, repr=False)

    def close_ours(self) -> None:
        """Close here what the job has by now: else the pipes would not end when it does."""
        if self._is_open:
            os.close(self.console)
            os.close(self.ready)
            self._is_open = False

    def is_ready(self) -> bool:
        """Return whether a job that has ended had all its walls up."""
        return sys.platform == "win32" or os.read(self.listening, 1) == b"1"

    def passed(self) -> list[int]:
        """Return those that a job's process keeps beside its standard ones."""
        return [self.ready, *([] if self.output is None else [self.output])]


@contextlib.contextmanager
def open_channels(job: Job) -> Iterator[Channels]:
    """Open what connects a job; its output file is made anew."""
    output = None
    if job.output is not None:
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND
        job.output.unlink(missing_ok=True)  # and not emptied: it might be a link
        output = os.open(job.output, flags, 0o600)
    channels = Channels(output, *os.pipe(), *os.pipe())
    try:
        yield channels
    finally:
        channels.close_ours()
        os.close(channels.listening)
        if output is not None:
            os.close(output)


def plan_of(job: Job, channels: Channels) -> Plan:
    """Return the plan for a job, as far as it is the same behind each wall."""
    if sys.platform == "win32":
        output = None if job.output is None else str(job.output)
    else:
        output = None if channels.output is None else str(channels.output)
    return Plan({}, (), (), limits=job.limits, output=output, ready=channels.ready)
