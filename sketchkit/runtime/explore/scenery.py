"""The scenery of a picture: which lines are drawn over it, seen by the same camera as it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from sketchkit.api.graphics import PGraphics
from sketchkit.core.matrix import eye_distance, multiply4
from sketchkit.draw.commands import DrawList
from sketchkit.draw.resources import Target
from sketchkit.draw.stage import Stage
from sketchkit.runtime.explore import gizmos
from sketchkit.runtime.explore.describe import DEFAULT_FOV, surroundings
from sketchkit.runtime.explore.log import FrameLog
from sketchkit.runtime.explore.panel import draw_lines
from sketchkit.runtime.explore.view import View, seen
from sketchkit.runtime.loader import Program


@dataclass(frozen=True)
class Scenery:
    """What there is to see of a sketch.

    Attributes
    ----------
    program : Program
        The sketch.
    log : FrameLog
        What it has drawn.
    """

    program: Program
    log: FrameLog

    @property
    def target(self) -> Target:
        """The main canvas."""
        return self.program.sketch.canvas.target

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in the sketch's own units."""
        canvas = self.program.sketch.canvas
        return canvas.width, canvas.height

    @property
    def lists(self) -> list[DrawList]:
        """What was drawn in the last frame, and before it if there was no `background()`."""
        return [step.commands for step in self.log.steps.values()]

    @property
    def stages(self) -> list[Stage]:
        """The stages of all that was drawn on the main canvas."""
        every = (step.records.stages for step in self.log.steps.values() if step.records)
        return [stage for stages in every for stage in stages if stage.target is self.target]

    @property
    def stage(self) -> Stage | None:
        """The stage of what was drawn last; on a 3D canvas, of what was drawn last in 3D."""
        every = self.stages
        solid = [stage for stage in every if stage.is_3d]
        return next(reversed(solid or every), None)

    @property
    def distance(self) -> float:
        """How far the middle of the picture is from the usual camera."""
        return float(eye_distance(self.size[1], DEFAULT_FOV))

    @property
    def own_view(self) -> View:
        """The sketch's own camera."""
        size = self.size
        is_3d = self.stage is not None and self.stage.is_3d
        return View.of(size, self.distance, is_3d=is_3d)

    def draw(self, canvas: PGraphics, view: View, *, wire: int, has_gizmos: bool) -> None:
        """Draw lines over the picture.

        Parameters
        ----------
        view : View
            How it is seen.
        wire : int
            1 for the edges of triangles, 2 for normals too.
        has_gizmos : bool
            Whether axes, ground, lights and the sketch's camera are drawn.
        """
        size = canvas.width, canvas.height
        for own in self._lines(view, wire, has_gizmos=has_gizmos):
            projection = own.projection
            if not view.is_home:
                projection = multiply4(projection, view.matrix)
            draw_lines(canvas, seen(projection, own.segments, size), own.color)

    def _lines(self, view: View, wire: int, *, has_gizmos: bool) -> Iterator[gizmos.Lines]:
        stage = self.stage
        if stage is None:
            return
        if wire:
            yield from gizmos.wire(self.lists, self.target)
        if wire > 1:
            yield from gizmos.normals(self.lists, self.target, self.distance)
        if has_gizmos:
            yield from self._gizmos(stage, view)

    def _gizmos(self, stage: Stage, view: View) -> Iterable[gizmos.Lines]:
        width, height = self.size
        camera = surroundings(self.program).camera
        yield from gizmos.axes(camera, stage.projection, height / 2)
        if not stage.is_3d:
            return
        is_usual = abs(camera[11] + self.distance) < 1.0
        centre = (width / 2, float(height), 0.0) if is_usual else (0.0, 0.0, 0.0)
        yield gizmos.ground(camera, stage.projection, centre, max(width, height) / 5)
        lights = dict.fromkeys(light for own in self.stages for light in own.lights or ())
        yield from gizmos.lamps(lights, stage.projection, self.distance)
        frustum = None if view.is_home else gizmos.frustum(stage.projection, self.distance)
        if frustum is not None:
            yield frustum
