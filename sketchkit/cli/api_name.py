"""A name of sketchkit's, described as its docstring does: how it is called, what it does."""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple, get_overloads

from sketchkit.api.sketch import Sketch
from sketchkit.core.errors import nearest
from sketchkit.reference.instead import BY_ITSELF, instead_of
from sketchkit.reference.names import every_name, names_by_owner
from sketchkit.runtime.visible_names import all_names
from sketchkit.stubs import blank_sketch

WIDTH = 92  # characters of a line
SHOWN = (bool, int, float, str, type(None))
STARS: dict[object, str] = {
    inspect.Parameter.VAR_POSITIONAL: "*",
    inspect.Parameter.VAR_KEYWORD: "**",
}
LEFT_OUT = "Raises"  # a section of docstrings: a mistake is told when it is made


class UnknownNameError(Exception):
    """A name that is not here; the message says what to write, or which is the nearest."""


class Found(NamedTuple):
    """A name and what it stands for."""

    written: str
    value: object


def described(name: str) -> Iterator[str]:
    """Yield lines about a name.

    Parameters
    ----------
    name : str
        As a sketch writes it, `rect` or `rect()`; `PVector.mag`, or `mag` alone.

    Raises
    ------
    UnknownNameError
        If there is none such.
    """
    sketch = blank_sketch()
    names = all_names(sketch)
    found = list(_found(name.strip().removesuffix("()"), sketch, names))
    if not found:
        raise UnknownNameError(_not_here(name.strip().removesuffix("()"), names))
    for place, (written, value) in enumerate(found):
        if place:
            yield ""
        yield from _usage(written, value)
        yield from (f"    {line}".rstrip() for line in _text(value))


def _found(name: str, sketch: Sketch, names: Mapping[str, object]) -> Iterator[Found]:
    """Yield what a name may mean: by itself, or else as a part of each class that has it."""
    owner, _, part = name.rpartition(".")
    if owner:
        kind = names.get(owner)
        if isinstance(kind, type) and hasattr(kind, part):
            yield Found(name, inspect.getattr_static(kind, part))
    elif name in names:
        yield Found(name, _as_defined(name, sketch, names))
    else:
        for title, kind in names.items():
            if isinstance(kind, type) and hasattr(kind, name) and not name.startswith("_"):
                yield Found(f"{title}.{name}", inspect.getattr_static(kind, name))


def _as_defined(name: str, sketch: Sketch, names: Mapping[str, object]) -> object:
    """Return the property behind a live value, which has the docstring; else the value itself."""
    for owner in (type(sketch), type(sketch.canvas)):
        value = inspect.getattr_static(owner, name, None)
        if isinstance(value, property):
            return value
    return names[name]


def _usage(written: str, value: object) -> Iterator[str]:
    """Yield each way to write a name."""
    if isinstance(value, type):
        yield f"{written}{_arguments(value, skips_self=False)}"
    elif isinstance(value, staticmethod) or callable(value):
        plain = getattr(value, "__func__", value)
        is_method = inspect.ismethod(value) or (
            "." in written and not isinstance(value, staticmethod)
        )
        for form in get_overloads(plain) or [plain]:
            yield f"{written}{_arguments(form, skips_self=is_method)}"
    elif isinstance(value, property):
        yield written
    else:
        yield f"{written} = {value!r}"


def _arguments(function: Callable[..., object], *, skips_self: bool) -> str:
    """Return the names of a function's arguments, in brackets."""
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except (TypeError, ValueError):
        return "(...)"
    texts = []
    for parameter in parameters[int(skips_self) :]:
        default = parameter.default
        text = STARS.get(parameter.kind, "") + parameter.name
        if default is not parameter.empty:
            text += f"={default!r}" if isinstance(default, SHOWN) else "=..."
        texts.append(text)
    return f"({', '.join(texts)})"


def _text(value: object) -> Iterator[str]:
    """Yield what a docstring says, and the methods of a class."""
    if not (isinstance(value, type | property | staticmethod) or callable(value)):
        return
    doc = inspect.cleandoc(getattr(value, "__doc__", None) or "").splitlines()
    is_left_out = False
    for line, following in zip(doc, [*doc[1:], ""], strict=True):
        if following and set(following) == {"-"}:
            is_left_out = line == LEFT_OUT
        if not is_left_out:
            yield line
    if isinstance(value, type) and (methods := _methods(value)):
        yield from ("", "Methods", "-------")
        yield from textwrap.wrap(", ".join(methods), WIDTH)


def _methods(kind: type) -> list[str]:
    """Return the names of the methods of a class, but for those of ours."""
    names = (name for name in dir(kind) if "_" not in name)
    return [name for name in names if inspect.isroutine(inspect.getattr_static(kind, name))]


def _not_here(name: str, names: Mapping[str, object]) -> str:
    owner, _, part = name.rpartition(".")
    if instead := instead_of(part, [owner]):
        return f"{name} is not in sketchkit.\n    {instead}"
    if not owner:
        of_classes = [
            f"{entry.written} is not in sketchkit.\n    {instead}"
            for entry in every_name()
            if entry.name == name and (instead := instead_of(name, [entry.owner]))
        ]
        if of_classes:
            return "\n".join(of_classes)
    if part in names_by_owner().get(owner or BY_ITSELF, ()):
        return f"{name} is one of Processing's names that sketchkit has not."
    known = nearest(name, [known for known in names if not known.startswith("_")])
    hint = f"\n    Do you mean {known}?" if known else ""
    return f"There is no {name}, neither here nor in Processing.{hint}"
