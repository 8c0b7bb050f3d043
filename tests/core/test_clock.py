from datetime import datetime

import pytest

from sketchkit.core.clock import RENDER_DATE, Clock, RealClock, VirtualClock


@pytest.mark.parametrize(
    ("frame", "millis"),
    [(0, 0), (1, 0), (2, 17), (3, 33), (4, 50), (5, 67), (61, 1000)],
)
def test_virtual_clock_steps_a_60th_of_a_second_rounded(frame, millis):
    clock = VirtualClock()  # as measured with Processing

    clock.frame = frame

    assert clock.millis() == millis


def test_virtual_date_does_not_move():
    clock = VirtualClock()

    clock.frame = 1000

    assert clock.now() == RENDER_DATE


def test_virtual_date_can_be_chosen():
    date = datetime(1999, 12, 31, 23, 59, 59)

    assert VirtualClock(date).now() == date


def test_real_clock_starts_near_zero_and_does_not_go_back():
    clock: Clock = RealClock()

    first = clock.millis()

    assert 0 <= first <= clock.millis()
