"""What a shader declares outside of its functions, read from its tokens.

Conditions of the preprocessor are not decided: what stands in any branch counts as declared.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from sketchkit.glsl.tokens import Kind, Token, code_of, directives
from sketchkit.glsl.words import PRECISIONS, word_set

STORAGES = ("uniform", "attribute", "varying", "in", "out", "const")
QUALIFIERS = PRECISIONS | word_set(
    """
    uniform attribute varying in out inout const centroid flat smooth noperspective invariant
    precise sample patch coherent volatile restrict readonly writeonly highp mediump lowp
    """
)
UNKNOWN_SIZE = 1024  # of an array whose size is no plain number: more than shaders have room for


class Variable(NamedTuple):
    """A variable, or a member of a struct; `length` is None if it is no array."""

    storage: str
    type: str
    name: str
    length: int | None
    line: int


@dataclass
class Declarations:
    """What a shader declares; functions by name with their lines."""

    variables: list[Variable] = field(default_factory=list)
    functions: dict[str, int] = field(default_factory=dict)
    structs: dict[str, list[Variable]] = field(default_factory=dict)

    def stored(self, *storages: str) -> Iterator[Variable]:
        """Yield the variables with one of the storages, each name once."""
        seen = set()
        for variable in self.variables:
            if variable.storage in storages and variable.name not in seen:
                seen.add(variable.name)
                yield variable


def read_declarations(tokens: Sequence[Token]) -> Declarations:
    """Return what a shader declares."""
    return _Reader(tokens).read()


class _Reader:
    """Walks along the code once, statement by statement."""

    def __init__(self, tokens: Sequence[Token]) -> None:
        self._code = code_of(tokens)
        self._sizes = _defined_numbers(tokens)
        self._found = Declarations()

    def read(self) -> Declarations:
        place, statement = 0, list[Token]()
        while place < len(self._code):
            token = self._code[place]
            if token.text == "{":
                place = self._block(place, statement)
                continue
            if token.text == ";":
                self._statement(statement)
                statement = []
            else:
                statement.append(token)
            place += 1
        return self._found

    def _block(self, place: int, statement: list[Token]) -> int:
        """Read what a brace opens, and return the place behind it."""
        end = _closing(self._code, place)
        words = [token.text for token in statement]
        if "struct" in words:
            self._struct(statement, self._code[place + 1 : end])
        elif words[-1:] == [")"]:
            self._function(statement)
            statement.clear()
        elif "=" not in words:  # a uniform block: its members are set through buffers
            statement[:] = statement[:0]
        return end + 1

    def _struct(self, statement: list[Token], body: list[Token]) -> None:
        """Note a struct; what is declared with it follows behind its name."""
        at = next(place for place, token in enumerate(statement) if token.text == "struct")
        named = statement[at + 1 :]
        name = named[0] if named else statement[at]._replace(text=f"struct at {statement[at].line}")
        self._found.structs[name.text] = [
            member for part in _split(body, ";") for member in self._variables(part)
        ]
        statement[at:] = [name]

    def _function(self, statement: list[Token]) -> None:
        name = _function_name(statement)
        if name is not None:
            self._found.functions.setdefault(name.text, name.line)

    def _statement(self, statement: list[Token]) -> None:
        if _function_name(statement) is not None:
            self._function(statement)
            return
        for variable in self._variables(statement):
            self._found.variables.append(variable)

    def _variables(self, statement: Sequence[Token]) -> Iterator[Variable]:
        """Yield what a statement declares."""
        storage, rest = "", _without_layout(statement)
        while rest and rest[0].text in QUALIFIERS:
            storage = rest[0].text if rest[0].text in STORAGES else storage
            rest = rest[1:]
        if not rest or rest[0].kind is not Kind.NAME:
            return
        kind, (shared, rest) = rest[0].text, self._array(rest[1:])
        for part in _split(rest, ","):
            if part[0].kind is not Kind.NAME:
                return
            own, initializer = self._array(part[1:])
            if storage == "const" and initializer and kind == "int":
                size = _number([token.text for token in initializer[1:]], self._sizes)
                self._sizes |= {} if size is None else {part[0].text: size}
            length = own if shared is None else shared * (own or 1)
            yield Variable(storage, kind, part[0].text, length, part[0].line)

    def _array(self, tokens: Sequence[Token]) -> tuple[int | None, Sequence[Token]]:
        """Cut `[n]`, once or more, off the beginning."""
        length = None
        while tokens and tokens[0].text == "[":
            end = next((at for at, token in enumerate(tokens) if token.text == "]"), len(tokens))
            size = _number([token.text for token in tokens[1:end]], self._sizes)
            length = (length or 1) * (UNKNOWN_SIZE if size is None else size)
            tokens = tokens[end + 1 :]
        return length, tokens


def _closing(code: Sequence[Token], place: int) -> int:
    """Return where the brace at `place` is closed; the end if nowhere."""
    depth = 0
    for at in range(place, len(code)):
        depth += {"{": 1, "}": -1}.get(code[at].text, 0)
        if depth == 0:
            return at
    return len(code)


def _function_name(statement: Sequence[Token]) -> Token | None:
    """Return the name in `type name(`, or None."""
    rest = _without_layout(statement)
    for place, token in enumerate(rest):
        if token.text in ("=", ","):
            return None
        if token.text == "(":
            is_named = place >= 2 and rest[place - 1].kind is Kind.NAME
            return rest[place - 1] if is_named else None
    return None


def _without_layout(statement: Sequence[Token]) -> Sequence[Token]:
    """Return a statement without the `layout(...)` that it begins with."""
    if not statement or statement[0].text != "layout":
        return statement
    end = next((at for at, token in enumerate(statement) if token.text == ")"), len(statement))
    return statement[end + 1 :]


def _split(tokens: Sequence[Token], separator: str) -> Iterator[Sequence[Token]]:
    """Yield what stands between separators that are in no brackets; nothing that is empty."""
    depth, part = 0, list[Token]()
    for token in tokens:
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(token.text, 0)
        if token.text == separator and depth == 0:
            if part:
                yield part
            part = []
        else:
            part.append(token)
    if part:
        yield part


def _defined_numbers(tokens: Sequence[Token]) -> dict[str, int]:
    """Return the whole numbers that have names by `#define`."""
    sizes: dict[str, int] = {}
    for line in directives(tokens):
        if line[0].text == "define" and len(line) > 2:
            size = _number([token.text for token in line[2:]], sizes)
            sizes |= {} if size is None else {line[1].text: size}
    return sizes


_OPERATIONS: dict[type, Callable[[int, int], int]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.floordiv,
}


def _number(words: Sequence[str], sizes: Mapping[str, int]) -> int | None:
    """Return the value of a constant expression in whole numbers, or None."""
    text = " ".join(str(sizes.get(word, word)) for word in words)
    try:
        return _value(ast.parse(text.strip(), mode="eval").body)
    except (SyntaxError, ValueError, ZeroDivisionError):
        return None


def _value(node: ast.expr) -> int:
    match node:
        case ast.Constant(value=int(number)):
            return number
        case ast.BinOp(left, operation, right) if type(operation) in _OPERATIONS:
            return _OPERATIONS[type(operation)](_value(left), _value(right))
    raise ValueError(ast.dump(node))
