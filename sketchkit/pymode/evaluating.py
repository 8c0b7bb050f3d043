"""Python 2 in texts and files that a sketch runs itself: `exec`, `eval`, `execfile`."""

from __future__ import annotations

import ast
import builtins
import sys
from pathlib import Path
from types import CodeType, FrameType
from typing import Any  # whatever the sketch runs

from sketchkit.pymode.meaning import python_3
from sketchkit.pymode.reading import text_of
from sketchkit.pymode.syntax import convert

Names = dict[str, Any]


def execute(code: Any, names: Names | None = None, local_names: Any = None) -> None:  # noqa: ANN401 # see the import
    """Run a text: Python 2's `exec`.

    In a function, what the text binds is put among the names of the module: Python 3 has no other
    place for it, and there the function finds it.
    """
    caller = sys._getframe(1)
    compiled = _statements(code, "<text>") if isinstance(code, str) else code
    if names is not None:
        builtins.exec(compiled, _with_builtins(names, caller), local_names)
    elif caller.f_locals is caller.f_globals:
        builtins.exec(compiled, caller.f_globals)
    else:
        bound = _Bound(dict(caller.f_locals))
        builtins.exec(compiled, caller.f_globals, bound)
        caller.f_globals.update((name, bound[name]) for name in bound.own)


def evaluate(code: Any, names: Names | None = None, local_names: Any = None) -> Any:  # noqa: ANN401 # see the import
    """Return what a text stands for: Python 2's `eval`."""
    caller = sys._getframe(1)
    compiled = _expression(code) if isinstance(code, str) else code
    if names is not None:
        return builtins.eval(compiled, _with_builtins(names, caller), local_names)
    return builtins.eval(compiled, caller.f_globals, dict(caller.f_locals))


def execute_file(name: str, names: Names | None = None) -> None:
    """Run a file: Python 2's `execfile`."""
    caller = sys._getframe(1)
    compiled = _statements(text_of(Path(name).read_bytes()), name)
    builtins.exec(compiled, caller.f_globals if names is None else _with_builtins(names, caller))


class _Bound(dict[str, Any]):
    """Names of a function, and which of them a text has bound anew."""

    def __init__(self, names: Names) -> None:
        super().__init__(names)
        self.own: set[str] = set()

    def __setitem__(self, name: str, value: object) -> None:
        super().__setitem__(name, value)
        self.own.add(name)

    def __delitem__(self, name: str) -> None:
        super().__delitem__(name)
        self.own.discard(name)


def _with_builtins(names: Names, caller: FrameType) -> Names:
    """Let what runs among these names see what the caller sees behind its own."""
    names.setdefault("__builtins__", caller.f_builtins)
    return names


def _statements(text: str, filename: str) -> CodeType:
    tree = python_3(convert(text, filename).tree(filename))
    return compile(tree, filename, "exec", dont_inherit=True)


def _expression(text: str) -> CodeType:
    tree = python_3(convert(text.strip(), "<text>").tree("<text>"))
    match tree.body:
        case [ast.Expr(value=value)]:
            return compile(ast.Expression(value), "<text>", "eval", dont_inherit=True)
    return compile(text.strip(), "<text>", "eval", dont_inherit=True)  # so that Python objects
