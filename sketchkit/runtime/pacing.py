"""When the next frame is due: evenly, without drift, and without hurry after a slow one."""

from __future__ import annotations

RATE_WEIGHT = 0.05  # of the newest frame in frameRate, as in Processing


class Pacer:
    """A schedule of frames.

    A frame that is late does not delay those after it, so that the rate is kept on average; after
    one that took longer than a whole frame, the schedule begins anew: nothing is caught up.

    Parameters
    ----------
    now_s : float
        The time; the first frame is due at once.

    Attributes
    ----------
    due_s : float
        When the next frame is due.
    """

    def __init__(self, now_s: float) -> None:
        self.due_s = self._last_s = now_s

    def wait_s(self, now_s: float) -> float:
        """Return how long it is until the next frame."""
        return max(self.due_s - now_s, 0.0)

    def go_on(self, now_s: float, rate: float) -> float:
        """Take that a frame begins now, and return how long the one before has lasted.

        `rate` is how many frames there are to be in a second.
        """
        interval_s = 1 / rate
        is_late = now_s - self.due_s > interval_s
        self.due_s = (now_s if is_late else self.due_s) + interval_s
        lasted_s, self._last_s = now_s - self._last_s, now_s
        return lasted_s

    def begin_anew(self, now_s: float) -> None:
        """Let the next frame be due at once: there was a pause."""
        self.due_s = self._last_s = now_s


def smoothed(rate: float, elapsed_s: float) -> float:
    """Return frames a second, so that one slow frame does not make the number jump.

    Parameters
    ----------
    rate : float
        As it was.
    elapsed_s : float
        What the newest frame has taken.
    """
    average_s = (1 - RATE_WEIGHT) / rate + RATE_WEIGHT * elapsed_s
    return 1 / average_s
