"""Text as files hold it: how it is encoded, and where its lines end."""

from __future__ import annotations

import codecs
import re

_MARKS = (  # what a file begins with that says itself how it is encoded
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)


def decoded(data: bytes) -> tuple[str, bool]:
    """Return the text of a file, and whether it is what its author wrote for certain.

    Text that is not UTF-8 is taken for Latin-1, where every byte is a character.

    Examples
    --------
    >>> decoded("Köln".encode()), decoded("Köln".encode("latin-1"))
    (('Köln', True), ('Köln', False))
    """
    encoding = next((name for mark, name in _MARKS if data.startswith(mark)), "utf-8")
    try:
        return data.decode(encoding), True
    except UnicodeDecodeError:
        return data.decode("latin-1"), False


def lines_of(text: str) -> list[str]:
    r"""Return the lines of a text; they end with a newline, a carriage return, or both.

    Examples
    --------
    >>> lines_of("a\r\nb\n\nc"), lines_of("a\n"), lines_of("")
    (['a', 'b', '', 'c'], ['a'], [])
    """
    lines = unified(text).split("\n")
    return lines if lines[-1] else lines[:-1]


def unified(text: str) -> str:
    r"""Return a text in which every line ends with a newline.

    Examples
    --------
    >>> unified("a\r\nb\rc")
    'a\nb\nc'
    """
    return re.sub("\r\n?", "\n", text)
