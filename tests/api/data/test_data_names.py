"""All that Processing's reference and its classes have for data is there; the list is its names."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from sketchkit.api.names import names_of
from tests.api.sketches import new_sketch

LIST = Path(__file__).with_name("data_names.csv")


def wanted() -> dict[str, list[str]]:
    members: dict[str, list[str]] = {}
    with LIST.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            members.setdefault(row["owner"], []).append(row["name"])
    return members


def test_functions_and_classes_are_among_the_names_of_a_sketch() -> None:
    assert set(wanted()[""]) <= names_of(new_sketch()).keys()


@pytest.mark.parametrize("owner", [owner for owner in wanted() if owner])
def test_class_has_all_methods(owner: str) -> None:
    kind = names_of(new_sketch())[owner]

    assert [name for name in wanted()[owner] if not hasattr(kind, name)] == []


@pytest.mark.parametrize("owner", [owner for owner in wanted() if owner])
def test_class_is_documented_with_an_example(owner: str) -> None:
    kind = names_of(new_sketch())[owner]

    assert ">>>" in str(kind.__doc__)
    methods = [getattr(kind, name) for name in wanted()[owner]]
    assert [method for method in methods if callable(method) and not method.__doc__] == []
