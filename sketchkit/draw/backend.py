"""What a renderer must be able to do."""

from __future__ import annotations

from typing import Protocol

from sketchkit.draw.commands import DrawList
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import U8


class Backend(Protocol):
    """Draws finished lists. It never asks what the current fill is."""

    name: str

    def describe(self) -> dict[str, str]:
        """Return what is drawing, in words: driver, version."""

    def execute(self, commands: DrawList) -> None:
        """Carry out the commands in order."""

    def prepare(self, source: ShaderSource) -> None:
        """Make ready to draw with a shader of the sketch's.

        Raises
        ------
        SketchError
            If it does not compile, or the backend runs no GLSL.
        """

    def read(self, target: Target) -> U8:
        """Return what was drawn, (h, w, 4) RGBA, top row first, samples averaged."""

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return one pixel of it, (4,) RGBA, x and y from the top left."""

    def forget(self, resource: Pixels | Target | Mesh) -> None:
        """Let go of the backend's copy of a resource."""

    def close(self) -> None:
        """Let go of everything."""
