"""Classes of Python 2, whose methods have other names: `__div__`, `__nonzero__`, `next`, ..."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar  # Any: operands are whatever the sketch has

Kind = TypeVar("Kind", bound=type[Any])

RENAMED = {
    "__div__": "__truediv__",
    "__rdiv__": "__rtruediv__",
    "__idiv__": "__itruediv__",
    "__nonzero__": "__bool__",
    "__unicode__": "__str__",
    "next": "__next__",
}
COMPARISONS: dict[str, Callable[[int], bool]] = {
    "__eq__": lambda order: order == 0,
    "__ne__": lambda order: order != 0,
    "__lt__": lambda order: order < 0,
    "__le__": lambda order: order <= 0,
    "__gt__": lambda order: order > 0,
    "__ge__": lambda order: order >= 0,
}
SPECIAL = frozenset({*RENAMED, "__cmp__", "__eq__", "__getslice__"})


def modernised(kind: Kind) -> Kind:
    """Give a class the methods that Python 3 looks for, and return it."""
    own: dict[str, Any] = dict(vars(kind))
    for old, new in RENAMED.items():
        if old in own and new not in own:
            setattr(kind, new, own[old])
    if "__cmp__" in own:
        for name, holds in COMPARISONS.items():
            if name not in own:
                setattr(kind, name, _comparison(own["__cmp__"], holds))
    if "__getslice__" in own and "__getitem__" in own:
        setattr(kind, "__getitem__", _with_slices(own["__getitem__"], own["__getslice__"]))  # noqa: B010 # a checker forbids the other way
    if own.get("__hash__") is None and "__eq__" in own:  # Python 3 has taken it away
        setattr(kind, "__hash__", _inherited_hash(kind))  # noqa: B010 # as above
    return kind


def _comparison(cmp: Callable[[Any, Any], int], holds: Callable[[int], bool]) -> Any:  # noqa: ANN401 # a method
    @functools.wraps(cmp)
    def compared(self: Any, other: Any) -> bool:  # noqa: ANN401 # see the import
        return holds(cmp(self, other))

    return compared


def _with_slices(getitem: Callable[..., Any], getslice: Callable[..., Any]) -> Any:  # noqa: ANN401 # a method
    @functools.wraps(getitem)
    def taken(self: Any, place: Any) -> Any:  # noqa: ANN401 # see the import
        if isinstance(place, slice) and place.step is None:
            return getslice(self, *place.indices(len(self))[:2])
        return getitem(self, place)

    return taken


def _inherited_hash(kind: type) -> Any:  # noqa: ANN401 # a method
    hashes = (vars(base).get("__hash__") for base in kind.__mro__[1:])
    return next((hash_ for hash_ in hashes if hash_ is not None), object.__hash__)
