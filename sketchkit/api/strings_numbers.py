"""Numbers written out as text, and read from it.

The work is done in `data/strings.py`; here lists are taken one by one, and errors are told.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, overload

from sketchkit.core.errors import SketchError, shown, wrong_numbers
from sketchkit.data import strings


@overload
def nf(num: float, left: int | None = None, right: int | None = None) -> str: ...
@overload
def nf(num: Sequence[float], left: int | None = None, right: int | None = None) -> list[str]: ...
def nf(num: Any, left: int | None = None, right: int | None = None) -> Any:
    """Return a number as text, with a fixed number of digits.

    Parameters
    ----------
    num : int, float or list of them
        The number. A list gives a list of texts.
    left : int, optional
        How many digits there are at least before the point.
    right : int, optional
        How many digits there are after it; 0 means up to three. Without it the number is cut
        off to a whole one.

    See Also
    --------
    nfs, nfp, nfc

    Examples
    --------
    >>> nf(7, 3)
    '007'
    >>> nf(3.14159, 1, 2)
    '3.14'
    >>> nf([1, 20, 300], 4)
    ['0001', '0020', '0300']
    """
    return _each("nf", strings.nf, num, left, right)


@overload
def nfs(num: float, left: int, right: int | None = None) -> str: ...
@overload
def nfs(num: Sequence[float], left: int, right: int | None = None) -> list[str]: ...
def nfs(num: Any, left: int, right: int | None = None) -> Any:
    """Return a number as text, with a space where a minus sign would stand.

    Parameters
    ----------
    num : int, float or list of them
        The number. A list gives a list of texts.
    left : int
        How many digits there are at least before the point.
    right : int, optional
        How many digits there are after it; 0 means up to three. Without it the number is cut
        off to a whole one.

    See Also
    --------
    nf, nfp, nfc

    Examples
    --------
    >>> nfs(7, 3), nfs(-7, 3)
    (' 007', '-007')
    """
    return _each("nfs", strings.nfs, num, left, right)


@overload
def nfp(num: float, left: int, right: int | None = None) -> str: ...
@overload
def nfp(num: Sequence[float], left: int, right: int | None = None) -> list[str]: ...
def nfp(num: Any, left: int, right: int | None = None) -> Any:
    """Return a number as text, with a plus or a minus sign.

    Parameters
    ----------
    num : int, float or list of them
        The number. A list gives a list of texts.
    left : int
        How many digits there are at least before the point.
    right : int, optional
        How many digits there are after it; 0 means up to three. Without it the number is cut
        off to a whole one.

    See Also
    --------
    nf, nfs, nfc

    Examples
    --------
    >>> nfp(7, 3), nfp(-7, 3)
    ('+007', '-007')
    """
    return _each("nfp", strings.nfp, num, left, right)


@overload
def nfc(num: float, right: int | None = None) -> str: ...
@overload
def nfc(num: Sequence[float], right: int | None = None) -> list[str]: ...
def nfc(num: Any, right: int | None = None) -> Any:
    """Return a number as text, with commas between thousands.

    Parameters
    ----------
    num : int, float or list of them
        The number. A list gives a list of texts.
    right : int, optional
        How many digits there are after the point; 0 means up to three. Without it the number is
        cut off to a whole one.

    See Also
    --------
    nf, nfs, nfp

    Examples
    --------
    >>> nfc(1234567)
    '1,234,567'
    >>> nfc(1234.5, 2)
    '1,234.50'
    """
    return _each("nfc", strings.nfc, num, right)


def hex(value: int | str, digits: int | None = None) -> str:
    """Return a number in hexadecimal digits: a colour as AARRGGBB.

    Parameters
    ----------
    value : int, or one character
        The number, of which 32 bits are shown; or a character, for its code.
    digits : int, optional
        How many digits, from the right; 8 if left out, 4 for a character.

    See Also
    --------
    unhex, binary

    Examples
    --------
    >>> hex(color(255, 102, 0))
    'FFFF6600'
    >>> hex(10, 2)
    '0A'
    """
    try:
        return strings.hex(value, digits)
    except (TypeError, ValueError):
        raise wrong_numbers("hex", (value,), "value [, digits]") from None


def unhex(value: str) -> int:
    """Return the number that hexadecimal digits stand for.

    Parameters
    ----------
    value : str
        Digits 0 to 9 and A to F.

    See Also
    --------
    hex, unbinary

    Notes
    -----
    The result is never negative, as colours are not; Java's `unhex("FFFFFFFF")` is -1.

    Examples
    --------
    >>> unhex("FF")
    255
    """
    try:
        return strings.unhex(value)
    except (TypeError, ValueError):
        raise wrong_text("unhex", "text of the digits 0 to 9 and A to F", value) from None


def binary(value: int | str, digits: int | None = None) -> str:
    """Return a number in binary digits.

    Parameters
    ----------
    value : int, or one character
        The number, of which 32 bits are shown; or a character, for its code.
    digits : int, optional
        How many digits, from the right; 32 if left out, 16 for a character.

    See Also
    --------
    unbinary, hex

    Examples
    --------
    >>> binary(5, 8)
    '00000101'
    """
    try:
        return strings.binary(value, digits)
    except (TypeError, ValueError):
        raise wrong_numbers("binary", (value,), "value [, digits]") from None


def unbinary(value: str) -> int:
    """Return the number that binary digits stand for.

    Parameters
    ----------
    value : str
        Digits 0 and 1.

    See Also
    --------
    binary, unhex

    Examples
    --------
    >>> unbinary("101")
    5
    """
    try:
        return strings.unbinary(value)
    except (TypeError, ValueError):
        raise wrong_text("unbinary", "text of the digits 0 and 1", value) from None


def wrong_text(name: str, takes: str, *args: object) -> SketchError:
    """Return the error for a function on text that got something else than it takes."""
    call = ", ".join(map(shown, args))
    return SketchError(f"{name}() takes {takes}.", got=f"{name}({call})")


def _each(name: str, write: Callable[..., str], num: Any, *digits: int | None) -> Any:  # noqa: ANN401 one or a list
    """Return what `write` makes of a number, or of each number of a list."""
    try:
        if isinstance(num, int | float):
            return write(num, *digits)
        return (
            [write(n, *digits) for n in num] if isinstance(num, Iterable) else write(num, *digits)
        )
    except (TypeError, ValueError):
        args = (num, *(count for count in digits if count is not None))
        usage = "num [, right]" if name == "nfc" else "num [, left] [, right]"
        raise wrong_numbers(name, args, usage) from None
