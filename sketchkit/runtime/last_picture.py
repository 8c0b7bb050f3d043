"""The last complete picture of a sketch, though the next one may be half drawn already.

It is what a mistake is shown over. Most frames are drawn all at once when they are complete, and
the canvas holds the picture of before until then. What is drawn earlier, as `get()` wants it,
would spoil that one: so it is copied just before, and only then.
"""

from __future__ import annotations

from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import DrawList, target_of
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.overlay import Overlay


class LastPicture:
    """Keeps the last complete picture, of one run of a sketch after another.

    Parameters
    ----------
    backend : Backend
        What draws.

    Attributes
    ----------
    is_of_run : bool
        Whether it is of the run that is followed now, and not of one before.
    """

    def __init__(self, backend: Backend) -> None:
        self.is_of_run = False
        self._backend = backend
        self._own: Target | None = None
        self._copy: Target | None = None
        self._was_top_row_first = True
        self._loop: Loop | None = None

    @property
    def target(self) -> Target | None:
        """The picture; None before there was one."""
        return self._copy or self._own

    def follow(self, loop: Loop, renderer: Renderer) -> None:
        """Look at a run of a sketch from now on; its pictures are not taken yet."""
        self._loop, self.is_of_run = loop, False
        renderer.observers.append(self._keep)

    def take(self, target: Target) -> None:
        """Take that a picture is complete."""
        self.is_of_run = True
        self._own, self._copy = target, None
        self._was_top_row_first = target.top_row_first

    def stop(self) -> None:
        """Take that the sketch draws no more, perhaps in the middle of a frame."""
        self._loop = None
        if self._own is not None and self._copy is None:
            self._turn(self._own)

    def _keep(self, commands: DrawList) -> None:
        """Copy the picture, if a part of the next one is about to be drawn over it."""
        own = self._own
        if own is None or self._copy is not None or self._loop is None or self._loop.is_complete:
            return
        if all(target_of(command) is not own for command in commands.commands):
            return
        is_turned = self._turn(own)
        self._copy = Overlay(self._backend).over(own, (own.across, own.down), lambda canvas: None)
        if is_turned:
            own.turn_over()

    def _turn(self, own: Target) -> bool:
        """Read the picture as it lies there: a frame that was not drawn may have turned it over."""
        is_turned = own.top_row_first is not self._was_top_row_first
        if is_turned:
            own.turn_over()
        return is_turned
