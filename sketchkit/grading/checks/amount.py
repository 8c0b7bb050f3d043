"""How many are expected: `3`, `">= 3"`, `"2..5"`, `"as in the reference"`."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from sketchkit.grading.assignment.table import Table, shown

AS_IN_THE_REFERENCE = "as in the reference"
FORMS = f'Write 3, ">= 3", "> 3", "<= 3", "< 3", "2..5" or "{AS_IN_THE_REFERENCE}".'


@dataclass(frozen=True)
class Amount:
    """A range of whole numbers, both ends within it.

    Attributes
    ----------
    low : int
    high : float
        Infinity if there is no upper end.
    """

    low: int
    high: float

    def __contains__(self, number: float) -> bool:
        return self.low <= number <= self.high

    def __str__(self) -> str:
        if self.high == 0:
            return "none"
        if self.low == self.high:
            return f"exactly {self.low:,}"
        if self.high == math.inf:
            return f"at least {self.low:,}"
        return f"{self.low:,} to {self.high:,}" if self.low else f"at most {self.high:,}"


def exactly(number: int) -> Amount:
    """Return the range of one number."""
    return Amount(number, number)


def parse_amount(value: object) -> Amount | None:
    """Return the range that a value means; None for `"as in the reference"`.

    Raises
    ------
    ValueError
        If it means none, with a sentence.

    Examples
    --------
    >>> str(parse_amount(">= 3")), str(parse_amount("2..5")), 4 in parse_amount("< 4")
    ('at least 3', '2 to 5', False)
    """
    if isinstance(value, int) and not isinstance(value, bool) and value >= 0:
        return exactly(value)
    if not isinstance(value, str):
        raise ValueError(f"is a number of things, not {shown(value)}.")
    text = value.strip()
    if text == AS_IN_THE_REFERENCE:
        return None
    if found := re.fullmatch(r"(>=|<=|>|<|=|==)?\s*(\d+)", text):
        return _compared(found[1] or "=", int(found[2]))
    if found := re.fullmatch(r"(\d+)\s*\.\.\s*(\d+)", text):
        low, high = int(found[1]), int(found[2])
        if low > high:
            raise ValueError(f"begins at {low} and ends at {high}: no number is within that.")
        return Amount(low, high)
    raise ValueError(f"is a number of things, not {shown(value)}.")


def read_amount(table: Table, key: str) -> Amount | None:
    """Return the range that stands for a key; None for `"as in the reference"`.

    Raises
    ------
    AssignmentError
        If it is no range.
    """
    try:
        return parse_amount(table.value(key))
    except ValueError as problem:
        raise table.error(f"{key} {problem}", key, FORMS) from None


def _compared(sign: str, number: int) -> Amount:
    match sign:
        case ">=":
            return Amount(number, math.inf)
        case ">":
            return Amount(number + 1, math.inf)
        case "<=":
            return Amount(0, number)
        case "<":
            if number == 0:
                raise ValueError("is less than 0: no number of things is.")
            return Amount(0, number - 1)
        case _:
            return exactly(number)
