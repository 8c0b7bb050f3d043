"""JSON read from text.

Strict JSON is what Python's own reader reads. Processing's takes more: names and texts in single
quotes or in none, a comma too many, `=` for `:`. What is not strict is read here the slow way,
which also knows where something is wrong.
"""

from __future__ import annotations

import json
import re
from typing import NoReturn

from sketchkit.data.java_numbers import read_float, read_whole
from sketchkit.data.malformed import MalformedError, malformed_at

Plain = dict[str, "Plain"] | list["Plain"] | str | int | float | bool | None

DEEPEST = 200  # objects and lists within each other

_ESCAPES = {"b": "\b", "t": "\t", "n": "\n", "f": "\f", "r": "\r"}
_SAME = "\"'\\/"  # escaped, they stand for themselves
_BLANKS = re.compile(r"[\x00-\x20\ufeff]*")
_BARE = re.compile(r"""[^\x00-\x1f,:\]}/\\"\[{;=#]*""")
_IN_QUOTES = re.compile(r"[^\"'\\\n\r]+")
_HEX = re.compile(r"[0-9a-fA-F]{4}")


def read_json(text: str) -> Plain:
    """Return what a text in JSON stands for.

    Raises
    ------
    MalformedError
        If it is none; also if a name is there twice in one object.

    Examples
    --------
    >>> read_json('{"a": [1, 2.5, true, null]}')
    {'a': [1, 2.5, True, None]}
    >>> read_json("{name: 'Ann', size => 3,}")
    {'name': 'Ann', 'size': 3}
    """
    try:
        strict: Plain = json.loads(text, object_pairs_hook=_distinct, parse_constant=_refuse)
    except (ValueError, RecursionError):
        return _Reader(text).read()
    return strict


def _distinct(pairs: list[tuple[str, Plain]]) -> Plain:
    members = dict(pairs)
    if len(members) < len(pairs):
        _refuse("")
    return members


def _refuse(_: str) -> NoReturn:
    raise ValueError


class _Reader:
    """Reads a text, from its beginning on."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._place = 0

    def read(self) -> Plain:
        self._skip_blanks()
        if self._place == len(self._text):
            raise self._error("There is nothing in it")
        value = self._value(0)
        self._skip_blanks()
        if self._place < len(self._text):
            raise self._error("Something follows behind its end")
        return value

    def _value(self, depth: int) -> Plain:
        self._skip_blanks()
        if depth > DEEPEST:
            raise self._error(f"More than {DEEPEST} lists and objects lie within each other")
        match self._text[self._place : self._place + 1]:
            case "{":
                return self._object(depth)
            case "[":
                return self._list(depth)
            case '"' | "'":
                return self._quoted()
            case _:
                return self._bare()

    def _object(self, depth: int) -> Plain:
        members: dict[str, Plain] = {}
        self._place += 1
        while not self._takes("}"):
            start = self._place
            name = self._name()
            if name in members:
                raise self._error(f'The name "{name}" is there twice in one object', start)
            if not (self._takes("=>") or self._takes("=") or self._takes(":")):
                raise self._error(f'A colon (:) is missing behind the name "{name}"')
            members[name] = self._value(depth + 1)
            if not self._goes_on("}", "object"):
                break
        return members

    def _list(self, depth: int) -> Plain:
        values: list[Plain] = []
        self._place += 1
        while not self._takes("]"):
            is_left_out = self._text.startswith(",", self._place)
            values.append(None if is_left_out else self._value(depth + 1))
            if not self._goes_on("]", "list"):
                break
        return values

    def _goes_on(self, end: str, kind: str) -> bool:
        """Read a comma, or what ends a list or an object; return whether it was a comma."""
        if self._takes(end):
            return False
        if not (self._takes(",") or self._takes(";")):
            if self._place == len(self._text):
                raise self._error(f"The {kind} does not end: {end} is missing")
            raise self._error(f"A comma or {end} is missing in this {kind}")
        return True

    def _name(self) -> str:
        self._skip_blanks()
        if self._text[self._place : self._place + 1] in ('"', "'"):
            return self._quoted()
        if not (name := self._bare_text()):
            raise self._error('A name in quotes ("...") is missing')
        return name

    def _quoted(self) -> str:
        start = self._place
        quote = self._text[start]
        self._place += 1
        pieces: list[str] = []
        while True:
            if found := _IN_QUOTES.match(self._text, self._place):
                pieces.append(found[0])
                self._place = found.end()
            match self._text[self._place : self._place + 1]:
                case "" | "\n" | "\r":
                    raise self._error("A text in quotes is not closed in its line", start)
                case "\\":
                    pieces.append(self._escaped())
                case mark:
                    self._place += 1
                    if mark == quote:
                        return _whole_marks("".join(pieces))
                    pieces.append(mark)

    def _escaped(self) -> str:
        start = self._place
        mark = self._text[start + 1 : start + 2]
        self._place += 2
        if mark == "u":
            if not (digits := _HEX.match(self._text, self._place)):
                raise self._error(r"Four hexadecimal digits are missing behind \u", start)
            self._place = digits.end()
            return chr(int(digits[0], 16))
        if mark in _ESCAPES:
            return _ESCAPES[mark]
        if mark and mark in _SAME:
            return mark
        raise self._error(rf"\{mark} means nothing in a text; for a backslash write \\", start)

    def _bare(self) -> Plain:
        """Read a number, true, false or null; anything else is text without quotes."""
        if not (text := self._bare_text()):
            raise self._error("A value is missing")
        words: dict[str, Plain] = {"true": True, "false": False, "null": None}
        if text.lower() in words:
            return words[text.lower()]
        if (whole := read_whole(text)) is not None:
            return whole
        number = read_float(text) if text[0] in "+-.0123456789" else None
        return text if number is None or number - number != 0 else number

    def _bare_text(self) -> str:
        found = _BARE.match(self._text, self._place)
        assert found is not None
        self._place = found.end()
        return found[0].strip()

    def _takes(self, mark: str) -> bool:
        self._skip_blanks()
        is_there = self._text.startswith(mark, self._place)
        self._place += len(mark) * is_there
        return is_there

    def _skip_blanks(self) -> None:
        found = _BLANKS.match(self._text, self._place)
        assert found is not None
        self._place = found.end()

    def _error(self, problem: str, place: int | None = None) -> MalformedError:
        return malformed_at(self._text, self._place if place is None else place, problem)


def _whole_marks(text: str) -> str:
    r"""Return a text in which the two halves of a mark, as \ud83d\ude00 has them, are one."""
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "surrogatepass")
