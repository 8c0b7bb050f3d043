"""Text: taken apart, joined and printed; with the numbers of `strings_numbers`, all that there is.

The work is done in `data/strings.py`; here errors are told to the sketch.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar, overload

from sketchkit.api.strings_numbers import (
    binary,
    hex,
    nf,
    nfc,
    nfp,
    nfs,
    unbinary,
    unhex,
    wrong_text,
)
from sketchkit.core.errors import SketchError, shown
from sketchkit.data import strings

T = TypeVar("T")

__all__ = [
    "binary",
    "hex",
    "join",
    "match",
    "matchAll",
    "nf",
    "nfc",
    "nfp",
    "nfs",
    "printArray",
    "println",
    "split",
    "splitTokens",
    "trim",
    "unbinary",
    "unhex",
]


def join(parts: Iterable[object], separator: str) -> str:
    """Return values as one text.

    Parameters
    ----------
    parts : list
        Texts, or anything that can be printed.
    separator : str
        What stands between them.

    See Also
    --------
    split, trim

    Examples
    --------
    >>> join(["cat", "dog", 3], ", ")
    'cat, dog, 3'
    """
    try:
        return strings.join(parts, separator)
    except (AttributeError, TypeError):
        raise wrong_text("join", "a list and the text between", parts, separator) from None


def split(value: str, delimiter: str) -> list[str]:
    """Return the pieces of a text.

    Parameters
    ----------
    value : str
        The text.
    delimiter : str
        What stands between the pieces. Two in a row have an empty piece between them.

    See Also
    --------
    splitTokens, join, trim

    Examples
    --------
    >>> split("a,b,,c", ",")
    ['a', 'b', '', 'c']
    """
    try:
        return strings.split(value, delimiter)
    except (AttributeError, TypeError, ValueError):
        raise wrong_text("split", "a text and what stands between", value, delimiter) from None


def splitTokens(value: str, delimiters: str = strings.BLANKS) -> list[str]:
    """Return the pieces of a text, none of them empty.

    Parameters
    ----------
    value : str
        The text.
    delimiters : str, optional
        The characters that may stand between pieces: spaces, tabs and line ends if left out.

    See Also
    --------
    split, join, trim

    Examples
    --------
    >>> splitTokens("a, b;  c", " ,;")
    ['a', 'b', 'c']
    """
    try:
        return strings.split_tokens(value, delimiters)
    except TypeError:
        takes = "a text and characters that separate"
        raise wrong_text("splitTokens", takes, value, delimiters) from None


@overload
def trim(value: str) -> str: ...
@overload
def trim(value: list[str]) -> list[str]: ...
def trim(value: Any) -> Any:
    """Return a text without spaces and line ends around it.

    Parameters
    ----------
    value : str, or list of them
        The text. A list gives a list.

    See Also
    --------
    split, join

    Examples
    --------
    >>> trim("  a word ")
    'a word'
    """
    try:
        return strings.trim(value) if isinstance(value, str) else [strings.trim(v) for v in value]
    except (AttributeError, TypeError):
        raise wrong_text("trim", "a text, or a list of them", value) from None


def match(value: str, pattern: str) -> list[str | None] | None:
    r"""Return the first place in a text that fits a regular expression.

    Parameters
    ----------
    value : str
        The text.
    pattern : str
        The regular expression.

    Returns
    -------
    list of str, or None
        What fits, then what fits each pair of brackets; None if nothing does.

    See Also
    --------
    matchAll, split

    Examples
    --------
    >>> match("size: 24 px", r"(\d+) (px|pt)")
    ['24 px', '24', 'px']
    """
    return _matching("match", strings.match, value, pattern)


def matchAll(value: str, pattern: str) -> list[list[str | None]] | None:
    """Return every place in a text that fits a regular expression.

    Parameters
    ----------
    value : str
        The text.
    pattern : str
        The regular expression.

    Returns
    -------
    list of lists of str, or None
        For each place what `match()` returns; None if there is none.

    See Also
    --------
    match, split

    Examples
    --------
    >>> matchAll("<b><i>", "<(.)>")
    [['<b>', 'b'], ['<i>', 'i']]
    """
    return _matching("matchAll", strings.match_all, value, pattern)


def println(*values: object) -> None:
    """Print values with spaces between them, and end the line.

    Parameters
    ----------
    *values
        Anything. With none, an empty line is printed.

    See Also
    --------
    printArray

    Notes
    -----
    Python's own `print()` does the same here.

    Examples
    --------
    >>> println("x:", 12)
    x: 12
    """
    print(*values)


def printArray(what: object) -> None:
    """Print the values of a list, each on its line with its number.

    Parameters
    ----------
    what : list
        The values. Anything else is printed as it is.

    See Also
    --------
    println

    Examples
    --------
    >>> printArray(["a", 2.5])
    [0] "a"
    [1] 2.5
    """
    if isinstance(what, str | Mapping) or not isinstance(what, Iterable):
        print(what)
        return
    for place, value in enumerate(what):
        print(f"[{place}]", f'"{value}"' if isinstance(value, str) else value)


def _matching(name: str, search: Callable[[str, str], T], value: str, pattern: str) -> T:
    try:
        return search(value, pattern)
    except re.error as error:
        problem = f"{name}() cannot read this pattern: {error.msg}."
        raise SketchError(problem, got=shown(pattern)) from None
    except TypeError:
        raise wrong_text(name, "a text and a pattern", value, pattern) from None
