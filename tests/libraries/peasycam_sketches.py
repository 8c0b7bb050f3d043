"""Sketches with a PeasyCam for tests, with a hand on the mouse and a clock that steps."""

from __future__ import annotations

from pathlib import Path

from sketchkit.backends.listing import ListingBackend
from sketchkit.core.clock import VirtualClock
from sketchkit.draw.renderer import Renderer
from sketchkit.libraries.peasycam import PeasyCam
from sketchkit.runtime.headless import Launch, Steps, opened
from sketchkit.runtime.replay import replay_of
from tests.runtime.sketches import Remarks, written

SKETCH = """
def setup():
    global cam
    size(200, 100, P3D)
    cam = PeasyCam(this, {distance})
    {setup}
def draw():
    {draw}
"""


def moved(
    folder: Path,
    frames: int,
    *events: dict[str, object],
    distance: float = 99,
    setup: str = "pass",
    draw: str = "pass",
) -> PeasyCam:
    """Return the camera of a sketch after some frames, with what the hand did in them."""
    path = written(folder, SKETCH.format(distance=distance, setup=setup, draw=draw))
    clock = VirtualClock()
    launch = Launch(path, Remarks().tell, replay=replay_of({"events": list(events)}))
    with opened(launch, Renderer(ListingBackend()), clock) as loop:
        loop.begin()
        steps = Steps(loop, clock, launch.replay)
        for _ in range(frames):
            steps.step()
        cam = loop.program.namespace["cam"]
    assert isinstance(cam, PeasyCam)
    return cam
