import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import P2D
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.overlay import Overlay

RED, GREEN, BLACK = (255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 0, 255)


@pytest.fixture
def red() -> PGraphics:
    """Return a sketch's canvas, 20 by 10 and red all over."""
    canvas = PGraphics(Renderer(CpuBackend()), Target(20, 10))
    canvas.resize(20, 10, P2D, 4)
    canvas.background(255, 0, 0)
    canvas.end_frame()
    return canvas


def square(canvas: PGraphics) -> None:
    canvas.noStroke()
    canvas.fill(0, 255, 0)
    canvas.translate(2, 0)
    canvas.square(0, 0, 4)


def test_what_is_drawn_lies_over_the_picture(red: PGraphics) -> None:
    backend = red._renderer.backend

    seen = backend.read(Overlay(backend).over(red.target, (20, 10), square))

    assert [tuple(seen[1, x]) for x in (1, 2, 5, 6)] == [RED, GREEN, GREEN, RED]


def test_sketch_keeps_its_own_pixels(red: PGraphics) -> None:
    Overlay(red._renderer.backend).over(red.target, (20, 10), square)

    assert np.all(red.image_data() == RED)


def test_each_time_begins_anew_with_the_first_matrix_and_style(red: PGraphics) -> None:
    backend = red._renderer.backend
    overlay = Overlay(backend)

    first = backend.read(overlay.over(red.target, (20, 10), square)).copy()
    second = backend.read(overlay.over(red.target, (20, 10), square))

    assert np.array_equal(first, second)


def test_beside_a_smaller_picture_it_is_black(red: PGraphics) -> None:
    backend = red._renderer.backend

    seen = backend.read(Overlay(backend).over(red.target, (40, 30), square))

    assert seen.shape == (30, 40, 4)
    assert [tuple(seen[y, x]) for x, y in ((19, 9), (20, 9), (19, 10))] == [RED, BLACK, BLACK]
