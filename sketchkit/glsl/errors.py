"""A driver's log made into a message for the student: file, line, source line, plain words."""

from __future__ import annotations

import re
from typing import Protocol

from sketchkit.glsl.declarations import Declarations, read_declarations
from sketchkit.glsl.dialect import Modern
from sketchkit.glsl.logs import Complaint, read_log
from sketchkit.glsl.mistakes import Finding, Place, finding_for
from sketchkit.glsl.syntax import syntax_finding
from sketchkit.glsl.tokens import Kind, tokenize

# Complaints that follow from another one: they are told only if there is no other.
_SECONDARY = re.compile(r"non-numeric data type|^type mismatch$|must be numeric", re.IGNORECASE)


class SourceFile(Protocol):
    """A shader as the sketch has it."""

    @property
    def text(self) -> str:
        """What is written in it."""

    @property
    def name(self) -> str:
        """What messages call it."""


def explain(
    log: str,
    vertex_file: SourceFile | None,
    fragment_file: SourceFile | None,
    vertex: Modern | None,
    fragment: Modern | None,
) -> str:
    """Return in plain words why a driver has refused a pair of shaders.

    Parameters
    ----------
    log : str
        The driver's, with the headings of moderngl.
    vertex_file, fragment_file : SourceFile or None
        The sketch's own; None stands for a built-in shader.
    vertex, fragment : Modern or None
        What was compiled of them.
    """
    shaders = {
        stage: (file, modern)
        for stage, file, modern in (
            ("fragment", fragment_file, fragment),
            ("vertex", vertex_file, vertex),
        )
        if file is not None and modern is not None
    }
    complaints = read_log(log)
    plain = [complaint for complaint in complaints if not _SECONDARY.search(complaint.message)]
    complaint = next(iter(plain or complaints), Complaint("", 0, 0, "the shader does not compile"))
    stage = complaint.stage or _stage_meant(complaint.message, list(shaders))
    if stage not in shaders:
        nowhere = Place(stage, "", Declarations(), frozenset())
        return finding_for(complaint.message, nowhere).sentence
    return _explained(complaint, stage, *shaders[stage])


def _stage_meant(message: str, stages: list[str]) -> str:
    """Return the stage that the link's log speaks of."""
    if len(stages) == 1:
        return stages[0]
    lacks_main = re.search(r"\b(vertex|fragment) shader lacks", message)
    return lacks_main[1] if lacks_main else "fragment"


def _explained(complaint: Complaint, stage: str, file: SourceFile, modern: Modern) -> str:
    message = original_names(complaint.message)
    tokens = tokenize(file.text)
    declared = read_declarations(tokens)
    line = modern.source_line(complaint.line) if complaint.line else 0
    lines = file.text.splitlines()
    names = frozenset(token.text for token in tokens if token.kind is Kind.NAME)
    text = lines[line - 1] if 0 < line <= len(lines) else ""
    finding = syntax_finding(modern.text, complaint)
    if finding is None:
        finding = finding_for(message, Place(stage, text, declared, names))
        line = finding.line or line or _declared_line(message, declared)
    else:
        line = modern.source_line(finding.line)
    return _composed(file.name, line, lines, finding)


def original_names(message: str) -> str:
    """Return a message with the student's names in place of those that we gave.

    Examples
    --------
    >>> original_names("`sk_FragColor' undeclared, sk_texture redeclared")
    "`gl_FragColor' undeclared, texture redeclared"
    """
    message = re.sub(r"\bsk_(?=[A-Z])", "gl_", message)
    return re.sub(r"\bsk_(?=[a-z])", "", message)


def _declared_line(message: str, declared: Declarations) -> int:
    """Return the line where a name of a message without a place is declared; 0 if nowhere."""
    quoted = set(re.findall(r"\w+", message))
    lines = declared.functions | {own.name: own.line for own in reversed(declared.variables)}
    return next((line for name, line in lines.items() if name in quoted and name != "main"), 0)


def _composed(name: str, line: int, lines: list[str], finding: Finding) -> str:
    place = f"{name}, line {line}" if line else name
    shown = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    sentence, hint = original_names(finding.sentence), original_names(finding.hint)
    parts = [f"{place}: {sentence}", f"    {shown}" if shown else "", f"    {hint}" if hint else ""]
    return "\n".join(part for part in parts if part)
