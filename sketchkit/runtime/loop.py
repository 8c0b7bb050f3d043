"""The life of a sketch: its own lines, `settings()`, `setup()`, then `draw()` for each frame.

It knows no window and no clock: who drives it says when the next frame is due.
"""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager

from sketchkit.api._sketch_parts import Phase
from sketchkit.runtime.events import AnyEvent, WindowEvent, dispatch
from sketchkit.runtime.loader import Program

OVERTAKEN = ("windowMoved", "windowResized")  # of several in a frame, the last one counts
LAST_CALLS = ("stop", "dispose")  # what Processing calls at the end, if the sketch has them


class Loop:
    """Takes a program through its life.

    Attributes
    ----------
    program : Program
        Entered by whoever made it.
    is_complete : bool
        Whether no frame is half drawn.

    Parameters
    ----------
    restarts_chance : bool
        Whether random numbers begin anew in `setup()`. The pictures of Processing that ours are
        compared with are made so; in a window nothing shall come twice.
    """

    def __init__(self, program: Program, *, restarts_chance: bool = False) -> None:
        self.program = program
        self.is_complete = True
        self._restarts_chance = restarts_chance
        self._sketch = program.sketch
        self._canvas = program.sketch.canvas
        self._progress = program.sketch.progress
        self._events: deque[AnyEvent] = deque()
        self._window_events: list[WindowEvent] = []

    @property
    def frame_count(self) -> int:
        """How many times `draw()` has been called."""
        return self._progress.frame_count

    @property
    def is_finished(self) -> bool:
        """Whether `exit()` has been called."""
        return self._progress.is_finished

    @property
    def is_drawing(self) -> bool:
        """Whether `draw()` will be called, by itself or after `redraw()`."""
        progress = self._progress
        is_due = progress.is_looping or progress.is_redraw_due
        return is_due and not progress.is_finished and self.program.has("draw")

    def begin(self) -> None:
        """Make the picture of frame 0: the file's own lines, then `settings()` and `setup()`."""
        self._canvas.begin_frame()
        with self._leaving():
            self.program.execute()
            self._progress.phase = Phase.SETTINGS
            self.program.call("settings")
            self._progress.phase = Phase.SETUP
            if self._restarts_chance:
                self._sketch.restart_chance()
            self.program.call("setup")
        self._progress.phase = Phase.DRAW
        self._canvas.end_frame()
        self._raise_failures()

    @contextmanager
    def running_first_lines(self) -> Iterator[None]:
        """Let a block do what belongs to a sketch's own lines, such as `size()`."""
        self._progress.phase = Phase.LOADING
        self._canvas.begin_frame()
        try:
            yield
        finally:
            self._progress.phase = Phase.DRAW
            self._canvas.end_frame()

    def post(self, event: AnyEvent) -> None:
        """Have an event handled in the next step.

        Mouse and keys come after `draw()`. What happens to the window comes before it, so that a
        picture of the new size is drawn; also after `noLoop()`, as the old picture is lost.
        """
        if not isinstance(event, WindowEvent):
            self._events.append(event)
            return
        if event.handler in OVERTAKEN:
            others = [other for other in self._window_events if other.handler != event.handler]
            self._window_events = others
        self._window_events.append(event)
        if event.size:
            self._progress.is_redraw_due = True

    def step(self) -> bool:
        """Draw a frame if one is due, and handle what has happened; tell whether there was any."""
        self._raise_failures()
        is_drawing = self.is_drawing
        calls = self._progress.due_calls
        if not (is_drawing or self._events or self._window_events or calls):
            return False
        self.is_complete = False
        with self._leaving():
            if not is_drawing:
                self._handle_window()
            if is_drawing:
                self._draw()
            while self._events:
                dispatch(self.program, self._events.popleft())
            while calls:
                self.program.publish()
                calls.pop(0)()
            if is_drawing:
                self.program.call_registered("draw")
        self.is_complete = True
        self._canvas.end_frame()
        self._raise_failures()
        if is_drawing:
            with self._leaving():
                self.program.call_registered("post")
        return True

    def end(self) -> None:
        """Call what the sketch wants to be called at its end."""
        for name in LAST_CALLS:
            if not self.program.needs_arguments(name):  # else it is one of the sketch's own
                self.program.call(name)
        self.program.call_registered("dispose")
        self._sketch.write_files()
        self._sketch.remark_on_lost_files()

    def _raise_failures(self) -> None:
        """Raise what has gone wrong in a function beside the others."""
        if self._progress.failures:
            raise self._progress.failures.pop(0)

    @contextmanager
    def _leaving(self) -> Iterator[None]:
        """Do what `sys.exit()` asks for: as `exit()`, but at once, and perhaps with last words."""
        try:
            yield
        except SystemExit as call:
            self._progress.is_finished = True
            if isinstance(call.code, str):
                print(call.code, file=sys.stderr)

    def _handle_window(self) -> None:
        while self._window_events:
            dispatch(self.program, self._window_events.pop(0))

    def _draw(self) -> None:
        pointer = self._sketch.pointer
        self._progress.frame_count += 1
        self._canvas.begin_frame(is_looping=self._progress.is_looping)
        self._handle_window()
        self._sketch.begin_ratio()
        self.program.call_registered("pre")
        pointer.previous_x, pointer.previous_y = pointer.drawn_x, pointer.drawn_y
        self._sketch.go_on_beside()
        self.program.call("draw")
        pointer.drawn_x, pointer.drawn_y = pointer.x, pointer.y
        self._progress.is_redraw_due = False
