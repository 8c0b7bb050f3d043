"""Python 2's numbers in texts: `str`, `"%s" % x` and `"{}".format(x)` show at most 12 digits."""

from __future__ import annotations

from typing import Any  # what is formatted is whatever the sketch has


class ShortFloat(float):
    """A number that is written with at most 12 digits; in all else it is a float."""

    def __str__(self) -> str:
        text = f"{float(self):.12g}"
        return f"{text}.0" if text.lstrip("-").isdigit() else text

    def __format__(self, form: str) -> str:
        return format(float(self), form) if form else str(self)


def written(*value: Any) -> str:  # noqa: ANN401 # see the import
    """Return `str(value)`: of a number at most 12 digits."""
    if len(value) > 1 and isinstance(value[0], str):
        return value[0]
    return str(*map(_short, value))


def filled(text: Any, values: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `text % values`."""
    if not isinstance(text, str):
        return text % values
    if isinstance(values, tuple):
        return text % tuple(map(_short, values))
    if type(values) is dict:
        return text % {name: _short(value) for name, value in values.items()}
    return text % _short(values)


def formatted(text: Any, *values: Any, **named: Any) -> Any:  # noqa: ANN401 # see the import
    """Return `text.format(*values, **named)`."""
    if not isinstance(text, str):
        return text.format(*values, **named)
    return text.format(*map(_short, values), **{name: _short(named[name]) for name in named})


def _short(value: Any) -> Any:  # noqa: ANN401 # see the import
    return ShortFloat(value) if type(value) is float else value
