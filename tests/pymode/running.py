"""Lines of Python 2, run as a sketch's are, but without a sketch."""

import builtins
from textwrap import dedent

from sketchkit.pymode.builtin_names import builtin_names
from sketchkit.pymode.meaning import python_3
from sketchkit.pymode.syntax import convert


def run(text: str, **names: object) -> dict[str, object]:
    """Run a text in which `names` are defined; return what it has defined."""
    tree = python_3(convert(dedent(text), "a.pyde").tree("a.pyde"))
    behind = vars(builtins) | builtin_names(vars(builtins))
    namespace: dict[str, object] = {"__builtins__": behind, "__name__": "a", **names}
    exec(compile(tree, "a.pyde", "exec", dont_inherit=True), namespace)
    return namespace


def value(expression: str, **names: object) -> object:
    """Return the value of an expression."""
    return run(f"result = {expression}", **names)["result"]
