"""Canvases for tests: ready to draw on, and what was drawn on them."""

from __future__ import annotations

import numpy as np

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.listing import ListingBackend
from sketchkit.core.constants import P2D, P3D
from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import Draw, DrawList
from sketchkit.draw.pipeline import Pipeline
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import Layer, VertexBlock


def new_canvas(
    renderer_name: str,
    backend: Backend | None = None,
    size: tuple[int, int] = (100, 100),
    samples: int = 4,
) -> PGraphics:
    """Return a canvas whose first frame has begun; without a backend it draws nothing."""
    canvas = PGraphics(Renderer(backend or ListingBackend()), Target(*size))
    canvas.resize(*size, renderer_name, samples)
    canvas.begin_frame()
    return canvas


def flat_canvas() -> PGraphics:
    return new_canvas(P2D)


def deep_canvas() -> PGraphics:
    return new_canvas(P3D)


def drawn(canvas: PGraphics) -> DrawList:
    """Return the list that everything drawn since the last time makes."""
    lists: list[DrawList] = [DrawList()]
    keep = lists.append
    observers = canvas._renderer.observers
    observers.append(keep)
    canvas.end_frame()
    observers.remove(keep)
    return lists[-1]


def draws(commands: DrawList) -> list[Draw]:
    return [command for command in commands.commands if isinstance(command, Draw)]


def pipeline_of(canvas: PGraphics) -> Pipeline:
    """Return what the canvas draws a rect with now."""
    canvas.noStroke()
    canvas.rect(0, 0, 9, 9)
    return draws(drawn(canvas))[-1].pipeline


def fills(canvas: PGraphics) -> VertexBlock:
    """Return the vertices of what is filled, P2D's strokes included."""
    return drawn(canvas).blocks[Layer.FILLS]


def strokes(canvas: PGraphics) -> VertexBlock:
    """Return the vertices of P3D's strokes."""
    return drawn(canvas).blocks[Layer.LINES]


def places(block: VertexBlock) -> list[tuple[float, float]]:
    """Return x and y of the vertices, rounded to a thousandth of a pixel."""
    return [(round(float(x), 3) + 0.0, round(float(y), 3) + 0.0) for x, y, _ in block.positions]


def area(block: VertexBlock) -> float:
    """Return what all triangles cover in x and y, overlaps counted twice."""
    a, b, c = block.positions[block.indices].reshape(-1, 3, 3).astype(np.float64).transpose(1, 0, 2)
    return float(np.abs(np.cross(b - a, c - a)[:, 2]).sum() / 2)
