"""Watching a job: what it prints is collected, and it is ended when it takes too long."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from sketchkit.grading.sandbox.job import MEGABYTE, Exceeded, Limits

CONSOLE_END = 16 * MEGABYTE  # who prints more than this prints without end
LONGEST_PAUSE_S = 0.02
PATIENCE_S = 5  # for the kernel, to end what was killed


class Console:
    """What a job prints: the first of it is kept, and all of it is read, so that nobody waits.

    A thread reads, since not every system can wait for a pipe and for a process at once.
    """

    def __init__(self, pipe: int, keep: int) -> None:
        self.total = 0  # bytes
        self._pipe = pipe
        self._keep = keep
        self._kept = bytearray()
        self._thread = threading.Thread(target=self._read, name="console of a job", daemon=True)
        self._thread.start()

    def _read(self) -> None:
        with os.fdopen(self._pipe, "rb", buffering=0) as pipe:
            while part := pipe.read(1 << 16):
                self._kept += part[: self._keep - len(self._kept)]
                self.total += len(part)

    def text(self) -> str:
        """Return what was kept, and say if that is not all."""
        self._thread.join(PATIENCE_S)
        text = self._kept.decode("utf-8", errors="replace").replace("\r\n", "\n")
        left_out = self.total - len(self._kept)
        if left_out <= 0:
            return text
        return f"{text}\n[It printed more: {left_out // 1024 + 1} kB are left out here.]\n"


@dataclass(frozen=True)
class Running:
    """A job's process, and what ends all that there is of it."""

    process: subprocess.Popen[bytes]
    end: Callable[[], None]

    def reap(self) -> None:
        """Make sure that the process is gone."""
        try:
            self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


@dataclass(frozen=True)
class Watched:
    """How a process ended: its status (negative for a signal), and what it took."""

    status: int
    exceeded: Exceeded | None
    cpu_s: float
    wall_s: float


def watch(running: Running, console: Console, limits: Limits) -> Watched:
    """Wait for a job, and end it when it exceeds the limits of time or of printing."""
    began = time.monotonic()
    exceeded = None
    pause = 0.001
    while (found := _ended(running.process)) is None:
        elapsed = time.monotonic() - began
        if exceeded is None:
            exceeded = _exceeded(elapsed, console, limits)
        if exceeded is not None:
            running.end()
        if elapsed > limits.wall_s + PATIENCE_S:
            running.process.kill()
        time.sleep(pause)
        pause = min(2 * pause, LONGEST_PAUSE_S)
    status, cpu_s = found
    return Watched(status, exceeded, cpu_s, time.monotonic() - began)


def _exceeded(elapsed: float, console: Console, limits: Limits) -> Exceeded | None:
    if elapsed > limits.wall_s:
        return Exceeded.WALL
    return Exceeded.CONSOLE if console.total > CONSOLE_END else None


def _ended(process: subprocess.Popen[bytes]) -> tuple[int, float] | None:
    """Return status and processor time of a process that has ended; else None."""
    if sys.platform == "win32":
        status = process.poll()
        return None if status is None else (status, 0.0)
    pid, status, used = os.wait4(process.pid, os.WNOHANG)
    if pid == 0:
        return None
    process.returncode = os.waitstatus_to_exitcode(status)  # we have waited in its stead
    return process.returncode, used.ru_utime + used.ru_stime
