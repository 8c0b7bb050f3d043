"""JSON written as text, laid out as Processing does."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sketchkit.data.java_numbers import shortest_text

COMPACT = -1  # an indent: everything in one line

_MARKS = {'"': '\\"', "\\": "\\\\", "\b": "\\b", "\t": "\\t", "\n": "\\n", "\f": "\\f", "\r": "\\r"}


def quote(text: str) -> str:
    r"""Return a text in quotes, as JSON has it.

    Examples
    --------
    >>> print(quote('say "hi"\n</b>'))
    "say \"hi\"\n<\/b>"
    """
    return '"' + "".join(map(_escaped, text)).replace("</", "<\\/") + '"'


def write_json(value: object, indent: int, margin: int = 0) -> str:
    """Return a value as JSON; what is no mapping, list, number or truth value is written as text.

    Parameters
    ----------
    value
        What to write.
    indent : int
        How many spaces each level is moved to the right; `COMPACT` for one line.
    margin : int
        How far the value itself is moved.

    Examples
    --------
    >>> print(write_json({"a": [1, 2.0], "b": {"c": None}}, 2))
    {
      "a": [
        1,
        2
      ],
      "b": {"c": null}
    }
    >>> write_json({"a": [1, True]}, COMPACT)
    '{"a":[1,true]}'
    """
    match value:
        case None:
            return "null"
        case bool():
            return "true" if value else "false"
        case int():
            return str(value)
        case float():
            return shortest_text(value)
        case str():
            return quote(value)
        case Mapping():
            colon = ": " if indent > 0 else ":"
            inner = margin + max(indent, 0) * (len(value) > 1)
            parts = [
                f"{quote(str(name))}{colon}{write_json(part, indent, inner)}"
                for name, part in value.items()
            ]
            return _enclosed("{", parts, "}", indent, margin)
        case Iterable():
            items = list(value)
            inner = margin + max(indent, 0) * (len(items) > 1)
            written = [write_json(item, indent, inner) for item in items]
            return _enclosed("[", written, "]", indent, margin)
        case _:
            return quote(str(value))


def _enclosed(opening: str, parts: list[str], closing: str, indent: int, margin: int) -> str:
    """Return parts between brackets: each on a line of its own if there are two or more."""
    if len(parts) < 2 or indent == COMPACT:
        return opening + ",".join(parts) + closing
    start = "\n" + " " * (margin + indent)
    return opening + start + f",{start}".join(parts) + "\n" + " " * margin + closing


def _escaped(mark: str) -> str:
    if mark in _MARKS:
        return _MARKS[mark]
    # control characters, and those that end lines or change the direction of writing
    needs_code = mark < " " or "\u0080" <= mark < "\u00a0" or "\u2000" <= mark < "\u2100"
    return f"\\u{ord(mark):04x}" if needs_code else mark
