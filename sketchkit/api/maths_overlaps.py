"""Functions on numbers that Python has as well: Processing's forms come first, Python's work too.

What has no answer is NaN or infinite, as in Java, and no error.
"""

import builtins
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from math import inf, nan
from typing import Any, TypeVar, overload

from sketchkit.api.maths_calculation import java_int, over_zero
from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.core.notices import warn_once

T = TypeVar("T")

_abs = builtins.abs
_floor = math.floor
_max = builtins.max
_min = builtins.min
_power = math.pow


def abs(n: float) -> float:
    """Return a number without its sign.

    Parameters
    ----------
    n : int or float
        Any number. An int gives an int.

    Examples
    --------
    >>> abs(-12)
    12
    """
    try:
        return _abs(n)
    except TypeError:
        raise wrong_numbers("abs", (n,), "n") from None


@overload
def map(value: float, start1: float, stop1: float, start2: float, stop2: float, /) -> float: ...
@overload
def map(function: Callable[..., T], /, *iterables: Iterable[Any]) -> Iterator[T]: ...
def map(value: Any, *ranges: Any) -> Any:
    """Return where a number of one range lies in another range.

    Parameters
    ----------
    value : float
        The number.
    start1, stop1 : float
        The range that it comes from.
    start2, stop2 : float
        The range that it goes to.

    See Also
    --------
    norm, lerp, constrain

    Notes
    -----
    The number may lie outside of its range. With a function and lists in place of the numbers,
    it is Python's own `map()`.

    Examples
    --------
    >>> map(25, 0, 100, 0, 8)
    2.0
    >>> list(map(abs, [-1, 2, -3]))
    [1, 2, 3]
    """
    if callable(value):
        return builtins.map(value, *ranges)
    try:
        start1, stop1, start2, stop2 = ranges
        return start2 + (stop2 - start2) * ((value - start1) / (stop1 - start1))
    except ZeroDivisionError:
        warn_once(f"map() has a range from {shown(start1)} to {shown(stop1)}: it holds no numbers.")
        return start2 + (stop2 - start2) * over_zero(value - start1)
    except (TypeError, ValueError):
        usage = "value, start1, stop1, start2, stop2"
        raise wrong_numbers("map", (value, *ranges), usage) from None


def max(*values: Any, **options: Any) -> Any:  # noqa: ANN401 whatever can be compared
    """Return the greatest of some numbers.

    Parameters
    ----------
    *values : float, or one list
        The numbers, two or more; or a list of them.
    **options
        `key` and `default`, as Python's own `max()` has them.

    See Also
    --------
    min, constrain

    Examples
    --------
    >>> max(5, 9, 2)
    9
    >>> max([5, 9, 2])
    9
    """
    if options:
        return _max(*values, **options)
    try:
        return _max(*values)
    except (TypeError, ValueError):
        raise _nothing_to_compare("max", values) from None


def min(*values: Any, **options: Any) -> Any:  # noqa: ANN401 whatever can be compared
    """Return the least of some numbers.

    Parameters
    ----------
    *values : float, or one list
        The numbers, two or more; or a list of them.
    **options
        `key` and `default`, as Python's own `min()` has them.

    See Also
    --------
    max, constrain

    Examples
    --------
    >>> min(5, 9, 2)
    2
    >>> min([5, 9, 2])
    2
    """
    if options:
        return _min(*values, **options)
    try:
        return _min(*values)
    except (TypeError, ValueError):
        raise _nothing_to_compare("min", values) from None


def pow(n: float, exponent: float, modulus: int | None = None) -> float:
    """Return a number to the power of another.

    Parameters
    ----------
    n : float
        The number that is multiplied by itself.
    exponent : float
        How often. Two ints give an int, if it is not negative.
    modulus : int, optional
        As in Python's own `pow()`.

    See Also
    --------
    sq, sqrt, exp

    Examples
    --------
    >>> pow(2, 8)
    256
    >>> pow(9, 0.5)
    3.0
    """
    try:
        if isinstance(n, int) and isinstance(exponent, int) and (exponent >= 0 or modulus):
            return builtins.pow(n, exponent, modulus)
        return _power(n, exponent)
    except ValueError:
        return inf if n == 0 else nan
    except OverflowError:
        return -inf if n < 0 and exponent % 2 == 1 else inf
    except TypeError:
        raise wrong_numbers("pow", (n, exponent), "n, exponent") from None


@overload
def round(n: float) -> int: ...
@overload
def round(n: float, digits: int) -> float: ...
def round(n: float, digits: int | None = None) -> float:
    """Return the nearest whole number; halves go up.

    Parameters
    ----------
    n : float
        Any number. NaN gives 0.
    digits : int, optional
        How many digits to keep after the point: with it, this is Python's own `round()`.

    See Also
    --------
    floor, ceil, nf

    Notes
    -----
    Python's own `round(2.5)` is 2, to the even neighbour.

    Examples
    --------
    >>> round(2.5)
    3
    >>> round(-2.5)
    -2
    >>> round(3.14159, 2)
    3.14
    """
    try:
        return _floor(n + 0.5) if digits is None else builtins.round(n, digits)
    except (OverflowError, TypeError, ValueError):
        return java_int("round", n)


def _nothing_to_compare(name: str, values: Sequence[object]) -> SketchError:
    call = ", ".join(shown(value) for value in values)
    return SketchError(f"{name}() takes two numbers or more, or a list.", got=f"{name}({call})")
