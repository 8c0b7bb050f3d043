"""Tweaks: the numbers that stand in a sketch, changed while it runs and written back on request.

The file is compiled anew with other numbers, and the functions that are alive get the new code:
so variables, objects and frameCount stay as they are.
"""

from __future__ import annotations

import ast
import copy
import math
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, FunctionType

from sketchkit.assets.output import write_file
from sketchkit.runtime.carrying import BEGINNINGS
from sketchkit.runtime.loader import Program
from sketchkit.runtime.source import Source

FIXED = ("size", "createGraphics", "smooth", "frameRate", "fullScreen", "range", "pixelDensity")


@dataclass
class Number:
    """A number that stands in the sketch.

    Attributes
    ----------
    line, column, end : int
        Where; columns in bytes, with its sign.
    original : float or int
        As it stands in the file.
    value : float or int
        As it is now.
    place : int
        Which of the file's constants it is, in the order of the syntax tree.
    written : str
        Its text in the file: `-5`, `0x80`.
    is_operand : bool
        Whether a sign would belong to more than the number: `2` in `x - 2` and in `2 ** x`.
    """

    line: int
    column: int
    end: int
    original: float
    value: float
    place: int
    written: str
    is_operand: bool = False

    @property
    def is_changed(self) -> bool:
        """Whether it is not what stands in the file."""
        return self.value != self.original

    @property
    def text(self) -> str:
        """The number as it is written into the file."""
        if not self.is_changed:
            return self.written
        if self.written.lower().startswith("0x") and self.value >= 0:
            return f"0x{int(self.value):0{len(self.written) - 2}X}"
        return f"({self.value!r})" if self.is_operand and self.value < 0 else repr(self.value)

    def step(self, count: int) -> None:
        """Make it larger, or smaller, by so many steps; whole numbers stay whole."""
        if isinstance(self.original, int):
            self.value = int(self.value) + count * max(abs(self.original) // 50, 1)
            return
        size = abs(self.original) or 1.0
        unit = 10.0 ** math.floor(math.log10(size) - 1)
        digits = max(-math.floor(math.log10(unit)), 0)
        self.value = round(self.value + count * unit, digits + 1)


class Tweaks:
    """The numbers of a sketch's file.

    Parameters
    ----------
    program : Program
        The sketch, as it runs.

    Attributes
    ----------
    numbers : list of Number
    """

    def __init__(self, program: Program) -> None:
        self._program = program
        self._written: Path | None = None
        self._begin(program.source)

    def _begin(self, source: Source) -> None:
        self._source = source
        self.numbers = sorted(_numbers(source), key=lambda own: (own.line, own.column))
        self._applied = [number.value for number in self.numbers]

    def is_of(self, program: Program) -> bool:
        """Whether these are the numbers of the text that a sketch runs now."""
        return program is self._program and program.source is self._source

    def around(self, number: Number) -> tuple[str, str, str]:
        """Return what stands before a number in its line, itself as it is now, and what follows."""
        encoded = self._source.line(number.line).encode()
        before, after = encoded[: number.column].decode(), encoded[number.end :].decode()
        return before.lstrip(), f"[{number.text}]", after.rstrip()

    def apply(self) -> None:
        """Let the running sketch have the numbers as they are now."""
        tree = copy.deepcopy(self._source.tree)
        constants = list(_constants(tree))
        for number in self.numbers:
            is_negated = number.written.startswith("-")
            constants[number.place].value = -number.value if is_negated else number.value
        values = [number.value for number in self.numbers]
        pairs = zip(self.numbers, self._applied, strict=True)
        self._set_variables(tree, [own.line for own, before in pairs if own.value != before])
        self._applied = values
        self._give(self._source.compiled(tree))

    def _give(self, code: CodeType) -> None:
        """Let the functions that are alive have the code of a text that differs in numbers."""
        codes = {_key(own): own for own in _codes(code)}
        functions = [*_functions(self._program.namespace)]
        functions += [own for own in self._handlers if isinstance(own, FunctionType)]
        for function in functions:
            if new := codes.get(_key(function.__code__)):
                function.__code__ = new

    @property
    def _handlers(self) -> Iterable[object]:
        """The sketch's functions that are no variables, such as `mousePressed`."""
        return self._program.sketch.handlers.values()

    def write(self) -> None:
        """Write the numbers into the sketch's file; all else of it stays as it is.

        If what runs is what the file says then, the sketch goes on; see `takes_written`.
        """
        changed = [number for number in self.numbers if number.is_changed]
        lines = self._source.data.splitlines(keepends=True)
        for number in reversed(changed):
            line = lines[number.line - 1]
            new = line[: number.column] + number.text.encode() + line[number.end :]
            lines[number.line - 1] = new
        if not changed:
            return
        write_file(self._source.path, b"".join(lines))
        if all(_is_live(self._source.tree, number.line) for number in changed):
            source = Source.read(self._source.path, self._source.python)
            self._give(source.code)
            self._program.follow_file(source)
            self._begin(source)
            self._written = source.path

    def takes_written(self, path: Path) -> bool:
        """Return whether a file holds what runs already: asked for once, granted once."""
        is_written = path == self._written
        self._written = None if is_written else self._written
        return is_written

    def _set_variables(self, tree: ast.Module, lines: Collection[int]) -> None:
        """Give variables of the file and of its classes the numbers that changed in these lines."""
        namespace = self._program.namespace
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and isinstance(
                kind := namespace.get(node.name), type
            ):
                for name, value in _assigned(node.body, lines):
                    setattr(kind, name, value)
        namespace.update(_assigned(tree.body, lines))


def _assigned(body: list[ast.stmt], lines: Collection[int]) -> Iterator[tuple[str, object]]:
    """Yield what statements in some lines give to names, if it is written out: `speed = 3`."""
    for node in body:
        match node:
            case (
                ast.Assign(targets=[ast.Name(id=name)], value=value)
                | ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value)
            ):
                if not any(node.lineno <= line <= (node.end_lineno or 0) for line in lines):
                    continue
                try:
                    yield name, ast.literal_eval(value)
                except ValueError:
                    continue  # reckoned from other things: it keeps its value


