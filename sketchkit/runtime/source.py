"""A student's file as text, syntax tree and code."""

from __future__ import annotations

import ast
import io
import tokenize
import warnings
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from types import CodeType
from typing import NamedTuple

from sketchkit.pymode.dialect import Sign, sign_of_python_2
from sketchkit.pymode.meaning import python_3
from sketchkit.pymode.reading import text_of
from sketchkit.pymode.settings import with_settings_first
from sketchkit.pymode.syntax import Converted, convert

PYTHON_MODE = ".pyde"  # how the files of Processing's Python Mode end: they are Python 2


class Position(NamedTuple):
    """A part of a file, as Python keeps it: lines from 1, columns in bytes from 0."""

    line: int
    end_line: int
    column: int
    end_column: int


@dataclass(frozen=True)
class Source:
    """A file that has been read and found to be Python.

    Attributes
    ----------
    path : Path
        Absolute.
    data : bytes
        As it is on disk: Python itself sees to byte order marks, CRLF and `coding:` lines.
    python : 2 or 3
        Which Python it is written in.
    remarks : list of (line, text)
        What Python finds strange in it.
    """

    path: Path
    data: bytes
    python: int = 3
    remarks: list[tuple[int, str]] = field(default_factory=list, compare=False)

    @classmethod
    def read(cls, path: Path, python: int | None = None) -> Source:
        """Read a file.

        Parameters
        ----------
        path : Path
            Where it is.
        python : 2 or 3, optional
            Which Python it is written in. Without it, the end of its name tells, or the text: one
            that is Python 2 and cannot be Python 3 is read as that, and a remark says so.

        Raises
        ------
        SyntaxError
            If it is not Python.
        OSError
            If it cannot be read.
        SketchError
            If it is Python 2 and the library that converts it is not installed.
        """
        sign = None if python or path.suffix == PYTHON_MODE else sign_of_python_2(path)
        python = python or (2 if sign or path.suffix == PYTHON_MODE else 3)
        source = cls(path.absolute(), path.read_bytes(), python)
        if sign:
            source.remarks.append(_remark(sign, path))
        source.code  # noqa: B018 # compiled here, so that mistakes come to light when it is read
        return source

    @cached_property
    def tree(self) -> ast.Module:
        """The syntax tree, in the syntax of Python 3."""
        if self.python == 2:
            return with_settings_first(self._converted.tree(str(self.path)))
        try:
            return ast.parse(self.data, str(self.path))
        except ValueError as problem:  # Python 3.11.2 says so of a file with null bytes
            raise SyntaxError(str(problem)) from problem

    @cached_property
    def lines(self) -> list[str]:
        """The text, line by line."""
        if self.python == 2:
            return text_of(self.data).split("\n")
        encoding, _ = tokenize.detect_encoding(io.BytesIO(self.data).readline)
        return self.data.decode(encoding, errors="replace").splitlines()

    @cached_property
    def code(self) -> CodeType:
        """What Python runs."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            tree = self.tree
            if self.python == 2:  # one of its own: it is changed
                tree = with_settings_first(self._converted.tree(str(self.path)))
            code = self.compiled(tree)
        self.remarks.extend((warning.lineno, f"{warning.message}") for warning in caught)
        return code

    @cached_property
    def names(self) -> frozenset[str]:
        """All names in it, but attributes: variables, and functions that it defines."""
        nodes = list(ast.walk(self.tree))
        used = {node.id for node in nodes if isinstance(node, ast.Name)}
        return frozenset(used | {own.name for own in nodes if isinstance(own, ast.FunctionDef)})

    @cached_property
    def parts(self) -> frozenset[int]:
        """The `id()` of its code, and of the code of all functions and classes within."""
        found, left = set(), [self.code]
        while left:
            code = left.pop()
            found.add(id(code))
            left += [own for own in code.co_consts if isinstance(own, CodeType)]
        return frozenset(found)

    def line(self, number: int) -> str:
        """Return a line, counted from 1; nothing if there is no such line."""
        return self.lines[number - 1] if 1 <= number <= len(self.lines) else ""

    def columns(self, position: Position | None) -> tuple[int, int]:
        """Return the first and the end column of a part, in characters, within its first line."""
        if position is None:
            return 0, 0
        text = self.line(position.line)
        if not self._is_as_written(position.line):
            return 0, 0
        first = _characters(text, position.column)
        is_one_line = position.end_line == position.line
        return first, _characters(text, position.end_column) if is_one_line else len(text)

    def expression_at(self, position: Position | None) -> ast.AST | None:
        """Return the part of the syntax tree that lies exactly there."""
        for node in ast.walk(self.tree):
            if isinstance(node, ast.expr) and position == (
                node.lineno,
                node.end_lineno,
                node.col_offset,
                node.end_col_offset,
            ):
                return node
        return None

    @cached_property
    def _converted(self) -> Converted:
        return convert(text_of(self.data), str(self.path))

    def compiled(self, tree: ast.Module) -> CodeType:
        """Return the code of a tree like its own; a tree in Python 2 is changed by it."""
        meant = tree if self.python == 3 else python_3(tree)
        return compile(meant, str(self.path), "exec", dont_inherit=True)

    def _is_as_written(self, number: int) -> bool:
        """Tell whether a line is read as it stands in the file, so that columns are the same."""
        if self.python == 3:
            return True
        lines = self._converted.text.split("\n")
        return number <= len(lines) and self.line(number) == lines[number - 1]

    def line_of_binding(self, name: str) -> int:
        """Return the line in which the sketch first gives a name a value; 1 if there is none."""
        for node in ast.walk(self.tree):
            match node:
                case ast.Name(id=bound, ctx=ast.Store()) if bound == name:
                    return node.lineno
                case ast.FunctionDef(name=bound) | ast.ClassDef(name=bound) if bound == name:
                    return node.lineno
        return 1


def _remark(sign: Sign, path: Path) -> tuple[int, str]:
    """Return a line of the sketch, and what is said there of its being Python 2."""
    is_own = sign.path == path
    what = "This" if is_own else f"{sign.path.name}, line {sign.line},"
    return sign.line if is_own else 1, (
        f"{what} is Python 2: the sketch is run as with --python-mode, where 7 / 2 is 3.\n"
        "    sketchkit port writes it as Python 3."
    )


def _characters(line: str, column: int) -> int:
    """Return how many characters the first `column` bytes of a line are."""
    return len(line.encode()[:column].decode(errors="ignore"))
