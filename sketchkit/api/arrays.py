"""Processing's functions on arrays, for lists, tuples, texts, bytes and NumPy's arrays.

All but `arrayCopy()` leave what they are given as it is, and return another of the same kind.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar, cast

import numpy as np

from sketchkit.api.data.faults import PlaceError, whole
from sketchkit.api.data.lists.value_list import ValueList
from sketchkit.core.errors import SketchError, kind_of, shown

S = TypeVar("S", bound="Sequence[Any] | np.ndarray[Any, Any]")  # values of any kind

__all__ = [
    "append",
    "arrayCopy",
    "concat",
    "expand",
    "reverse",
    "shorten",
    "sort",
    "splice",
    "subset",
]


def append(array: S, value: object) -> S:
    """Return a list with one more value at its end.

    Parameters
    ----------
    array : list
        The list. It stays as it is.
    value
        What is added.

    See Also
    --------
    concat, shorten, expand

    Examples
    --------
    >>> append([1, 2], 3)
    [1, 2, 3]
    """
    return _like(array, [*_values("append", array), value])


def concat(a: S, b: Sequence[object]) -> S:
    """Return the values of two lists, one behind the other.

    Parameters
    ----------
    a, b : list
        The lists. They stay as they are.

    See Also
    --------
    append, splice

    Examples
    --------
    >>> concat([1, 2], [3, 4])
    [1, 2, 3, 4]
    """
    return _like(a, [*_values("concat", a), *_values("concat", b)])


def reverse(list: S) -> S:
    """Return a list the other way around.

    Parameters
    ----------
    list : list
        The list. It stays as it is.

    See Also
    --------
    sort

    Examples
    --------
    >>> reverse([1, 2, 3])
    [3, 2, 1]
    """
    return _like(list, _values("reverse", list)[::-1])


def shorten(list: S) -> S:
    """Return a list without its last value.

    Parameters
    ----------
    list : list
        The list. It stays as it is.

    See Also
    --------
    append, expand

    Examples
    --------
    >>> shorten([1, 2, 3])
    [1, 2]
    """
    values = _values("shorten", list)
    if not values:
        raise PlaceError("shorten() takes a list with at least one value.", got="shorten([])")
    return _like(list, values[:-1])


def expand(list: S, newSize: int | None = None) -> S:
    """Return a list with places for more values.

    Parameters
    ----------
    list : list
        The list. It stays as it is.
    newSize : int, optional
        How many places there are then; twice as many if it is left out.

    See Also
    --------
    append, shorten

    Notes
    -----
    New places hold 0 behind numbers, False behind truth values, and else None.

    Examples
    --------
    >>> expand([1, 2], 4)
    [1, 2, 0, 0]
    """
    values = _values("expand", list)
    size = max(2 * len(values), 1) if newSize is None else whole("expand", newSize)
    if size < 0:
        raise PlaceError("expand() takes a size that is not negative.", got=f"{size}")
    return _like(list, [*values[:size], *[_blank(values)] * (size - len(values))])


def subset(list: S, start: int, count: int | None = None) -> S:
    """Return a part of a list.

    Parameters
    ----------
    list : list
        The list. It stays as it is.
    start : int
        Where the part begins, counted from 0.
    count : int, optional
        How many values it has; all that follow if it is left out.

    See Also
    --------
    splice, shorten

    Examples
    --------
    >>> subset([10, 20, 30, 40], 1, 2)
    [20, 30]
    """
    values = _values("subset", list)
    first = whole("subset", start)
    end = len(values) if count is None else first + whole("subset", count)
    _check_range("subset", first, end, len(values))
    return _like(list, values[first:end])


def splice(list: S, value: object, index: int) -> S:
    """Return a list with a value, or the values of another list, put in.

    Parameters
    ----------
    list : list
        The list. It stays as it is.
    value : value or list
        What is put in.
    index : int
        Where, counted from 0.

    See Also
    --------
    append, concat, subset

    Examples
    --------
    >>> splice([1, 4], [2, 3], 1)
    [1, 2, 3, 4]
    """
    values = _values("splice", list)
    place = whole("splice", index)
    _check_range("splice", place, place, len(values))
    is_many = isinstance(value, np.ndarray | ValueList | tuple) or type(value) is type(values)
    new = _values("splice", value) if is_many else [value]
    return _like(list, [*values[:place], *new, *values[place:]])


def sort(list: S, count: int | None = None) -> S:
    """Return a list in order: numbers with the smallest first, text by the alphabet.

    Parameters
    ----------
    list : list
        The list. It stays as it is.
    count : int, optional
        How many values, from the first on, are put in order; all if it is left out.

    See Also
    --------
    reverse

    Notes
    -----
    Capital letters come before small ones. What is no number (NaN) comes last.

    Examples
    --------
    >>> sort([3, 1, 2])
    [1, 2, 3]
    >>> sort(["deer", "elephant", "bear"])
    ['bear', 'deer', 'elephant']
    """
    values = _values("sort", list)
    end = len(values) if count is None else whole("sort", count)
    _check_range("sort", 0, end, len(values))
    try:
        ordered = sorted(values[:end], key=lambda value: (value != value, value))
    except TypeError:
        raise SketchError(
            "sort() takes numbers alone, or text alone.", got=f"sort({shown(list)})"
        ) from None
    return _like(list, ordered + values[end:])


def arrayCopy(src: Sequence[object], *places: Any) -> None:  # noqa: ANN401 numbers and a list
    """Copy values from one list into another, which is changed.

    Parameters
    ----------
    src : list
        Where they come from.
    *places
        Either the list that they go to, and how many; or the place of the first one, the list
        that they go to, the place of the first one there, and how many.

    See Also
    --------
    concat

    Examples
    --------
    >>> new = [0, 0, 0, 0]
    >>> arrayCopy([1, 2, 3], new)
    >>> new
    [1, 2, 3, 0]
    >>> arrayCopy([7, 8, 9], 1, new, 2, 2)
    >>> new
    [1, 2, 8, 9]
    """
    values = _values("arrayCopy", src)
    match places:
        case (target,):
            start, first, count = 0, 0, len(values)
        case (target, length):
            start, first, count = 0, 0, whole("arrayCopy", length)
        case (begin, target, end, length):
            start, first = whole("arrayCopy", begin), whole("arrayCopy", end)
            count = whole("arrayCopy", length)
        case _:
            raise SketchError(
                "arrayCopy() takes two lists [and how many values], or"
                " from, place in it, to, place in it, how many.",
                got=f"{1 + len(places)} values",
            )
    if not isinstance(target, list | bytearray | np.ndarray | ValueList):
        raise SketchError(
            "arrayCopy() takes a list that it can change.",
            got=f"{kind_of(target)}: {shown(target)}",
        )
    _check_range("arrayCopy", start, start + count, len(values))
    _check_range("arrayCopy", first, first + count, len(target))
    for place, value in enumerate(values[start : start + count], first):
        target[place] = value


def _values(name: str, array: object) -> list[Any]:
    """Return the values of a list, or of what is like one."""
    if isinstance(array, np.ndarray | ValueList | Sequence):
        return [*array]
    raise SketchError(f"{name}() takes a list.", got=f"{kind_of(array)}: {shown(array)}")


def _like(array: S, values: list[Any]) -> S:
    """Return values in what is of the same kind as `array`."""
    result: object = values
    match array:
        case np.ndarray():
            result = np.asarray(values, dtype=array.dtype if _fits(array, values) else None)
        case str():
            result = "".join(map(str, values))
        case tuple():
            result = tuple(values)
        case bytes() | bytearray():
            result = type(array)(value & 0xFF for value in values)
        case ValueList():
            result = type(array)(values)
    return cast("S", result)


def _fits(array: np.ndarray[Any, Any], values: list[Any]) -> bool:
    return np.can_cast(np.asarray(values).dtype, array.dtype, "same_kind")


def _blank(values: list[Any]) -> object:
    if values and isinstance(values[0], bool | np.bool_):
        return False
    if values and isinstance(values[0], int | float | np.number):
        return type(values[0])(0)
    return None


def _check_range(name: str, first: int, end: int, count: int) -> None:
    if not 0 <= first <= end <= count:
        raise PlaceError(
            f"{name}() reaches beyond the list, which has {count} values.",
            got=f"the places from {first} to {end}",
        )
