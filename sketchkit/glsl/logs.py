"""What drivers say of a shader that they refuse, read from their logs.

Understood: Mesa (Intel and AMD on Linux), NVIDIA, AMD and Intel on Windows, Apple, ANGLE.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple


class Complaint(NamedTuple):
    """One error of a log.

    Attributes
    ----------
    stage : str
        `vertex` or `fragment`; empty, if the log does not tell or the two do not fit.
    line : int
        Of the text that was compiled, from 1; 0 if the log does not tell.
    column : int
        From 1; 0 if the log does not tell, as all but Mesa's do not.
    message : str
        In the driver's words.
    """

    stage: str
    line: int
    column: int
    message: str


# Mesa `0:12(5): error: ...`, NVIDIA `0(12) : error C1008: ...`, the others `ERROR: 0:12: ...`.
_PLACED = re.compile(
    r"(?P<before>ERROR|WARNING|INFO|NOTE)?:?\s*\d+(?::(?P<a>\d+)(?:\((?P<column>\d+)\))?|\((?P<b>\d+)\))"
    r"\s*:\s*(?P<message>.*)",
    re.IGNORECASE,
)
_GRADE = re.compile(
    r"(?:preprocessor |internal )?(?P<grade>error|warning|note)\s*(?:C\d+|\(#?\d+\))?\s*:?\s*",
    re.IGNORECASE,
)
_STAGE = re.compile(r"(vertex|fragment)(?:_shader| info| shader)?\W*$", re.IGNORECASE)
_NO_MESSAGE = re.compile(
    r"\W*$|GLSL \w+ failed$|program\W*$|.*compilation terminated|.*no code generated"
    r"|.*compilation errors|.*not successfully compiled|.*failed to (?:link|compile)"
    r"|(?:vertex|fragment) shader\(s\) (?:linked|failed)|link info$",
    re.IGNORECASE,
)


def read_log(log: str) -> list[Complaint]:
    """Return the errors of a log; a line that says no more than that it failed is none."""
    return list(_complaints(log))


def _complaints(log: str) -> Iterator[Complaint]:
    stage = ""
    for line in map(str.strip, log.splitlines()):
        if heading := _STAGE.match(line):
            stage = heading[1].lower()
            continue
        if _NO_MESSAGE.match(line):
            stage = "" if re.match(r"program\b", line, re.IGNORECASE) else stage
            continue
        placed = _PLACED.match(line)
        message = placed["message"] if placed else line
        grade = _GRADE.match(message)
        words = {placed["before"] if placed else None, grade["grade"] if grade else None}
        if {str(word).lower() for word in words} & {"warning", "note", "info"}:
            continue
        if grade is not None:
            message = message[grade.end() :]
        if placed is None:
            yield Complaint(stage, 0, 0, re.sub(r"^ERROR:\s*", "", message, flags=re.IGNORECASE))
        else:
            number = int(placed["a"] or placed["b"])
            yield Complaint(stage, number, int(placed["column"] or 0), message)
