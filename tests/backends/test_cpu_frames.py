from __future__ import annotations

import numpy as np
import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.cpu.frames import FARTHEST, NO_TRIANGLE, Frame, Window, window_of
from sketchkit.draw.commands import Clear, DrawList, Settle, Settling
from sketchkit.draw.pipeline import Clip
from sketchkit.draw.resources import Target

ROWS = np.array([(10, 10, 10, 255), (90, 90, 90, 255)], np.uint8)


def frame_of_two_rows() -> Frame:
    """Return a frame of one column and two rows, whose samples are alike but for one."""
    frame = Frame(Target(1, 2, 4))
    frame.colors[:] = ROWS[:, None]
    frame.colors[3, 1] = 250
    return frame


def test_a_new_frame_is_transparent_and_far() -> None:
    frame = Frame(Target(3, 2))

    assert not frame.colors.any()
    assert np.all(frame.depths == FARTHEST << 32 | NO_TRIANGLE)


@pytest.mark.parametrize(("white", "mean"), [(0, 0), (1, 64), (2, 128), (3, 191), (4, 255)])
def test_a_pixel_is_the_mean_of_its_samples(white: int, mean: int) -> None:
    frame = Frame(Target(1, 1, 4))
    frame.colors[:white] = 255

    assert frame.picture()[0, 0].tolist() == [mean] * 4


def test_clear_may_leave_the_depth() -> None:
    frame = Frame(Target(2, 2))
    frame.depths[:] = 5

    frame.clear(Window(0, 0, 2, 2), (1, 2, 3, 4), depth=False)

    assert np.all(frame.colors == (1, 2, 3, 4))
    assert np.all(frame.depths == 5)


@pytest.mark.parametrize(
    ("how", "expected"),
    [
        (Settling.KEEP, [[10] * 4, [90, 90, 90, 250]]),
        (Settling.MEAN, [[10] * 4, [130] * 4]),
        (Settling.TURN, [[90] * 4, [10] * 4]),
    ],
)
def test_settling(how: Settling, expected: list[list[int]]) -> None:
    frame = frame_of_two_rows()
    frame.depths[:] = 5

    frame.settle(how)

    assert frame.colors[:, :, 0, 0].T.tolist() == expected
    far = FARTHEST << 32 | NO_TRIANGLE
    assert np.all(frame.depths == (5 if how is Settling.MEAN else far))


@pytest.mark.parametrize("top_row_first", [True, False])
def test_a_clip_counts_from_the_top_of_the_picture(top_row_first: bool) -> None:
    target = Target(100, 50, 4, top_row_first)

    window = window_of(target, Clip(-5, 10, 30, 15))

    assert window == (Window(0, 10, 25, 25) if top_row_first else Window(0, 25, 25, 40))


def test_a_resized_target_begins_anew() -> None:
    target, backend = Target(4, 3), CpuBackend()
    backend.execute(DrawList([Clear(target, (9, 9, 9, 9))]))

    target.resize(5, 2, 1, 1)

    assert backend.read(target).shape == (2, 5, 4)
    assert not backend.read(target).any()


def test_forgotten_targets_begin_anew() -> None:
    target, backend = Target(4, 3), CpuBackend()
    backend.execute(DrawList([Clear(target, (9, 9, 9, 9)), Settle(target, Settling.KEEP)]))

    backend.forget(target)

    assert not backend.read(target).any()
