"""What can be said of the values in a file before it runs: which are whole numbers for sure.

A kind is a text: "int", "float", "other", or "list of int"; "?" is anything, "" nothing yet. Names
are followed through assignments, calls and lists until nothing new is found.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Sequence

INT, FLOAT, OTHER, ANY, NONE = "int", "float", "other", "?", ""
LIST = "list of "
ROUNDS = 20  # more than any chain of assignments in a sketch has

INTS = frozenset(
    {
        *("width", "height", "mouseX", "mouseY", "pmouseX", "pmouseY", "frameCount", "keyCode"),
        *("displayWidth", "displayHeight", "pixelWidth", "pixelHeight", "mouseButton"),
    }
)
FLOATS = frozenset({"PI", "TWO_PI", "HALF_PI", "QUARTER_PI", "TAU", "frameRate"})
INT_CALLS = frozenset(
    {
        *("int", "len", "ord", "floor", "ceil", "millis", "second", "minute", "hour", "day"),
        *("month", "year", "color", "lerpColor", "get", "randint", "randrange", "cmp", "unhex"),
    }
)
FLOAT_CALLS = frozenset(
    {
        *("float", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "sq", "pow"),
        *("exp", "log", "dist", "mag", "map", "lerp", "norm", "noise", "random", "radians"),
        *("degrees", "randomGaussian", "red", "green", "blue", "hue", "saturation", "uniform"),
        *("brightness", "alpha", "textWidth", "gauss", "heading", "hypot"),
    }
)
SAME_CALLS = frozenset({"abs", "max", "min", "constrain", "sum"})


class Kinds:
    """What is known of the values of a sketch's files.

    Parameters
    ----------
    trees : sequence of ast.Module
        The sketch's file and its modules.
    """

    def __init__(self, trees: Sequence[ast.Module]) -> None:
        self._known: dict[str, str] = {}
        self._functions: dict[str, list[ast.FunctionDef]] = {}
        self._scopes: dict[ast.AST, str] = {}
        self._shared: set[str] = set()
        self._has_vectors = any(_mentions_vectors(tree) for tree in trees)
        for tree in trees:
            self._survey(tree, "")
        for _ in range(ROUNDS):
            before = dict(self._known)
            for tree in trees:
                for node in ast.walk(tree):
                    self._learn(node)
            if self._known == before:
                break

    def of(self, node: ast.expr) -> str:
        """Return the kind of an expression: "int" and "float" are sure."""
        return self._of(node) or ANY

    def _survey(self, node: ast.AST, scope: str) -> None:
        """Note in which function each node is, which names are shared, and what is defined."""
        self._scopes[node] = scope
        inner = scope
        match node:
            case ast.FunctionDef(name=name):
                self._functions.setdefault(name, []).append(node)
                inner = f"{scope}/{name}:{node.lineno}"
            case ast.ClassDef(name=name, body=body):
                makers = [part for part in body if isinstance(part, ast.FunctionDef)]
                first = [part for part in makers if part.name == "__init__"]
                self._functions.setdefault(name, []).extend(first)
            case ast.Global(names=names):
                self._shared.update(f"{scope}.{name}" for name in names)
        for child in ast.iter_child_nodes(node):
            self._survey(child, inner)

    def _learn(self, node: ast.AST) -> None:
        match node:
            case ast.Assign(targets=targets, value=value):
                for target in targets:
                    self._bind(target, self._of(value), value)
            case ast.AugAssign(target=target, op=op, value=value):
                read = self._of(target)
                self._bind(target, _result(op, read, self._of(value)), None)
            case (
                ast.For(target=target, iter=values) | ast.comprehension(target=target, iter=values)
            ):
                self._bind(target, self._item(values), None)
            case ast.Call():
                self._learn_from_call(node)
            case ast.Return(value=ast.expr() as value):
                self._join(f"return {self._scopes[node]}", self._of(value))
            case ast.FunctionDef(args=arguments):
                self._learn_defaults(node, arguments)

    def _bind(self, target: ast.expr, kind: str, value: ast.expr | None) -> None:
        match target, value:
            case ((ast.Tuple(elts=parts) | ast.List(elts=parts)), (ast.Tuple() | ast.List())):
                for part, each in zip(parts, value.elts, strict=False):
                    self._bind(part, self._of(each), each)
            case ((ast.Tuple(elts=parts) | ast.List(elts=parts)), _):
                for part in parts:
                    self._bind(part, ANY, None)
            case ast.Subscript(value=owner), _:
                self._bind(owner, LIST + kind, None)
            case _:
                if key := self._key(target):
                    self._join(key, kind)

    def _learn_from_call(self, call: ast.Call) -> None:
        match call.func:
            case ast.Attribute(value=owner, attr="append") if len(call.args) == 1:
                self._bind(owner, LIST + self._of(call.args[0]), None)
        for function in self._functions.get(_name_of(call.func), ()):
            names = [argument.arg for argument in function.args.args]
            if names[:1] == ["self"]:
                names = names[1:]
            inner = self._inner(function)
            for name, value in zip(names, call.args, strict=False):
                self._join(f"{inner}.{name}", self._of(value))
            for keyword in call.keywords:
                self._join(f"{inner}.{keyword.arg}", self._of(keyword.value))
            if any(isinstance(value, ast.Starred) for value in call.args):
                for name in names:
                    self._join(f"{inner}.{name}", ANY)

    def _learn_defaults(self, function: ast.FunctionDef, arguments: ast.arguments) -> None:
        inner = self._inner(function)
        with_default = arguments.args[len(arguments.args) - len(arguments.defaults) :]
        for argument, value in zip(with_default, arguments.defaults, strict=True):
            self._join(f"{inner}.{argument.arg}", self._of(value))

    def _join(self, key: str, kind: str) -> None:
        self._known[key] = _join(self._known.get(key, NONE), kind)

    def _inner(self, function: ast.FunctionDef) -> str:
        return f"{self._scopes[function]}/{function.name}:{function.lineno}"

    def _key(self, node: ast.expr) -> str | None:
        match node:
            case ast.Name(id=name):
                return self._key_of_name(name, self._scopes.get(node, ""))
            case ast.Attribute(attr=name):
                return f"attribute {name}"
        return None

    def _key_of_name(self, name: str, scope: str) -> str:
        own = f"{scope}.{name}"
        return f".{name}" if own in self._shared else own

    def _of(self, node: ast.AST) -> str:  # noqa: C901 # a table of the kinds of expressions
        match node:
            case ast.Constant(value=bool() | int()):
                return INT
            case ast.Constant(value=float()):
                return FLOAT
            case ast.Constant() | ast.JoinedStr() | ast.Dict() | ast.Lambda():
                return OTHER
            case ast.Name(id=name):
                return self._of_name(name, self._scopes.get(node, ""))
            case ast.Attribute(attr="x" | "y" | "z") if self._has_vectors:
                return ANY  # those of a PVector are floats, whatever other classes have
            case ast.Attribute(attr=name):
                return self._known.get(f"attribute {name}", INT if name in INTS else ANY)
            case ast.BinOp(left=left, op=op, right=right):
                return _result(op, self._of(left), self._of(right))
            case ast.UnaryOp(op=ast.Not()) | ast.Compare():
                return INT
            case ast.UnaryOp(operand=operand):
                return self._of(operand)
            case ast.IfExp(body=yes, orelse=no):
                return _join(self._of(yes), self._of(no))
            case ast.BoolOp(values=values):
                return _joined(self._of(value) for value in values)
            case ast.List(elts=parts) | ast.Tuple(elts=parts):
                return LIST + _joined(self._of(part) for part in parts)
            case ast.ListComp(elt=part):
                return LIST + self._of(part)
            case ast.Subscript(value=owner, slice=ast.Slice()):
                return self._of(owner)
            case ast.Subscript(value=owner):
                return self._item(owner)
            case ast.Call():
                return self._of_call(node)
        return ANY

    def _of_name(self, name: str, scope: str) -> str:
        places = [self._key_of_name(name, scope)]
        while scope:
            scope = scope.rpartition("/")[0]
            places.append(f"{scope}.{name}")
        for place in places:
            if place in self._known:
                return self._known[place]
        return INT if name in INTS else FLOAT if name in FLOATS else ANY

    def _of_call(self, call: ast.Call) -> str:
        name = _name_of(call.func)
        if functions := self._functions.get(name):
            return _joined(
                self._known.get(f"return {self._inner(function)}", OTHER)
                if function.name == name
                else OTHER
                for function in functions
            )
        if name == "range":
            return LIST + INT
        if name == "list" and len(call.args) == 1:
            return self._of(call.args[0])
        if name in SAME_CALLS and call.args:
            kinds = [self._of(value) for value in call.args]
            return _joined(kind.removeprefix(LIST) for kind in kinds)
        if name == "choice" and call.args:
            return self._item(call.args[0])
        return INT if name in INT_CALLS else FLOAT if name in FLOAT_CALLS else ANY

    def _item(self, values: ast.expr) -> str:
        kind = self._of(values)
        if kind == NONE:
            return NONE
        return kind.removeprefix(LIST) if kind.startswith(LIST) else ANY


def _mentions_vectors(tree: ast.Module) -> bool:
    return any(isinstance(node, ast.Name) and node.id == "PVector" for node in ast.walk(tree))


def _name_of(function: ast.expr) -> str:
    match function:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def _joined(kinds: Iterable[str]) -> str:
    result = NONE
    for kind in kinds:
        result = _join(result, kind)
    return result


def _join(one: str, other: str) -> str:
    if NONE in (one, other) or one == other:
        return one or other
    if one.startswith(LIST) and other.startswith(LIST):
        return LIST + _join(one.removeprefix(LIST), other.removeprefix(LIST))
    return ANY


def _result(operator: ast.operator, left: str, right: str) -> str:
    """Return the kind of what an operator makes of two, as Python 2 does."""
    if NONE in (left, right):
        return NONE
    if left == right == INT:
        return INT
    if {left, right} <= {INT, FLOAT}:
        return FLOAT
    lists = [kind for kind in (left, right) if kind.startswith(LIST)]
    if isinstance(operator, ast.Mult | ast.Add) and lists:
        return _joined(lists)
    return ANY
