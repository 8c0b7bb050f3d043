"""Threads that take turns, so that a render is the same at every run.

One function runs at a time. A function that was started beside the others runs at once, until it
ends or waits; then whoever started it goes on. It comes back when the time it waits for has come.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from time import sleep

PATIENCE_S = 10.0  # how long a turn may take before nobody waits for its end any more


class _Left(BaseException):
    """Ends a function that waits for a turn that will never come."""


class _Runner:
    """A function that runs beside the others.

    Attributes
    ----------
    due_ms : float
        When its next turn comes.
    is_over : bool
        Whether it has come to its end.
    is_left : bool
        Whether it shall end at its next turn, without going on.
    """

    def __init__(self, function: Callable[[], object], due_ms: float) -> None:
        self.due_ms = due_ms
        self.is_over = self.is_left = False
        self._function = function
        self._may_run, self._has_stopped = threading.Event(), threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def is_running_here(self) -> bool:
        """Tell whether this is the thread of the function."""
        return threading.current_thread() is self._thread

    def take_turn(self) -> bool:
        """Run until it ends or waits; tell whether it did so before patience ended."""
        self._has_stopped.clear()
        if self._thread.ident is None:
            self._thread.start()
        else:
            self._may_run.set()
        return self._has_stopped.wait(PATIENCE_S)

    def stop_until(self, due_ms: float) -> None:
        """Hand over, from within the function, until the next turn.

        A function that is left and waits once more, since it catches everything, waits for ever.
        """
        self.due_ms = due_ms
        was_left = self.is_left
        self._may_run.clear()
        self._has_stopped.set()
        self._may_run.wait()
        if self.is_left and not was_left:
            raise _Left

    def _run(self) -> None:
        try:
            self._function()
        except _Left:
            pass
        finally:
            self.is_over = True
            self._has_stopped.set()


class Turns:
    """The functions that were started, and when each goes on.

    Parameters
    ----------
    millis : callable
        Returns the time.
    """

    def __init__(self, millis: Callable[[], int]) -> None:
        self._millis = millis
        self._home = threading.current_thread()
        self._runners: list[_Runner] = []

    def start(self, function: Callable[[], object]) -> bool:
        """Run a function until it ends or waits.

        Returns
        -------
        bool
            Whether it did: if it takes too long it goes on by itself.
        """
        return self._give_turn(_Runner(function, self._millis()))

    def wait(self, milliseconds: float) -> bool:
        """Stop the function that calls this for a while.

        Returns
        -------
        bool
            Whether it was stopped: not if all others hang on it, as it takes the turns.
        """
        for runner in self._runners:
            if runner.is_running_here():
                runner.stop_until(runner.due_ms + max(milliseconds, 1.0))
                return True
        if threading.current_thread() is self._home:
            return False
        sleep(max(milliseconds, 0.0) / 1000)  # a thread of the sketch's own
        return True

    def go_on(self) -> None:
        """Give a turn to each function whose time has come, the earliest first."""
        while due := [runner for runner in self._runners if runner.due_ms <= self._millis()]:
            first = min(due, key=lambda runner: runner.due_ms)
            self._runners.remove(first)
            self._give_turn(first)

    def end(self) -> None:
        """End the functions that still wait."""
        for runner in self._runners:
            runner.is_left = True
            runner.take_turn()
        self._runners.clear()

    def _give_turn(self, runner: _Runner) -> bool:
        self._runners.append(runner)
        has_stopped = runner.take_turn()
        if runner.is_over or not has_stopped:
            self._runners.remove(runner)
        return has_stopped
