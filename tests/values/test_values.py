"""What our functions give, beside what Processing itself gave for the same calls.

`processing_values.json` is the record: `make_processing_values.py` makes it. Processing's numbers
have 32 bits, ours 64; so ours are rounded to 32 bits before they are compared, and then must be the
same. Only where Java rounds in the middle of a sum as well, and we have more digits, is the last
place of the largest number that takes part allowed to differ: those groups are in `STEPS`.
"""

from __future__ import annotations

import ast
import builtins
import json
import math
import struct
import warnings
from collections.abc import Iterator

import pytest

from sketchkit.api.names import names_of
from sketchkit.core import constants
from sketchkit.core.notices import SketchWarning
from tests.api.sketches import new_sketch
from tests.values.calls import every_call
from tests.values.make_processing_values import RECORD

# How many steps of a 32-bit float ours may be away, where Java rounds in between.
STEPS = {
    "ranges": 2,
    "lengths": 2,
    "powers": 16,  # pow(1.1, 20): Java's 1.1 is a little more, and that twenty times
    "angles": 2,  # sin(PI): Java's PI is a little more than the angle of half a turn
    "vectors": 2,
    "curves": 8,  # four products, each rounded
    "matrices": 8,
}

# Calls in which ours is meant to differ, and what it gives.
OURS = {
    "pow(10, 20)": 10**20,  # an int of Python's: all digits
    "exp(100)": math.exp(100),  # Java's float ends at 3.4e38
    "round(1e10)": 10**10,  # Java's int ends at 2147483647
    "round(-1e10)": -(10**10),
    "floor(1e10)": 10**10,
    "ceil(-1e10)": -(10**10),
    "str(PVector(0.5, -2.25, 1e10))": "[ 0.5, -2.25, 10000000000.0 ]",  # Java writes 1.0E10
    # Processing's matrix of a shear is none: one of its rows is 0.
    "s = PMatrix2D(); s.shearX(0.3); s.get([0.0] * 6)": [1.0, math.tan(0.3), 0.0, 0.0, 1.0, 0.0],
}


def recorded() -> dict[str, list[tuple[str, object]]]:
    return json.loads(RECORD.read_text(encoding="utf-8"))


@pytest.mark.parametrize(("group", "calls"), list(every_call()), ids=[g for g, _ in every_call()])
def test_values_are_processings(group: str, calls: list[str]) -> None:
    sketch = new_sketch()
    sketch.take_over()
    scope: dict[str, object] = {"__builtins__": vars(builtins) | names_of(sketch)}
    differences = []

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SketchWarning)  # of ranges that hold no numbers
        for line, theirs in recorded()[group]:
            expected = plain(OURS[line]) if line in OURS else theirs
            ours = plain(value_of(line, scope))
            away = tolerance(line, theirs, STEPS.get(group, 0))
            if not is_same(ours, expected, away):
                differences.append(f"{line}: {ours!r}, Processing {theirs!r}")

    assert [line for line, _ in recorded()[group]] == calls, "make the record anew"
    assert differences == []


def test_there_are_at_least_300_calls() -> None:
    assert sum(len(calls) for calls in recorded().values()) >= 300


def test_each_of_our_differences_is_of_a_recorded_call() -> None:
    lines = {line for calls in recorded().values() for line, _ in calls}

    assert OURS.keys() <= lines


@pytest.mark.parametrize(
    ("ours", "theirs", "away", "same"),
    [
        (1.0, 1.0, 0.0, True),
        (1.0, 1.0000001192092896, 0.0, False),
        (1.0, 1.0000001192092896, 2e-7, True),
        (1, 1.0, 0.0, True),
        (1.0, 1, 0.0, False),
        ("nan", "nan", 0.0, True),
        ([1, "a"], [1, "b"], 0.0, False),
        ([1], [1, 2], 0.0, False),
    ],
)
def test_comparison_finds_a_difference(
    ours: object, theirs: object, away: float, same: bool
) -> None:
    assert is_same(ours, theirs, away) is same


def value_of(line: str, scope: dict[str, object]) -> object:
    """Return the value of the last part of a line."""
    *statements, last = line.split("; ")
    for statement in statements:
        exec(statement, scope)
    return eval(last, scope)


def plain(value: object) -> object:
    """Return a value as the record has it, numbers rounded to 32 bits."""
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, float):
        return single(value) if math.isfinite(value) else str(value)
    if type(value).__name__ == "PVector":
        return {"PVector": [plain(number) for number in value]}
    return [plain(item) for item in value]


def single(number: float) -> float:
    """Return the nearest number of 32 bits; it stays as it is where there is none."""
    try:
        return struct.unpack("<f", struct.pack("<f", number))[0]
    except OverflowError:
        return number


def is_same(ours: object, theirs: object, away: float) -> bool:
    match ours, theirs:
        case (int() | float(), float()):
            return ours == theirs or abs(ours - theirs) <= away
        case (list(), list()):
            return len(ours) == len(theirs) and all(
                is_same(a, b, away) for a, b in zip(ours, theirs, strict=True)
            )
        case ({"PVector": a}, {"PVector": b}):
            return is_same(a, b, away)
    return ours == theirs and type(ours) is type(theirs)


def tolerance(line: str, value: object, steps: int) -> float:
    """Return how far apart two numbers may be: some steps of the largest one that takes part."""
    return steps * 2.0**-24 * max(map(abs, [*_numbers_in(line), *_numbers_of(value)]), default=0.0)


def _numbers_in(line: str) -> Iterator[float]:
    for node in ast.walk(ast.parse(line)):
        match node:
            case ast.Constant(value=int() | float() as number):
                yield number
            case ast.Name(id=name) if isinstance(number := getattr(constants, name, None), float):
                yield number


def _numbers_of(value: object) -> Iterator[float]:
    match value:
        case int() | float():
            yield value
        case {"PVector": items} | [*items]:
            for item in items:
                yield from _numbers_of(item)
