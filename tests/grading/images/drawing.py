"""Pictures to judge, drawn by sketchkit itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.runtime.headless import Launch, render

U8 = NDArray[np.uint8]

FLAT = """
def setup():
    size(160, 120)
    background(235)
    noStroke()
    fill(200, 80, 40)
    rect(12, 10, 50, 40)
    fill(30, 90, 160)
    circle(110, 45, 50)
    stroke(20)
    strokeWeight(2)
    fill(250, 220, 60)
    triangle(20, 110, 50, 65, 83, 106)
    strokeWeight(1)
    line(95, 112, 150, 83)
    fill(0, 120, 90)
    noStroke()
    rect(142, 98, 8, 8)
"""

SOLID = """
def setup():
    size(160, 120, P3D)
    background(20, 24, 40)
    lights()
    noStroke()
    translate(50, 60, 0)
    rotateY(0.5)
    rotateX(0.4)
    fill(220, 140, 60)
    box(46)
    resetMatrix()
    translate(35, 10, -110)
    fill(90, 200, 120)
    sphere(22)
"""


def drawn(folder: Path, source: str) -> U8:
    """Return the first frame of a sketch, (h, w, 3)."""
    path = folder / "sketch.py"
    path.write_text(source, encoding="utf-8")
    launch = Launch(path, lambda *_: None, 0)
    (frame,) = render(launch, (1,), CpuBackend())
    return np.ascontiguousarray(frame.pixels[..., :3])


def changed(source: str, before: str, after: str) -> str:
    """Return a sketch with something written otherwise."""
    assert source.count(before) == 1
    return source.replace(before, after)
