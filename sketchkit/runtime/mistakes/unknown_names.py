"""Names, attributes and modules that are not there, or have no value yet."""

from __future__ import annotations

import ast
import builtins
import re
import sys
from collections.abc import Iterable, Iterator
from types import ModuleType

from sketchkit.core.errors import nearest
from sketchkit.reference.instead import BY_ITSELF, MODULES, instead_of, instead_of_attribute
from sketchkit.reference.names import names_by_owner
from sketchkit.runtime.mistakes.mistake import Explanation, Mistake, a_kind


def explain_name(mistake: Mistake) -> Explanation | None:
    """Explain a name that nothing defines."""
    name = getattr(mistake.error, "name", None)
    if not isinstance(name, str):
        return None
    functions = _functions_that_set(name, mistake)
    if functions:
        function = functions[0]
        return Explanation(
            f"{name} is not defined here: it belongs to {function}() alone.",
            f"Write global {name} as the first line of {function}(), to share it.",
        )
    if later := _line_below(name, mistake):
        return Explanation(f"{name} is not defined yet: it gets its value in line {later}.")
    problem = f"{name} is not defined."
    if instead := instead_of(name):
        return Explanation(problem, instead)
    if name in names_by_owner()[BY_ITSELF]:
        return Explanation(f"{name} is one of Processing's names that sketchkit has not.")
    return Explanation(problem, _suggestion(name, [*_visible(mistake.names), *mistake.own]))


def explain_unbound_local(mistake: Mistake) -> Explanation | None:
    """Explain a variable that a function sets, and so takes for its own, but reads before."""
    found = re.search(r"local variable '(\w+)'", mistake.text)
    if not found:
        return None
    name, function = found[1], mistake.function or "the function"
    if name in (mistake.frame.f_globals if mistake.frame else ()):
        return Explanation(
            f"{name} is set in {function}(), so it is a variable of {function}() alone, "
            "and has no value yet.",
            f"Write global {name} as the first line of {function}().",
        )
    if name in mistake.names:
        return Explanation(
            f"{name} is set in {function}(), so it is a variable of {function}() alone, "
            f"and hides sketchkit's {name}.",
            "Give your variable another name.",
        )
    return Explanation(
        f"{name} has no value yet at this line of {function}().",
        "Perhaps it gets one only inside an if or a loop that was not run.",
    )


def explain_attribute(mistake: Mistake) -> Explanation | None:
    """Explain what stands behind a dot and is not there."""
    error = mistake.error
    name, owner = getattr(error, "name", None), getattr(error, "obj", None)
    if not isinstance(name, str):
        return None
    if owner is None:
        value = getattr(mistake.expression, "value", None)
        what = mistake.written(value) or "The value"
        return Explanation(f"{what} is None, and None has no {name}.", _why_none(value, mistake))
    problem = f"{_the(owner)} has no {name}."
    if instead := instead_of_attribute(name, _owners(owner)):
        return Explanation(problem, instead)
    written = mistake.written(getattr(mistake.expression, "value", None))
    is_module = written in sys.stdlib_module_names and written != "this"  # which is the sketch
    if is_module and not isinstance(owner, ModuleType):
        return Explanation(problem, f"For Python's module write import {written} at the beginning.")
    return Explanation(problem, _suggestion(name, _visible(dir(owner))))


def _why_none(value: ast.AST | None, mistake: Mistake) -> str:
    """Return what probably made a value None: a search that found nothing, or no return."""
    match value:
        case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name)):
            tree = mistake.source.tree if mistake.source else ast.Module([], [])
            functions = (n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef))
            is_own = any(function.name == name for function in functions)
            if SEARCHES.match(name) and not is_own and name in _every_name():
                return f"{name}() gives None where it finds nothing."
    return "Is the function that should have given a value without a return?"


# How the names of Processing's functions begin that give None where they find nothing.
SEARCHES = re.compile("get|find|match|parse|read")


def _every_name() -> frozenset[str]:
    """Return the names of Processing's, whatever they belong to."""
    return frozenset().union(*names_by_owner().values())


# What a class is called in Processing's table.
IN_TABLE = {"Sketch": BY_ITSELF, "PMatrix2D": "PMatrix", "PMatrix3D": "PMatrix"}


def _owners(owner: object) -> list[str]:
    """Return the names of an object's classes in Processing's table, the nearest first."""
    kinds = owner.__mro__ if isinstance(owner, type) else type(owner).__mro__
    return [IN_TABLE.get(kind.__name__, kind.__name__) for kind in kinds]


def explain_import(mistake: Mistake) -> Explanation | None:
    """Explain a module that is not there, or that lacks a name."""
    name = getattr(mistake.error, "name", None)
    if isinstance(mistake.error, ModuleNotFoundError) and isinstance(name, str):
        known = _suggestion(name, [*sys.stdlib_module_names, "numpy"])
        instead = instead_of(name.partition(".")[0], [MODULES])
        return Explanation(
            f"There is no module {name}: no {name}.py beside the sketch, and none installed.",
            instead or known or f"If it is a package: pip install {name}",
        )
    found = re.match(r"cannot import name '(\w+)' from '([\w.]+)'", mistake.text)
    if not found:
        return None
    name, module = found.groups()
    known_names = mistake.names if module == "sketchkit" else dir(sys.modules.get(module))
    problem = f"The module {module} has no {name}."
    return Explanation(problem, _suggestion(name, _visible(known_names)))


def _suggestion(name: str, known_names: Iterable[str]) -> str | None:
    """Return the hint that names the nearest known name: a constant only for capitals."""
    alike = sorted(known_names, key=lambda known: known.isupper() == name.isupper())
    known = nearest(name, alike)
    return f"Do you mean {known}?" if known else None


def _functions_that_set(name: str, mistake: Mistake) -> list[str]:
    tree = mistake.source.tree if mistake.source else ast.Module([], [])
    return [
        function.name
        for function in ast.walk(tree)
        if isinstance(function, ast.FunctionDef)
        and function.name != mistake.function
        and name in _bound_in(function)
    ]


def _bound_in(function: ast.FunctionDef) -> Iterator[str]:
    for node in ast.walk(function):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id


def _line_below(name: str, mistake: Mistake) -> int:
    """Return a later line of the file itself that would give the name a value, or 0."""
    if mistake.source is None or mistake.frame is None or mistake.function:
        return 0
    line = mistake.source.line_of_binding(name)
    return line if line > mistake.frame.f_lineno else 0


def _visible(names: Iterable[str]) -> list[str]:
    """Return names that a student may have meant: not Python's exceptions and inner names."""
    errors = {name for name, value in vars(builtins).items() if _is_exception(value)}
    return [name for name in names if not name.startswith("_") and name not in errors]


def _is_exception(value: object) -> bool:
    return isinstance(value, type) and issubclass(value, BaseException)


def _the(owner: object) -> str:
    kind = a_kind(owner)
    if isinstance(owner, type):
        return f"The class {owner.__name__}"
    if kind == "a module":
        return f"The module {getattr(owner, '__name__', '')}"
    return kind[0].upper() + kind[1:]
