import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.grading.checks.amount import Amount, exactly, parse_amount

COUNTS = st.integers(0, 10_000)


@pytest.mark.parametrize(
    ("value", "amount", "words"),
    [
        (3, Amount(3, 3), "exactly 3"),
        (0, Amount(0, 0), "none"),
        ("3", Amount(3, 3), "exactly 3"),
        ("= 3", Amount(3, 3), "exactly 3"),
        (">= 3", Amount(3, math.inf), "at least 3"),
        (">3", Amount(4, math.inf), "at least 4"),
        ("<= 1500", Amount(0, 1500), "at most 1,500"),
        ("< 3", Amount(0, 2), "at most 2"),
        ("2..5", Amount(2, 5), "2 to 5"),
        (" 2 .. 5 ", Amount(2, 5), "2 to 5"),
        ("as in the reference", None, "None"),
    ],
)
def test_amount_that_is_meant(value: object, amount: Amount | None, words: str) -> None:
    assert parse_amount(value) == amount
    assert str(parse_amount(value)) == words


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (True, "not true"),
        (2.5, "not 2.5"),
        (-1, "not -1"),
        ("many", "not 'many'"),
        ("5..2", "begins at 5 and ends at 2"),
        ("< 0", "less than 0"),
        ([1], "not a list"),
        (None, "not None"),
    ],
)
def test_what_is_no_amount_is_refused(value: object, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        parse_amount(value)


@given(COUNTS, COUNTS)
def test_signs_mean_what_they_mean_in_python(number: int, limit: int) -> None:
    for sign, truth in (
        (">=", number >= limit),
        (">", number > limit),
        ("<=", number <= limit),
        ("==", number == limit),
    ):
        amount = parse_amount(f"{sign} {limit}")
        assert amount is not None
        assert (number in amount) == truth


@given(COUNTS, COUNTS, COUNTS)
def test_range_holds_both_of_its_ends(number: int, one: int, other: int) -> None:
    low, high = sorted((one, other))
    amount = parse_amount(f"{low}..{high}")

    assert amount is not None
    assert (number in amount) == (low <= number <= high)


@given(COUNTS)
def test_number_alone_is_itself(number: int) -> None:
    assert parse_amount(number) == parse_amount(str(number)) == exactly(number)
