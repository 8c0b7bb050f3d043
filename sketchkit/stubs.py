"""The names of a sketch, written down for editors: `__builtins__.pyi`.

Pyright and Pylance take the names in a file of this name beside a sketch for built-in. It is made
from the same table as the names of a running sketch (`api/names.py`), with `inspect`.
"""

from __future__ import annotations

import inspect
import re
import textwrap
from collections.abc import Callable, Iterator
from typing import get_overloads

from sketchkit.api.graphics import PGraphics
from sketchkit.api.live import live_names
from sketchkit.api.sketch import Sketch
from sketchkit.backends.listing import ListingBackend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.visible_names import all_groups

HEADER = '''\
"""The names that a sketch sees without importing them. Written by sketchkit: do not edit."""

# ruff: noqa
# pyright: reportIncompatibleMethodOverride=none, reportInconsistentConstructor=none
import builtins
from collections.abc import Callable, Iterable
from typing import Self, TypeVar, overload

_T = TypeVar("_T")
'''

# Python has them too, as classes: these must stay classes that can do more.
CLASSES_OF_PYTHON = {
    "set": '''
class set(builtins.set[_T]):
    """Python's set; with three numbers, x, y and a colour, it sets a pixel of the canvas."""

    @overload
    def __init__(self, iterable: Iterable[_T] = ..., /) -> None: ...
    @overload
    def __init__(self, x: float, y: float, color: object, /) -> None: ...
''',
    "filter": '''
class filter(builtins.filter[_T]):
    """Python's filter; with BLUR, GRAY, ... or a shader it changes the picture so far."""

    @overload
    def __new__(cls, function: Callable[[_T], object] | None, items: Iterable[_T], /) -> Self: ...
    @overload
    def __new__(cls, kind: object, level: float = ..., /) -> None: ...
''',
}
AS_IN_PYTHON = frozenset({"open"})  # what editors know of Python's own is right

INDENT = "    "
STARS: dict[object, str] = {
    inspect.Parameter.VAR_POSITIONAL: "*",
    inspect.Parameter.VAR_KEYWORD: "**",
}
SHOWN_DEFAULTS = (bool, int, float, str, type(None))


class Imports:
    """The imports that a stub needs, gathered as its annotations are written."""

    def __init__(self) -> None:
        self._lines: dict[str, str] = {}

    def need(self, annotation: str, function: Callable[..., object]) -> None:
        """Import the names of an annotation from where its function's module has them."""
        known = inspect.unwrap(function).__globals__
        for name in re.findall(r"[A-Za-z_]\w*", annotation):
            value = known.get(name)
            if isinstance(value, type):
                self._lines.setdefault(name, f"from {value.__module__} import {name}")
            elif value is not None:
                self._lines.setdefault(name, f"from {known['__name__']} import {name}")

    def need_class(self, kind: type) -> None:
        """Import a class for an annotation."""
        if kind.__module__ != "builtins":
            self._lines.setdefault(kind.__name__, f"from {kind.__module__} import {kind.__name__}")

    def export(self, kind: type) -> None:
        """Import a class that the sketch itself sees: `as` says so to editors."""
        name = kind.__name__
        self._lines[name] = f"from {kind.__module__} import {name} as {name}"

    def __str__(self) -> str:
        return "\n".join(sorted(self._lines.values()))


def stub() -> str:
    """Return the text of `__builtins__.pyi`."""
    sketch = blank_sketch()
    imports = Imports()
    parts = []
    for group, names in all_groups(sketch).items():
        parts.append(f"\n# {group}\n")
        for name, value in sorted(names.items()):
            if name not in AS_IN_PYTHON:
                parts.append(_declaration(name, value, imports))
    parts.append("\n# live values\n")
    for owner in (type(sketch), type(sketch.canvas)):
        parts += [_live_value(name, owner, imports) for name in live_names(owner)]
    return "\n".join([HEADER + str(imports), *(part for part in parts if part)]) + "\n"


