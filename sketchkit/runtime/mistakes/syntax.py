"""What Python cannot read: a colon forgotten, an indentation astray, a line of Java.

The first rule that fits answers. Rules on the line itself come before rules on Python's message,
for what looks like Java or Python 2 is said best as that.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from sketchkit.core.errors import SketchError

JAVA_TYPES = (
    r"(?:int|float|double|long|boolean|char|byte|color|String|void|PVector|PImage|PShape|PFont|"
    r"PShader|PGraphics|ArrayList(?:<\w+>)?|final|public|private|static)"
)


OLDER = " A whole sketch in Python 2 runs with --python-mode."


class LineRule(NamedTuple):
    """What the line looks like, and what to say, with the groups of the pattern in it."""

    pattern: str
    problem: str
    hint: str


class MessageRule(NamedTuple):
    """What Python says, and what to say instead; `hint` may be empty."""

    pattern: str
    problem: str
    hint: str = ""


LINE_RULES = (
    LineRule(
        rf"^\s*{JAVA_TYPES}(?:\[\])?\s+(\w+)\s*\([^)]*\)\s*\{{?",
        "This is how Java defines a function.",
        r"Python writes def \1(): and indents what belongs to it.",
    ),
    LineRule(
        rf"^\s*{JAVA_TYPES}(?:\[\])*\s+(\w+)\s*(?:;|=(?!=)|,)",
        "Python's variables have no type in front of them.",
        r"Write \1 = and its first value.",
    ),
    LineRule(
        r"^\s*for\s*\(.*;.*;",
        "This is Java's for.",
        "Python writes for i in range(10):",
    ),
    LineRule(
        r"^\s*(?://|/\*|\*/)",
        "// and /* begin no comment in Python.",
        "A comment begins with #.",
    ),
    LineRule(r"\S\s+//", "// begins no comment in Python.", "A comment begins with #."),
    LineRule(r"&&", "&& is no operator in Python.", "Write and."),
    LineRule(r"\|\|", "|| is no operator in Python.", "Write or."),
    LineRule(r"(\w+)\s*\+\+", "Python has no ++.", r"Write \1 += 1."),
    LineRule(r"(\w+)\s*--\s*(?:;|$|\))", "Python has no --.", r"Write \1 -= 1."),
    LineRule(r"(?:^|[\s(=])!\s*[\w(]", "! does not mean not in Python.", "Write not."),
    LineRule(r"\belse\s+if\b", "else if is one word in Python.", "Write elif."),
    LineRule(r"\bnew\s+(\w+)\s*\(", "Python makes objects without new.", r"Write \1(...)."),
    LineRule(r"^\s*switch\s*\(", "Python has no switch.", "Write if, elif and else."),
    LineRule(r"\?[^:]*:", "Python has no ? and :.", "Write a if condition else b."),
    LineRule(
        r"^\s*(?:\}\s*)?(?:if|else|while|def|class)\b.*\{\s*$|^\s*\}",
        "Python has no braces around the lines that belong together.",
        "End the first line with a colon, and indent the others.",
    ),
    LineRule(
        r"^\s*print\s+\S",
        "print is a function in Python 3.",
        f"Write print(...), with brackets.{OLDER}",
    ),
    LineRule(
        r"^\s*except\s+\w+\s*,\s*\w+\s*:", "This is Python 2.", f"Write except Error as e:{OLDER}"
    ),
    LineRule(r"^\s*raise\s+\w+\s*,", "This is Python 2.", f"Write raise Error(text).{OLDER}"),
    LineRule(r"^\s*exec\s+\S", "exec is a function in Python 3.", f"Write exec(...).{OLDER}"),
    LineRule(r"<>", "<> is Python 2.", f"Write !=.{OLDER}"),
)

MESSAGE_RULES = (
    MessageRule(r"expected ':'", "This line ends with a colon in Python.", "Write : at its end."),
    MessageRule(
        r"expected an indented block after (.+?)(?: statement| definition)? on line (\d+)",
        r"The line below line \2 must be indented: it belongs to the \1 there.",
        "Put four spaces in front of it.",
    ),
    MessageRule(
        r"unexpected indent",
        "This line is indented, but belongs to nothing above it.",
        "Begin it where the line above it begins.",
    ),
    MessageRule(
        r"unindent does not match any outer indentation level",
        "This line begins at another place than every line above it.",
        "Lines that belong together begin at the same place.",
    ),
    MessageRule(
        r"inconsistent use of tabs and spaces",
        "Tabs and spaces are mixed at the beginning of lines.",
        "Let your editor write four spaces for each step.",
    ),
    MessageRule(
        r"'(.)' was never closed", r"The \1 here is never closed.", "Its partner is missing."
    ),
    MessageRule(r"unmatched '(.)'", r"There is a \1 too many: nothing opens it."),
    MessageRule(
        r"closing parenthesis '(.)' does not match opening parenthesis '(.)'",
        r"\2 is closed by \1: they are no pair.",
    ),
    MessageRule(
        r"unterminated string literal",
        "The text that begins here has no end.",
        "Write the same quotation mark at its end.",
    ),
    MessageRule(
        r"unterminated triple-quoted string literal",
        "The text that begins here has no end.",
        "Write three quotation marks at its end.",
    ),
    MessageRule(
        r"cannot assign to (.+?)(?: here.*)?$",
        r"No value can be given to \1: on the left of = stands a name.",
        "To compare write ==.",
    ),
    MessageRule(
        r"Maybe you meant '==' or ':=' instead of '='|Maybe you meant '==' instead of '='",
        "One = gives a value to a name.",
        "To compare write ==.",
    ),
    MessageRule(
        r"Perhaps you forgot a comma", "Something is missing between these two.", "Perhaps a comma."
    ),
    MessageRule(
        r"invalid decimal literal",
        "A name cannot begin with a digit.",
        "To multiply write *, as in 2 * x.",
    ),
    MessageRule(
        r"leading zeros in decimal integer literals",
        "A whole number does not begin with 0.",
    ),
    MessageRule(
        r"invalid character '(.)'",
        r"The character \1 means nothing in Python.",
        "Quotation marks are straight: \" or '.",
    ),
    MessageRule(
        r"invalid non-printable character U\+(\w+)",
        r"There is an invisible character here (U+\1).",
        "Delete the space at this place and type it again.",
    ),
    MessageRule(
        r"name '(\w+)' is (?:used|assigned to) (?:prior to|before) global declaration",
        r"\1 is used before the line global \1.",
        r"Write global \1 as the first line of the function.",
    ),
    MessageRule(
        r"name '(\w+)' is parameter and global",
        r"\1 is a parameter of the function, so it cannot be global too.",
    ),
    MessageRule(
        r"'(return|yield|break|continue|await)' (outside|not properly in)",
        r"\1 stands outside of a function or loop.",
        "Is its indentation right?",
    ),
    MessageRule(
        r"positional argument follows keyword argument",
        "Values without a name come before those with one.",
    ),
    MessageRule(
        r"(?:unicode error|codec can't decode|encoding problem|Non-UTF-8)",
        "This file is not written in UTF-8.",
        "Save it as UTF-8 in your editor.",
    ),
    MessageRule(
        r"null bytes",
        "This file is not written in UTF-8: it has null bytes in it.",
        "Save it as UTF-8 in your editor.",
    ),
    MessageRule(
        r"unexpected EOF|unexpected end",
        "The file ends too early.",
        "Perhaps a bracket is not closed.",
    ),
)


def explain_syntax(error: SyntaxError) -> str:
    """Return what Python could not read, and in an indented line what to write."""
    line = _without_texts(error.text or "")
    for rule in LINE_RULES:
        if found := re.search(rule.pattern, line):
            return _message(found, rule.problem, rule.hint)
    for message_rule in MESSAGE_RULES:
        if found := re.search(message_rule.pattern, error.msg):
            return _message(found, message_rule.problem, message_rule.hint)
    if error.msg == "invalid syntax":
        return "Python does not understand this line, from the mark on."
    return f"Python does not understand this line: {error.msg}."


def _message(found: re.Match[str], problem: str, hint: str) -> str:
    return SketchError(found.expand(problem), hint=found.expand(hint) or None).message


def _without_texts(line: str) -> str:
    """Return a line in which what stands between quotation marks, or behind #, is gone."""
    return re.sub(r"\"[^\"]*\"|'[^']*'|#.*", '""', line)
