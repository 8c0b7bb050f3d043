from pathlib import Path

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.listing import ListingBackend
from sketchkit.runtime.headless import Frame, Launch, render
from sketchkit.runtime.replay import replay_of
from sketchkit.runtime.report import StoppedError
from tests.runtime.sketches import Remarks, written

RED, GREEN, GREY = (255, 0, 0), (0, 255, 0), (204, 204, 204)


def pictures(path: Path, *numbers: int, seed: int = 0) -> list[Frame]:
    return list(render(Launch(path, Remarks().tell, seed), numbers, CpuBackend()))


def colors(path: Path, *numbers: int) -> list[tuple[int, ...]]:
    return [tuple(map(int, frame.pixels[5, 5])) for frame in pictures(path, *numbers)]


def test_static_sketch_has_the_same_picture_in_all_frames(tmp_path: Path) -> None:
    sketch = written(tmp_path, "size(20, 10)\nbackground(255, 0, 0)")

    frames = pictures(sketch, 0, 1, 7)

    assert [frame.pixels.shape for frame in frames] == [(10, 20, 3)] * 3
    assert [frame.repeats for frame in frames] == [None, 0, 0]
    assert (frames[2].pixels == RED).all()


def test_frame_0_is_the_picture_after_setup(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(20, 20)
            background(255, 0, 0)
        def draw():
            background(0, 255, 0)
        """,
    )

    assert colors(sketch, 0, 1) == [RED, GREEN]


def test_sketch_with_draw_alone_has_100_pixels_each_way(tmp_path: Path) -> None:
    sketch = written(tmp_path, "def draw():\n    noStroke()\n    rect(20, 20, 60, 60)\n")

    (frame,) = pictures(sketch, 1)

    assert frame.pixels.shape == (100, 100, 3)
    assert tuple(frame.pixels[5, 5]) == GREY
    assert tuple(frame.pixels[50, 50]) == (255, 255, 255)


def test_picture_repeats_after_noLoop(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def draw():
            background(frameCount * 10)
            if frameCount == 3:
                noLoop()
        """,
    )

    frames = pictures(sketch, 2, 3, 9)

    assert [int(frame.pixels[0, 0, 0]) for frame in frames] == [20, 30, 30]
    assert [frame.repeats for frame in frames] == [None, None, 3]


@pytest.mark.parametrize(
    "number",
    ["random(9) * random(9)", "255 * noise(3.3)", "255 * __import__('random').random()"],
)
def test_seed_rules_all_random_numbers(tmp_path: Path, number: str) -> None:
    sketch = written(tmp_path, f"size(9, 9)\nbackground({number})")

    first, again, other = (pictures(sketch, 0, seed=seed)[0].pixels for seed in (0, 0, 1))

    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)


def test_numpy_begins_at_the_seed(tmp_path: Path) -> None:
    sketch = written(
        tmp_path, "import numpy\nsize(9, 9)\nbackground(int(numpy.random.rand() * 256))"
    )

    assert np.array_equal(pictures(sketch, 0)[0].pixels, pictures(sketch, 0)[0].pixels)


def test_noSmooth_behind_drawing_loses_nothing(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def setup():
            size(20, 20)
            background(255, 0, 0)
            noSmooth()
        """,
    )

    assert colors(sketch, 0) == [RED]


def test_frames_before_a_mistake_are_there(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def draw():
            background(255, 0, 0)
            if frameCount == 3:
                elipse(1, 2, 3, 4)
        """,
    )
    frames = render(Launch(sketch, Remarks().tell), (1, 3), CpuBackend())

    assert next(frames).number == 1
    with pytest.raises(StoppedError):
        next(frames)


def test_cost_of_a_frame_is_counted_apart(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def draw():
            background(0)
            noStroke()
            for i in range(frameCount):
                rect(i, i, 10, 10)
        """,
    )

    frames = pictures(sketch, 1, 3)

    assert [frame.vertices for frame in frames] == [4, 12]
    assert [frame.draw_calls for frame in frames] == [1, 1]


def test_events_of_a_film_tell_the_films_time_and_double_clicks_stay(tmp_path: Path) -> None:
    sketch = written(
        tmp_path,
        """
        def draw():
            pass
        def mouseClicked(event):
            saveStrings(f"{event.count}.txt", [event.millis, millis()])
        """,
    )
    clicks = [{"frame": 4, "click": "left", "at": [5, 5]}, {"frame": 16, "click": "left"}]
    launch = Launch(sketch, Remarks().tell, replay=replay_of({"events": clicks}), rate=10)

    list(render(launch, [20], ListingBackend()))

    assert (tmp_path / "1.txt").read_text().split() == ["300", "300"]
    assert (tmp_path / "2.txt").read_text().split() == ["1500", "1500"]
