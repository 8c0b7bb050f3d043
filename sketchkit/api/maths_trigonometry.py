"""Trigonometry: angles in radians, positive ones clockwise on the screen, where y points down.

What has no answer is NaN, as in Java, and no error: `acos(2)`.
"""

import math
from math import nan

from sketchkit.core.errors import wrong_numbers

_acos = math.acos
_asin = math.asin
_atan = math.atan
_atan2 = math.atan2
_cos = math.cos
_degrees = math.degrees
_radians = math.radians
_sin = math.sin
_tan = math.tan


def acos(value: float) -> float:
    """Return the angle whose cosine is a number.

    Parameters
    ----------
    value : float
        From -1 to 1; beyond them the result is NaN.

    Returns
    -------
    float, radians
        From 0 to PI.

    See Also
    --------
    cos, asin, atan

    Examples
    --------
    >>> degrees(acos(-1))
    180.0
    """
    try:
        return _acos(value)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("acos", (value,), "value") from None


def asin(value: float) -> float:
    """Return the angle whose sine is a number.

    Parameters
    ----------
    value : float
        From -1 to 1; beyond them the result is NaN.

    Returns
    -------
    float, radians
        From -HALF_PI to HALF_PI.

    See Also
    --------
    sin, acos, atan

    Examples
    --------
    >>> degrees(asin(1))
    90.0
    """
    try:
        return _asin(value)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("asin", (value,), "value") from None


def atan(value: float) -> float:
    """Return the angle whose tangent is a number.

    Parameters
    ----------
    value : float
        Any number.

    Returns
    -------
    float, radians
        From -HALF_PI to HALF_PI.

    See Also
    --------
    tan, atan2

    Examples
    --------
    >>> degrees(atan(1))
    45.0
    """
    try:
        return _atan(value)
    except TypeError:
        raise wrong_numbers("atan", (value,), "value") from None


def atan2(y: float, x: float) -> float:
    """Return the angle from the x axis to a point.

    Parameters
    ----------
    y, x : float
        The point, seen from the origin: y comes first.

    Returns
    -------
    float, radians
        From -PI to PI.

    See Also
    --------
    atan, PVector.heading

    Examples
    --------
    >>> degrees(atan2(10, 0))
    90.0
    """
    try:
        return _atan2(y, x)
    except TypeError:
        raise wrong_numbers("atan2", (y, x), "y, x") from None


def cos(angle: float) -> float:
    """Return the cosine of an angle: how far right a point on the unit circle lies.

    Parameters
    ----------
    angle : float, radians
        Any angle.

    Returns
    -------
    float
        From -1 to 1.

    See Also
    --------
    sin, tan, acos, radians

    Examples
    --------
    >>> cos(0)
    1.0
    """
    try:
        return _cos(angle)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("cos", (angle,), "angle") from None


def degrees(radians: float) -> float:
    """Return an angle in degrees.

    Parameters
    ----------
    radians : float, radians
        The angle.

    Returns
    -------
    float, degrees
        A whole turn is 360.

    See Also
    --------
    radians

    Examples
    --------
    >>> degrees(PI)
    180.0
    """
    try:
        return _degrees(radians)
    except TypeError:
        raise wrong_numbers("degrees", (radians,), "radians") from None


def radians(degrees: float) -> float:
    """Return an angle in radians.

    Parameters
    ----------
    degrees : float, degrees
        The angle.

    Returns
    -------
    float, radians
        A whole turn is TWO_PI.

    See Also
    --------
    degrees

    Examples
    --------
    >>> radians(180) == PI
    True
    """
    try:
        return _radians(degrees)
    except TypeError:
        raise wrong_numbers("radians", (degrees,), "degrees") from None


def sin(angle: float) -> float:
    """Return the sine of an angle: how far down a point on the unit circle lies.

    Parameters
    ----------
    angle : float, radians
        Any angle.

    Returns
    -------
    float
        From -1 to 1.

    See Also
    --------
    cos, tan, asin, radians

    Examples
    --------
    >>> sin(HALF_PI)
    1.0
    """
    try:
        return _sin(angle)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("sin", (angle,), "angle") from None


def tan(angle: float) -> float:
    """Return the tangent of an angle: sine divided by cosine.

    Parameters
    ----------
    angle : float, radians
        Any angle.

    Returns
    -------
    float
        Any number.

    See Also
    --------
    sin, cos, atan, atan2

    Examples
    --------
    >>> round(tan(QUARTER_PI), 6)
    1.0
    """
    try:
        return _tan(angle)
    except ValueError:
        return nan
    except TypeError:
        raise wrong_numbers("tan", (angle,), "angle") from None
