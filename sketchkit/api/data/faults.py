"""Mistakes with what is kept: no such place, no such name, a value of another kind.

The first two are also the errors that Python's own lists and dictionaries raise, so that
`except IndexError` and `except KeyError` catch them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sized
from typing import SupportsFloat, SupportsIndex, SupportsInt

from sketchkit.core.errors import SketchError, kind_of, nearest, shown
from sketchkit.data.malformed import MalformedError


class PlaceError(SketchError, IndexError):
    """There is nothing at a place."""


class MissingNameError(SketchError, KeyError):
    """There is nothing of a name."""


def no_place(name: str, place: object, values: Sized, what: str = "value") -> PlaceError:
    """Return the error for a place beyond the end; `name` is the function's."""
    count = len(values)
    if not count:
        return PlaceError(f"{name}() finds nothing: there is no {what}.", got=f"{name}({place})")
    problem = f"{name}() takes a number from 0 to {count - 1}: there are {count} {what}s."
    if count == 1:
        problem = f"{name}() takes 0 alone: there is 1 {what}."
    return PlaceError(problem, got=f"{name}({shown(place)})")


def no_name(owner: str, kind: str, name: object, names: Iterable[str]) -> MissingNameError:
    """Return the error for a name that nothing has; it tells the nearest, or what names there are.

    Parameters
    ----------
    owner : str
        What has been looked into, at the beginning of a sentence.
    kind : str
        What was looked for: "column", "key".
    name
        Its name.
    names : iterable of str
        The names that there are.
    """
    known = list(names)
    close = nearest(name, known) if isinstance(name, str) else None
    if close:
        hint = f"Do you mean {close!r}?"
    elif known:
        hint = f"There is {', '.join(map(repr, known[:8]))}{', ...' if len(known) > 8 else ''}."
    else:
        hint = None
    return MissingNameError(f"{owner} has no {kind} {shown(name)}.", hint=hint)


def wrong_kind(
    name: str, takes: str, value: object, hint: str | None = None, *, place: object = None
) -> SketchError:
    """Return the error for a value of another kind than a function takes."""
    before = "" if place is None else f"{shown(place)}, "
    return SketchError(
        f"{name}() takes {takes}.",
        got=f"{kind_of(value)}: {name}({before}{shown(value)})",
        hint=hint,
    )


def whole(name: str, value: object, *, place: object = None) -> int:
    """Return a value as a whole number; a fraction is cut off, as Processing does.

    Raises
    ------
    SketchError
        If it is no number; `name` is the function's that it was given to.
    """
    if isinstance(value, SupportsIndex | SupportsInt) and not isinstance(value, str | bytes):
        try:
            return int(value)
        except (ValueError, OverflowError, TypeError):
            pass  # infinity, or an array of many
    hint = f"int({value!r}) makes a number of it." if _is_number_text(value) else None
    raise wrong_kind(name, "a whole number", value, hint, place=place)


def fraction(name: str, value: object, *, place: object = None) -> float:
    """Return a value as a number.

    Raises
    ------
    SketchError
        If it is none; `name` is the function's that it was given to.
    """
    if isinstance(value, SupportsFloat | SupportsIndex) and not isinstance(value, str | bytes):
        try:
            return float(value)
        except (TypeError, OverflowError):
            pass  # an array of many
    hint = f"float({value!r}) makes a number of it." if _is_number_text(value) else None
    raise wrong_kind(name, "a number", value, hint, place=place)


def unreadable(source: str, error: MalformedError, hint: str | None = None) -> SketchError:
    """Return the error for a file, or a text, that does not follow the rules of its format."""
    return SketchError(
        f"{source}, line {error.line}, column {error.column}: {error.problem}.", hint=hint
    )


def _is_number_text(value: object) -> bool:
    if not isinstance(value, str):
        return False
    try:
        float(value)
    except ValueError:
        return False
    return True
