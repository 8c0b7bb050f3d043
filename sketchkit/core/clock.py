"""What time it is for a sketch: the computer's, or one that is the same at every render."""

import time
from collections.abc import Callable
from datetime import datetime
from typing import Protocol

FRAMES_PER_SECOND = 60
RENDER_DATE = datetime(2000, 1, 1, 12, 0, 0)  # named in the report of a render


def milliseconds_of(frame: int, frames_per_second: float = FRAMES_PER_SECOND) -> int:
    """Return what `millis()` is in a frame of a virtual clock, rounded as measured.

    Examples
    --------
    >>> [milliseconds_of(frame) for frame in (0, 1, 2, 3)]
    [0, 0, 17, 33]
    """
    return round(max(frame - 1, 0) * 1000 / frames_per_second)


class Clock(Protocol):
    """A clock that a sketch can read."""

    def millis(self) -> int:
        """Return the milliseconds since the sketch began."""
        ...

    def now(self) -> datetime:
        """Return the local date and time."""
        ...

    def wait(self, milliseconds: float) -> None:
        """Let some time pass; none if the number is not above 0."""
        ...


class VirtualClock:
    """A clock that stands still during a frame, and steps as far from each to the next.

    Whoever counts the frames sets `frame`. A step is a 60th of a second: frame 1 is at 0
    milliseconds, and so is `setup()`, before it; frame 2 is at 17, frame 3 at 33 (rounded, as
    measured). For a film `frames_per_second` is the film's. Waiting takes no time, but all that
    comes after it is later by so much. The date never moves.
    """

    def __init__(self, date: datetime = RENDER_DATE) -> None:
        self.frame = 0
        self.frames_per_second: float = FRAMES_PER_SECOND
        self.date = date
        self._waited_ms = 0.0

    def millis(self) -> int:
        """Return the milliseconds from frame 1 to this frame, with those that were waited."""
        return milliseconds_of(self.frame, self.frames_per_second) + round(self._waited_ms)

    def wait(self, milliseconds: float) -> None:
        """Put the clock forward."""
        self._waited_ms += max(milliseconds, 0.0)

    def now(self) -> datetime:
        """Return the fixed date."""
        return self.date


class RealClock:
    """The computer's own clock; milliseconds count from when it is made.

    Parameters
    ----------
    now : callable
        Returns the time in seconds, from whenever.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._since_s = now()
        self._passed_s = 0.0  # until then
        self._speed = 1.0

    def millis(self) -> int:
        """Return the milliseconds since the start."""
        return int(self._elapsed_s() * 1000)

    def wait(self, milliseconds: float) -> None:
        """Sleep."""
        time.sleep(max(milliseconds, 0.0) / 1000)

    def now(self) -> datetime:
        """Return the local date and time."""
        return datetime.now()

    def run_at(self, speed: float) -> None:
        """Let time pass faster or slower from now on; at 0 it stands still."""
        if speed != self._speed:
            self._passed_s, self._since_s = self._elapsed_s(), self._now()
            self._speed = speed

    def skip(self, seconds: float) -> None:
        """Let some time pass at once."""
        self._passed_s += seconds

    def _elapsed_s(self) -> float:
        return self._passed_s + (self._now() - self._since_s) * self._speed
