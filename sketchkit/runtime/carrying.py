"""What survives when a running sketch gets a new text: the values of its variables.

The new text's own lines are run, and then each variable gets back the value that it had, unless
the line that first gives it a value has been edited. Functions and classes are the new ones, and
objects of the sketch's own classes belong to the new classes from then on.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from types import FunctionType, ModuleType

from sketchkit.runtime.source import Source

Names = dict[str, object]

BEGINNINGS = ("settings", "setup")  # a change in one of these is not seen unless it is run again


def begins_alike(old: Source, new: Source) -> bool:
    """Return whether two texts of a sketch have the same `settings()` and `setup()`."""
    first, second = _beginnings(old), _beginnings(new)
    return first == second


def carry(old: Names, new: Names, old_source: Source, new_source: Source) -> None:
    """Give variables of a module that has been run anew the values that they had.

    Parameters
    ----------
    old, new : dict
        What the module has defined, before and now.
    old_source, new_source : Source
        Its text.
    """
    before, after = _bindings(old_source.tree), _bindings(new_source.tree)
    for name, value in old.items():
        is_edited = name in new and before.get(name) != after.get(name)
        if name.startswith("__") or is_edited or _is_code(value) or _is_code(new.get(name)):
            continue
        new[name] = value


def adopt(namespaces: Iterable[Names]) -> None:
    """Let objects of the sketch's old classes belong to its new classes of the same names.

    Parameters
    ----------
    namespaces : iterable of dict
        What its modules define now. Objects are found in variables, in lists, tuples, sets and
        dictionaries, and in one another's attributes.
    """
    namespaces = list(namespaces)
    modules = {str(namespace.get("__name__")) for namespace in namespaces}
    values = [value for namespace in namespaces for value in namespace.values()]
    classes = {_name_of(kind): kind for kind in values if isinstance(kind, type)}
    classes = {name: kind for name, kind in classes.items() if name[0] in modules}
    seen: set[int] = set()
    while values:
        value = values.pop()
        if isinstance(value, int | float | str | type | ModuleType) or id(value) in seen:
            continue
        seen.add(id(value))
        if isinstance(value, dict):
            values += value.values()
        elif isinstance(value, list | tuple | set | frozenset):
            values += value
        elif kind := classes.get(_name_of(type(value))):
            _move_to(value, kind)
            values += getattr(value, "__dict__", {}).values()


def _move_to(value: object, kind: type) -> None:
    if type(value) is not kind:
        try:
            value.__class__ = kind
        except TypeError:  # the new class keeps its attributes in another way, as by __slots__
            return


def _name_of(kind: type) -> tuple[str, str]:
    return kind.__module__, kind.__qualname__


def _is_code(value: object) -> bool:
    return isinstance(value, FunctionType | type | ModuleType)


def _beginnings(source: Source) -> list[str]:
    return [
        ast.dump(node)
        for node in source.tree.body
        if isinstance(node, ast.FunctionDef) and node.name in BEGINNINGS
    ]


def _bindings(tree: ast.Module) -> dict[str, list[str]]:
    """Return which statements of the file itself give each variable a value."""
    found: dict[str, list[str]] = {}
    for statement in tree.body:
        if isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            continue
        text = ast.dump(statement)
        for node in ast.walk(statement):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                found.setdefault(node.id, []).append(text)
    return found
