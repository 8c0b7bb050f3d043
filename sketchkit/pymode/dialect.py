"""Which Python a .py file is in: many sketches of Python Mode are published as .py files.

Only what cannot be Python 3, in more places than one, and is Python 2 as it stands, counts as
Python 2. A single `print x` is a slip of somebody who writes Python 3, and so are several if
anything is newer than Python 2: the mistake is told then, and no division cuts off fractions.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from sketchkit.core.errors import SketchError
from sketchkit.pymode.reading import text_of
from sketchkit.pymode.syntax import change, convert, parse, refactoring

# What is written otherwise in Python 3, and is no mere slip of somebody who writes Python 3.
SIGNS = ("except", "exec", "ne", "print", "raise", "repr", "throw", "tuple_params")
# A quick look for any of them, which may find too much: the library takes its time.
LOOKS_OLD = re.compile(
    r"\b(?:print|exec)\b\s*[^\s(=.,:)\]]|\b(?:except|raise|throw)\b.*,|<>|`|(?:def|lambda)\b.*\(.*:"
)
MOST_SLIPS = 1  # places
NEWER = (
    *(ast.AnnAssign, ast.AsyncFunctionDef, ast.JoinedStr, ast.Match, ast.MatMult, ast.NamedExpr),
    *(ast.Nonlocal, ast.YieldFrom),
)


class Sign(NamedTuple):
    """Where Python 3 cannot read what is Python 2.

    Attributes
    ----------
    path : Path
        The file.
    line : int
        The first line of it that is no Python 3.
    """

    path: Path
    line: int


def sign_of_python_2(path: Path) -> Sign | None:
    """Return what shows that a sketch is written in Python 2, or None if nothing does.

    Parameters
    ----------
    path : Path
        Its file; the modules beside it that it imports are looked at as well.

    Raises
    ------
    OSError
        If the file cannot be read.
    """
    waiting, seen = [path], {path}
    while waiting:
        file = waiting.pop()
        data = file.read_bytes()
        tree = _python_3(data)
        if tree is None:
            line = _line_of_python_2(data)
            return None if line is None else Sign(file, line)
        modules = {path.parent / f"{name}.py" for name in _imported(tree)}
        waiting += sorted(module for module in modules - seen if module.is_file())
        seen |= modules
    return None


def _python_3(data: bytes) -> ast.Module | None:
    try:
        return ast.parse(data)
    except (SyntaxError, ValueError):  # a ValueError of what has null bytes in it
        return None


def _line_of_python_2(data: bytes) -> int | None:
    """Return the first line of a text that is Python 2 and no Python 3; None of another text."""
    try:
        text = text_of(data)
        ast.parse(text)
    except ValueError:
        return None
    except SyntaxError as error:
        return error.lineno or 1 if _is_python_2(text) else None
    return None  # only the tabs were wrong


def _is_python_2(text: str) -> bool:
    if not LOOKS_OLD.search(text):
        return False
    try:
        tree = parse(text)
    except SketchError:  # what converts is not installed
        return False
    if tree is None:
        return False
    before = str(tree).splitlines()
    after = str(change(tree, refactoring(SIGNS))).splitlines()
    if sum(old != new for old, new in zip(before, after, strict=False)) <= MOST_SLIPS:
        return False
    try:
        converted = convert(text, "").tree("")
    except SyntaxError:
        return False
    return not any(_is_newer(node) for node in ast.walk(converted))


def _is_newer(node: ast.AST) -> bool:
    """Tell whether it is something that Python 2 does not have."""
    match node:
        case ast.arg(annotation=ast.expr()) | ast.FunctionDef(returns=ast.expr()):
            return True
    return isinstance(node, NEWER)


def _imported(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        match node:
            case ast.Import(names=names):
                yield from (alias.name for alias in names)
            case ast.ImportFrom(module=str(module), level=0 | 1):
                yield module
