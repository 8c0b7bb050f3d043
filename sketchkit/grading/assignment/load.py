"""From the folder of an assignment to plain values; every mistake is told with its line."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from sketchkit.grading.assignment.assignment import Assignment, Check, Limits
from sketchkit.grading.assignment.digest import digest_of
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.names import path_within, similar
from sketchkit.grading.assignment.read_check import COMMON_KEYS, read_check
from sketchkit.grading.assignment.table import FILE_NAME, Document, Table

RENDERERS = ("cpu", "gl")
USUAL_DATA = "data"
CHECK_EXAMPLE = '[[checks]], and below it kind = "image", points = 4 and frames = "1,30"'


def load(folder: Path) -> Assignment:
    """Return the assignment in a folder.

    Raises
    ------
    AssignmentError
        If something in it is wrong or missing.
    """
    document = Document(_text(folder), folder)
    table = Table(_parsed(document.text), document)
    title = table.text("title", example='title = "Spinning box"')
    data = _read_data(table)
    assignment = Assignment(
        folder,
        title,
        table.choice("renderer", RENDERERS, "cpu"),
        table.whole("seed", 0, least=-(2**31)),
        _read_limits(table),
        _read_checks(table),
        data,
    )
    table.finish(COMMON_KEYS)
    names = {FILE_NAME, *assignment.references, *(check.events for check in assignment.checks)}
    names |= {data.relative_to(folder).as_posix()} if data else set()
    return replace(assignment, digest=digest_of(folder, names - {""}))


def _text(folder: Path) -> str:
    path = folder / FILE_NAME
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise AssignmentError("It is not written in UTF-8.", hint="Save it as UTF-8.") from None
    except OSError:
        raise AssignmentError(
            f"There is no such file in {folder}.",
            hint=f"Write sketchkit grade init {folder}: it makes one to begin with.",
        ) from None


def _parsed(text: str) -> Mapping[str, object]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        said = re.fullmatch(
            r"(.*?)(?: \(at (?:line (\d+), column \d+|end of document)\))?", str(problem)
        )
        assert said
        raise AssignmentError(
            f"This is no TOML: {said[1][0].lower()}{said[1][1:]}.",
            line=int(said[2]) if said[2] else len(text.splitlines()),
            hint='A line is: name = "text", name = 3, or name = [1, 2]. Comments begin with #.',
        ) from None


def _read_data(table: Table) -> Path | None:
    """Return the folder of data: the one that is named, or `data` if it is there."""
    folder = table.document.folder
    if "data" not in table:
        usual = folder / USUAL_DATA
        return usual if usual.is_dir() else None
    name = table.text("data", "")
    path = path_within(table, "data", name)
    if not path.is_dir():
        raise table.error(f"There is no folder {name} for data.", "data", similar(path))
    return path


def _read_limits(table: Table) -> Limits:
    own = table.table("limits", "limits")
    if own is None:
        return Limits()
    usual = Limits()
    limits = Limits(
        own.number("cpu_s", usual.cpu_s, above=0),
        own.number("wall_s", usual.wall_s, above=0),
        own.whole("memory_mb", usual.memory_mb, least=64),
        own.whole("output_mb", usual.output_mb, least=1),
    )
    own.finish()
    return limits


def _read_checks(table: Table) -> tuple[Check, ...]:
    tables = table.required("checks", CHECK_EXAMPLE)
    if not isinstance(tables, list) or not all(isinstance(own, Mapping) for own in tables):
        raise table.error("checks are tables.", "checks", f"Write {CHECK_EXAMPLE}.")
    if not tables:
        raise table.error("There are no checks.", "checks", f"Write {CHECK_EXAMPLE}.")
    checks: list[Check] = []
    for place, content in enumerate(tables):
        own = Table(content, table.document, ("checks", place), "a check")
        check = read_check(own, place, table)
        if check.name in [other.name for other in checks]:
            raise own.error(
                f"There are two checks {check.name!r}.",
                "name" if "name" in own else None,
                'Give each a name: name = "The box turns".',
            )
        checks.append(check)
    return tuple(checks)
