from sketchkit.api.live import LiveFlag, LiveFloat, LiveInt, live, live_names


class Weather:
    @property
    @live
    def wind(self) -> float:
        return 3.0

    @property
    def name(self) -> str:
        return "mild"


def test_only_marked_properties_are_live() -> None:
    assert live_names(Weather) == ("wind",)


def test_number_that_is_a_function() -> None:
    calls: list[float] = []
    rate = LiveFloat(60.0, calls.append)

    rate(30)

    assert calls == [30]
    assert (rate, rate / 2, f"{rate:.1f}", str(rate)) == (60.0, 30.0, "60.0", "60.0")


def test_whole_number_that_is_a_function() -> None:
    calls: list[int] = []
    density = LiveInt(1, calls.append)

    density(2)

    assert (calls, density, str(density)) == ([2], 1, "1")


def test_flag_that_is_a_function() -> None:
    flag = LiveFlag(True, lambda *args: ("called", *args))

    assert flag
    assert flag == True  # noqa: E712 # as sketches write it
    assert str(flag) == "True"
    assert flag(1) == ("called", 1)
    assert not LiveFlag(False, print)
