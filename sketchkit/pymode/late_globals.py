"""`global x` behind the first use of x: Python 2 let it stand there, Python 3 does not."""

from __future__ import annotations

import ast
import re


def with_early_globals(text: str) -> str:
    """Return a text in which such lines stand first in their functions."""
    lines = text.split("\n")
    functions = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef)]
    for function in sorted(functions, key=lambda node: node.lineno, reverse=True):
        late = _late_globals(function)
        if not late:
            continue
        for statement in sorted(late, key=lambda node: node.lineno, reverse=True):
            _take_out(lines, statement)
        names = dict.fromkeys(name for statement in late for name in statement.names)
        first = function.body[0]
        if first.lineno == function.lineno:
            continue  # all in one line: there is no room, and nothing to read
        indent = " " * first.col_offset
        lines.insert(first.lineno - 1, f"{indent}global {', '.join(names)}")
    return "\n".join(lines)


def _late_globals(function: ast.FunctionDef) -> list[ast.Global]:
    """Return the declarations in a function that come after a use of one of their names."""
    used: dict[str, int] = {}
    declared: list[ast.Global] = []
    for node in ast.walk(function):
        match node:
            case ast.Name(id=name):
                used[name] = min(used.get(name, node.lineno), node.lineno)
            case ast.Global():
                declared.append(node)
    return [
        statement
        for statement in declared
        if any(used.get(name, statement.lineno) < statement.lineno for name in statement.names)
    ]


def _take_out(lines: list[str], statement: ast.Global) -> None:
    """Take the declaration away; `pass` stands for it, lest a block be left empty."""
    line = lines[statement.lineno - 1]
    lines[statement.lineno - 1] = re.sub(r"\bglobal\b[^;#\n]*", "pass  ", line, count=1).rstrip()
