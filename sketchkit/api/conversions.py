"""One kind of value made into another, as Processing does it: text that is no number is no error.

`int()`, `float()` and `str()` are Python's own. What Python has no name for is here, and so are the
names in which Java's spelling hides behind them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import nan
from typing import Any, TypeVar

from sketchkit.api.maths_calculation import java_int
from sketchkit.core.errors import SketchError, shown

__all__ = [
    "boolean",
    "byte",
    "char",
    "parseBoolean",
    "parseByte",
    "parseChar",
    "parseFloat",
    "parseInt",
]

T = TypeVar("T")


def parseInt(what: Any, otherwise: int = 0) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as a whole number; text that is none gives 0, and no error.

    Parameters
    ----------
    what : str, float, bool, or list of them
        Text loses what stands behind its point, a number its fraction. A list gives a list.
    otherwise : int
        What text gives that is no number.

    See Also
    --------
    parseFloat

    Notes
    -----
    Python's own `int("four")` is an error that stops the sketch. Source: Processing's reference,
    int().

    Examples
    --------
    >>> parseInt("42") + 1
    43
    >>> parseInt("3.9"), parseInt("four"), parseInt("four", -1)
    (3, 0, -1)
    >>> parseInt(["1", "2"])
    [1, 2]
    """

    def convert(value: object) -> int:
        if isinstance(value, str):
            try:
                return int(_plain_number(value.partition(".")[0]))
            except ValueError:
                return otherwise
        return _whole("parseInt", value)

    return _each(convert, what)


def parseFloat(what: Any, otherwise: float = nan) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as a number; text that is none gives NaN, and no error.

    Parameters
    ----------
    what : str, float, bool, or list of them
        A list gives a list.
    otherwise : float
        What text gives that is no number: NaN, "not a number", if left out.

    See Also
    --------
    parseInt

    Notes
    -----
    Python's own `float("four")` is an error that stops the sketch. Source: Processing's reference,
    float().

    Examples
    --------
    >>> parseFloat("3.5") * 2
    7.0
    >>> parseFloat("four"), parseFloat("four", 0)
    (nan, 0.0)
    """

    def convert(value: object) -> float:
        if isinstance(value, str):
            try:
                return float(_plain_number(value.strip()))
            except ValueError:
                return float(otherwise)
        return float(_number("parseFloat", value))

    return _each(convert, what)


def parseBoolean(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as True or False: what `boolean()` does, by its other name.

    Parameters
    ----------
    what : float, str, bool, or list of them
        A number is true unless it is 0; text is if it says "true".

    See Also
    --------
    boolean

    Examples
    --------
    >>> parseBoolean("true"), parseBoolean("yes")
    (True, False)
    """

    def convert(value: object) -> bool:
        return value.lower() == "true" if isinstance(value, str) else bool(value)

    return _each(convert, what)


def boolean(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as True or False.

    Parameters
    ----------
    what : float, str, bool, or list of them
        A number is true unless it is 0; text is if it says "true", in whatever letters. A list
        gives a list.

    Notes
    -----
    Python's own `bool("false")` is True, as of every text that is not empty. Source: Processing's
    reference, boolean().

    Examples
    --------
    >>> boolean(3), boolean(0), boolean("TRUE"), boolean("false")
    (True, False, True, False)
    """
    return parseBoolean(what)


def parseByte(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as a number from -128 to 127: what `byte()` does, by its other name.

    Parameters
    ----------
    what : float, bool, one character, or list of them
        Of a number the last 8 bits count, of a character its code.

    See Also
    --------
    byte

    Examples
    --------
    >>> parseByte(127), parseByte(128)
    (127, -128)
    """

    def convert(value: object) -> int:
        is_code = isinstance(value, str) and len(value) == 1
        number = ord(str(value)) if is_code else _whole("byte", value)
        return (number + 128) % 256 - 128

    return _each(convert, what)


def byte(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return a value as a number from -128 to 127: the last 8 bits of it.

    Parameters
    ----------
    what : float, bool, one character, or list of them
        A number loses its fraction first; of a character it is the code. A list gives a list.

    See Also
    --------
    char

    Notes
    -----
    Java's bytes have a sign: 255 is -1. Source: Processing's reference, byte().

    Examples
    --------
    >>> byte(65), byte("A"), byte(200)
    (65, 65, -56)
    """
    return parseByte(what)


def parseChar(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return the character of a code: what `char()` does, by its other name.

    Parameters
    ----------
    what : int, one character, or list of them
        A character stays as it is.

    See Also
    --------
    char

    Examples
    --------
    >>> parseChar(65), parseChar([72, 105])
    ('A', ['H', 'i'])
    """

    def convert(value: object) -> str:
        is_code = isinstance(value, str) and len(value) == 1
        return str(value) if is_code else chr(_whole("char", value) & 0xFFFF)

    return _each(convert, what)


def char(what: Any) -> Any:  # noqa: ANN401 a value, or a list of them
    """Return the character of a code.

    Parameters
    ----------
    what : int, one character, or list of them
        The code, of which 16 bits count; a character stays as it is. A list gives a list.

    See Also
    --------
    byte

    Notes
    -----
    Python's `ord()` goes the other way. Source: Processing's reference, char().

    Examples
    --------
    >>> char(65)
    'A'
    >>> char(ord("A") + 1)
    'B'
    """
    return parseChar(what)


def _each(convert: Callable[[object], T], what: object) -> T | list[T]:
    """Return what `convert` makes of a value, or of each value of a list."""
    if isinstance(what, Sequence) and not isinstance(what, str):
        return [convert(value) for value in what]
    return convert(what)


def _plain_number(text: str) -> str:
    """Return text that Python reads as Java does: `1_000` is a number in Python alone.

    Raises
    ------
    ValueError
        If it is such a one.
    """
    if "_" in text:
        raise ValueError(text)
    return text


def _whole(name: str, value: object) -> int:
    """Return a number without its fraction."""
    number = _number(name, value)
    try:
        return int(number)
    except (OverflowError, ValueError):
        return java_int(name, number)


def _number(name: str, value: object) -> float:
    try:
        return value + 0  # type: ignore[operator] # what cannot be added is told of
    except TypeError:
        raise SketchError(
            f"{name}() takes a number, or a list of them.", got=f"{name}({shown(value)})"
        ) from None
