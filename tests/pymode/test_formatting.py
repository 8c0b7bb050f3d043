"""Expected texts are what Python 2.7 prints."""

import pytest

from tests.pymode.running import value


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("'%s' % (0.1 + 0.2)", "0.3"),
        ("'%s|%d|%.2f' % (1 / 3.0, 3.7, 2.345)", "0.333333333333|3|2.35"),
        ("'%r' % (0.1 + 0.2)", "0.30000000000000004"),
        ("'%(a)s' % {'a': 2.0 / 3}", "0.666666666667"),
        ("'%s' % [0.1 + 0.2]", "[0.30000000000000004]"),
        ("'%5s|%-5s|' % (2.5, 1.0)", "  2.5|1.0  |"),
        ("u'%s' % 1e20", "1e+20"),
        ("'{} {}'.format(0.1 + 0.2, 7)", "0.3 7"),
        ("'{0:.1f}'.format(0.25 + 0.5)", "0.8"),
        ("'{a}'.format(a=1 / 3.0)", "0.333333333333"),
        ("str(100.0)", "100.0"),
        ("str(1.0 / 7)", "0.142857142857"),
    ],
)
def test_numbers_in_texts_have_at_most_12_digits(expression: str, expected: str) -> None:
    assert value(expression) == expected


@pytest.mark.parametrize(
    ("expression", "expected"),
    [("x % y", 1.5), ("-7 % 3", 2), ("x % 3", 1.5), ("z % (y,)", "a3")],
)
def test_percent_is_still_a_remainder(expression: str, expected: object) -> None:
    assert value(expression, x=7.5, y=3, z="a%s") == expected


def test_format_of_an_object_is_its_own() -> None:
    class Clock:
        def format(self, style: str) -> str:
            return f"clock {style}"

    assert value("clock.format('short')", clock=Clock()) == "clock short"
