"""`sketchkit api`: which of Processing's names are here, and what to write for the others."""

from __future__ import annotations

import json
import sys
import textwrap
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import click

from sketchkit.cli.api_name import UnknownNameError, described
from sketchkit.reference.standing import Entry, Standing, entries
from sketchkit.runtime.visible_names import all_names
from sketchkit.stubs import blank_sketch

TIERS = {
    1: "in Processing's reference, or in coursework",
    2: "in other people's sketches",
    3: "all else that its source makes public",
}
WIDTH = 96  # characters of a line
UNEXPLAINED = "Nothing is said about these yet:"


@click.command(name="api")
@click.argument("name", required=False)
@click.option("--missing", is_flag=True, help="List every name that is not here, whatever tier.")
@click.option("--json", "as_json", is_flag=True, help="Print it for programs.")
def command(name: str | None, missing: bool, as_json: bool) -> None:
    """Say how NAME is used; without one, what sketchkit has of Processing.

    NAME is a function, a value or a class, as rect or mouseX; or a method, as PVector.mag.
    """
    if name is not None:
        _describe(name)
        return
    found = list(entries(all_names(blank_sketch())))
    if as_json:
        click.echo(json.dumps(as_data(found, only_missing=missing), indent=1))
        return
    if not missing:
        click.echo("\n".join(score_lines(found)))
        click.echo("\nNot here, of tiers 1 and 2 (all: --missing), and what to write instead:")
        found = [entry for entry in found if entry.name.tier < max(TIERS)]
    click.echo("\n".join(missing_lines(found)))


def score(found: Iterable[Entry]) -> dict[int, Counter[Standing]]:
    """Return how many names of each tier stand where."""
    counts: dict[int, Counter[Standing]] = {tier: Counter() for tier in TIERS}
    for entry in found:
        counts[entry.name.tier][entry.standing] += 1
    return counts


def score_lines(found: Sequence[Entry]) -> Iterator[str]:
    """Yield the score as a table."""
    yield f"{'tier':<50}{'names':>7}{'here':>7}{'instead':>9}{'missing':>9}"
    for tier, counts in score(found).items():
        numbers = (counts[Standing.HERE], counts[Standing.INSTEAD], counts[Standing.MISSING])
        here, instead, missing = numbers
        title = f"{tier}  {TIERS[tier]}"
        yield f"{title:<50}{sum(numbers):>7}{here:>7}{instead:>9}{missing:>9}"


def missing_lines(found: Iterable[Entry]) -> Iterator[str]:
    """Yield what is not here, by what is said of it."""
    entries_by_sentence: dict[str, list[Entry]] = {}
    for entry in found:
        if entry.standing is not Standing.HERE:
            entries_by_sentence.setdefault(entry.instead or UNEXPLAINED, []).append(entry)
    indent = "    "
    for sentence in sorted(entries_by_sentence, key=lambda text: (text == UNEXPLAINED, text)):
        yield ""
        yield from textwrap.wrap(sentence, WIDTH)
        listed = ", ".join(_together(entries_by_sentence[sentence]))
        yield from textwrap.wrap(listed, WIDTH, initial_indent=indent, subsequent_indent=indent)


def _together(same: Sequence[Entry]) -> list[str]:
    """Return names of which the same is said; a class that is not here stands for all of its."""
    classes = {entry.name.name for entry in same if entry.name.kind == "class"}
    counts = Counter(entry.name.owner for entry in same)
    written = []
    for entry in same:
        if entry.name.owner in classes:
            continue
        count = counts[entry.name.name] if entry.name.kind == "class" else 0
        whole = f" and its {count} name{'s' * (count > 1)}" if count else ""
        written.append(entry.name.written + whole)
    return list(dict.fromkeys(written))


def as_data(found: Iterable[Entry], *, only_missing: bool) -> dict[str, object]:
    """Return score and names, for JSON."""
    found = list(found)
    return {
        "tiers": {
            tier: {standing.name.lower(): counts[standing] for standing in Standing}
            for tier, counts in score(found).items()
        },
        "names": [
            {
                **entry.name._asdict(),
                "standing": entry.standing.name.lower(),
                "instead": entry.instead,
            }
            for entry in found
            if not (only_missing and entry.standing is Standing.HERE)
        ],
    }


def _describe(name: str) -> None:
    try:
        click.echo("\n".join(described(name)))
    except UnknownNameError as error:
        click.echo(str(error), err=True)
        sys.exit(1)
