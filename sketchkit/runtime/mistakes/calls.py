"""Calls that cannot be made, and operators between things that do not go together."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Callable
from types import ModuleType

from sketchkit.core.errors import either, shown, wrong_numbers
from sketchkit.runtime.mistakes.mistake import KINDS, Explanation, Mistake, a_kind

# What a function is often called for with so many values, and the function that does it.
INSTEAD = {("rect", 3): ("a square", "square")}
NUMERIC = re.compile(r"(float|int|None|bool|[| ])+")  # annotations
VARIABLE = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)


def explain_type(mistake: Mistake) -> Explanation | None:
    """Explain a TypeError: the first of the cases that knows it does."""
    for explain in CASES:
        if answer := explain(mistake):
            return answer
    return None


def _not_callable(mistake: Mistake) -> Explanation | None:
    found = re.match(r"'(.+)' object is not callable", mistake.text)
    if not found:
        return None
    name = mistake.called
    if name is None:
        return _brackets_after_value(mistake)
    value = mistake.own.get(name, mistake.names.get(name))
    if name in mistake.own and callable(mistake.names.get(name)):
        return _hidden_function(mistake, name, value)
    if name in mistake.names and name not in mistake.own:
        return Explanation(f"{name} is a value, not a function.", f"Write {name} without brackets.")
    if isinstance(value, list | tuple | dict):
        hint = f"Its items are taken with square brackets: {name}[...]"
        return Explanation(f"{name} is {a_kind(value)}, not a function.", hint)
    got = f"{name} = {shown(value)}"
    return Explanation(f"{name} is {a_kind(value)}, not a function.", got=got)


def _hidden_function(mistake: Mistake, name: str, value: object) -> Explanation:
    if isinstance(value, ModuleType):
        return Explanation(
            f"{name} is the module {value.__name__} here, and hides the function {name}().",
            f"Import it by another name: import {value.__name__} as {name}_module.",
        )
    line = mistake.source.line_of_binding(name) if mistake.source else 0
    return Explanation(
        f"{name} is your own variable here, and hides the function {name}().",
        f"Give the variable of line {line} another name, say my_{name}.",
        got=f"{name} = {shown(value)}",
    )


def _brackets_after_value(mistake: Mistake) -> Explanation:
    what = mistake.written(getattr(mistake.expression, "func", None)) or "This"
    return Explanation(
        f"{what} is no function, so no brackets can follow it.",
        "To multiply write *, as in 2 * (x + 1).",
    )


def _wrong_count(mistake: Mistake) -> Explanation | None:
    """Explain too few, too many or unknown arguments."""
    pattern = r"(?:[\w.]+\.|[\w.<>]+>\.)?(\w+)\(\) (missing|takes|got)"
    found = re.match(pattern, mistake.text)
    if not found or not isinstance(mistake.expression, ast.Call):
        return None
    function = _called_function(mistake, mistake.expression)
    if function is None:
        return None
    name = mistake.written(mistake.expression.func)
    call = mistake.written(mistake.expression)
    if keyword := re.search(r"unexpected keyword argument '(\w+)'", mistake.text):
        return Explanation(f"{name}() has no argument called {keyword[1]}.", got=call)
    counted = len(mistake.expression.args) + len(mistake.expression.keywords)
    is_plain = not any(isinstance(arg, ast.Starred) for arg in mistake.expression.args)
    return Explanation(
        _problem(name, function),
        hint=_instead(mistake.expression, counted) or _where_defined(function, mistake),
        got=f"{counted}: {call}" if is_plain else call,
    )


def _wrong_count_in_c(mistake: Mistake) -> Explanation | None:
    """Explain too few or too many arguments of a function that is written in C."""
    found = re.match(r"(\w+) expected (.+) arguments?, got (\d+)", mistake.text)
    name = mistake.called
    if not found or name is None:
        return None
    module = getattr(mistake.own.get(name), "__module__", None)
    is_hiding = module and callable(mistake.names.get(name))
    return Explanation(
        f"{name}() takes {found[2]} values.",
        hint=f"This is {name}() of {module}; it hides sketchkit's." if is_hiding else None,
        got=f"{found[3]}: {mistake.written(mistake.expression)}",
    )


def _called_function(mistake: Mistake, call: ast.Call) -> Callable[..., object] | None:
    try:
        match call.func:
            case ast.Attribute(value=owner, attr=name):
                function = getattr(mistake.value_of(owner), name)
            case node:
                function = mistake.value_of(node)
    except (LookupError, AttributeError):
        return None
    return inspect.unwrap(function) if callable(function) else None


def _problem(name: str, function: Callable[..., object]) -> str:
    """Return how many values a function takes: as its own file says, or as its signature does."""
    known = getattr(getattr(function, "__func__", function), "__globals__", {})
    usage = known.get(f"{getattr(function, '__name__', name).upper()}_USAGE")
    return wrong_numbers(name, (), usage).problem if usage else f"{name}() {_takes(function)}"


def _instead(call: ast.Call, count: int) -> str | None:
    """Return the call that was probably meant."""
    match call.func:
        case ast.Name(id=name) if (name, count) in INSTEAD:
            shape, function = INSTEAD[name, count]
            meant = ast.unparse(ast.Call(ast.Name(function), call.args, call.keywords))
            return f"For {shape} write {meant}."
    return None


def _takes(function: Callable[..., object]) -> str:
    """Return how many values a function takes, and their names."""
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        return "takes other values."
    if not parameters:
        return "takes nothing between its brackets."
    needed = sum(p.default is p.empty and p.kind not in VARIABLE for p in parameters)
    most = len(parameters)
    if any(parameter.kind in VARIABLE for parameter in parameters):
        count = f"at least {needed}"
    else:
        count = either(range(needed, most + 1))
    is_numeric = all(_is_numeric(parameter) for parameter in parameters)
    noun = "number" if is_numeric else "value"
    return f"takes {count} {noun}{'s' * (count != '1')}: {_usage(parameters)}."


def _is_numeric(parameter: inspect.Parameter) -> bool:
    annotation = parameter.annotation
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    return bool(NUMERIC.fullmatch(text))


def _usage(parameters: list[inspect.Parameter]) -> str:
    """Return names of parameters as messages write them: `x, y [, z]`."""
    usage = ""
    for parameter in parameters:
        is_many = parameter.kind in VARIABLE
        name = f"{parameter.name} ..." if is_many else parameter.name
        is_optional = is_many or parameter.default is not parameter.empty
        separator = ", " if usage else ""
        usage += f" [{separator}{name}]" if is_optional else f"{separator}{name}"
    return usage.strip()


def _where_defined(function: Callable[..., object], mistake: Mistake) -> str | None:
    code = getattr(function, "__code__", None)
    if code is None or mistake.source is None or code.co_filename != str(mistake.source.path):
        return None
    return f"It is defined in line {code.co_firstlineno}."


def _operands(mistake: Mistake) -> Explanation | None:
    """Explain an operator between two things that do not go together."""
    text = mistake.text
    if re.match(r'can only concatenate str \(not "(\w+)"\) to str', text):
        kinds = "str", re.findall(r'not "(\w+)"', text)[0]
        operator = "+"
    elif found := re.match(
        r"unsupported operand type\(s\) for (\S+?): '(.+)' and '(.+)'"
        r"|'(\S+)' not supported between instances of '(.+)' and '(.+)'",
        text,
    ):
        parts = [part for part in found.groups() if part]
        operator, kinds = parts[0], (parts[1], parts[2])
    else:
        return None
    left, right = (KINDS.get(kind, f"a {kind}") for kind in kinds)
    problem = f"{operator} does not work between {left} and {right}."
    return Explanation(problem, _operand_hint(kinds, operator))


def _operand_hint(kinds: tuple[str, str], operator: str) -> str | None:
    if "NoneType" in kinds:
        return "None is what a function gives that ends without return."
    if "str" in kinds and operator == "+":
        return "str(...) makes text of a number, float(...) a number of text."
    if "str" in kinds:
        return "float(...) or int(...) makes a number of text."
    if any(kind in ("function", "method", "builtin_function_or_method") for kind in kinds):
        return "Is there a pair of brackets missing after the function's name?"
    if "list" in kinds or "tuple" in kinds:
        return "A list's items are taken one by one: values[0], values[1]."
    return None


def _whole_number(mistake: Mistake) -> Explanation | None:
    if "'float' object cannot be interpreted as an integer" in mistake.text:
        call = f"{mistake.called}() takes whole numbers." if mistake.called else None
        return Explanation(
            call or "A whole number is needed here.",
            "/ always gives a fraction: write // instead, or int(...).",
        )
    if found := re.match(r"can't multiply sequence by non-int of type '(\w+)'", mistake.text):
        kind = KINDS.get(found[1], found[1])
        return Explanation(
            f"Lists and texts are repeated by whole numbers, not by {kind}.",
            "/ always gives a fraction: write // instead, or int(...).",
        )
    found = re.match(r"(\w+) indices must be integers(?: or slices)?, not '?(\w+)'?", mistake.text)
    if not found:
        return None
    hint = "int(...) or // makes whole numbers." if found[2] == "float" else None
    if found[2] == "str":
        hint = "Names as keys belong to dictionaries: {'name': value}."
    return Explanation(f"The items of a {found[1]} are counted with whole numbers.", hint)


def _number_of_many(mistake: Mistake) -> Explanation | None:
    """Explain `int()` and `float()` of something else than one text or number."""
    found = re.match(r"(int|float)\(\) argument must be .*, not '(.+)'", mistake.text)
    if not found:
        return None
    problem = f"{found[1]}() takes one text or number, not {KINDS.get(found[2], found[2])}."
    if found[2] not in ("list", "tuple"):
        return Explanation(problem)
    parse = {"int": "parseInt", "float": "parseFloat"}[found[1]]
    return Explanation(problem, f"{parse}(...) makes a number of each of its items.")


def _subscript(mistake: Mistake) -> Explanation | None:
    found = re.match(r"'(.+)' object (is not subscriptable|does not support item)", mistake.text)
    if not found:
        return None
    what = mistake.written(getattr(mistake.expression, "value", None)) or "This"
    kind = KINDS.get(found[1], f"a {found[1]}")
    if kind == "a function":
        return Explanation(f"{what} is a function: write {what}(...), with round brackets.")
    if kind == "text":
        return Explanation("The characters of a text cannot be changed one by one.")
    return Explanation(f"{what} is {kind}: it has no items to take with square brackets.")


def _iteration(mistake: Mistake) -> Explanation | None:
    if found := re.match(r"'(.+)' object is not iterable", mistake.text):
        hint = "To count write: for i in range(10):" if found[1] in ("int", "float") else None
        kind = KINDS.get(found[1], f"a {found[1]}")
        return Explanation(f"for goes through lists and the like, not through {kind}.", hint)
    if found := re.match(r"cannot unpack non-iterable (\w+) object", mistake.text):
        kind = KINDS.get(found[1], f"a {found[1]}")
        return Explanation(f"There are several names before the =, but only one value: {kind}.")
    if found := re.match(r"object of type '(\w+)' has no len\(\)", mistake.text):
        return Explanation(f"{KINDS.get(found[1], found[1]).capitalize()} has no length.")
    return None


CASES: tuple[Callable[[Mistake], Explanation | None], ...] = (
    _not_callable,
    _wrong_count,
    _wrong_count_in_c,
    _operands,
    _whole_number,
    _number_of_many,
    _subscript,
    _iteration,
)
