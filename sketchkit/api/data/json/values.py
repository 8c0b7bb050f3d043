"""What JSONObject and JSONArray share: values of six kinds, the two of them among these."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from os import PathLike
from typing import ClassVar

from sketchkit.api.data.faults import unreadable, wrong_kind
from sketchkit.api.data.lists.value_list import ValueList, Writes
from sketchkit.api.data.saving import save_text
from sketchkit.core.errors import SketchError, kind_of, shown
from sketchkit.core.float32 import f32
from sketchkit.core.notices import warn_once
from sketchkit.data.java_numbers import read_float, read_whole
from sketchkit.data.json_reading import Plain, read_json
from sketchkit.data.json_writing import COMPACT, write_json
from sketchkit.data.malformed import MalformedError

Number = int | float


class JSONValue:
    """An object or an array of JSON. Each of the two makes itself known as what it holds."""

    kinds: ClassVar[dict[type, type[JSONValue]]] = {}

    def __init__(self, plain: object) -> None:
        raise NotImplementedError

    def __init_subclass__(cls, plain: type | None = None) -> None:
        if plain is not None:
            JSONValue.kinds[plain] = cls

    def format(self, indentFactor: int = 2) -> str:
        """Return it as text, with each level moved that far to the right; -1 for a single line."""
        return write_json(self, indentFactor)

    def save(self, file: str | PathLike[str], options: str | None = None) -> bool:
        """Write it into a file; with the option `"compact"`, or `"indent=4"`."""
        save_text("save", file, self.format(_indent(options)))
        return True

    def write(self, output: Writes, options: str | None = None) -> bool:
        """Write it to what `createWriter()` has made; options are those of `save()`."""
        output.write(self.format(_indent(options)))
        return True

    def __str__(self) -> str:
        return self.format(2)

    def __repr__(self) -> str:
        return self.format(COMPACT)


def held(name: str, value: object) -> object:
    """Return a value as JSON can hold it: dictionaries and lists as objects and arrays.

    Raises
    ------
    SketchError
        If JSON has no such values; `name` is the function's that it was given to.
    """
    match value:
        case None | bool() | str() | JSONValue():
            return value
        case int() | float():
            return finite(name, value)
        case Mapping():
            return JSONValue.kinds[dict](value)
        case list() | tuple() | ValueList():
            return JSONValue.kinds[list](value)
    if hasattr(value, "tolist"):  # NumPy's
        return held(name, value.tolist())
    if hasattr(value, "items"):
        return JSONValue.kinds[dict](dict(value.items()))
    takes = "what JSON can hold: text, numbers, True, False, None, lists and dictionaries"
    raise wrong_kind(name, takes, value)


def finite(name: str, value: Number) -> Number:
    """Return a number, or raise that JSON has neither infinity nor NaN."""
    if value - value != 0:
        raise SketchError(
            f"{name}() takes a number that is finite: JSON has no other.", got=f"{value}"
        )
    return value


def single(name: str, value: float) -> float:
    """Return a number in 32 bits, as Processing's `setFloat()` keeps it."""
    return f32(float(finite(name, value)))


def parsed(source: str, text: str, kind: type) -> JSONValue:
    """Return what a text holds.

    Parameters
    ----------
    source : str
        The name of its file, or the function that got it, for messages.
    text : str
        The text.
    kind : type
        What is expected: dict for an object, list for an array.

    Raises
    ------
    SketchError
        If it is no JSON, or something else than expected.
    """
    try:
        plain = read_json(text)
    except MalformedError as error:
        raise unreadable(source, error) from None
    if not isinstance(plain, kind):
        raise _other_kind(source, plain)
    return JSONValue.kinds[kind](plain)


def parsed_or_none(name: str, text: object, kind: type) -> JSONValue | None:
    """Return what a text holds; if it cannot be read, remark on it and return None."""
    if not isinstance(text, str):
        raise wrong_kind(
            name, "text", text, "A file is read by loadJSONObject() or loadJSONArray()."
        )
    try:
        return parsed("The text", text, kind)
    except SketchError as error:
        warn_once(f"{name}() gives None. {error.problem}")
        return None


def as_whole(value: object) -> int | None:
    """Return a number, or a text of one, as a whole number; None if it is neither."""
    if isinstance(value, str):
        return read_whole(value)
    return int(value) if isinstance(value, int | float) and not isinstance(value, bool) else None


def as_fraction(value: object) -> float | None:
    """Return a number, or a text of one; None if it is neither."""
    if isinstance(value, str):
        return read_float(value)
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None


def as_truth(value: object) -> bool | None:
    """Return a truth value, or a text of one; None if it is neither."""
    if isinstance(value, str):
        return {"true": True, "false": False}.get(value.lower())
    return value if isinstance(value, bool) else None


def as_text(value: object) -> str:
    """Return a value of any kind as text, as JSON has it."""
    return value if isinstance(value, str) else write_json(value, 2)


def not_a(call: str, wanted: str, value: object) -> SketchError:
    """Return the error for a value that is there, but of another kind than was asked for."""
    getter = next((g for kinds, g in _GETTERS if isinstance(value, kinds)), None)
    found = "null" if value is None else _worded(value)
    hint = f"Write {getter}(...) for it." if getter and getter not in call else None
    return SketchError(f"{call} finds no {wanted} there.", got=found, hint=hint)


def _worded(value: object) -> str:
    if isinstance(value, JSONValue):
        return kind_of(value)
    return f"{'a truth value' if isinstance(value, bool) else kind_of(value)}: {shown(value)}"


_GETTERS: list[tuple[tuple[type, ...], str]] = [
    ((str,), "getString"),
    ((bool,), "getBoolean"),
    ((int,), "getInt"),
    ((float,), "getFloat"),
    ((Mapping,), "getJSONObject"),
    ((Iterable,), "getJSONArray"),
]


def _other_kind(source: str, plain: Plain) -> SketchError:
    if isinstance(plain, list):
        problem = f"{source} holds an array, [...], and no object, {{...}}."
        return SketchError(problem, hint="Read it as an array: loadJSONArray(), parseJSONArray().")
    if isinstance(plain, dict):
        problem = f"{source} holds an object, {{...}}, and no array, [...]."
        return SketchError(
            problem, hint="Read it as an object: loadJSONObject(), parseJSONObject()."
        )
    return SketchError(f"{source} holds {kind_of(plain)} alone, no object and no array.")


def _indent(options: str | None) -> int:
    """Return the indent that options ask for."""
    indent = 2
    for option in (options or "").split(","):
        name, _, number = option.strip().partition("=")
        if name == "compact":
            indent = COMPACT
        elif name == "indent" and (wanted := read_whole(number)) is not None:
            indent = wanted
        elif option.strip():
            raise SketchError(
                'JSON is saved with the option "compact" or "indent=4".', got=repr(option.strip())
            )
    return indent
