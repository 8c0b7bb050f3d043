"""Mistake: an error, and all that can be found out about the line it came from."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import FrameType
from typing import NamedTuple

from sketchkit.runtime.source import Source


class Explanation(NamedTuple):
    """What was wrong, what was received, and what to write instead: whole sentences."""

    problem: str
    hint: str | None = None
    got: str | None = None


@dataclass(frozen=True)
class Mistake:
    """An error, and where in the sketch it came up.

    Attributes
    ----------
    error : BaseException
    frame : FrameType or None
        The sketch's innermost function, stopped at the line that failed.
    expression : ast.AST or None
        The part of the line that failed.
    names : dict
        What the sketch sees behind its own names.
    source : Source or None
        The file.
    is_inside : bool
        Whether the error came up inside of a function of sketchkit that the line calls.
    """

    error: BaseException
    frame: FrameType | None = None
    expression: ast.AST | None = None
    names: Mapping[str, object] = field(default_factory=dict)
    source: Source | None = None
    is_inside: bool = False

    @property
    def text(self) -> str:
        """What Python says."""
        return str(self.error)

    @property
    def own(self) -> dict[str, object]:
        """The sketch's own variables that can be seen from the line."""
        if self.frame is None:
            return {}
        visible = {**self.frame.f_globals, **self.frame.f_locals}
        return {name: value for name, value in visible.items() if not name.startswith("__")}

    @property
    def function(self) -> str:
        """The function that the line is in; empty outside of all functions."""
        name = self.frame.f_code.co_name if self.frame else "<module>"
        return "" if name.startswith("<") else name

    @property
    def called(self) -> str | None:
        """The name in front of the brackets, if a call by name has failed."""
        match self.expression:
            case ast.Call(func=ast.Name(id=name)):
                return name
        return None

    def written(self, node: ast.AST | None) -> str:
        """Return a part of the line as Python writes it."""
        return ast.unparse(node) if node else ""

    def value_of(self, node: ast.AST | None) -> object:
        """Return the value of a simple expression: a name or a constant.

        Raises
        ------
        LookupError
            If it is not simple, or has no value.
        """
        match node:
            case ast.Constant(value=value):
                return value
            case ast.Name(id=name):
                own = self.own
                return own[name] if name in own else self.names[name]
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(value))):
                return -value
        raise LookupError


def a_kind(value: object) -> str:
    """Return what sort of thing a value is, in words: "a whole number", "text"."""
    kind = type(value).__name__
    return KINDS.get(kind, f"{'an' if kind[0] in 'aeiouAEIOU' else 'a'} {kind}")


# Python's names of kinds, in words.
KINDS = {
    "NoneType": "None",
    "bool": "True or False",
    "int": "a whole number",
    "float": "a number",
    "LiveFloat": "a number",
    "LiveInt": "a whole number",
    "LiveFlag": "True or False",
    "str": "text",
    "list": "a list",
    "tuple": "a tuple",
    "dict": "a dictionary",
    "set": "a set",
    "function": "a function",
    "method": "a function",
    "builtin_function_or_method": "a function",
    "module": "a module",
    "type": "a class",
}
