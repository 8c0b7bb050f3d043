"""The lookout: sees to it that a sketch is told, once, when nothing of what it draws shows.

Noting down what is drawn costs something, and so does looking at a picture. Both are done for a
few pictures alone: as soon as some of them have shown something, all is well.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from sketchkit.draw.renderer import Renderer
from sketchkit.draw.vertex import U8
from sketchkit.runtime.explore.blank import Remark, remark_on
from sketchkit.runtime.explore.describe import surroundings
from sketchkit.runtime.explore.log import FrameLog
from sketchkit.runtime.explore.noting import noting
from sketchkit.runtime.loader import Program

ENOUGH = 3  # pictures with something on them


class Lookout:
    """Looks at the pictures of a sketch.

    Parameters
    ----------
    program : Program
        The sketch.
    renderer : Renderer
        Its own.
    """

    def __init__(self, program: Program, renderer: Renderer) -> None:
        self._program = program
        self._renderer = renderer
        self._log = FrameLog()
        self._last = -1
        self._is_watched = False
        self._left = ENOUGH

    @property
    def is_done(self) -> bool:
        """Whether it looks no more."""
        return self._left == 0

    @contextmanager
    def watching(self, frame: int) -> Iterator[None]:
        """Note down what is drawn in this block, which is a frame; 0 is `setup()`."""
        self._is_watched = not self.is_done
        if not self._is_watched:
            yield
            return
        if frame > self._last + 1:
            self._log.skip_frames()
        self._last = self._log.frame = frame
        self._renderer.readers.append(self._log)
        try:
            with noting(self._program) as self._log.notes:
                yield
                self._renderer.flush()
        finally:
            self._renderer.readers.remove(self._log)

    def look(self, pixels: U8, frame: int) -> Remark | None:
        """Return what to tell about the picture of a frame, if it was the last one and watched."""
        if self.is_done or not self._is_watched or frame != self._last:
            return None
        remark = remark_on(self._log, surroundings(self._program), pixels, frame)
        if remark is not None:
            self.stop()
        elif frame:
            self._left -= 1
        return remark

    def stop(self) -> None:
        """Look no more."""
        self._left = 0
        self._log = FrameLog()
