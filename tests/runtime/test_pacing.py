import pytest

from sketchkit.runtime.pacing import Pacer, smoothed

FRAME_S = 1 / 50


def test_frame_that_is_a_little_late_does_not_delay_those_after_it() -> None:
    pacer = Pacer(0.0)

    for now_s in (0.0, 0.024, 0.041):
        pacer.go_on(now_s, 50)

    assert pacer.due_s == pytest.approx(0.060)


def test_after_a_long_frame_nothing_is_caught_up() -> None:
    pacer = Pacer(0.0)
    pacer.go_on(0.0, 50)

    pacer.go_on(1.0, 50)

    assert pacer.wait_s(1.0) == pytest.approx(FRAME_S)


def test_it_tells_how_long_the_last_frame_took() -> None:
    pacer = Pacer(0.0)
    pacer.go_on(0.5, 50)

    assert pacer.go_on(0.75, 50) == pytest.approx(0.25)


def test_one_slow_frame_moves_frameRate_by_a_twentieth() -> None:
    assert 1 / smoothed(50, 0.120) == pytest.approx(0.95 * 0.020 + 0.05 * 0.120)
