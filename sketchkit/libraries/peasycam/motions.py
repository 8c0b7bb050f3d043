"""How a camera moves by itself: it glides on after a drag, and travels to other places."""

from __future__ import annotations

from collections.abc import Callable

FRICTION = 0.16  # of the speed is lost in each frame, as in PeasyCam
STANDSTILL = 0.001  # a speed below it ends
ARRIVED = 0.99  # of the time: the rest would be too little to see


class Glide:
    """Something that is pushed, and comes to rest by itself.

    Parameters
    ----------
    move : callable
        Takes the speed: how far to move in this frame.
    """

    def __init__(self, move: Callable[[float], None]) -> None:
        self._move = move
        self._speed = 0.0

    def push(self, speed: float) -> None:
        """Make it faster."""
        self._speed += speed

    def stop(self) -> None:
        """Let it stand still at once."""
        self._speed = 0.0

    def step(self) -> bool:
        """Move for one frame; tell whether anything moved."""
        if self._speed == 0:
            return False
        self._move(self._speed)
        self._speed *= 1 - FRICTION
        if abs(self._speed) < STANDSTILL:
            self._speed = 0.0
        return True


class Travel:
    """A change that takes its time.

    Parameters
    ----------
    change : callable
        Takes which part of it, 0..1, is to be done; 1 is the end itself.
    start_ms, duration_ms : float
        When it begins, by the sketch's clock, and how long it takes.
    """

    def __init__(
        self, change: Callable[[float], None], start_ms: float, duration_ms: float
    ) -> None:
        self._change = change
        self._start_ms = start_ms
        self._duration_ms = duration_ms

    def step(self, now_ms: float) -> bool:
        """Go as far as the time says; tell whether it goes on after that."""
        passed_ms = now_ms - self._start_ms
        part = passed_ms / self._duration_ms if self._duration_ms > 0 else 1.0
        is_over = part > ARRIVED
        self._change(1.0 if is_over else part)
        return not is_over


def eased(start: float, end: float, part: float) -> float:
    """Return what lies between two numbers, slow at both ends (Hermite's cubic).

    Examples
    --------
    >>> [eased(10, 20, part) for part in (0, 0.25, 0.5, 1)]
    [10, 11.5625, 15.0, 20]
    """
    weight = part * part * (3 - 2 * part)
    return end * weight + start * (1 - weight)
