"""Python 2's order: anything can be compared with anything, and lists are sorted by `cmp`."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from typing import Any  # whatever can be compared

Comparison = Callable[[Any, Any], int]


def compare(a: Any, b: Any) -> int:  # noqa: ANN401 # see the import
    """Return -1, 0 or 1, as one thing comes before, with or after another: Python 2's `cmp`."""
    if a is b or a == b:
        return 0
    try:
        return -1 if a < b else 1
    except TypeError:
        return -1 if _rank(a) < _rank(b) else 1


def less(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `a < b`; of things that Python 3 cannot compare, what Python 2 says."""
    try:
        return a < b
    except TypeError:
        return compare(a, b) < 0


def less_or_equal(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `a <= b`, likewise."""
    try:
        return a <= b
    except TypeError:
        return compare(a, b) <= 0


def greater(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `a > b`, likewise."""
    try:
        return a > b
    except TypeError:
        return compare(a, b) > 0


def greater_or_equal(a: Any, b: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `a >= b`, likewise."""
    try:
        return a >= b
    except TypeError:
        return compare(a, b) >= 0


def ordered(
    values: Iterable[Any],
    cmp: Comparison | None = None,
    key: Callable[[Any], Any] | None = None,
    reverse: bool = False,
) -> list[Any]:
    """Return the values in order: Python 2's `sorted`."""
    items = list(values)
    sort(items, cmp, key, reverse)
    return items


def sort(
    values: Any,  # noqa: ANN401 # a list, or whatever has a sort() of its own
    cmp: Comparison | None = None,
    key: Callable[[Any], Any] | None = None,
    reverse: bool = False,
    **options: Any,  # noqa: ANN401 # of that sort()
) -> Any:  # noqa: ANN401 # what that sort() returns
    """Sort a list in its place: Python 2's `list.sort`."""
    if not isinstance(values, list):
        return _own_sort(values, cmp, key, reverse, options)
    if cmp is None:
        before = list(values)
        try:
            return values.sort(key=key, reverse=bool(reverse))
        except TypeError:
            values[:] = before
    by_comparison = functools.cmp_to_key(cmp or compare)
    rank = by_comparison if key is None else (lambda value: by_comparison(key(value)))
    values.sort(key=rank, reverse=bool(reverse))
    return None


def _own_sort(
    values: Any,  # noqa: ANN401 # see sort
    cmp: Any,  # noqa: ANN401
    key: Any,  # noqa: ANN401
    reverse: bool,
    options: dict[str, Any],
) -> Any:  # noqa: ANN401
    given = [] if cmp is None else [cmp]
    named = options | ({} if key is None else {"key": key})
    return values.sort(*given, **named, **({"reverse": reverse} if reverse else {}))


def _rank(value: object) -> tuple[int, str, int]:
    """Return where a thing stands among those of other kinds: None, numbers, then by kind."""
    if value is None:
        return 0, "", 0
    if isinstance(value, int | float):
        return 1, "", 0
    return 2, type(value).__name__, id(value)
