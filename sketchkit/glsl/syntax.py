"""Where the syntax of a shader breaks: what drivers report is often a line too late."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sketchkit.core.errors import nearest
from sketchkit.glsl.logs import Complaint
from sketchkit.glsl.mistakes import Finding
from sketchkit.glsl.tokens import Kind, Token, code_of, tokenize
from sketchkit.glsl.vocabulary import STATEMENTS, TYPES

_CLOSING = {"(": ")", "[": "]", "{": "}"}
_SYMBOLS = frozenset("()[]{}.,;:?+-*/%<>=!&|^~#")
_WHOLE_STATEMENTS = frozenset(("return", "true", "false", "break", "continue", "discard"))
_NUMBER = re.compile(
    r"0[xX][0-9a-fA-F]+[uU]?|\d+[uU]?|(?=.*[.eE])[\d.]+([eE][+-]?\d+)?(f|F|lf|LF)?"
)
_SYNTAX = re.compile(r"syntax error|unexpected|expected|invalid token|invalid char|parse", re.I)


def syntax_finding(text: str, complaint: Complaint) -> Finding | None:
    """Return what breaks the syntax of a compiled text, with its line; None if nothing does."""
    tokens = tokenize(text)
    if finding := _open_comment(tokens):
        return finding
    if not _SYNTAX.search(complaint.message):
        return None
    code = code_of(tokens)
    place = _place_of(code, complaint)
    return (
        _stray_letter(code)
        or _missing_semicolon(code, place)
        or _unbalanced(code)
        or _wrong_word(code, place)
    )


def _open_comment(tokens: Sequence[Token]) -> Finding | None:
    last = tokens[-1] if tokens else None
    if last is None or not last.text.startswith("/*") or last.text[2:].endswith("*/"):
        return None
    return Finding("A comment that begins with /* has no */.", "", last.line)


def _stray_letter(code: Sequence[Token]) -> Finding | None:
    """Find a letter that GLSL does not have."""
    for token in code:
        if token.kind is Kind.NUMBER and not _NUMBER.fullmatch(token.text):
            return Finding(f"{token.text} is no number of GLSL.", "", token.line)
        if token.kind is not Kind.SYMBOL or token.text in _SYMBOLS:
            continue
        if token.text in "\"'\u2018\u2019\u201c\u201d":
            return Finding("There is no text in GLSL, so no quotation marks.", "", token.line)
        hint = (
            "Type it again: - is the one beside the 0."
            if token.text in "\u2212\u2013\u2014"
            else ""
        )
        return Finding(f"{token.text} is no letter that GLSL knows.", hint, token.line)
    return None


def _place_of(code: Sequence[Token], complaint: Complaint) -> int:
    """Return which token a complaint means; the end if none."""
    at_line = [place for place, token in enumerate(code) if token.line >= complaint.line]
    if not at_line:
        return len(code)
    if complaint.column:
        place = _place_at_column(code, at_line, complaint)
        # In lines without indentation Mesa counts from 1: what it has met tells.
        is_late = (
            "IDENTIFIER" in complaint.message
            and place
            and (place == len(code) or code[place].kind is not Kind.NAME)
        )
        return place - 1 if is_late else place
    named = re.search(r"at token [\"<](.+?)[\">]|^'(.+?)' :", complaint.message)
    word = (named[1] or named[2]) if named else ""
    on_line = [place for place in at_line if code[place].line == complaint.line]
    return next((place for place in on_line if code[place].text == word), at_line[0])


def _place_at_column(code: Sequence[Token], places: Sequence[int], complaint: Complaint) -> int:
    """Return the token at a column, which Mesa counts from 0, but the first is 1, too."""
    column = complaint.column if complaint.column > 1 else 0
    for place in places:
        if code[place].line > complaint.line or code[place].column >= column:
            return place
    return len(code)


def _missing_semicolon(code: Sequence[Token], place: int) -> Finding | None:
    """Find a statement without its end: the next one begins where it should have gone on."""
    if place == 0:
        return None
    before = code[place - 1]
    follows = code[place] if place < len(code) else None
    is_end = follows is None or follows.line > before.line or follows.text == "}"
    is_complete = before.kind is not Kind.SYMBOL or before.text in ")]"
    if follows is not None and follows.text in "{;":
        return None
    if not is_end or not is_complete or before.text in STATEMENTS - _WHOLE_STATEMENTS:
        return None
    if _depth(code[:place]) != 0:
        return None
    return Finding("A semicolon is missing at the end of the line.", "", before.line)


def _depth(code: Sequence[Token]) -> int:
    """Return how many round and square brackets are open at the end of the current statement."""
    depth = 0
    for token in code:
        if token.text in "{};" and not (token.text == ";" and depth):
            depth = 0
        depth += (token.text in "([") - (token.text in ")]")
    return depth


def _unbalanced(code: Sequence[Token]) -> Finding | None:
    """Find a bracket without its partner; which brace it is the indentation tells."""
    opened: list[Token] = []
    suspect: Token | None = None
    indents = {token.line: token.column for token in reversed(code)}
    for token in code:
        if (
            token.text == ";"
            and opened
            and opened[-1].text in "(["
            and not _is_for(code, opened[-1])
        ):
            return Finding(f"The bracket {opened[-1].text} is not closed.", "", opened[-1].line)
        if token.text in _CLOSING:
            opened.append(token)
        elif token.text in _CLOSING.values():
            if not opened or _CLOSING[opened[-1].text] != token.text:
                return Finding(f"There is a {token.text} too many.", "", token.line)
            last = opened.pop()
            if indents[last.line] > indents[token.line] and suspect is None:
                suspect = last
    if not opened:
        return None
    last = suspect or opened[-1]
    hint = f"A {_CLOSING[last.text]} is missing further down."
    return Finding(f"The bracket {last.text} of this line is not closed.", hint, last.line)


def _is_for(code: Sequence[Token], bracket: Token) -> bool:
    place = next(place for place, token in enumerate(code) if token is bracket)
    return place > 0 and code[place - 1].text == "for"


def _wrong_word(code: Sequence[Token], place: int) -> Finding | None:
    """Find a word that is no type, or that is GLSL's own."""
    if not 0 < place < len(code):
        return None
    before, token = code[place - 1], code[place]
    if token.text in STATEMENTS and before.text in TYPES:
        return Finding(
            f"{token.text} is a word of GLSL's own: it cannot be a name.", "", token.line
        )
    words = (before, token) if token.kind is Kind.NAME else ()
    if words and before.kind is Kind.NAME and before.text not in TYPES | STATEMENTS:
        known = nearest(before.text, TYPES)
        return Finding(
            f"{before.text} is no type.", f"Do you mean {known}?" if known else "", before.line
        )
    if token.kind is Kind.NAME and token.text not in TYPES | STATEMENTS:
        known = nearest(token.text, TYPES)
        if known and before.text in ("uniform", "varying", "attribute", "in", "out", "const"):
            return Finding(f"{token.text} is no type.", f"Do you mean {known}?", token.line)
    return Finding(
        f"Something is wrong before {token.text}.",
        "Is there an operator, a comma or a semicolon missing?",
        token.line,
    )
