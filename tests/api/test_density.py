"""Two pixels for each unit, each way: coordinates stay, and all is drawn more finely."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.core.constants import JAVA2D, P2D, P3D
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8

WHITE, BLACK = 255, 0


def drawn(kind: str, density: int, draw: Callable[[PGraphics], None]) -> U8:
    """Return the red of a picture of 40 by 30 units, black on white."""
    canvas = PGraphics(Renderer(CpuBackend()), Target(1, 1))
    canvas.resize(40, 30, kind, 1, density)
    canvas.background(255)
    canvas.fill(0)
    draw(canvas)
    return canvas.image_data()[:, :, 0]


def filled(g: PGraphics) -> None:
    g.noStroke()
    g.rect(10, 5, 20, 8)


def clipped(g: PGraphics) -> None:
    g.clip(10, 5, 20, 8)
    g.background(0)


def stroked(g: PGraphics) -> None:
    g.strokeWeight(4)
    g.line(5, 15, 35, 15)


def pasted(g: PGraphics) -> None:
    other = g.offscreen(20, 8, P2D, 1)
    with other:
        other.background(0)
    g.image(other, 10, 5)


@pytest.mark.parametrize("kind", [P2D, P3D, JAVA2D])
@pytest.mark.parametrize("draw", [filled, clipped, pasted])
def test_whole_units_are_two_pixels(kind: str, draw: Callable[[PGraphics], None]) -> None:
    picture = drawn(kind, 2, draw)

    rows, columns = np.nonzero(picture == BLACK)
    assert picture.shape == (60, 80)
    assert (columns.min(), columns.max(), rows.min(), rows.max()) == (20, 59, 10, 25)
    assert len(rows) == 40 * 16


@pytest.mark.parametrize("kind", [P2D, P3D])
def test_strokes_are_twice_as_many_pixels_wide(kind: str) -> None:
    once, twice = (drawn(kind, density, stroked) for density in (1, 2))

    assert np.count_nonzero(once[:, 20] == BLACK) == 4
    assert np.count_nonzero(twice[:, 40] == BLACK) == 8


@pytest.mark.parametrize("kind", [P2D, P3D, JAVA2D])
def test_letters_are_of_the_same_size_and_finer(kind: str) -> None:
    def lettered(g: PGraphics) -> None:
        g.textSize(20)
        g.text("H", 10, 25)

    once, twice = (drawn(kind, density, lettered) for density in (1, 2))

    boxes = [
        [side for axis in np.nonzero(picture < 128) for side in (axis.min(), axis.max() + 1)]
        for picture in (once, twice)
    ]
    assert np.allclose(boxes[1], np.multiply(boxes[0], 2), atol=2)
    enlarged = once.repeat(2, axis=0).repeat(2, axis=1)
    assert np.any(enlarged != twice)


def test_places_on_the_screen_are_in_units() -> None:
    canvas = PGraphics(Renderer(CpuBackend()), Target(1, 1))
    canvas.resize(40, 30, P3D, 1, 2)

    assert (canvas.width, canvas.height) == (40, 30)
    assert canvas.screenX(20, 15, 0) == pytest.approx(20)
    assert canvas.get(79, 59) != 0
    assert canvas.get(80, 59) == 0
