"""Calls as they stand in the sketch: file, line, function, and the call's own text."""

from __future__ import annotations

import ast
import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import CodeType

from sketchkit.runtime.explore.noting import Call, Chain
from sketchkit.runtime.source import Position, Source

LONGEST = 72  # characters of a call that are shown


@dataclass(frozen=True)
class Texts:
    """The texts of a sketch, by file name.

    Attributes
    ----------
    now : mapping
        What it runs.
    former : sequence of mapping
        What it ran before a saved text took its place: some of the picture may come from there.
    """

    now: Mapping[str, Source]
    former: Sequence[Mapping[str, Source]] = ()

    def of(self, code: CodeType) -> Source | None:
        """Return the text that some code was made from."""
        name = code.co_filename
        now = self.now.get(name)
        if now is None or not self.former or id(code) in now.parts:
            return now
        sources = (texts[name] for texts in reversed(self.former) if name in texts)
        return next((source for source in sources if id(code) in source.parts), now)


@dataclass(frozen=True)
class Site:
    """A call in the sketch.

    Attributes
    ----------
    file : str
        The name of its file.
    line : int
        From 1.
    function : str
        The function of the sketch that it stands in; "" outside of all.
    text : str
        The call, on one line: `rect(10, 10, 20, 20)`.
    name : str
        What is called: `rect`.
    times : int
        How often it stands in a row, in a recursion.
    """

    file: str
    line: int
    function: str
    text: str
    name: str
    times: int = 1

    @property
    def place(self) -> str:
        """File and line: `spinning.py, line 14`."""
        return f"{self.file}, line {self.line}"

    @property
    def where(self) -> str:
        """The function in words."""
        return f"in {self.function}()" if self.function else "outside of all functions"


def sites(chain: Chain, texts: Texts) -> list[Site]:
    """Return the calls of a chain, innermost first; equal ones that follow each other are one."""
    single = [_site(call, texts) for call in chain]
    grouped = [(site, len(list(same))) for site, same in itertools.groupby(single)]
    return [
        Site(site.file, site.line, site.function, site.text, site.name, count)
        for site, count in grouped
    ]


def _site(call: Call, texts: Texts) -> Site:
    code = call.code
    source = texts.of(code)
    position = position_of(call)
    line = position.line if position else code.co_firstlineno
    function = "" if code.co_name == "<module>" else code.co_qualname.replace(".<locals>", "")
    text, name = "", ""
    if source is not None:
        node = source.expression_at(position)
        if isinstance(node, ast.Call):
            text = ast.get_source_segment(_text(source), node) or ""
            name = ast.unparse(node.func)
        text = text or source.line(line).strip()
    return Site(Path(code.co_filename).name, line, function, shortened(text), name)


def position_of(call: Call) -> Position | None:
    """Return which part of its file a call is."""
    positions = call.code.co_positions()
    parts = next(itertools.islice(positions, call.instruction // 2, None), (None,) * 4)
    line, end_line, column, end_column = parts
    if line is None or end_line is None or column is None or end_column is None:
        return None
    return Position(line, end_line, column, end_column)


def _text(source: Source) -> str:
    return "\n".join(source.lines)


def shortened(text: str) -> str:
    """Return a text on one line, and not longer than is shown."""
    line = " ".join(text.split())
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 4]} ..."


def shape_begin(endshape: Call, texts: Texts) -> int | None:
    """Return the line of the `beginShape()` that an `endShape()` belongs to, if it is plain.

    It is the last one before it in the same function.
    """
    source, position = texts.of(endshape.code), position_of(endshape)
    if source is None or position is None:
        return None
    first = endshape.code.co_firstlineno if endshape.code.co_name != "<module>" else 1
    lines = [
        node.lineno
        for node in ast.walk(source.tree)
        if isinstance(node, ast.Call)
        and ast.unparse(node.func).split(".")[-1] == "beginShape"
        and first <= node.lineno <= position.line
    ]
    return max(lines, default=None)
