import pytest

from sketchkit.libraries.peasycam.motions import Glide, Travel


def test_glide_loses_16_percent_in_each_frame() -> None:
    moves: list[float] = []
    glide = Glide(moves.append)
    glide.push(1.0)

    for _ in range(3):
        glide.step()

    assert moves == pytest.approx([1.0, 0.84, 0.7056])


def test_glide_ends_below_a_thousandth() -> None:
    moves: list[float] = []
    glide = Glide(moves.append)
    glide.push(0.00119)

    assert [glide.step(), glide.step(), glide.step()] == [True, False, False]
    assert moves == [0.00119]  # the next would be 0.0009996


def test_stopped_glide_moves_no_more() -> None:
    glide = Glide(lambda _: glide.stop())
    glide.push(1.0)

    assert [glide.step(), glide.step()] == [True, False]


def test_travel_arrives_after_99_percent_of_its_time() -> None:
    parts: list[float] = []
    travel = Travel(parts.append, start_ms=100, duration_ms=200)

    goes_on = [travel.step(now) for now in (150, 298, 299)]

    assert goes_on == [True, True, False]
    assert parts == [0.25, 0.99, 1.0]


def test_travel_without_duration_arrives_at_once() -> None:
    parts: list[float] = []

    assert not Travel(parts.append, 0, 0).step(0)
    assert parts == [1.0]
