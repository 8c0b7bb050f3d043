"""A job for the sandbox, its limits, and how it ended: plain data."""

from __future__ import annotations

import signal
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

MEGABYTE = 1 << 20


class SandboxError(Exception):
    """The grader, not the submission, is at fault: the sandbox could not be set up."""


class Exceeded(Enum):
    """The limit that a job did not keep."""

    CPU = "processor time"
    WALL = "time"
    MEMORY = "memory"
    OUTPUT = "output"
    CONSOLE = "printing"


@dataclass(frozen=True)
class Limits:
    """What a job may use.

    Attributes
    ----------
    cpu_s : float
        Processor time, start of Python included.
    wall_s : float
        Time by the clock.
    memory_mb : int
        Address space. NumPy and Mesa's renderer take about 500 of it before a sketch begins.
    output_mb : int
        The output file, and each other file that the job writes.
    scratch_mb, scratch_files : int
        What its own folder, and its folder of temporary files, may each hold.
    console_kb : int
        How much of what it prints is kept. It may print much more before it is stopped.
    threads : int
        Beside the first one.
    """

    cpu_s: float = 20
    wall_s: float = 40
    memory_mb: int = 1536
    output_mb: int = 256
    scratch_mb: int = 128
    scratch_files: int = 4096
    console_kb: int = 64
    threads: int = 64


@dataclass(frozen=True)
class Job:
    """What is to run in the sandbox.

    Attributes
    ----------
    module : str
        A module of sketchkit: it is run as `python -m module args`, with all walls up.
    args : tuple of str
    readable : mapping of str to Path
        Name inside ("/submission", "/tape") to file or folder here; read-only. The module finds
        them with `inside.path("/submission")`. As root, others must be allowed to read them, for
        the job runs as a user who owns nothing.
    output : Path or None
        A file; it is made anew, and the job can only append to it, as file descriptor 3.
    hidden : tuple of Path
        Folders here that must not be visible, should they lie within Python's own folders.
    limits : Limits
    """

    module: str
    args: tuple[str, ...] = ()
    readable: Mapping[str, Path] = field(default_factory=dict)
    output: Path | None = None
    hidden: tuple[Path, ...] = ()
    limits: Limits = field(default_factory=Limits)


@dataclass(frozen=True)
class Ending:
    """How a job ended.

    Attributes
    ----------
    code, signal : int or None
        Its exit status, or the signal that ended it: one of them is None. A status of 128 + n is
        taken for signal n, as bubblewrap and shells write it.
    exceeded : Exceeded or None
    cpu_s, wall_s : float
    console : str
        What it printed, both streams in order; untrusted text.
    limits : Limits
        That it ran under.
    """

    code: int | None
    signal: int | None
    exceeded: Exceeded | None
    cpu_s: float
    wall_s: float
    console: str
    limits: Limits = field(default_factory=Limits)

    @property
    def went_well(self) -> bool:
        """Whether it ended by itself, with status 0, within its limits."""
        return self.code == 0 and self.exceeded is None

    def sentence(self) -> str:
        """Say to the student why it did not end well; "" if it did."""
        if self.exceeded is not None:
            return self._over_limit(self.exceeded)
        if self.signal is not None:
            return f"Its process was ended by a signal: {_signal_in_words(self.signal)}."
        if self.code:
            return f"Its process ended by itself, with exit status {self.code}."
        return ""

    def _over_limit(self, exceeded: Exceeded) -> str:
        limits = self.limits
        match exceeded:
            case Exceeded.CPU:
                return f"It needed more than {limits.cpu_s:g} s of processor time and was stopped."
            case Exceeded.WALL:
                return f"It was not done after {limits.wall_s:g} s and was stopped."
            case Exceeded.MEMORY:
                return f"It needed more than the {limits.memory_mb} MB of memory that it may have."
            case Exceeded.OUTPUT:
                return f"It drew more than the {limits.output_mb} MB that a recording may have."
            case Exceeded.CONSOLE:
                return "It printed without end and was stopped. Is there a print() in draw()?"


def _signal_in_words(number: int) -> str:
    meanings = {
        "SIGSEGV": "it touched memory that is not its own, or gave up (SIGSEGV)",
        "SIGABRT": "it gave up (SIGABRT)",
        "SIGKILL": "it was killed (SIGKILL)",
        "SIGSYS": "it asked the system for something forbidden (SIGSYS)",
    }
    try:
        name = signal.Signals(number).name
    except ValueError:
        return f"number {number}"
    return meanings.get(name, name)
