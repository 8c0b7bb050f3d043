"""What one call costs: recorded while the sketch runs, and expanded when it is drawn."""

from __future__ import annotations

import gc
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P2D
from sketchkit.draw.commands import DrawList
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.vertex import U8

CALLS = 10_000
ROUNDS = 25

Pair = tuple[Callable[..., object], Callable[..., object]]


class NoBackend:
    """A backend that draws nothing: what is left is what comes before it."""

    name = "none"

    def describe(self) -> dict[str, str]:
        """Say nothing."""
        return {}

    def execute(self, commands: DrawList) -> None:
        """Draw nothing."""

    def read(self, target: Target) -> U8:
        """Return a black picture."""
        return np.zeros((target.height, target.width, 4), np.uint8)

    def forget(self, resource: Pixels | Target) -> None:
        """Forget nothing."""

    def close(self) -> None:
        """Close nothing."""


@dataclass(frozen=True)
class CallCost:
    """Nanoseconds of `fill(r, g, b)` and `rect(x, y, w, h)` together, without the loop around them.

    Attributes
    ----------
    recorded, expanded : float
        By the calls themselves, and by turning the records into vertices.
    empty : float
        Two Python functions that do nothing, in their place.
    """

    recorded: float
    expanded: float
    empty: float


@dataclass(frozen=True)
class Memory:
    """Bytes for each rectangle: of the record, and of all there is while it is drawn."""

    recorded: float
    drawing: float


def call_cost() -> CallCost:
    """Measure the best of some rounds."""
    canvas, renderer = _canvas()
    pair = canvas.fill, canvas.rect
    _draw(*pair)
    renderer.flush()
    loops, empties, calls, flushes = [], [], [], []
    gc.disable()
    for _ in range(ROUNDS):
        loops.append(_timed(_loop))
        empties.append(_timed(lambda: _draw(_nothing3, _nothing4)))
        calls.append(_timed(lambda: _draw(*pair)))
        flushes.append(_timed(renderer.flush))
    gc.enable()
    loop = min(loops)
    return CallCost(
        recorded=_each_ns(min(calls) - loop),
        expanded=_each_ns(min(flushes)),
        empty=_each_ns(min(empties) - loop),
    )


def memory() -> Memory:
    """Measure what rectangles need once nothing is kept from before."""
    tracemalloc.start()
    canvas, renderer = _canvas()
    before, _ = tracemalloc.get_traced_memory()
    _draw(canvas.fill, canvas.rect)
    recorded, _ = tracemalloc.get_traced_memory()
    renderer.flush()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return Memory((recorded - before) / CALLS, (peak - before) / CALLS)


def _canvas() -> tuple[PGraphics, Renderer]:
    renderer = Renderer(NoBackend())
    canvas = PGraphics(renderer, Target(640, 480))
    canvas.resize(640, 480, P2D, 1)
    canvas.begin_frame()
    canvas.noStroke()
    renderer.flush()
    return canvas, renderer


def _loop() -> None:
    for i in range(CALLS):
        i & 255  # the part of the loop below that is not the calls


def _draw(fill: Callable[..., object], rect: Callable[..., object]) -> None:
    for i in range(CALLS):
        fill(i & 255, 120, 13)
        rect(10, 20, 30, 40)


def _nothing3(a: object, b: object, c: object) -> None: ...


def _nothing4(a: object, b: object, c: object, d: object) -> None: ...


def _timed(work: Callable[[], object]) -> float:
    start = perf_counter()
    work()
    return perf_counter() - start


def _each_ns(elapsed_s: float) -> float:
    return elapsed_s / CALLS * 1e9
