"""A canvas's projection and lights, put aside and put back: what is drawn over a scene needs it."""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.api._parts import CanvasParts
from sketchkit.core.lights import LightRig
from sketchkit.core.matrix import Mat4


@dataclass(frozen=True)
class View:
    """How a canvas shows what is drawn on it, apart from the matrix."""

    projection: Mat4
    is_perspective: bool
    lights: LightRig | None


class Views(CanvasParts):
    """For libraries: a sketch does not see these."""

    @property
    def is_3d(self) -> bool:
        """Whether the canvas is one of P3D."""
        return self._is_3d

    def current_view(self) -> View:
        """Return projection and lights as they are."""
        stage = self._stage
        return View(stage.projection, stage.is_perspective, stage.lights)

    def set_view(self, view: View) -> None:
        """Put projection and lights back."""
        self._restage(
            projection=view.projection, is_perspective=view.is_perspective, lights=view.lights
        )
