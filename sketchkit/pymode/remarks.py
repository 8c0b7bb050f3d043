"""What a ported sketch may do otherwise than the old one, and what to look at in it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

FUNCTIONS = {
    "add_library": "Libraries of Processing are Java: see whether this one is here.",
    "round": "round() gives a whole number here. In Python 2 it gave a float: 3.0.",
    "cmp": "Python 3 has no cmp(): write (a > b) - (a < b).",
    "execfile": "Python 3 has no execfile(): import the file.",
}
METHODS = {
    "encode": "encode() gives bytes in Python 3, and no text. Perhaps it can be left out.",
    "decode": "In Python 3 only bytes have decode(). Perhaps it can be left out.",
}
SPECIAL_METHODS = {
    "__cmp__": "Python 3 does not call __cmp__(): write __eq__() and __lt__().",
    "__getslice__": "Python 3 does not call __getslice__(): __getitem__() gets a slice.",
    "__coerce__": "Python 3 does not call __coerce__().",
}
JAVA = ("java", "javax", "processing", "org", "com")


def remarks(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Yield line and text of each remark on a file."""
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id="round")) if _is_used_whole(tree, node):
                continue
            case ast.Call():
                yield from _of_call(node)
            case ast.FunctionDef(name=name) if name in SPECIAL_METHODS:
                yield node.lineno, SPECIAL_METHODS[name]
            case ast.Import(names=aliases):
                for alias in aliases:
                    yield from _of_import(alias.name, node.lineno)
            case ast.ImportFrom(module=str(module), level=0):
                yield from _of_import(module, node.lineno)


def _of_import(module: str, line: int) -> Iterator[tuple[int, str]]:
    if module.partition(".")[0] in JAVA:
        yield line, f"{module} is Java, and not available. Processing's own names need no import."


def _of_call(call: ast.Call) -> Iterator[tuple[int, str]]:
    match call.func:
        case ast.Name(id=name) if name in FUNCTIONS:
            yield call.lineno, FUNCTIONS[name]
        case ast.Attribute(attr=name) if name in METHODS:
            yield call.lineno, METHODS[name]
    if any(keyword.arg == "cmp" for keyword in call.keywords):
        yield (
            call.lineno,
            "Python 3 sorts by no cmp=: write key=functools.cmp_to_key(...), and import functools.",
        )


def _is_used_whole(tree: ast.Module, call: ast.Call) -> bool:
    """Tell whether a number is made whole at once, as in `int(round(x))`."""
    return any(
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "int"
        and call in node.args
        for node in ast.walk(tree)
    )
