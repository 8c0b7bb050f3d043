from pathlib import Path

import numpy as np
import pytest

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.mistake_panel import MARGIN, draw_mistake, shown_size
from sketchkit.runtime.overlay import Overlay
from sketchkit.runtime.report import Report

LONG = Report(
    "ellipse() takes 4 numbers: x, y, width, height.\n    Got 3: ellipse(10, 20, 30).\n" * 2,
    Path("a_sketch_with_a_rather_long_name.py"),
    114,
    "        " + "x + " * 60 + "ellipse(10, 20, 30)",
    (248, 267),
    ("called from planets(), line 92", "called from draw(), line 120"),
)


@pytest.mark.parametrize("size", [(100, 100), (480, 120), (1280, 720)])
def test_all_of_it_fits(size: tuple[int, int]) -> None:
    backend = CpuBackend()
    picture = PGraphics(Renderer(backend), Target(*size))
    picture.background(0)
    picture.end_frame()

    size = shown_size(*size)
    shown = Overlay(backend).over(picture.target, size, lambda canvas: draw_mistake(canvas, LONG))
    seen = backend.read(shown)[:, :, :3].astype(int)

    lettered = np.abs(seen - seen[0, 0]).sum(axis=2) > 30
    rows, columns = np.nonzero(lettered)
    assert rows.size > 500
    assert rows.max() < size[1] - 2
    assert columns.min() >= MARGIN - 1
    assert columns.max() < size[0] - 2
