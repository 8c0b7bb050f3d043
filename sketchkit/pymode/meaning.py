"""A syntax tree that means in Python 3 what its file means in Python 2.

Where the two differ, and only there, a call of one of `OPERATIONS` is put in, at the same line.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from typing import TypeVar

from sketchkit.pymode.classes import SPECIAL

Node = TypeVar("Node", bound=ast.AST)

# Methods that answer otherwise, and with how many arguments.
METHODS: dict[str, range] = {
    **dict.fromkeys(("keys", "values", "items", "iterkeys", "itervalues", "iteritems"), range(1)),
    "has_key": range(1, 2),
    "next": range(1),
    "sort": range(4),
    "decode": range(3),
    "encode": range(3),
    "format": range(256),
}
# What every sketch has, and what is no number only if it says so itself.
NUMBERS = frozenset({"width", "height", "mouseX", "mouseY", "pmouseX", "pmouseY", "frameCount"})
WRITERS = ("str", "unicode")
SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)


def python_3(tree: ast.Module) -> ast.Module:
    """Change a tree so that Python 3 runs it as Python 2 would, and return it.

    Parameters
    ----------
    tree : ast.Module
        In the syntax of Python 3.
    """
    has_true_division = "division" in _futures(tree)
    meant = _Meaning(tree, has_true_division).visit_Module(tree)
    return ast.fix_missing_locations(meant)


class _Meaning(ast.NodeTransformer):
    def __init__(self, tree: ast.Module, has_true_division: bool) -> None:
        self._has_true_division = has_true_division
        bound = set(_bound_names(tree))
        self._writers = frozenset(name for name in WRITERS if name not in bound)

    def visit_Module(self, node: ast.Module) -> ast.Module:
        node.body = list(_without_globals(node.body))
        self.generic_visit(node)
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """Put `global` first: Python 2 lets it come after the first use."""
        if len(names := _names_of_globals(node.body)) > 0:
            place = 1 if ast.get_docstring(node) is not None else 0
            first = ast.copy_location(ast.Global(list(names)), node.body[0])
            body = list(_without_globals(node.body))
            node.body = [*body[:place], first, *body[place:]]
        self.generic_visit(node)
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        bound = {name for statement in node.body for name in _bound_by(statement)}
        self.generic_visit(node)
        if bound & SPECIAL:
            decorator = ast.Name("python2.modernised", ast.Load())
            node.decorator_list.append(ast.copy_location(decorator, node))
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        if isinstance(node.op, ast.Mod) and _may_be_filled_in(node.left, node.right):
            return _call("filled", [node.left, node.right], node)
        if self._has_true_division or not isinstance(node.op, ast.Div):
            return node
        match node.left, node.right:
            case ast.Constant(value=int(a)), ast.Constant(value=int(b)) if b:
                return ast.copy_location(ast.Constant(a // b), node)
        if _is_evidently_float(node.left) or _is_evidently_float(node.right):
            return node
        return _call("divide", [node.left, node.right], node)

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AugAssign:
        self.generic_visit(node)
        is_division = isinstance(node.op, ast.Div) and not self._has_true_division
        if is_division and not _is_evidently_float(node.value):
            node.value = _call("divisor", [node.value], node.value)
        return node

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        """Let things of different kinds be compared: a list with a number, say."""
        self.generic_visit(node)
        match node.ops, node.comparators:
            case [ast.Lt() | ast.LtE() | ast.Gt() | ast.GtE() as sign], [right]:
                if not (_is_evidently_number(node.left) and _is_evidently_number(right)):
                    return _call(type(sign).__name__, [node.left, right], node)
        return node

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        match node.func:
            case ast.Attribute(value=owner, attr=name) if name in METHODS:
                count = len(node.args) + len(node.keywords)
                if count in METHODS[name]:
                    return _call(name, [owner, *node.args], node, node.keywords)
            case ast.Name(id=name) if name in self._writers and node.args and not node.keywords:
                return _call("written", node.args, node)
        return node


def _call(
    name: str, arguments: list[ast.expr], node: ast.expr, named: list[ast.keyword] | None = None
) -> ast.Call:
    function = ast.copy_location(ast.Name(f"python2.{name}", ast.Load()), node)
    return ast.copy_location(ast.Call(function, arguments, named or []), node)


def _is_evidently_float(node: ast.expr) -> bool:
    match node:
        case ast.Constant(value=float()) | ast.Call(func=ast.Name(id="float")):
            return True
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div(), right=right):
            return _is_evidently_float(left) or _is_evidently_float(right)
        case ast.UnaryOp(operand=operand):
            return _is_evidently_float(operand)
    return False


def _is_evidently_number(node: ast.expr) -> bool:
    match node:
        case ast.Constant(value=int() | float()):
            return True
        case ast.Name(id=name):
            return name in NUMBERS
        case ast.Call(func=ast.Name(id="len" | "int" | "float" | "random" | "dist")):
            return True
        case ast.BinOp(op=ast.Sub() | ast.Div() | ast.Pow() | ast.FloorDiv()):
            return True
        case ast.UnaryOp(operand=operand):
            return _is_evidently_number(operand)
    return False


def _may_be_filled_in(text: ast.expr, values: ast.expr) -> bool:
    """Tell whether a `%` may put numbers with fractions into a text."""
    match text, values:
        case _, ast.Constant(value=int() | str()):
            return False
        case ast.Constant(value=str()), _:
            return True
    return not (_is_evidently_number(text) or _is_evidently_number(values))


def _futures(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.module == "__future__":
            yield from (alias.name for alias in node.names)


def _bound_names(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        match node:
            case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name):
                yield name
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                yield name


def _bound_by(statement: ast.stmt) -> Iterator[str]:
    match statement:
        case ast.FunctionDef(name=name):
            yield name
        case ast.Assign(targets=targets):
            yield from (target.id for target in targets if isinstance(target, ast.Name))


def _names_of_globals(body: Iterable[ast.stmt]) -> dict[str, None]:
    """Return what a function declares as global, itself and not in one that it defines."""
    names: dict[str, None] = {}
    for statement in body:
        if isinstance(statement, ast.Global):
            names |= dict.fromkeys(statement.names)
        elif not isinstance(statement, SCOPES):
            for block in _blocks(statement):
                names |= _names_of_globals(block)
    return names


def _without_globals(body: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
    for statement in body:
        if isinstance(statement, ast.Global):
            yield ast.copy_location(ast.Pass(), statement)
            continue
        if not isinstance(statement, SCOPES):
            for block in _blocks(statement):
                block[:] = _without_globals(block)
        yield statement


def _blocks(statement: ast.stmt) -> Iterator[list[ast.stmt]]:
    """Yield the lists of statements that one is made of."""
    for name in ("body", "orelse", "finalbody"):
        block = getattr(statement, name, None)
        if isinstance(block, list):
            yield block
    for part in (*getattr(statement, "handlers", ()), *getattr(statement, "cases", ())):
        yield part.body
