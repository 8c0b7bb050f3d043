"""Tweaks: the numbers that stand in a sketch, changed while it runs and written back on request.

The file is compiled anew with other numbers, and the functions that are alive get the new code:
so variables, objects and frameCount stay as they are.
"""

from __future__ import annotations

import ast
import copy
import math
from collections.abc import Iterator
from dataclasses import dataclass
from types import CodeType, FunctionType

from sketchkit.assets.output import write_file
from sketchkit.runtime.loader import Program
from sketchkit.runtime.source import Source

FIXED = ("size", "createGraphics", "smooth", "frameRate", "fullScreen", "range", "pixelDensity")


@dataclass
class Number:
    """A number that stands in the sketch.

    Attributes
    ----------
    line, column, end : int
        Where; columns in bytes, without a sign.
    original : float or int
        As it stands in the file.
    value : float or int
        As it is now.
    place : int
        Which of the file's constants it is, in the order of the syntax tree.
    """

    line: int
    column: int
    end: int
    original: float
    value: float
    place: int

    @property
    def is_changed(self) -> bool:
        """Whether it is not what stands in the file."""
        return self.value != self.original

    @property
    def text(self) -> str:
        """The number as it is written into the file."""
        return repr(self.value)

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
        self._source = program.source
        found = _numbers(self._source)
        self.numbers = sorted(found, key=lambda own: (own.line, own.column))

    def is_of(self, program: Program) -> bool:
        """Whether these are the numbers of the text that a sketch runs now."""
        return program is self._program and program.source is self._source

    def label(self, number: Number) -> str:
        """Return the line of the sketch with a number as it is now, marked."""
        encoded = self._source.line(number.line).encode()
        before, after = encoded[: number.column].decode(), encoded[number.end :].decode()
        return f"{number.line:>4}  {before.lstrip()}[{number.text}]{after}".rstrip()

    def apply(self) -> None:
        """Let the running sketch have the numbers as they are now."""
        tree = copy.deepcopy(self._source.tree)
        constants = list(_constants(tree))
        for number in self.numbers:
            constants[number.place].value = number.value
        code = compile(tree, str(self._source.path), "exec", dont_inherit=True)
        codes = {_key(own): own for own in _codes(code)}
        for function in _functions(self._program.namespace):
            if new := codes.get(_key(function.__code__)):
                function.__code__ = new
        self._set_variables(tree)

    def write(self) -> None:
        """Write the numbers into the sketch's file; all else of it stays as it is."""
        lines = self._source.data.splitlines(keepends=True)
        for number in sorted(self.numbers, key=lambda own: (own.line, own.column), reverse=True):
            if number.is_changed:
                line = lines[number.line - 1]
                new = line[: number.column] + number.text.encode() + line[number.end :]
                lines[number.line - 1] = new
        write_file(self._source.path, b"".join(lines))

    def _set_variables(self, tree: ast.Module) -> None:
        """Give a variable of the file a number that was changed: `speed = 3`, outside of all."""
        changed = {number.line for number in self.numbers if number.is_changed}
        for node in tree.body:
            match node:
                case (
                    ast.Assign(targets=[ast.Name(id=name)], value=value)
                    | ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value)
                ):
                    if node.lineno in changed:
                        try:
                            self._program.namespace[name] = ast.literal_eval(value)
                        except ValueError:
                            continue  # reckoned from other things: it keeps its value


def _numbers(source: Source) -> Iterator[Number]:
    """Yield the numbers of a file that may be changed while it runs."""
    fixed = {
        id(inner)
        for node in ast.walk(source.tree)
        if isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] in FIXED
        for inner in ast.walk(node)
    }
    for place, node in enumerate(_constants(source.tree)):
        value = node.value
        if isinstance(value, bool) or not isinstance(value, int | float):
            continue
        if id(node) not in fixed and node.end_col_offset is not None:
            yield Number(node.lineno, node.col_offset, node.end_col_offset, value, value, place)


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
