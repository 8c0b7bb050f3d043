"""What explores a running sketch from outside, as the player sees it.

The player asks before it hands an event on, before it draws a frame, and before it shows one. The
sketch itself notices nothing: its pixels, its state and its stream of drawing stay as they are.
"""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from sketchkit.api.graphics import PGraphics
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.events import AnyEvent
from sketchkit.runtime.loop import Loop


class Explorer(Protocol):
    """Looks at a sketch while it runs. One is there as long as the window, for each fresh start."""

    @property
    def is_paused(self) -> bool:
        """Whether no frame is to be drawn. Events wait until there is one, unless handled here."""
        ...

    @property
    def speed(self) -> float:
        """How fast the sketch's time passes, above 0: at 0.1, ten times fewer frames a second."""
        ...

    @property
    def has_overlay(self) -> bool:
        """Whether `draw_over` has something to draw now."""
        ...

    def begin(self, loop: Loop, renderer: Renderer) -> None:
        """Take a sketch that has been read; its first line is run after this.

        `renderer` is the sketch's own: whoever adds a reader or an observer to it takes it away
        again in `end`.
        """
        ...

    def end(self) -> None:
        """Let go of the sketch: it has ended, has stopped by a mistake, or begins anew."""
        ...

    def handles(self, event: AnyEvent) -> bool:
        """Take an event; return whether it is swallowed, so that the sketch does not get it.

        Places are in the sketch's own units.
        """
        ...

    def takes_step(self) -> bool:
        """Return whether one frame is to be drawn though paused. Asked for once, granted once."""
        ...

    def takes_film(self) -> bool:
        """Return whether a film is to begin, or to end if one is being made.

        Asked for once, granted once.
        """
        ...

    def takes_written(self, path: Path) -> bool:
        """Return whether a file has changed only since it was written here, with what runs already.

        Asked for once, granted once: nothing begins anew then.
        """
        ...

    def picture(self, target: Target) -> Target:
        """Return what to show instead of the sketch's picture; mostly that itself.

        Called before each showing, and not only after new frames. It must be of the same size.
        """
        ...

    def draw_over(self, canvas: PGraphics) -> None:
        """Draw over the picture, which lies on the canvas already.

        The canvas is a P2D one of its own, in the sketch's units, and as fine as the window. Style
        and matrix are as at the beginning of a sketch.
        """
        ...


class NoExplorer:
    """Leaves everything as it is."""

    is_paused = False
    speed = 1.0
    has_overlay = False

    def begin(self, loop: Loop, renderer: Renderer) -> None:
        """Do nothing."""

    def end(self) -> None:
        """Do nothing."""

    def handles(self, event: AnyEvent) -> bool:
        """Leave every event to the sketch."""
        return False

    def takes_step(self) -> bool:
        """Want none."""
        return False

    def takes_film(self) -> bool:
        """Make none."""
        return False

    def takes_written(self, path: Path) -> bool:
        """Write none."""
        return False

    def picture(self, target: Target) -> Target:
        """Show what the sketch has drawn."""
        return target

    def draw_over(self, canvas: PGraphics) -> None:
        """Do nothing."""
