"""Reading a sketch's text: what it calls and what it defines, by its syntax tree.

It runs behind the wall, since a text can be made so that even parsing it brings Python down.
"""

from __future__ import annotations

import ast
import warnings
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from sketchkit.core.errors import SketchError
from sketchkit.grading.evidence import SourceFacts
from sketchkit.pymode.dialect import sign_of_python_2
from sketchkit.pymode.reading import text_of
from sketchkit.pymode.syntax import convert

MOST_BYTES = 2 << 20  # of one file
ENDINGS = (".py", ".pyde")
STATEMENTS: dict[type[ast.AST], str] = {
    ast.For: "for",
    ast.While: "while",
    ast.If: "if",
    ast.With: "with",
    ast.Try: "try",
    ast.Lambda: "lambda",
    ast.Global: "global",
    ast.Match: "match",
    ast.ListComp: "list comprehension",
    ast.DictComp: "dict comprehension",
    ast.SetComp: "set comprehension",
    ast.GeneratorExp: "generator expression",
    ast.Yield: "yield",
    ast.Return: "return",
    ast.JoinedStr: "f-string",
}


def read_sources(folder: Path) -> SourceFacts:
    """Return what all Python files of a folder show; one that is no Python shows nothing.

    Where one is a sketch of Processing's Python Mode, or can only be Python 2, all may be in it.
    """
    facts = _Facts()
    files = [path for path in sorted(folder.rglob("*")) if _is_source(path)]
    is_python_mode = any(_is_python_2(path) for path in files)
    for path in files:
        facts.read(path.read_bytes(), is_python_mode=is_python_mode)
    return facts.result()


def _is_source(path: Path) -> bool:
    is_named = path.suffix.lower() in ENDINGS
    return is_named and path.is_file() and path.stat().st_size <= MOST_BYTES


def _is_python_2(path: Path) -> bool:
    try:
        return path.suffix.lower() == ".pyde" or sign_of_python_2(path) is not None
    except (RecursionError, MemoryError):
        return False


def _parsed(data: bytes, *, is_python_mode: bool) -> ast.AST:
    try:
        return ast.parse(data)
    except SyntaxError:
        if not is_python_mode:
            raise
        return ast.parse(convert(text_of(data), "sketch").text)


class _Facts:
    def __init__(self) -> None:
        self.calls: Counter[str] = Counter()
        self.statements: Counter[str] = Counter()
        self.functions: set[str] = set()
        self.classes: set[str] = set()
        self.names: set[str] = set()

    def read(self, data: bytes, *, is_python_mode: bool) -> None:
        """Add what one file shows."""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                tree = _parsed(data, is_python_mode=is_python_mode)
            self._take(tree)
        except (SyntaxError, SketchError, ValueError, RecursionError, MemoryError):
            return

    def result(self) -> SourceFacts:
        """Return all of it."""
        return SourceFacts(
            dict(sorted(self.calls.items())),
            tuple(sorted(self.functions)),
            tuple(sorted(self.classes)),
            tuple(sorted(self.names)),
            dict(sorted(self.statements.items())),
        )

    def _take(self, tree: ast.AST) -> None:
        for name in _definitions(tree, ""):
            (self.classes if name.startswith("class ") else self.functions).add(
                name.removeprefix("class ")
            )
        for node in ast.walk(tree):
            if (word := STATEMENTS.get(type(node))) is not None:
                self.statements[word] += 1
            match node:
                case ast.Call(func=function) if names := _called(function):
                    self.calls.update(names)
                case ast.Name(id=name) | ast.Attribute(attr=name):
                    self.names.add(name)
                case ast.Import(names=aliases):
                    self.statements.update(f"import {alias.name}" for alias in aliases)
                case ast.ImportFrom(module=str(module)):
                    self.statements[f"import {module}"] += 1


def _called(function: ast.expr) -> set[str]:
    """Return the names that a call goes by: `pg.rect(...)` is one of `rect` and of `pg.rect`."""
    match function:
        case ast.Name(id=name):
            return {name}
        case ast.Attribute(value=ast.Name(id=owner), attr=name):
            return {name, f"{owner}.{name}"}
        case ast.Attribute(attr=name):
            return {name}
    return set()


def _definitions(tree: ast.AST, owner: str) -> Iterator[str]:
    """Yield functions by name, methods as `Ball.update`, classes as `class Ball`."""
    for node in ast.iter_child_nodes(tree):
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name):
                yield f"{owner}{name}"
                yield from _definitions(node, owner)
            case ast.ClassDef(name=name):
                yield f"class {name}"
                yield from _definitions(node, f"{name}.")
            case _:
                yield from _definitions(node, owner)
