"""Python 2's way to write things, as Python 3 writes them: `print x`, `except E, e`, `0777`, ...

A library knows how to; this file says what it is to change, and in which line each result was.
"""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import ModuleType
from typing import TYPE_CHECKING

from sketchkit.core.errors import SketchError

if TYPE_CHECKING:
    from fissix.pytree import Base, Leaf
    from fissix.refactor import RefactoringTool

FIXERS = (
    *("except", "exec", "ne", "numliterals", "paren", "print", "raise", "repr", "throw"),
    "tuple_params",
)
# The grammars to try: `print` is a word of the language, or, after an import, a function.
GRAMMARS = (
    "python_grammar",
    "python_grammar_no_print_statement",
    "python_grammar_no_print_and_exec_statement",
)
PRINT_FUNCTION = re.compile(r"^from __future__ import .*\bprint_function\b", re.MULTILINE)
CLEAR = ("was never closed", "unterminated")  # what Python 3 says better, wherever it says it
STRING = re.compile(r"(?P<prefix>[a-zA-Z]*)(?P<rest>[\"'].*)", re.DOTALL)
NEW_ESCAPES = re.compile(r"(?<!\\)((?:\\\\)*)\\([uUN])")


@dataclass(frozen=True)
class Converted:
    """A file in the syntax of Python 3.

    Attributes
    ----------
    text : str
        All of it.
    origins : sequence of int, or None
        Of each line the one of the file that it was; None if all are as they were.
    """

    text: str
    origins: Sequence[int] | None = None

    def tree(self, filename: str) -> ast.Module:
        """Return the syntax tree, with the lines of the file itself."""
        tree = ast.parse(self.text, filename)
        if self.origins is not None:
            for node in ast.walk(tree):
                if isinstance(node, ast.expr | ast.stmt | ast.excepthandler | ast.arg):
                    node.lineno = self._origin(node.lineno)
                    node.end_lineno = max(node.lineno, self._origin(node.end_lineno or 0))
        return tree

    def _origin(self, line: int) -> int:
        origins = self.origins or ()
        return origins[line - 1] if 1 <= line <= len(origins) else line


def convert(text: str, filename: str) -> Converted:
    """Return a file in the syntax of Python 3; what is no Python 2 is given back as it is.

    Parameters
    ----------
    text : str
        As `text_of` returns it.
    filename : str
        For messages.

    Raises
    ------
    SyntaxError
        If it is neither Python 2 nor Python 3.
    SketchError
        If the library is missing that does this.
    """
    tree, mistake = _parsed(text, GRAMMARS)
    if tree is None:
        _check_python_3(text, filename, mistake)
        return Converted(text)
    refactored = modernised(tree)
    result = str(refactored).removesuffix("\n")
    if result.count("\n") == text.count("\n"):
        return Converted(result)
    return Converted(result, list(_origins(refactored)))


def parse(text: str, grammars: Sequence[str] = GRAMMARS) -> Base | None:
    """Return the library's tree of a file, or None if it is no Python 2.

    Parameters
    ----------
    text : str
        The file.
    grammars : sequence of str
        Which to try: `GRAMMARS[1:]` is for what is in the syntax of Python 3 already.
    """
    return _parsed(text, grammars)[0]


def modernised(tree: Base) -> Base:
    """Change a tree to the syntax of Python 3, and return it."""
    change(tree, refactoring(FIXERS))
    for leaf in tree.leaves():
        _modernise_string(leaf)
    return tree


def change(tree: Base, tools: RefactoringTool) -> Base:
    """Apply some fixers to a tree, and return it."""
    tools.refactor_tree(tree, "sketch")
    return tree


@lru_cache
def refactoring(names: tuple[str, ...], package: str = "fissix.fixes") -> RefactoringTool:
    """Return what applies the fixers of these names, the library's or those of a package.

    Raises
    ------
    SketchError
        If the library is missing.
    """
    tool: type[RefactoringTool] = _library("refactor").RefactoringTool
    return tool([f"{package}.fix_{name}" for name in names])


def _library(name: str) -> ModuleType:
    try:
        return importlib.import_module(f"fissix.{name}")
    except ImportError:
        raise SketchError(
            "This is a sketch of Processing's Python Mode, and what converts it is not installed.",
            hint='Install it with: pip install "sketchkit[pde]"',
        ) from None


def _parsed(text: str, grammars: Sequence[str]) -> tuple[Base | None, SyntaxError | None]:
    """Return the tree, or the mistake that the first grammar finds."""
    pygram, driver, pytree = _library("pygram"), _library("pgen2.driver"), _library("pytree")
    tokenizing, parsing = _library("pgen2.tokenize"), _library("pgen2.parse")
    mistake = None
    for name in grammars[1:] if PRINT_FUNCTION.search(text) else grammars:
        reader = driver.Driver(getattr(pygram, name), convert=pytree.convert)
        try:
            tree: Base = reader.parse_string(text + "\n")
        except parsing.ParseError as error:
            _, (line, column) = error.context
            mistake = mistake or _syntax_error(error.msg, line, column, text)
        except tokenizing.TokenError as error:
            message, (line, column) = error.args
            mistake = mistake or _syntax_error(message, line, column, text)
        except IndentationError as error:
            mistake = mistake or _syntax_error(error.msg, error.lineno or 1, 0, text)
        else:
            tree.future_features = frozenset()  # some fixers ask for it
            return tree, None
    return None, mistake


def _syntax_error(message: str, line: int, column: int, text: str) -> SyntaxError:
    lines = text.split("\n")
    shown = lines[line - 1] if 1 <= line <= len(lines) else ""
    readable = {"bad input": "invalid syntax", "EOF in multi-line statement": "unexpected EOF"}
    return SyntaxError(readable.get(message, message), ("", line, column + 1, shown))


def _check_python_3(text: str, filename: str, mistake: SyntaxError | None) -> None:
    """Raise the clearer of two syntax errors, if the text is no Python 3 either."""
    try:
        ast.parse(text, filename)
    except SyntaxError as error:
        is_clear = any(words in error.msg for words in CLEAR)
        if mistake is None or error.lineno == mistake.lineno or is_clear:
            raise
        mistake.filename = filename
        raise mistake from None
    except ValueError as problem:
        raise SyntaxError(str(problem)) from problem


def _modernise_string(leaf: Leaf) -> None:
    r"""Write a string so that Python 3 reads the same: `ur"..."`, `b"..."`, `"\user"`."""
    if leaf.type != _library("pgen2.token").STRING:
        return
    found = STRING.match(leaf.value)
    if found is None:
        return
    prefix, rest = found["prefix"].lower(), found["rest"]
    if "f" in prefix:
        return
    if "u" not in prefix and "r" not in prefix:
        rest = NEW_ESCAPES.sub(r"\1\\\\\2", rest)
    value = ("r" if "r" in prefix else "u" if prefix == "u" else "") + rest
    if value != leaf.value:
        leaf.value = value
        leaf.changed()


def _origins(tree: Base) -> Iterator[int]:
    """Yield of each line of the tree's text the line that it was in the file."""
    origin = 1
    for leaf in tree.leaves():
        before = leaf.prefix.count("\n")
        first = leaf.lineno - before if leaf.lineno else origin
        for step in range(before):
            yield first + step
        origin = leaf.lineno or origin
        for step in range(leaf.value.count("\n")):
            yield origin + step
