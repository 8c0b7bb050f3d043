"""The random numbers of the running sketch, for what belongs to no sketch: vectors and lists.

There is one sketch at a time. As long as there is none, nobody knows what comes.
"""

from __future__ import annotations

import time

from sketchkit.core.rng import JavaRandom

_random = JavaRandom(time.time_ns())


def use_random(random: JavaRandom) -> None:
    """Let all that is random draw from a sketch's own numbers, which it can seed."""
    global _random
    _random = random


def chance() -> JavaRandom:
    """Return the random numbers of the running sketch."""
    return _random
