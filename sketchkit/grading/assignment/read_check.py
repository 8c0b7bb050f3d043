"""One check of `assignment.toml`: what all kinds have in common; the rest its kind reads itself."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import replace
from pathlib import PurePosixPath

from sketchkit.core.errors import either, nearest
from sketchkit.grading.assignment.assignment import Check
from sketchkit.grading.assignment.events_file import read_events
from sketchkit.grading.assignment.names import path_within, similar
from sketchkit.grading.assignment.references import frames_of, sketch_of
from sketchkit.grading.assignment.table import Table, shown
from sketchkit.grading.checks.case import Basis
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.runtime.frame_numbers import parse_frames

LAST_FRAME = 10_000  # nearly three minutes; a class has many sketches
USUAL_REFERENCE = "reference"
COMMON_KEYS = ("frames", "input", "reference")  # the assignment's, unless a check says otherwise


def read_check(table: Table, place: int, whole: Table) -> Check:
    """Return a check.

    Parameters
    ----------
    table : Table
        Its own.
    place : int
        Which it is, from 0.
    whole : Table
        The assignment's, for what is not said in the check.

    Raises
    ------
    AssignmentError
        If something in it is wrong or missing.
    """
    kind_name = _read_kind(table)
    kind = KINDS[kind_name]
    table.noun = f"{'an' if kind_name[0] in 'aeiou' else 'a'} {kind_name} check"
    name = table.text("name", kind_name)
    if not name.strip():
        raise table.error("A check's name is what students read: it has letters.", "name")
    check = Check(
        name,
        f"{place + 1}-{_slug(name)}",
        kind_name,
        table.as_number(table.required("points", "points = 4"), "points", above=0),
        None,
        expect=table.text("expect", ""),
        references=_read_references(table, whole),
    )
    if kind.has_frames:
        check = replace(check, frames=_read_frames(table, whole), events=_read_input(table, whole))
    options = kind.read(table, check)
    table.finish()
    _prove_references(table, check, kind.basis(options))
    return replace(check, options=options)


def _read_kind(table: Table) -> str:
    kind = table.required("kind", f"kind = {either(repr(name) for name in KINDS)}")
    if isinstance(kind, str) and kind in KINDS:
        return kind
    slip = nearest(str(kind), list(KINDS))
    hint = f"Do you mean {slip!r}?" if slip else f"Kinds are {', '.join(KINDS)}."
    raise table.error(f"There is no kind of check {shown(kind)}.", "kind", hint)


def _read_frames(table: Table, whole: Table) -> tuple[int, ...]:
    owner = _owner("frames", table, whole)
    value = owner.value("frames")
    if value is None:
        value = table.required("frames", 'frames = "1,30"')
    items = value if isinstance(value, list) else [value]
    try:
        numbers = parse_frames(",".join(str(item) for item in items))
    except ValueError as problem:
        raise owner.error(f"frames: {problem}", "frames") from None
    if numbers[-1] > LAST_FRAME:
        raise owner.error(
            f"Frame {numbers[-1]:,} is out of reach: the last one is {LAST_FRAME:,}.", "frames"
        )
    return numbers


def _read_input(table: Table, whole: Table) -> str:
    """Return the name of the file of events; "" in a check takes back what holds for all."""
    owner = _owner("input", table, whole)
    name = owner.text("input", "")
    if not name:
        return ""
    path = path_within(owner, "input", name)
    if not path.is_file():
        raise owner.error(f"There is no file {name}.", "input", similar(path))
    read_events(path, name)
    return PurePosixPath(name).as_posix()


def _read_references(table: Table, whole: Table) -> tuple[str, ...]:
    owner = _owner("reference", table, whole)
    names = owner.texts("reference") or (USUAL_REFERENCE,)
    for name in names:
        path = path_within(owner, "reference", name)
        key = "reference" if "reference" in owner else None
        if not path.exists():
            raise owner.error(f"There is no reference {name}.", key, similar(path))
        if sketch_of(path) is None and not frames_of(path):
            raise owner.error(
                f"The reference {name} is no sketch, and has no frames.",
                key,
                "A reference is a Python file, a folder with one, or with frame-0001.png and so "
                "on, as sketchkit render writes them.",
            )
    return tuple(PurePosixPath(name).as_posix() for name in names)


def _prove_references(table: Table, check: Check, basis: Basis) -> None:
    """Refuse references that do not have what the check compares with."""
    for name in check.references:
        path = table.document.folder / name
        if basis is Basis.NOTHING or sketch_of(path) is not None:
            continue
        if basis is Basis.SKETCH:
            raise table.error(
                f"{table.subject} needs a sketch to compare with: the reference {name} is a folder "
                "of pictures.",
                hint="Put the reference's sketch there, or say the numbers here.",
            )
        lacking = [number for number in check.frames if number not in frames_of(path)]
        if lacking:
            raise table.error(
                f"The reference {name} has no frame-{lacking[0]:04d}.png.",
                "frames" if "frames" in table else None,
                f"Render it: sketchkit render SKETCH --frames {lacking[0]} --out {name}.",
            )


def _owner(key: str, table: Table, whole: Table) -> Table:
    """Return the table that says something: the check's, or else the assignment's."""
    return table if key in table else whole


def _slug(name: str) -> str:
    """Return a file name of ASCII letters, digits and `-`."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:40] or "check"
