"""Stand-ins: what a canvas showed at a moment that is past, drawn again."""

from __future__ import annotations

from dataclasses import replace

from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import Command, Draw, DrawList, DrawMesh, Settle, Settling
from sketchkit.draw.resources import Pixels, Target, Texture
from sketchkit.runtime.explore.log import FrameLog, Moment

DEEPEST = 6  # canvases drawn on canvases
MOST_KEPT = 16

Key = tuple[Target, Moment | None]


class StandIns:
    """Draws again what was on canvases.

    Parameters
    ----------
    log : FrameLog
        What was drawn.
    backend : Backend
        What drew it.
    """

    def __init__(self, log: FrameLog, backend: Backend) -> None:
        self._log = log
        self._backend = backend
        self._made: dict[Key, Target] = {}
        self._depth = 0

    def texture(self, texture: object, moment: Moment) -> Texture | None:
        """Return an image, or the picture of a canvas, as it was at a moment."""
        if isinstance(texture, Pixels):
            return self._log.steps[moment[0]].pictures.get(texture, texture)
        return self._canvas(texture, moment) if isinstance(texture, Target) else None

    def noted(self, target: Target, moment: Moment) -> Target:
        """Return what a canvas showed when it was last noted down for shaders."""
        moments, _ = self._log.before(target, moment)
        for own in reversed(moments):
            command = self._log.command(own)
            if isinstance(command, Settle) and command.how is Settling.NOTE:
                return self._canvas(target, own)
        return Target(1, 1)

    def _canvas(self, target: Target, moment: Moment) -> Target:
        moments, _ = self._log.before(target, moment)
        key = target, moments[-1] if moments else None
        if key not in self._made:
            if len(self._made) >= MOST_KEPT:
                self._made.clear()
            self._made[key] = self._drawn(target, moments)
        return self._made[key]

    def _drawn(self, target: Target, moments: list[Moment]) -> Target:
        """Return a new canvas with what these moments have drawn."""
        if not moments or self._depth >= DEEPEST:
            return Target(target.width, target.height, 1, target.top_row_first)
        last = self._log.steps[moments[-1][0]].surfaces[target]
        made = Target(last.width, last.height, last.samples, last.top_row_first)
        self._depth += 1
        try:
            for own in moments:
                step = self._log.steps[own[0]]
                surface = step.surfaces[target]
                if (surface.width, surface.height) != (last.width, last.height):
                    continue
                made.top_row_first = surface.top_row_first
                command = self._moved(step.commands.commands[own[1]], own, target, made)
                self._backend.execute(DrawList([command], step.commands.blocks))
        finally:
            self._depth -= 1
        return made

    def _moved(self, command: Command, moment: Moment, target: Target, made: Target) -> Command:
        """Return a command for another canvas."""
        if not isinstance(command, Draw | DrawMesh):
            return replace(command, target=made)
        pipeline = command.pipeline
        texture = made if pipeline.reads_itself else self.texture(pipeline.texture, moment)
        return replace(command, pipeline=pipeline._replace(target=made, texture=texture))
