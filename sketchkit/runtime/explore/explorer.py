"""The explorer of a running sketch: what the keys F1 to F12 do, and what they show.

It is the `Explorer` that the player asks (runtime/explorer.py). What it draws lies on canvases of
its own; the sketch's pixels, its mouse and its frameCount stay as they are.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import CODED, LEFT, RIGHT
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.imaging.flatness import is_flat
from sketchkit.runtime.events import AnyEvent
from sketchkit.runtime.explore.blank import Remark, remark_on
from sketchkit.runtime.explore.describe import surroundings
from sketchkit.runtime.explore.inspection import Inspection, look, report, short_report
from sketchkit.runtime.explore.log import MOST_KEPT, FrameLog
from sketchkit.runtime.explore.modes import HELP, SPEEDS, Modes
from sketchkit.runtime.explore.noting import noting
from sketchkit.runtime.explore.numbers_panel import NumbersPanel
from sketchkit.runtime.explore.panel import draw_graph, draw_panel
from sketchkit.runtime.explore.scenery import Scenery
from sketchkit.runtime.explore.view import View, redrawn
from sketchkit.runtime.loader import Tell
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.source import Source

KEPT_ALWAYS = 50_000  # vertices of past frames, while nobody looks
FIRST_CHECK = 2  # frames, until it is looked at whether anything shows
NOTED_FRAMES = 2  # at the beginning, so that a sketch that stands still can be inspected
TOLD_S = 60.0  # how long a remark stays in the window, if no key is pressed, and no button
FRAMES_SHOWN = 120
F1 = 112  # keyCode
STEP = 6  # F6


class SketchExplorer:
    """Explores one sketch after another, in one window.

    Parameters
    ----------
    tell : callable
        Called with file, line and text of a remark.
    now : callable
        Returns the time, in seconds from whenever.
    """

    def __init__(self, tell: Tell, now: Callable[[], float] = time.perf_counter) -> None:
        self._tell = tell
        self._now = now
        self._modes = Modes()
        self._is_paused = self._wants_step = self._wants_film = False
        self._loop: Loop | None = None
        self._renderer: Renderer | None = None
        self._stand_in: Target | None = None
        self._log = FrameLog()
        self._notes = ExitStack()
        self._view: View | None = None
        self._frame = -1
        self._shown_s = 0.0
        self._times_ms: deque[float] = deque(maxlen=FRAMES_SHOWN)
        self._counts = (0, 0, 0, 0)  # draw calls and vertices, in all and of the last frame
        self._mouse, self._dragged = (0, 0), (0, 0)
        self._pinned: tuple[int, int] | None = None
        self._looked: tuple[tuple[int, int], int, Inspection] | None = None
        self._remark: tuple[Remark, float] | None = None
        self._numbers = NumbersPanel()
        self._source: Source | None = None
        self._checked_from = 0

    # What the player asks

    @property
    def is_paused(self) -> bool:
        """Whether no frame is to be drawn."""
        return self._is_paused

    @property
    def speed(self) -> float:
        """How fast the sketch's time passes."""
        return SPEEDS[self._modes.speed]

    @property
    def has_overlay(self) -> bool:
        """Whether anything is drawn over the picture."""
        shows = any(self._modes[:-1]) or self._modes.speed > 0
        return shows or self._is_paused or self._remark is not None

    def begin(self, loop: Loop, renderer: Renderer) -> None:
        """Take a sketch that has been read."""
        self._loop, self._renderer = loop, renderer
        limit = MOST_KEPT if self._modes.inspect else KEPT_ALWAYS
        self._log = FrameLog(None, limit, lambda: loop.frame_count)
        self._log.backend = renderer.backend
        self._view = None
        self._frame, self._counts = -1, (0, 0, 0, 0)
        self._looked = self._remark = None
        renderer.readers.append(self._log)
        self._take_text(0)

    def end(self) -> None:
        """Let go of the sketch."""
        self._notes.close()
        if self._renderer is not None and self._log in self._renderer.readers:
            self._renderer.readers.remove(self._log)
        self._loop = self._renderer = None
        self._log = FrameLog()
        self._is_paused = False

    def takes_step(self) -> bool:
        """Return whether one frame is to be drawn though paused."""
        wants, self._wants_step = self._wants_step, False
        return wants

    def takes_film(self) -> bool:
        """Return whether a film is to begin, or to end."""
        wants, self._wants_film = self._wants_film, False
        return wants

    def takes_written(self, path: Path) -> bool:
        """Return whether a file was written by the explorer, and holds what runs already."""
        return self._numbers.tweaks is not None and self._numbers.tweaks.takes_written(path)

    def handles(self, event: AnyEvent) -> bool:
        """Take an event; return whether the sketch does not get it."""
        if isinstance(event, KeyEvent | MouseEvent) and event.action == KeyEvent.PRESS:
            self._remark = None
        if self._modes.numbers and self._loop is not None:
            self._numbers.follow(self._loop.program)
        match event:
            case KeyEvent(key=key, keyCode=code) if key == CODED and F1 <= code < F1 + 12:
                self._take_key(event, code - F1 + 1)
                return True
            case KeyEvent() if self._modes.numbers:
                return self._numbers.handles_key(event)
            case MouseEvent() if self._modes.numbers and self._numbers.handles_mouse(event):
                return True
            case MouseEvent():
                return self._handles_mouse(event)
        return False

    def _take_key(self, event: KeyEvent, number: int) -> None:
        """Do what F1 to F12 stand for; while one is held, only frames go on."""
        if event.action == KeyEvent.PRESS and (number == STEP or not event.is_repeat):
            KEYS[number](self)

    @property
    def _scenery(self) -> Scenery | None:
        return None if self._loop is None else Scenery(self._loop.program, self._log)

    def picture(self, target: Target) -> Target:
        """Return the sketch's picture, or what it has drawn under another camera."""
        loop = self._loop
        if loop is None or self._renderer is None:
            return target
        if loop.program.source is not self._source:
            self._take_text(max(self._frame, 0))
        if loop.frame_count != self._frame:
            self._take_frame(loop.frame_count)
        scenery, view = self._scenery, self._view
        if scenery is None or view is None or view.is_home:
            return target
        stand_in = self._stand_in
        size = target.width, target.height, target.samples, target.top_row_first
        if stand_in is None or size != _size(stand_in):
            stand_in = self._stand_in = Target(*size)
        for own in redrawn(scenery.lists, target, stand_in, view):
            self._renderer.backend.execute(own)
        return stand_in

    def draw_over(self, canvas: PGraphics) -> None:
        """Draw what is switched on."""
        modes = self._modes
        if (modes.wire or modes.gizmos) and (scenery := self._scenery):
            view = self._view or scenery.own_view
            scenery.draw(canvas, view, wire=modes.wire, has_gizmos=modes.gizmos)
        if modes.graph:
            self._draw_graph(canvas)
        if modes.numbers and self._loop is not None:
            self._numbers.follow(self._loop.program)
            self._numbers.draw(canvas)
        if modes.inspect:
            self._draw_inspection(canvas)
        self._draw_state(canvas)
        if self._remark is not None:
            remark, until_s = self._remark
            place = f"line {remark.line}: {remark.text}"
            draw_panel(canvas, place.splitlines(), at=(0, canvas.height))
            if self._now() > until_s:
                self._remark = None
        if modes.help:
            draw_panel(canvas, HELP)

    # Keys

    def toggle(self, name: str) -> None:
        """Switch something on or off."""
        self._modes = self._modes._replace(**{name: not getattr(self._modes, name)})

    def film(self) -> None:
        """Begin a film, or end it."""
        self._wants_film = True

    def pause(self) -> None:
        """Stand still, or go on."""
        self._is_paused = not self._is_paused

    def step(self) -> None:
        """Draw one frame, and stand still."""
        self._is_paused = self._wants_step = True

    def slow_down(self) -> None:
        """Let time pass more slowly, or as it should again."""
        self._modes = self._modes._replace(speed=(self._modes.speed + 1) % len(SPEEDS))

    def go_home(self) -> None:
        """Go back to the sketch's own camera."""
        self._view = None
        self._modes = self._modes._replace(camera=False)

    def next_wire(self) -> None:
        """Show edges, normals too, or none."""
        self._modes = self._modes._replace(wire=(self._modes.wire + 1) % 3)

    def inspect(self) -> None:
        """Begin to inspect, or end it."""
        self.toggle("inspect")
        self._pinned = self._looked = None
        if self._modes.inspect:
            self._view = None  # what is pointed at is the sketch's own picture
            self._log.limit = MOST_KEPT
            self._begin_notes()
        else:
            self._log.limit = KEPT_ALWAYS
            self._notes.close()

    # Frames

    def _begin_notes(self) -> None:
        self._notes.close()
        if self._loop is not None:
            notes = noting(self._loop.program, each_pixel=self._modes.inspect)
            self._log.notes = self._notes.enter_context(notes)

    def _take_text(self, frame: int) -> None:
        """Take that a sketch runs another text after a frame: what it draws is looked at anew."""
        self._source = None if self._loop is None else self._loop.program.source
        self._checked_from = frame
        self._looked = None
        self._log.forgets = False
        self._begin_notes()

    def _take_frame(self, number: int) -> None:
        """Take that a frame has been drawn."""
        now_s = self._now()
        if self._frame >= 0:
            self._times_ms.append((now_s - self._shown_s) * 1000)
        self._frame, self._shown_s = number, now_s
        assert self._renderer is not None
        assert self._loop is not None
        stats, (calls, vertices, _, _) = self._renderer.stats, self._counts
        own = stats.draw_calls - calls, stats.vertices - vertices
        self._counts = (stats.draw_calls, stats.vertices, *own)
        count = number - self._checked_from
        is_last = count > 0 and not self._loop.is_drawing
        if not self._log.forgets and (count >= FIRST_CHECK or is_last):
            self._check_picture(number)
            self._log.forgets = True
        if count >= NOTED_FRAMES and not self._modes.inspect:
            self._notes.close()

    def _check_picture(self, number: int) -> None:
        """Tell if nothing of what is drawn shows."""
        assert self._loop is not None
        pixels = self._loop.program.sketch.canvas.image_data()
        if not is_flat(pixels):
            return
        remark = remark_on(self._log, surroundings(self._loop.program), pixels, number)
        if remark is not None:
            self._remark = remark, self._now() + TOLD_S
            self._tell(remark.path, remark.line, remark.text)

    # Mouse

    def _handles_mouse(self, event: MouseEvent) -> bool:
        place = event.x, event.y
        before, self._mouse = self._mouse, place
        if self._modes.inspect:
            if event.action == MouseEvent.PRESS:
                self._pinned = None if event.button == RIGHT else place
            return event.action in CLICKS
        if not self._modes.camera or event.action not in CLICKS | {
            MouseEvent.DRAG,
            MouseEvent.WHEEL,
        }:
            return False
        scenery = self._scenery
        if scenery is None:
            return False
        view = self._view or scenery.own_view
        dx, dy = place[0] - before[0], place[1] - before[1]
        if event.action == MouseEvent.WHEEL:
            view = view.zoomed(event.count, place)
        elif event.action == MouseEvent.DRAG:
            view = view.turned(dx, dy) if event.button == LEFT else view.moved(dx, dy)
        self._view = view
        return True

    # Pictures

    def _draw_graph(self, canvas: PGraphics) -> None:
        times = list(self._times_ms)
        mean = sum(times) / len(times) if times else 0.0
        _, _, calls, vertices = self._counts
        rate = f"{1000 / mean:.0f} frames/s" if mean else "-"
        lines = [f"{mean:.1f} ms, {rate}", f"{calls} draw calls", f"{vertices} vertices"]
        draw_graph(canvas, times, lines)

    def _draw_state(self, canvas: PGraphics) -> None:
        parts = []
        if self._is_paused:
            parts.append(f"paused at frame {max(self._frame, 0)}: F5 goes on, F6 one frame")
        if self._modes.speed:
            parts.append(f"at {self.speed:g} of its speed: F7")
        if self._modes.camera or (self._view is not None and not self._view.is_home):
            parts.append("another camera: F2 mouse, F3 back")
        if parts:
            draw_panel(canvas, ["   ".join(parts)], at=(8, canvas.height))

    def _draw_inspection(self, canvas: PGraphics) -> None:
        place = self._pinned or self._mouse
        found = self._inspection(place)
        if found is None:
            return
        x, y = place
        canvas.noFill()
        canvas.stroke(0xFFFFD060)
        canvas.strokeWeight(1)
        canvas.rect(x - 2.5, y - 2.5, 5, 5)
        if self._pinned is None:
            draw_panel(canvas, [short_report(found)], at=(x + 12, y + 12))
        else:
            assert self._loop is not None
            draw_panel(canvas, report(found, self._loop.program.source.path.name))

    def _inspection(self, place: tuple[int, int]) -> Inspection | None:
        """Return what has drawn a pixel; looked up once for each place and frame."""
        if self._loop is None:
            return None
        canvas = self._loop.program.sketch.canvas
        if not (0 <= place[0] < canvas.width and 0 <= place[1] < canvas.height):
            return None
        if self._looked is None or self._looked[:2] != (place, self._frame):
            found = look(self._loop.program, self._log, place, self._frame)
            self._looked = place, self._frame, found
        return self._looked[2]


CLICKS = {MouseEvent.PRESS, MouseEvent.RELEASE, MouseEvent.CLICK}
KEYS: dict[int, Callable[[SketchExplorer], None]] = {
    1: lambda own: own.toggle("help"),
    2: lambda own: own.toggle("camera"),
    3: SketchExplorer.go_home,
    4: SketchExplorer.film,
    5: SketchExplorer.pause,
    STEP: SketchExplorer.step,
    7: SketchExplorer.slow_down,
    8: SketchExplorer.inspect,
    9: lambda own: own.toggle("graph"),
    10: SketchExplorer.next_wire,
    11: lambda own: own.toggle("gizmos"),
    12: lambda own: own.toggle("numbers"),
}


def _size(target: Target) -> tuple[int, int, int, bool]:
    return target.width, target.height, target.samples, target.top_row_first
