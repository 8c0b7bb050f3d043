"""Java's random numbers, so that a seed gives the same sketch here as in Processing.

The generator is the one that java.util.Random documents: 48 bits, a linear congruence, of which
the highest bits are handed out. On it stand the rules of `random()` and `randomGaussian()`.
"""

from math import log, sqrt

from sketchkit.core.errors import SketchError
from sketchkit.core.float32 import ROUND, f32

_MULTIPLIER = 0x5DEECE66D
_INCREMENT = 0xB
_MASK = 2**48 - 1


class JavaRandom:
    """A seeded stream of random numbers.

    Examples
    --------
    >>> JavaRandom(0).below(1)
    0.7309677600860596
    """

    __slots__ = ("_spare_gaussian", "_state")

    def __init__(self, seed: int) -> None:
        self.seed(seed)

    def seed(self, seed: int) -> None:
        """Start the stream that belongs to `seed`, of which 48 bits count."""
        self._state = (seed ^ _MULTIPLIER) & _MASK
        self._spare_gaussian: float | None = None

    def next_float(self) -> float:
        """Return a number from 0 up to 1, of 24 random bits."""
        self._state = state = (self._state * _MULTIPLIER + _INCREMENT) & _MASK
        return (state >> 24) / 0x1000000

    def next_double(self) -> float:
        """Return a number from 0 up to 1, of 53 random bits."""
        return ((self._bits(26) << 27) + self._bits(27)) / 2**53

    def next_gaussian(self) -> float:
        """Return a normally distributed number, mean 0, deviation 1.

        Marsaglia's polar method makes two at a time: a point in the unit disc gives both.
        """
        if (spare := self._spare_gaussian) is not None:
            self._spare_gaussian = None
            return spare
        while True:
            x = 2 * self.next_double() - 1
            y = 2 * self.next_double() - 1
            square = x * x + y * y
            if 0 < square < 1:
                break
        stretch = sqrt(-2 * log(square) / square)
        self._spare_gaussian = y * stretch
        return x * stretch

    def below(self, high: float) -> float:
        """Return what `random(high)` gives: from 0 up to `high`, which may be negative."""
        t = high * ROUND
        high = t - (t - high)
        if high == 0:
            return 0.0
        if high - high != 0:
            raise _not_finite(high)
        while True:  # rounding to 32 bits can reach `high`: Processing then draws again
            value = self.next_float() * high
            t = value * ROUND
            value = t - (t - value)
            if value != high:
                return value

    def between(self, low: float, high: float) -> float:
        """Return what `random(low, high)` gives: from `low` up to `high`; `low` if it is higher."""
        low, high = f32(low), f32(high)
        if low >= high:
            return low
        span = f32(high - low)
        while True:
            value = f32(self.below(span) + low)
            if value != high:
                return value

    def gaussian(self) -> float:
        """Return what `randomGaussian()` gives: a normally distributed number, in 32 bits."""
        return f32(self.next_gaussian())

    def _bits(self, count: int) -> int:
        self._state = state = (self._state * _MULTIPLIER + _INCREMENT) & _MASK
        return state >> 48 - count


def _not_finite(value: float) -> SketchError:
    return SketchError(
        "random() needs a number that is finite.",
        got=f"{value}",
        hint="A division by zero, or a square root of a negative number, may have made it.",
    )
