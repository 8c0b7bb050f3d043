"""Chance: random numbers and noise, the same as Processing's for the same seed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar, overload

from sketchkit.core.errors import SketchError, wrong_numbers
from sketchkit.core.noise import PerlinNoise
from sketchkit.core.rng import JavaRandom

RANDOM_USAGE = "high | low, high | list"
T = TypeVar("T")


class Randomness:
    """Random numbers and noise, each with its own seed."""

    _random: JavaRandom
    _noise: PerlinNoise
    _first_seed: int
    _has_own_seeds: dict[str, bool]

    @overload
    def random(self, high: float = 1.0, /) -> float: ...
    @overload
    def random(self, low: float, high: float, /) -> float: ...
    @overload
    def random(self, values: Sequence[T], /) -> T: ...
    def random(self, low: object = 1.0, high: float | None = None, /) -> object:
        """Return an unpredictable number.

        Parameters
        ----------
        low, high : float
            The range: up to `high`, without reaching it, from `low`, or from 0 if it is left
            out. With neither it is from 0 to 1. Also a list in their place: one of its values is
            returned.

        See Also
        --------
        randomSeed, randomGaussian, noise

        Notes
        -----
        If `low` is not below `high`, it is the result. Choosing from a list is not in Processing.

        Examples
        --------
        >>> randomSeed(0)
        >>> print(nf(random(100), 0, 3))
        73.097
        >>> random(["rock", "paper", "scissors"])
        'scissors'
        """
        try:
            if high is not None:
                return self._random.between(low, high)  # type: ignore[arg-type]  # raises
            return self._random.below(low)  # type: ignore[arg-type]  # raises
        except TypeError:
            if high is None and isinstance(low, Sequence) and not isinstance(low, str):
                return self._choice("random", low)
            args = (low,) if high is None else (low, high)
            raise wrong_numbers("random", args, RANDOM_USAGE) from None

    @overload
    def choice(self, high: float, /) -> int: ...
    @overload
    def choice(self, low: float, high: float, /) -> int: ...
    @overload
    def choice(self, values: Sequence[T], /) -> T: ...
    def choice(self, low: object, high: float | None = None, /) -> object:
        """Return an unpredictable whole number, or one of a list's values.

        Parameters
        ----------
        low, high : float
            The range: up to `high`, without reaching it, from `low`, or from 0 if it is left
            out. Also a list in their place.

        See Also
        --------
        random, randomSeed

        Notes
        -----
        It is what `random()` gives, without its fraction. Choosing from a list is not in
        Processing; it is what `choice()` of Python's module random does.

        Examples
        --------
        >>> randomSeed(0)
        >>> choice(6) + 1
        5
        >>> choice(["rock", "paper", "scissors"])
        'scissors'
        """
        try:
            if high is not None:
                return int(self._random.between(low, high))  # type: ignore[arg-type]  # raises
            return int(self._random.below(low))  # type: ignore[arg-type]  # raises
        except TypeError:
            if high is None and isinstance(low, Sequence) and not isinstance(low, str):
                return self._choice("choice", low)
            args = (low,) if high is None else (low, high)
            raise wrong_numbers("choice", args, RANDOM_USAGE) from None

    def randomGaussian(self) -> float:
        """Return an unpredictable number, most often near 0 and seldom beyond -3 or 3.

        See Also
        --------
        random, randomSeed

        Notes
        -----
        The numbers are normally distributed, with mean 0 and standard deviation 1.

        Examples
        --------
        >>> randomSeed(0)
        >>> print(nf(randomGaussian(), 0, 3))
        0.803
        """
        return self._random.gaussian()

    def randomSeed(self, seed: int) -> None:
        """Start the random numbers anew, so that the same ones come each time.

        Parameters
        ----------
        seed : int
            Each seed has numbers of its own.

        See Also
        --------
        random, randomGaussian, noiseSeed

        Examples
        --------
        >>> randomSeed(42)
        >>> a = random(10)
        >>> randomSeed(42)
        >>> a == random(10)
        True
        """
        self._random.seed(_whole("randomSeed", seed))
        self._has_own_seeds["random"] = True

    def noise(self, x: float, y: float = 0.0, z: float = 0.0) -> float:
        """Return a number from 0 to 1 that varies smoothly from place to place.

        Parameters
        ----------
        x, y, z : float
            The place, in one, two or three dimensions. Steps of 0.005 to 0.03 look smooth.

        See Also
        --------
        noiseDetail, noiseSeed, random

        Examples
        --------
        >>> noiseSeed(0)
        >>> print(nf(noise(0.5), 0, 3), nf(noise(0.51), 0, 3))
        0.668 0.669
        """
        try:
            return self._noise.at(x, y, z)
        except TypeError:
            raise wrong_numbers("noise", (x, y, z), "x [, y] [, z]") from None

    def noiseDetail(self, lod: int, falloff: float | None = None) -> None:
        """Set how rough the noise is.

        Parameters
        ----------
        lod : int
            The number of octaves, 4 at first. Each adds finer detail.
        falloff : float, optional
            How high each octave is, compared with the one before: 0.5 at first. From 0.5
            upwards the noise can go beyond 1.

        See Also
        --------
        noise

        Notes
        -----
        A number that is not above 0 changes nothing.

        Examples
        --------
        >>> noiseDetail(8, 0.65)
        """
        try:
            self._noise.detail(_whole("noiseDetail", lod), falloff)
        except TypeError:
            raise wrong_numbers("noiseDetail", (lod, falloff), "lod [, falloff]") from None

    def noiseSeed(self, seed: int) -> None:
        """Start the noise anew, so that it is the same each time.

        Parameters
        ----------
        seed : int
            Each seed has a noise of its own.

        See Also
        --------
        noise, randomSeed

        Examples
        --------
        >>> noiseSeed(42)
        >>> a = noise(0.3)
        >>> noiseSeed(42)
        >>> a == noise(0.3)
        True
        """
        self._noise.seed(_whole("noiseSeed", seed))
        self._has_own_seeds["noise"] = True

    def restart_chance(self) -> None:
        """Begin anew with the random numbers and the noise that the sketch has not seeded itself.

        So what the lines outside of all functions have used up does not count in `setup()`.
        """
        if not self._has_own_seeds["random"]:
            self._random.seed(self._first_seed)
        if not self._has_own_seeds["noise"]:
            self._noise.seed(self._first_seed)

    def _choice(self, name: str, values: Sequence[T]) -> T:
        if not values:
            raise SketchError(f"{name}() chooses from a list that has something in it.", got="[]")
        return values[int(self._random.below(len(values)))]


def _whole(name: str, number: float) -> int:
    try:
        return int(number + 0)
    except (TypeError, ValueError, OverflowError):
        raise wrong_numbers(name, (number,), "seed") from None
