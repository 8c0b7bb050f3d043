"""Calculation: the everyday functions on numbers, as Processing names and defines them.

What has no answer is NaN or infinite, as in Java, and no error: `sqrt(-1)`, `log(0)`. A sketch
calls these 100,000 times a frame, so each is one expression; what is unusual is left to an
exception. Those that Python has, too, are in `maths_overlaps`.
"""

import math
from math import inf, isnan, nan
from typing import Any, overload

from sketchkit.core.constants import MAX_INT, MIN_INT
from sketchkit.core.errors import wrong_numbers

_ceil = math.ceil
_exp = math.exp
_floor = math.floor
_hypot = math.hypot
_log = math.log
_sqrt = math.sqrt


def ceil(n: float) -> int:
    """Return the nearest whole number that is not below a number.

    Parameters
    ----------
    n : float
        Any number. NaN gives 0.

    See Also
    --------
    floor, round

    Examples
    --------
    >>> ceil(8.22)
    9
    """
    try:
        return _ceil(n)
    except (OverflowError, TypeError, ValueError):
        return java_int("ceil", n)


def constrain(amount: float, low: float, high: float) -> float:
    """Return a number, or the limit that it goes beyond.

    Parameters
    ----------
    amount : float
        The number.
    low, high : float
        The least and the greatest that it may be.

    Examples
    --------
    >>> constrain(120, 0, 100)
    100
    """
    try:
        return low if amount < low else high if amount > high else amount
    except TypeError:
        raise wrong_numbers("constrain", (amount, low, high), "amount, low, high") from None


@overload
def dist(x1: float, y1: float, x2: float, y2: float, /) -> float: ...
@overload
def dist(x1: float, y1: float, z1: float, x2: float, y2: float, z2: float, /) -> float: ...
def dist(
    a: Any, b: Any = None, c: Any = None, d: Any = None, e: Any = None, f: Any = None
) -> float:
    """Return the distance between two points.

    Parameters
    ----------
    x1, y1, z1 : float
        The first point; z1 and z2 are left out in the plane.
    x2, y2, z2 : float
        The second point.

    See Also
    --------
    mag, PVector.dist

    Examples
    --------
    >>> dist(0, 0, 30, 40)
    50.0
    >>> dist(0, 0, 0, 1, 2, 2)
    3.0
    """
    try:
        if e is None:
            return _hypot(c - a, d - b)
        return _hypot(d - a, e - b, f - c)
    except TypeError:
        args = [number for number in (a, b, c, d, e, f) if number is not None]
        raise wrong_numbers("dist", args, "x1, y1, x2, y2 | x1, y1, z1, x2, y2, z2") from None


def exp(n: float) -> float:
    """Return e (2.71828...) to the power of a number.

    Parameters
    ----------
    n : float
        The exponent.

    Examples
    --------
    >>> exp(0)
    1.0
    """
    try:
        return _exp(n)
    except OverflowError:
        return inf
    except TypeError:
        raise wrong_numbers("exp", (n,), "n") from None


def floor(n: float) -> int:
    """Return the nearest whole number that is not above a number.

    Parameters
    ----------
    n : float
        Any number. NaN gives 0.

    See Also
    --------
    ceil, round

    Examples
    --------
    >>> floor(2.88)
    2
    >>> floor(-2.5)
    -3
    """
    try:
        return _floor(n)
    except (OverflowError, TypeError, ValueError):
        return java_int("floor", n)


def lerp(start: float, stop: float, amount: float) -> float:
    """Return the number that lies some of the way from one number to another.

    Parameters
    ----------
    start, stop : float
        The two numbers.
    amount : float
        How much of the way: 0 is at the start, 1 at the stop; beyond them it goes on.

    See Also
    --------
    map, norm, lerpColor

    Examples
    --------
    >>> lerp(10, 20, 0.25)
    12.5
    """
    try:
        return start + (stop - start) * amount + 0.0
    except TypeError:
        raise wrong_numbers("lerp", (start, stop, amount), "start, stop, amount") from None


def log(n: float) -> float:
    """Return the natural logarithm of a number.

    Parameters
    ----------
    n : float
        A number above 0. 0 gives minus infinity, a negative one NaN.

    Examples
    --------
    >>> log(1)
    0.0
    """
    try:
        return _log(n)
    except ValueError:
        return -inf if n == 0 else nan
    except TypeError:
        raise wrong_numbers("log", (n,), "n") from None


def mag(a: float, b: float, c: float = 0.0) -> float:
    """Return the length of the arrow from the origin to a point.

    Parameters
    ----------
    a, b, c : float
        The point; c is left out in the plane.

    See Also
    --------
    dist, PVector.mag

    Examples
    --------
    >>> mag(30, 40)
    50.0
    """
    try:
        return _hypot(a, b, c)
    except TypeError:
        raise wrong_numbers("mag", (a, b, c), "a, b [, c]") from None


def norm(value: float, start: float, stop: float) -> float:
    """Return where a number lies in a range: 0 at its start, 1 at its end.

    Parameters
    ----------
    value : float
        The number, inside or outside of the range.
    start, stop : float
        The range.

    See Also
    --------
    map, lerp

    Examples
    --------
    >>> norm(20, 0, 50)
    0.4
    """
    try:
        return (value - start) / (stop - start)
    except ZeroDivisionError:
        return over_zero(value - start)
    except TypeError:
        raise wrong_numbers("norm", (value, start, stop), "value, start, stop") from None


def sq(n: float) -> float:
    """Return a number multiplied by itself.

    Parameters
    ----------
    n : float
        Any number.

    See Also
    --------
    sqrt, pow

    Examples
    --------
    >>> sq(-5)
    25.0
    """
    try:
        return n * n + 0.0
    except TypeError:
        raise wrong_numbers("sq", (n,), "n") from None


def sqrt(n: float) -> float:
    """Return the square root of a number.

    Parameters
    ----------
    n : float
        The number. A negative one gives NaN.

    See Also
    --------
    sq, pow

    Examples
    --------
    >>> sqrt(25)
    5.0
    """
    try:
        return _sqrt(n)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("sqrt", (n,), "n") from None


def java_int(name: str, n: float) -> int:
    """Return what Java's (int) makes of a number that Python refuses to make whole."""
    try:
        n = n + 0.0
    except TypeError:
        raise wrong_numbers(name, (n,), "n") from None
    return 0 if isnan(n) else MAX_INT if n > 0 else MIN_INT


def over_zero(n: float) -> float:
    """Return n / 0 as floating point numbers have it."""
    return math.copysign(inf, n) if n else nan
