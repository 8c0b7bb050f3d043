"""Numbers as text, text as numbers, and text taken apart, as Processing does it.

Numbers with a fraction are 32-bit floats in Processing, and rounded from those, halves to even:
so `nf(1.115, 1, 2)` is 1.12. Whole numbers stay exact here.
"""

import math
import operator
import re
from collections.abc import Iterable

import numpy as np

BLANKS = " \t\n\r\f\u00a0"

_UP_TO_SPACE = "".join(map(chr, range(33)))  # what Java's trim() takes for blank


def nf(number: float, left: int | None = None, right: int | None = None) -> str:
    """Return a number as text, with at least `left` digits before the point and `right` after it.

    With `left` alone the number is cut off to a whole one; with neither it is written as it is.
    `right` 0 means up to three digits, as many as it needs.

    Examples
    --------
    >>> nf(7, 3), nf(3.14159, 2, 1), nf(2.50)
    ('007', '03.1', '2.5')
    """
    if left is None:
        return _shortest(number)
    if right is None:
        return _fixed(int(number), left, 0)
    return _fixed(number, left, right)


def nfs(number: float, left: int, right: int | None = None) -> str:
    """Return what `nf` does, with a space before numbers that have no minus sign.

    Examples
    --------
    >>> nfs(7, 3), nfs(-7, 3)
    (' 007', '-007')
    """
    return nf(number, left, right) if number < 0 else " " + nf(number, left, right)


def nfp(number: float, left: int, right: int | None = None) -> str:
    """Return what `nf` does, with a plus sign before numbers that have no minus sign.

    Examples
    --------
    >>> nfp(7, 3), nfp(-7, 3)
    ('+007', '-007')
    """
    return nf(number, left, right) if number < 0 else "+" + nf(number, left, right)


def nfc(number: float, right: int | None = None) -> str:
    """Return a number as text, with commas between thousands and `right` digits after the point.

    Examples
    --------
    >>> nfc(1234567), nfc(1234.5, 2)
    ('1,234,567', '1,234.50')
    """
    if right is None:
        return f"{int(number):,}"
    return _fixed(number, 0, right, grouped=True)


def hex(value: int | str, digits: int | None = None) -> str:
    """Return a number as `digits` hexadecimal digits, at most 8; of one character, its code in 4.

    Examples
    --------
    >>> hex(255), hex(255, 2), hex(-1), hex("A")
    ('000000FF', 'FF', 'FFFFFFFF', '0041')
    """
    text = f"{_bits(value):08X}"
    if digits is None:
        digits = 4 if isinstance(value, str) else 8
    return text[max(8 - digits, 0) :]


def unhex(text: str) -> int:
    """Return the number that hexadecimal digits stand for, never negative.

    Examples
    --------
    >>> unhex("FF"), unhex("FFCC6600") == 0xFFCC6600
    (255, True)
    """
    return int(text, 16)


def binary(value: int | str, digits: int | None = None) -> str:
    """Return a number as `digits` binary digits, at most 32; of one character, its code in 16.

    Examples
    --------
    >>> binary(5, 8), binary("A")
    ('00000101', '0000000001000001')
    """
    text = f"{_bits(value):032b}"
    if digits is None:
        digits = 16 if isinstance(value, str) else 32
    return text[max(32 - digits, 0) :]


def unbinary(text: str) -> int:
    """Return the number that binary digits stand for, never negative.

    Examples
    --------
    >>> unbinary("101")
    5
    """
    return int(text, 2)


def join(parts: Iterable[object], separator: str) -> str:
    """Return the parts as one text, with the separator between them.

    Examples
    --------
    >>> join(["x", 1, 2.5], ", ")
    'x, 1, 2.5'
    """
    return separator.join(map(str, parts))


def split(text: str, delimiter: str) -> list[str]:
    """Return the pieces between delimiters, empty ones too.

    Examples
    --------
    >>> split("a,,b", ",")
    ['a', '', 'b']
    """
    return text.split(delimiter)


def split_tokens(text: str, delimiters: str = BLANKS) -> list[str]:
    """Return the pieces between delimiters, each character being one; no piece is empty.

    Examples
    --------
    >>> split_tokens("a, b;c", " ,;")
    ['a', 'b', 'c']
    """
    return re.findall(f"[^{re.escape(delimiters)}]+", text) if delimiters else [text]


def trim(text: str) -> str:
    """Return the text without blanks and control characters at its ends.

    No-break spaces and byte order marks become spaces, inside as well.

    Examples
    --------
    >>> trim("  a b ")
    'a b'
    """
    return text.replace("\u00a0", " ").replace("\ufeff", " ").strip(_UP_TO_SPACE)


def match(text: str, pattern: str) -> list[str | None] | None:
    r"""Return the first match of a regular expression and its groups; None if there is no match.

    Examples
    --------
    >>> match("size: 24 px", r"(\d+) (px|pt)")
    ['24 px', '24', 'px']
    """
    found = _compiled(pattern).search(text)
    return _groups(found) if found else None


def match_all(text: str, pattern: str) -> list[list[str | None]] | None:
    """Return every match of a regular expression, each with its groups; None if there is none.

    Examples
    --------
    >>> match_all("<b><i>", "<(.)>")
    [['<b>', 'b'], ['<i>', 'i']]
    """
    return [_groups(found) for found in _compiled(pattern).finditer(text)] or None


def _fixed(number: float, left: int, right: int, *, grouped: bool = False) -> str:
    """Return `number` with its digits counted, as Java's NumberFormat writes it."""
    if hasattr(number, "__index__"):
        text = f"{operator.index(number):+,d}" + "." * bool(right) + "0" * right
    elif not math.isfinite(number):
        return "NaN" if math.isnan(number) else f"{number:f}".replace("inf", "\u221e")
    elif right:
        text = f"{np.float32(number):+,.{right}f}"
    else:
        text = f"{np.float32(number):+,.3f}".rstrip("0").removesuffix(".")
    sign = text[0].replace("+", "")
    whole, point, fraction = text[1:].partition(".")
    return sign + (whole if grouped else whole.replace(",", "").zfill(left)) + point + fraction


def _shortest(number: float) -> str:
    """Return `number` in as few digits as tell it from other 32-bit floats, in Java's form."""
    if hasattr(number, "__index__"):
        return str(operator.index(number))
    value = np.float32(number)
    if not np.isfinite(value):
        return "NaN" if np.isnan(value) else str(value).replace("inf", "Infinity")
    if abs(value) < 2**31 and value == int(value):
        return str(int(value))
    if 1e-3 <= abs(value) < 1e7:
        return np.format_float_positional(value, trim="0")
    return np.format_float_scientific(value, trim="0", exp_digits=1).replace("e+", "E").upper()


def _bits(value: int | str) -> int:
    """Return the 32 bits of a number, or of the code of one character."""
    return (ord(value) if isinstance(value, str) else int(value)) & 0xFFFFFFFF


def _compiled(pattern: str) -> re.Pattern[str]:
    """Return a pattern as Processing reads it: ^ and $ at each line, and . for line ends, too."""
    java_group_name = r"\(\?<(?=[A-Za-z])"
    return re.compile(re.sub(java_group_name, "(?P<", pattern), re.MULTILINE | re.DOTALL)


def _groups(found: re.Match[str]) -> list[str | None]:
    return [found[0], *found.groups()]
