"""In which line of a TOML file a value begins, which `tomllib` does not tell."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence

Path = Sequence[str | int]  # ("checks", 1, "tolerance"): keys of tables, places in lists


def line_of(text: str, path: Path) -> int | None:
    r"""Return the line, from 1, in which a value's statement begins; of a table, its header's.

    A value that is not there stands in for the table that it is missing from.

    Examples
    --------
    >>> line_of('title = "A"\n[limits]\nmemory_mb = 1', ("limits", "memory_mb"))
    3
    """
    lines = text.splitlines()
    # The beginning of a file is itself TOML exactly where a statement ends, so that the first
    # beginning which has the value ends with the value's statement.
    starts: dict[int, int] = {}  # by how much of the path there is
    start = 1
    for count in range(1, len(lines) + 1):
        try:
            content = tomllib.loads("\n".join(lines[:count]))
        except tomllib.TOMLDecodeError:
            continue
        for depth in range(1, _depth(content, path) + 1):
            starts.setdefault(depth, start)
        if len(path) in starts:
            break
        start = count + 1
    return starts[max(starts)] if starts else None


def _depth(content: object, path: Path) -> int:
    """Return how many steps of a path lead somewhere."""
    for depth, step in enumerate(path):
        try:
            content = content[step]  # type: ignore[index]  # what is no container raises
        except (KeyError, IndexError, TypeError):
            return depth
    return len(path)
