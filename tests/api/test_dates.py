from datetime import datetime

import pytest

from sketchkit.api.dates import Dates
from sketchkit.core.clock import VirtualClock


@pytest.mark.parametrize(
    ("name", "expected"),
    [("year", 2024), ("month", 5), ("day", 6), ("hour", 7), ("minute", 8), ("second", 9)],
)
def test_parts_of_the_date_are_the_clocks(name, expected):
    dates = Dates()
    dates._clock = VirtualClock(datetime(2024, 5, 6, 7, 8, 9))

    assert getattr(dates, name)() == expected


def test_millis_is_the_clocks():
    dates = Dates()
    dates._clock = VirtualClock()

    dates._clock.frame = 31

    assert dates.millis() == 500
