"""Every name of Processing's that is in common use is here, documented and tried; or it is said
what to write instead.

Names of tier 1 are in Processing's reference, or used by coursework; those of tier 2 are used by
other sketches.
"""

from __future__ import annotations

import inspect
import re
from functools import cache
from pathlib import Path

import pytest

from sketchkit.api.names import joined
from sketchkit.api.sketch import Sketch
from sketchkit.reference.names import Name, every_name
from sketchkit.reference.standing import KNOWN_AS, Standing, entries, is_here
from sketchkit.runtime.visible_names import all_groups, all_names
from tests.canvases import flat_canvas

TESTS = Path(__file__).parents[1]
COMMON = 2  # the last tier that counts

# Not here yet, and nothing is said about it.
AWAITED: frozenset[str] = frozenset()


@cache
def names() -> dict[str, object]:
    sketch = Sketch(flat_canvas())
    return all_names(sketch)


@cache
def functions() -> dict[str, object]:
    return joined(all_groups(Sketch(flat_canvas())))


def common_names() -> list[Name]:
    """Return the names that are here and can have a docstring, or be tried."""
    kinds = ("class", "function", "method", "variable")
    return [
        entry
        for entry in every_name()
        if entry.tier <= COMMON and entry.kind in kinds and is_here(entry, names())
    ]


@cache
def words_of_tests() -> frozenset[str]:
    texts = [path.read_text(encoding="utf-8") for path in TESTS.rglob("*.py")]
    return frozenset(word for text in texts for word in re.findall(r"\w+", text))


@cache
def words_of_examples() -> frozenset[str]:
    """Return the words in the examples of all docstrings: they are run as tests."""
    folders = [TESTS.parent / "sketchkit" / name for name in ("api", "libraries")]
    paths = [path for folder in folders for path in folder.rglob("*.py")]
    lines = [line for path in paths for line in path.read_text("utf-8").splitlines()]
    code = [line for line in lines if line.strip().startswith((">>>", "..."))]
    return frozenset(word for line in code for word in re.findall(r"\w+", line))


def found(name: Name) -> object:
    """Return what a name stands for; as it is defined, where it is a part of a class."""
    if not name.owner:
        return names()[name.name]
    return inspect.getattr_static(names()[KNOWN_AS.get(name.owner, name.owner)], name.name)


parametrized = pytest.mark.parametrize(
    "name", [pytest.param(name, id=name.written) for name in common_names()]
)


@parametrized
def test_name_is_documented_with_an_example(name: Name) -> None:
    if name.kind == "variable" or not (name.owner or name.name in functions()):
        return  # values are tested in tests/api; the others are Python's own

    assert "Examples\n" in (found(name).__doc__ or "")


@parametrized
def test_name_is_tried(name: Name) -> None:
    assert name.name in words_of_tests() | words_of_examples()


def test_every_name_is_here_or_it_is_said_what_to_write() -> None:
    missing = [
        entry.name.written
        for entry in entries(names())
        if entry.standing is Standing.MISSING and entry.name.written not in AWAITED
    ]

    assert missing == []


def test_most_names_in_common_use_are_here() -> None:
    common = [entry for entry in entries(names()) if entry.name.tier <= COMMON]
    libraries = [entry for entry in common if entry.name.category.startswith("library:")]

    here = sum(entry.standing is Standing.HERE for entry in common)

    assert here >= 966
    assert len(common) - len(libraries) == 938
