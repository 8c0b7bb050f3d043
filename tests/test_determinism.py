"""Two renders of one sketch are the same to the last bit, on every renderer."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from sketchkit.backends.listing import ListingBackend
from sketchkit.draw.backend import Backend
from sketchkit.runtime.backends import RENDERERS
from sketchkit.runtime.headless import Launch, render

SKETCH = """\
import random as python_random
import numpy as np

def setup():
    size(120, 90, P3D)
    background(240)

def draw():
    lights()
    stroke(random(255), noise(frameCount) * 255, python_random.random() * 255)
    fill(np.random.rand() * 255, second(), millis() % 256)
    translate(60 + randomGaussian(), 45)
    rotate(PVector.random2D().heading())
    rotateX(frameCount * 0.3)
    box(40, 30, 20)
    sphere(18)
    text(str(hour()), -50, 20)
"""
FRAMES = (0, 1, 2, 5)


@pytest.fixture
def sketch(tmp_path: Path) -> Path:
    path = tmp_path / "chance.py"
    path.write_text(SKETCH, encoding="utf-8")
    return path


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path}, line {line}: {text}")


def test_two_renders_in_one_process_are_equal(sketch: Path, backend: Backend) -> None:
    runs = []
    for _ in range(2):
        frames = list(render(Launch(sketch, refuse), FRAMES, backend))
        runs.append([frame.pixels.tobytes() for frame in frames])

    assert runs[0] == runs[1]
    assert len(set(runs[0])) == len(FRAMES)  # it does draw, and each time something else


def test_two_traces_are_equal(sketch: Path) -> None:
    texts = []
    for _ in range(2):
        backend = ListingBackend()
        list(render(Launch(sketch, refuse), FRAMES, backend, looks=False))
        texts.append("".join(backend.texts))

    assert texts[0] == texts[1]


def test_another_seed_draws_another_picture(sketch: Path) -> None:
    texts = []
    for seed in (0, 1):
        backend = ListingBackend()
        list(render(Launch(sketch, refuse, seed), FRAMES, backend, looks=False))
        texts.append("".join(backend.texts))

    assert texts[0] != texts[1]


@pytest.mark.parametrize("renderer", RENDERERS)
def test_render_in_a_process_of_its_own_is_equal_too(sketch: Path, renderer: str) -> None:
    folders = [sketch.parent / name for name in ("first", "second")]

    for folder in folders:
        call = ["render", str(sketch), "--frames", "1,5", "--out", str(folder)]
        subprocess.run(
            [sys.executable, "-m", "sketchkit", *call, "--renderer", renderer],
            check=True,
            cwd=Path(__file__).parents[1],
            timeout=60,
        )

    first, second = ({path.name: path.read_bytes() for path in f.iterdir()} for f in folders)
    assert sorted(first) == ["frame-0001.png", "frame-0005.png"]
    assert first == second
