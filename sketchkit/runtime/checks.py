"""What can be told of a sketch before it runs, from its text alone."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

from sketchkit.core.errors import SketchError
from sketchkit.runtime.source import Source

# Packages that sketchkit itself stands on: a file of the sketch with such a name hides them.
FOUNDATIONS = frozenset(
    {
        *("PIL", "click", "font_source_sans_pro", "glfw", "moderngl", "numpy", "pydyf", "rich"),
        *("sketchkit", "svgelements", "uharfbuzz"),
    }
)
# Python's modules that nothing else imports: a helper of such a name is what the sketch means.
RARE_MODULES = frozenset({"chunk", "sched", "this", "turtle", "wave"})
TAKEN_NAMES = (sys.stdlib_module_names | FOUNDATIONS) - RARE_MODULES
SMOOTHING = frozenset({"smooth", "noSmooth"})
SIZING = frozenset({"size", "fullScreen"})
DRAWING = frozenset(
    {
        *("arc", "background", "bezier", "box", "circle", "clear", "curve", "ellipse", "endShape"),
        *("image", "line", "point", "quad", "rect", "shape", "sphere", "square", "text"),
        "triangle",
    }
)


class EarlyError(SketchError):
    """A mistake that shows before the sketch runs.

    Attributes
    ----------
    path, line :
        Where it is.
    """

    def __init__(self, problem: str, hint: str, path: Path, line: int) -> None:
        super().__init__(problem, hint=hint)
        self.path = path
        self.line = line


def begins_without_smoothing(source: Source) -> bool:
    """Tell whether the sketch asks for hard edges at its beginning.

    Processing takes `noSmooth()` out of `setup()` and applies it before the canvas is made, so
    that nothing drawn is lost by it.
    """
    calls = [
        called for statement in _opening(source.tree) if (called := _called(statement)) in SMOOTHING
    ]
    return bool(calls) and calls[-1] == "noSmooth"


def refuse_hidden_modules(source: Source) -> None:
    """Raise an error if the sketch would import its own file instead of a standard module.

    Raises
    ------
    EarlyError
        If it would.
    """
    if source.python == 2:
        return  # there the sketch's own file comes first
    for name, line in _imported_names(source.tree):
        if name in TAKEN_NAMES and _has_module(source.path.parent, name):
            whose = "the installed" if name in FOUNDATIONS else "Python's own"
            raise EarlyError(
                f"Your file {name}.py hides {whose} module {name}.",
                f"Give your file another name, say my_{name}.py.",
                source.path,
                line,
            )


def refuse_drawing_before_size(source: Source) -> None:
    """Raise an error if something is drawn that `size()`, further down, would throw away.

    Raises
    ------
    EarlyError
        If so.
    """
    statements = _opening(source.tree)
    sizes = [place for place, node in enumerate(statements) if _called(node) in SIZING]
    for statement in statements[: sizes[0]] if sizes else []:
        for node in ast.walk(statement):
            if (name := _called(node)) in DRAWING:
                size = f"{_called(statements[sizes[0]])}()"
                raise EarlyError(
                    f"{name}() draws before {size}, which throws away what was drawn.",
                    f"Write {size} first.",
                    source.path,
                    getattr(node, "lineno", 0),
                )


def _opening(tree: ast.Module) -> list[ast.stmt]:
    """Return the lines of `setup()`; of a sketch without it, those outside of all functions."""
    functions = (ast.FunctionDef, ast.ClassDef)
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and node.name == "setup":
            return node.body
    return [node for node in tree.body if not isinstance(node, functions)]


def _called(node: ast.AST) -> str | None:
    """Return the name of the function that an expression calls."""
    match node:
        case ast.Expr(value=ast.Call(func=ast.Name(id=name))) | ast.Call(func=ast.Name(id=name)):
            return name
    return None


def _imported_names(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Yield the first part of the name of each module that is imported, and the line."""
    for node in ast.walk(tree):
        match node:
            case ast.Import(names=aliases):
                for alias in aliases:
                    yield alias.name.partition(".")[0], node.lineno
            case ast.ImportFrom(module=str(module), level=0):
                yield module.partition(".")[0], node.lineno


def _has_module(folder: Path, name: str) -> bool:
    return (folder / f"{name}.py").is_file() or (folder / name / "__init__.py").is_file()
