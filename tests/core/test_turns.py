import pytest

from sketchkit.core import turns
from sketchkit.core.turns import Turns


class Time:
    """A clock that is put forward by hand."""

    now = 0

    def millis(self) -> int:
        return self.now


@pytest.fixture
def time() -> Time:
    return Time()


def test_function_runs_to_its_end_before_the_others_go_on(time):
    log = []

    has_ended = Turns(time.millis).start(lambda: log.append("beside"))
    log.append("main")

    assert (has_ended, log) == (True, ["beside", "main"])


def test_function_that_waits_goes_on_when_its_time_has_come(time):
    log, together = [], Turns(time.millis)

    def work():
        for step in range(3):
            log.append((step, time.now))
            together.wait(100)

    together.start(work)
    for time.now in (50, 99, 100, 150, 199, 200, 1000):
        together.go_on()

    assert log == [(0, 0), (1, 100), (2, 200)]


def test_function_that_waits_shortly_has_several_turns_in_a_frame(time):
    ticks, together = [], Turns(time.millis)

    def tick():
        while True:
            ticks.append(time.now)
            together.wait(5)

    together.start(tick)
    time.now = 17
    together.go_on()
    together.end()

    assert ticks == [0, 17, 17, 17]  # due at 0, 5, 10 and 15


def test_functions_take_turns_in_the_order_of_their_times(time):
    log, together = [], Turns(time.millis)

    def wait_and_log(name, milliseconds):
        together.wait(milliseconds)
        log.append(name)

    together.start(lambda: wait_and_log("late", 30))
    together.start(lambda: wait_and_log("early", 20))
    time.now = 40
    together.go_on()

    assert log == ["early", "late"]


def test_who_takes_the_turns_is_not_stopped(time):
    assert Turns(time.millis).wait(100) is False


def test_thread_that_has_no_turns_really_waits(time, monkeypatch):
    slept, together = [], Turns(time.millis)
    monkeypatch.setattr(turns, "sleep", slept.append)
    other = turns.threading.Thread(target=together.wait, args=(250,))

    other.start()
    other.join()

    assert slept == [0.25]


def test_function_that_catches_everything_ends_too(time):
    rounds, together = [], Turns(time.millis)

    def work():
        while True:
            try:
                rounds.append(1)
                together.wait(100)
            except BaseException:  # as a bare except does
                pass

    together.start(work)
    together.end()  # returns, and the function waits for ever

    assert len(rounds) == 2


def test_those_that_wait_end_without_going_on(time):
    log, together = [], Turns(time.millis)

    def work():
        try:
            together.wait(100)
            log.append("went on")
        finally:
            log.append("left")

    together.start(work)
    together.end()

    assert log == ["left"]


def test_function_that_takes_too_long_is_left_to_itself(time, monkeypatch):
    monkeypatch.setattr(turns, "PATIENCE_S", 0.0)
    together = Turns(time.millis)
    go = turns.threading.Event()

    has_ended = together.start(go.wait)
    together.go_on()  # it has no turn: nobody waits for it

    assert has_ended is False
    go.set()
