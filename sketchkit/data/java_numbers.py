"""Numbers as Java reads them from text and writes them: in tables, lists, JSON and XML."""

from __future__ import annotations

import re

import numpy as np

INT_RANGE = range(-(2**31), 2**31)

_WHOLE = re.compile(r"[+-]?[0-9]{1,4000}")  # Python reads no more
_DECIMAL = re.compile(
    r"[+-]?(?:NaN|Infinity|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?[fFdD]?)"
)
_BLANKS = "".join(map(chr, range(33)))


def read_whole(text: str) -> int | None:
    """Return the whole number that a text is, or None: blanks are not allowed.

    Examples
    --------
    >>> read_whole("-12"), read_whole(" 12"), read_whole("1.5")
    (-12, None, None)
    """
    return int(text) if _WHOLE.fullmatch(text) else None


def read_int(text: str) -> int | None:
    """Return what stands before the point of a number, or None if that has more than 32 bits.

    Examples
    --------
    >>> read_int("7.9"), read_int("-3"), read_int(" 30 "), read_int("3000000000")
    (7, -3, None, None)
    """
    number = read_whole(text.partition(".")[0])
    return number if number is not None and number in INT_RANGE else None


def read_float(text: str) -> float | None:
    """Return the number that a text is, blanks around it aside; None if it is none.

    Examples
    --------
    >>> read_float(" 1.5 "), read_float("2e3f"), read_float("abc"), read_float("1_0")
    (1.5, 2000.0, None, None)
    """
    bare = text.strip(_BLANKS)
    return float(bare.rstrip("fFdD")) if _DECIMAL.fullmatch(bare) else None


def float_text(value: float) -> str:
    """Return a number as Java writes a float: in as few digits as tell 32 bits from others.

    Examples
    --------
    >>> float_text(0.1), float_text(2), float_text(1 / 3), float_text(1e8)
    ('0.1', '2.0', '0.33333334', '1.0E8')
    """
    with np.errstate(over="ignore"):
        return _java_text(np.float32(value))


def double_text(value: float) -> str:
    """Return a number as Java writes a double.

    Examples
    --------
    >>> double_text(0.1), double_text(1e7), double_text(0.0001)
    ('0.1', '1.0E7', '1.0E-4')
    """
    return _java_text(np.float64(value))


def shortest_text(value: float) -> str:
    """Return a number as a double, without a point where nothing follows it: as JSON has it.

    Examples
    --------
    >>> shortest_text(2.0), shortest_text(2.5), shortest_text(1e20)
    ('2', '2.5', '1.0E20')
    """
    return double_text(value).removesuffix(".0")


def _java_text(value: np.floating) -> str:
    if not np.isfinite(value):
        return "NaN" if np.isnan(value) else str(value).replace("inf", "Infinity")
    if value == 0 or 1e-3 <= abs(value) < 1e7:
        return np.format_float_positional(value, trim="0")
    return np.format_float_scientific(value, trim="0", exp_digits=1).replace("e+", "E").upper()
