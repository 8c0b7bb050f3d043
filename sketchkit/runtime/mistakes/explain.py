"""Which function explains which kind of error."""

from __future__ import annotations

from collections.abc import Callable

from sketchkit.core.errors import SketchError
from sketchkit.runtime.mistakes.calls import explain_type
from sketchkit.runtime.mistakes.mistake import Explanation, Mistake
from sketchkit.runtime.mistakes.unknown_names import (
    explain_attribute,
    explain_import,
    explain_name,
    explain_unbound_local,
)
from sketchkit.runtime.mistakes.values import (
    explain_assertion,
    explain_division,
    explain_file,
    explain_index,
    explain_interrupt,
    explain_key,
    explain_memory,
    explain_recursion,
    explain_value,
)

EXPLANATIONS: dict[type[BaseException], Callable[[Mistake], Explanation | None]] = {
    AssertionError: explain_assertion,
    AttributeError: explain_attribute,
    FileNotFoundError: explain_file,
    ImportError: explain_import,
    IndexError: explain_index,
    KeyError: explain_key,
    KeyboardInterrupt: explain_interrupt,
    MemoryError: explain_memory,
    NameError: explain_name,
    RecursionError: explain_recursion,
    TypeError: explain_type,
    UnboundLocalError: explain_unbound_local,
    ValueError: explain_value,
    ZeroDivisionError: explain_division,
}

# What arguments that a function of sketchkit did not expect may raise in it.
OF_ARGUMENTS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)


def explain(mistake: Mistake) -> str:
    """Return what was wrong; in an indented line what was received and what to do about it."""
    error = mistake.error
    if isinstance(error, SketchError):
        return error.message
    if mistake.is_inside and mistake.called and isinstance(error, OF_ARGUMENTS):
        problem = f"{mistake.called}() cannot work with these values ({error})."
        return SketchError(problem, got=mistake.written(mistake.expression)).message
    for kind in type(error).__mro__:
        explanation = EXPLANATIONS[kind](mistake) if kind in EXPLANATIONS else None
        if explanation:
            problem, hint, got = explanation
            return SketchError(problem, got=got, hint=hint).message
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