def _is_live(tree: ast.Module, line: int) -> bool:
    """Return whether a new number in a line changes what a sketch does that runs already."""
    for node in tree.body:
        if node.lineno <= line <= (node.end_lineno or node.lineno):
            if isinstance(node, ast.FunctionDef):
                return node.name not in BEGINNINGS
            return isinstance(node, ast.ClassDef) or any(_assigned([node], [line]))
    return False


def _numbers(source: Source) -> Iterator[Number]:
    """Yield the numbers of a file that may be changed while it runs."""
    nodes = list(ast.walk(source.tree))
    parents = {id(inner): node for node in nodes for inner in ast.iter_child_nodes(node)}
    calls = (node for node in nodes if isinstance(node, ast.Call))
    kept = (call for call in calls if ast.unparse(call.func).split(".")[-1] in FIXED)
    fixed = {id(inner) for call in kept for inner in ast.walk(call)}
    for place, node in enumerate(_constants(source.tree)):
        if id(node) not in fixed and type(node.value) in (int, float):
            number = _number(source, place, node, parents[id(node)])
            if _means(number.written, number.value):  # in f-strings, Python 3.11 knows no places
                yield number


def _number(source: Source, place: int, node: ast.Constant, parent: ast.AST) -> Number:
    """Return a number with its sign."""
    value = node.value
    assert isinstance(value, int | float)
    whole: ast.expr = node
    is_operand = isinstance(parent, ast.BinOp | ast.UnaryOp | ast.Attribute)
    if isinstance(parent, ast.UnaryOp) and isinstance(parent.op, ast.USub):
        whole, value, is_operand = parent, -value, False
    column, end = whole.col_offset, whole.end_col_offset or 0
    text = source.data.splitlines()[whole.lineno - 1][column:end].decode("latin-1")
    return Number(whole.lineno, column, end, value, value, place, text, is_operand)


def _means(text: str, value: float) -> bool:
    """Return whether a text is a number that is written out."""
    try:
        return bool(ast.literal_eval(text) == value)
    except (ValueError, SyntaxError):
        return False


def _constants(tree: ast.AST) -> Iterator[ast.Constant]:
    """Yield all constants, always in the same order."""
    return (node for node in ast.walk(tree) if isinstance(node, ast.Constant))


def _key(code: CodeType) -> tuple[str, int, int]:
    return code.co_qualname, code.co_firstlineno, len(code.co_freevars)


def _codes(code: CodeType) -> Iterator[CodeType]:
    """Yield the code of all functions within some code."""
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield constant
            yield from _codes(constant)


def _functions(namespace: dict[str, object]) -> Iterator[FunctionType]:
    """Yield the sketch's functions, and the methods of its classes."""
    for value in list(namespace.values()):
        if isinstance(value, FunctionType):
            yield value
        elif isinstance(value, type):
            for member in list(vars(value).values()):
                inner = getattr(member, "__func__", getattr(member, "fget", member))
                if isinstance(inner, FunctionType):
                    yield inner
