"""What Python 2 does otherwise than Python 3 as a program runs; `meaning.py` puts in the calls."""

from __future__ import annotations

import codecs
from collections.abc import Iterator
from typing import Any  # operands are whatever the sketch has

from sketchkit.pymode.classes import modernised
from sketchkit.pymode.formatting import filled, formatted, written
from sketchkit.pymode.ordering import greater, greater_or_equal, less, less_or_equal, sort

TEXT_CODECS = ("utf", "latin", "iso", "ascii", "cp1", "mbcs")


class Whole(int):
    """A divisor that divides whole numbers into whole numbers: for `x /= 2`."""

    def __rtruediv__(self, other: Any) -> Any:  # noqa: ANN401 # as below
        if isinstance(other, int):
            return other // int(self)
        return other / int(self)


def divide(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `a / b`: of whole numbers the whole number below it."""
    if isinstance(a, int) and isinstance(b, int):
        return a // b
    return a / b


def divisor(value: Any) -> Any:  # noqa: ANN401 # see the import
    """Return what stands to the right of `/=`, so that it divides as Python 2 does."""
    return Whole(value) if isinstance(value, int) else value


def keys(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.keys()`: of a dictionary a list."""
    return list(owner) if isinstance(owner, dict) else owner.keys()


def values(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.values()`: of a dictionary a list."""
    return list(owner.values()) if isinstance(owner, dict) else owner.values()


def items(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.items()`: of a dictionary a list."""
    return list(owner.items()) if isinstance(owner, dict) else owner.items()


def iterkeys(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.iterkeys()`."""
    return iter(owner) if isinstance(owner, dict) else owner.iterkeys()


def itervalues(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.itervalues()`."""
    return iter(owner.values()) if isinstance(owner, dict) else owner.itervalues()


def iteritems(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.iteritems()`."""
    return iter(owner.items()) if isinstance(owner, dict) else owner.iteritems()


def has_key(owner: Any, key: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.has_key(key)`."""
    return key in owner if isinstance(owner, dict) else owner.has_key(key)


def following(owner: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `owner.next()`: of a generator its next value."""
    return next(owner) if isinstance(owner, Iterator) else owner.next()


def decode(text: Any, *how: Any, **named: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `text.decode("utf-8")`: texts are all of one kind now."""
    if not isinstance(text, str):
        return text.decode(*how, **named)
    return text if _is_text_codec(how) else codecs.decode(text, *how)


def encode(text: Any, *how: Any, **named: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `text.encode("utf-8")`: texts are all of one kind now."""
    if not isinstance(text, str):
        return text.encode(*how, **named)
    if _is_text_codec(how):
        return text
    if how[0] in ("hex", "base64", "bz2", "zip"):
        return codecs.encode(text.encode(), *how).decode("latin-1")
    return codecs.encode(text, *how)


def _is_text_codec(how: tuple[Any, ...]) -> bool:
    return not how or str(how[0]).lower().startswith(TEXT_CODECS)


# By the names that a file calls them by. No name of its own can have a point in it.
OPERATIONS = {
    f"python2.{name}": function
    for name, function in {
        "divide": divide,
        "divisor": divisor,
        "keys": keys,
        "values": values,
        "items": items,
        "iterkeys": iterkeys,
        "itervalues": itervalues,
        "iteritems": iteritems,
        "has_key": has_key,
        "next": following,
        "sort": sort,
        "Lt": less,
        "LtE": less_or_equal,
        "Gt": greater,
        "GtE": greater_or_equal,
        "decode": decode,
        "encode": encode,
        "written": written,
        "filled": filled,
        "format": formatted,
        "modernised": modernised,
    }.items()
}