def blank_sketch() -> Sketch:
    """Return a sketch that draws nothing and does nothing, to look at its names."""
    return Sketch(blank_canvas())


def blank_canvas() -> PGraphics:
    """Return a canvas that draws nothing."""
    return PGraphics(Renderer(ListingBackend()), Target(1, 1))


def _declaration(name: str, value: object, imports: Imports) -> str:
    if name in CLASSES_OF_PYTHON:
        return CLASSES_OF_PYTHON[name]
    if isinstance(value, type):
        imports.export(value)
        return ""
    if inspect.isroutine(value):
        return _function(name, value, imports)
    imports.need_class(type(value))
    return f"{name}: {type(value).__name__}"


def _function(name: str, function: Callable[..., object], imports: Imports) -> str:
    plain = getattr(function, "__func__", function)
    overloads = get_overloads(plain)
    if not overloads:
        return _definition(name, plain, inspect.signature(function), imports, plain.__doc__)
    *first, last = overloads
    definitions = [
        "@overload\n" + _definition(name, form, _as_called(form, function), imports, doc)
        for form, doc in [*((form, None) for form in first), (last, plain.__doc__)]
    ]
    return "\n".join(definitions)


def _as_called(form: Callable[..., object], function: Callable[..., object]) -> inspect.Signature:
    """Return the signature of an overload, without `self` if the function is a method."""
    signature = inspect.signature(form)
    if not inspect.ismethod(function):
        return signature
    return signature.replace(parameters=list(signature.parameters.values())[1:])


def _definition(
    name: str,
    function: Callable[..., object],
    signature: inspect.Signature,
    imports: Imports,
    doc: str | None,
) -> str:
    parameters = ", ".join(_parameters(signature, function, imports))
    returned = _annotation(signature.return_annotation, function, imports)
    head = f"def {name}({parameters}) -> {returned}:"
    return f"{head} ..." if doc is None else f"{head}\n{_docstring(doc)}"


def _parameters(
    signature: inspect.Signature, function: Callable[..., object], imports: Imports
) -> Iterator[str]:
    parameters = list(signature.parameters.values())
    is_after_star = False
    for place, parameter in enumerate(parameters):
        if parameter.kind is parameter.KEYWORD_ONLY and not is_after_star:
            yield "*"
        is_after_star |= parameter.kind in (parameter.KEYWORD_ONLY, parameter.VAR_POSITIONAL)
        text = STARS.get(parameter.kind, "") + parameter.name
        if parameter.annotation is not parameter.empty:
            text += f": {_annotation(parameter.annotation, function, imports)}"
        if parameter.default is not parameter.empty:
            text += f" = {_default(parameter.default)}"
        yield text
        following = parameters[place + 1].kind if place + 1 < len(parameters) else None
        if parameter.kind is parameter.POSITIONAL_ONLY and following is not parameter.kind:
            yield "/"


def _annotation(annotation: object, function: Callable[..., object], imports: Imports) -> str:
    if annotation is inspect.Parameter.empty:
        return "object"
    if isinstance(annotation, str):
        text = annotation
    else:  # of a module without `from __future__ import annotations`: its names are spelt out
        text = re.sub(r"~|(?:\w+\.)+(?=\w)", "", inspect.formatannotation(annotation))
    imports.need(text, function)
    return text


def _default(value: object) -> str:
    return repr(value) if isinstance(value, SHOWN_DEFAULTS) and value == value else "..."


def _live_value(name: str, owner: type, imports: Imports) -> str:
    getter = getattr(owner, name).fget
    kind = _annotation(inspect.signature(getter).return_annotation, getter, imports)
    return f"{name}: {kind}\n{_docstring(getter.__doc__ or '', indent='')}"


def _docstring(text: str, indent: str = INDENT) -> str:
    quoted = inspect.cleandoc(text).replace("\\", "\\\\").replace('"""', r"\"\"\"")
    return textwrap.indent(f'"""{quoted}\n"""', indent)
