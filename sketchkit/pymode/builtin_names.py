"""Python 2's own functions, as far as Python 3 has none of the name or another one."""

from __future__ import annotations

import ast
import builtins
import functools
import importlib
import itertools
import math
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from numbers import Number
from types import ModuleType
from typing import Any  # whatever the sketch calls them with

from sketchkit.pymode.evaluating import evaluate, execute, execute_file
from sketchkit.pymode.formatting import written
from sketchkit.pymode.operations import OPERATIONS
from sketchkit.pymode.ordering import compare, ordered

Function = Callable[..., Any]
# Python Mode's own beginnings are run among the sketch's names, and leave these behind.
_MODULES = (ast, importlib, os, re, sys)
LEFT_OVER = {module.__name__: module for module in _MODULES} | {"Number": Number}
FLOATING = ("lerp", "norm", "pow", "sq")  # in Java floats, also of whole numbers


def builtin_names(names: Mapping[str, object]) -> dict[str, object]:
    """Return Python 2's functions by name.

    Parameters
    ----------
    names : mapping
        What a sketch sees in Python 3: some of the functions are Processing's as well.
    """
    own = {
        "apply": lambda function, args=(), named=None: function(*args, **(named or {})),
        "basestring": str,
        "cmp": compare,
        "eval": evaluate,
        "exec": execute,
        "execfile": execute_file,
        "file": names.get("open", builtins.open),
        "filter": _filter(names.get("filter", builtins.filter)),
        "intern": sys.intern,
        "long": int,
        "map": _map(names.get("map", builtins.map)),
        "open": _open(names.get("open", builtins.open)),
        "print": _print,
        "range": _range,
        "raw_input": builtins.input,
        "reduce": functools.reduce,
        "reload": _reload,
        "round": _round,
        "sorted": ordered,
        "unichr": builtins.chr,
        "unicode": str,
        "xrange": _xrange,
        "zip": _zip,
    }
    floats = {name: _floating(names[name]) for name in FLOATING if name in names}
    return own | floats | OPERATIONS | LEFT_OVER


def _range(*bounds: Any) -> list[int]:  # noqa: ANN401 # see the import
    return list(_xrange(*bounds))


def _xrange(*bounds: Any) -> range:  # noqa: ANN401 # see the import
    try:
        return builtins.range(*bounds)
    except TypeError:
        return builtins.range(*(int(bound) for bound in bounds))


def _zip(*rows: Iterable[Any]) -> list[tuple[Any, ...]]:
    return list(builtins.zip(*rows, strict=False))


def _map(processing: Any) -> Function:  # noqa: ANN401 # Processing's map(), or Python's
    def map(function: Any, *rows: Any) -> Any:  # noqa: ANN401 # see the import
        if len(rows) == 4 and isinstance(function, int | float) and not isinstance(rows[0], list):
            return processing(function, *rows)
        if len(rows) == 1:
            return list(rows[0]) if function is None else [function(item) for item in rows[0]]
        together = list(itertools.zip_longest(*rows))
        return together if function is None else [function(*row) for row in together]

    return map


def _filter(processing: Any) -> Function:  # noqa: ANN401 # Processing's filter(), or Python's
    def filter(*args: Any) -> Any:  # noqa: ANN401 # see the import
        if len(args) != 2 or not (args[0] is None or callable(args[0])):
            return processing(*args)
        kept = list(builtins.filter(*args))
        if isinstance(args[1], str):
            return "".join(kept)
        return tuple(kept) if isinstance(args[1], tuple) else kept

    return filter


def _floating(function: Any) -> Function:  # noqa: ANN401 # one of Processing's
    @functools.wraps(function)
    def answer(*args: Any) -> Any:  # noqa: ANN401 # see the import
        result = function(*args)
        return float(result) if isinstance(result, int) else result

    return answer


def _round(number: float, digits: int = 0) -> float:
    """Return the nearest number with so many digits; halves go away from zero."""
    scale = 10.0**digits
    scaled = abs(number) * scale
    if not math.isfinite(scaled):
        return float(number)
    return math.copysign(math.floor(scaled + 0.5) / scale, number)


def _print(*values: Any, **options: Any) -> None:  # noqa: ANN401 # see the import
    builtins.print(*(written(value) for value in values), **options)


def _open(find: Any) -> Function:  # noqa: ANN401 # an open() that finds the sketch's files
    def open(name: Any, mode: str = "r", *args: Any, **named: Any) -> Any:  # noqa: ANN401 # see the import
        mode = mode.replace("U", "") or "r"
        if "b" in mode or args:
            return find(name, mode if mode != "b" else "rb", *args, **named)
        return find(name, mode, **{"encoding": "utf-8", "errors": "surrogateescape"} | named)

    return open


def _reload(module: ModuleType) -> ModuleType:
    return module if module.__name__ == "sys" else importlib.reload(module)
