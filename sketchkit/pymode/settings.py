"""`size()` and its like, which Python Mode takes out of `setup()` and runs before all else."""

from __future__ import annotations

import ast

FIRST = frozenset({"size", "fullScreen", "smooth", "noSmooth", "pixelDensity"})
SIZING = frozenset({"size", "fullScreen"})


def with_settings_first(tree: ast.Module) -> ast.Module:
    """Move them to the beginning of `setup()`; of a sketch without functions, to its beginning.

    A call that needs a variable from a line above it stays where it is.
    """
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    setup = next((node for node in functions if node.name == "setup"), None)
    if setup is not None:
        setup.body = _reordered(setup.body)
    elif not any(node.name in ("draw", "settings") for node in functions):
        tree.body = _reordered(tree.body)
    return tree


def _reordered(body: list[ast.stmt]) -> list[ast.stmt]:
    moved: list[ast.stmt] = []
    bound: set[str] = set()
    for statement in body:
        is_first = _called(statement) in FIRST
        if is_first and not bound & {n.id for n in ast.walk(statement) if isinstance(n, ast.Name)}:
            moved.append(statement)
        bound |= _bound_in(statement)
    moved.sort(key=lambda statement: _called(statement) not in SIZING)
    rest = [statement for statement in body if statement not in moved]
    place = _end_of_head(rest)
    return [*rest[:place], *moved, *rest[place:]]


def _called(statement: ast.stmt) -> str | None:
    match statement:
        case ast.Expr(value=ast.Call(func=ast.Name(id=name))):
            return name
    return None


def _bound_in(statement: ast.stmt) -> set[str]:
    names = set()
    for node in ast.walk(statement):
        match node:
            case ast.Name(id=name, ctx=ast.Store()) | ast.FunctionDef(name=name):
                names.add(name)
            case ast.ClassDef(name=name) | ast.alias(asname=str(name)) | ast.alias(name=name):
                names.add(name)
    return names


def _end_of_head(body: list[ast.stmt]) -> int:
    """Return how many statements must stay in front: a docstring, imports from the future."""
    for place, statement in enumerate(body):
        match statement:
            case ast.ImportFrom(module="__future__") | ast.Global():
                continue
            case ast.Expr(value=ast.Constant(value=str())) if place == 0:
                continue
        return place
    return len(body)
