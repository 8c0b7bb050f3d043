"""A sketch in a window: frames in time, mistakes shown, and a fresh start on each save."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import Protocol

from sketchkit.api.events import KeyEvent
from sketchkit.api.host import Host
from sketchkit.api.pshader import loaded_files, reload_shaders
from sketchkit.assets.paths import files_read
from sketchkit.core.clock import RealClock, VirtualClock
from sketchkit.core.constants import ESC
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.events import AnyEvent
from sketchkit.runtime.explorer import Explorer, NoExplorer
from sketchkit.runtime.filming import Filming
from sketchkit.runtime.headless import Launch, opened
from sketchkit.runtime.inputs import Inputs, Live
from sketchkit.runtime.last_picture import LastPicture
from sketchkit.runtime.loader import Tell, seed_everything
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.mistake_panel import draw_mistake, shown_size
from sketchkit.runtime.overlay import Overlay
from sketchkit.runtime.pacing import Pacer, smoothed
from sketchkit.runtime.reload import Watch, compile_all, exchange
from sketchkit.runtime.report import Report, StoppedError, reporting
from sketchkit.runtime.run import Run
from sketchkit.runtime.source import PYTHON_MODE

IDLE_S = 0.05  # how long to wait for events when nothing is to be drawn; then files are looked at
SCREEN_RATE = 60.0  # of showing when the sketch draws slower, or not at all
FIRST_PICTURE = 640, 360  # px; what a mistake is shown on before there is any picture


class Screen(Host, Protocol):
    """What the player needs of a window."""

    @property
    def backend(self) -> Backend:
        """What draws in it."""
        ...

    @property
    def is_closed(self) -> bool:
        """Whether the user has closed it."""
        ...

    def now(self) -> float:
        """Return the time, in seconds from whenever."""
        ...

    def wait(self, timeout_s: float) -> Sequence[AnyEvent]:
        """Return what has happened, at the latest after a while."""
        ...

    def pace(self, frames_per_second: float) -> None:
        """Prepare to show so many frames a second."""
        ...

    def show(self, target: Target) -> None:
        """Show a picture."""
        ...

    @property
    def is_damaged(self) -> bool:
        """Whether what was shown is lost, as when another window lay over it."""
        ...


@dataclass(frozen=True)
class Manner:
    """How a sketch is to be played.

    Attributes
    ----------
    args : sequence of str
        What it sees as `args`.
    inputs : Inputs
        Where its events come from.
    reloads : bool
        Whether it begins anew when one of its files is saved.
    keeps_state : bool
        Whether a saved text takes the place of the old one instead, if it can: see `carrying`.
    python : 2 or 3, optional
        Which Python it is written in. Without it, the end of its name tells.
    """

    args: Sequence[str] = ()
    inputs: Inputs = field(default_factory=Live)
    reloads: bool = True
    keeps_state: bool = False
    python: int | None = None


PLAIN = Manner()
NO_EXPLORER = NoExplorer()


class Ending(Enum):
    """Why a sketch runs no more."""

    CLOSED = "the window was closed, or the sketch has ended"
    CHANGED = "its file was saved"


class Player:
    """Plays a file in a window until that is closed.

    Parameters
    ----------
    path : Path
        The sketch's file.
    screen : Screen
        The window.
    manner : Manner
        How it is to be played.
    tell : callable
        Called with file, line and text of each remark.
    say : callable
        Called with each mistake.
    note : callable
        Called with what becomes of a film.
    explorer : Explorer, optional
        What looks at the sketch while it runs.
    """

    def __init__(  # noqa: PLR0913 # one place calls it
        self,
        path: Path,
        screen: Screen,
        manner: Manner = PLAIN,
        *,
        tell: Tell,
        say: Callable[[Report], None],
        note: Callable[[str], None] = print,
        explorer: Explorer = NO_EXPLORER,
    ) -> None:
        self._path = path.absolute()  # a sketch is run in its own folder
        self._screen = screen
        self._manner = manner
        self._python = manner.python or (2 if path.suffix == PYTHON_MODE else None)
        self._tell = tell
        self._say = say
        self._explorer = explorer
        self._filming = Filming(self._path.parent, note)
        self._last = LastPicture(screen.backend)
        self._size = FIRST_PICTURE  # of the window, as the sketch wants it
        self._overlay, self._panel = Overlay(screen.backend), Overlay(screen.backend)
        self._mistake: Report | None = None
        self._watch = Watch([self._path])

    def play(self) -> bool:
        """Play until the window is closed; tell whether all went well at the end."""
        while True:
            self._screen.set_title(self._path.stem)
            try:
                ending, is_well = self._run(), True
            except StoppedError as stopped:
                self._show_mistake(stopped.report)
                ending, is_well = self._wait_for_change(), False
            if ending is Ending.CLOSED:
                return is_well

    def _run(self) -> Ending:
        renderer = Renderer(self._screen.backend)
        is_repeatable = self._manner.inputs.is_repeatable
        seed = 0 if is_repeatable else time.time_ns() & 0xFFFFFFFF
        clock = VirtualClock() if is_repeatable else RealClock(self._screen.now)
        self._manner.inputs.begin()
        launch = Launch(self._path, self._tell, seed, self._manner.args, python=self._python)
        with opened(launch, renderer, clock, self._screen) as loop:
            if is_repeatable:
                seed_everything(seed)
            self._explorer.begin(loop, renderer)
            self._last.follow(loop, renderer)
            try:
                loop.begin()
                if self._last.target is None or not loop.is_drawing:
                    self._take_picture(loop)  # else the first frame is to take the old one's place
                ending = self._go_on(Run(loop, clock, Pacer(self._screen.now())))
                loop.end()
            finally:
                canvas = loop.program.sketch.canvas
                self._size = canvas.width, canvas.height
                self._last.stop()
                self._filming.stop()
                self._watch.add([*loop.program.files, *files_read()])
                self._explorer.end()
        return ending

    def _go_on(self, run: Run) -> Ending:
        loop, screen, inputs = run.loop, self._screen, self._manner.inputs
        while not (screen.is_closed or loop.is_finished):
            for event in screen.wait(self._wait_s(run)):
                if not self._explorer.handles(event):
                    for heard in inputs.take(event, run.frame + 1):
                        loop.post(heard)
            if self._explorer.takes_film():
                self._toggle_film(run)
            if self._must_begin_anew(loop):
                return Ending.CHANGED
            is_paused = self._explorer.is_paused
            run.pass_time(0.0 if is_paused else self._explorer.speed)
            if is_paused:
                self._stand_still(run)
            elif not (self._is_moving(run) and run.pacer.wait_s(screen.now())):
                self._take_frame(run)
        return Ending.CLOSED

    def _toggle_film(self, run: Run) -> None:
        """Begin a film, or end it."""
        self._film(run)  # the last frame is shown until now
        self._filming.toggle(run.loop.program.sketch.progress.wanted_rate)
        self._film(run)

    def _film(self, run: Run) -> None:
        """Add the sketch's own picture to the film, if one is being made."""
        if self._filming.is_on:
            self._filming.add(run.loop.program.sketch.canvas.image_data(), self._screen.now())

    def _is_moving(self, run: Run) -> bool:
        """Return whether frames follow one another by themselves."""
        return run.loop.is_drawing or self._manner.inputs.is_repeatable

    def _wait_s(self, run: Run) -> float:
        """Return how long nothing needs to be done unless something happens."""
        if self._explorer.is_paused:
            return 1 / SCREEN_RATE
        return run.pacer.wait_s(self._screen.now()) if self._is_moving(run) else IDLE_S

    def _take_frame(self, run: Run) -> None:
        """Draw a frame if one is due, handle what has happened, and show it."""
        progress, now_s = run.loop.program.sketch.progress, self._screen.now()
        is_new = run.step(self._manner.inputs)
        if is_new:
            self._screen.pace(progress.wanted_rate)
            self._film(run)
            self._take_picture(run.loop)
        elif self._screen.is_damaged or self._explorer.has_overlay:
            self._show_picture()
        if not self._is_moving(run):
            run.pacer.begin_anew(now_s)
            return
        lasted_s = run.pacer.go_on(now_s, progress.wanted_rate * self._explorer.speed)
        if lasted_s > 0:
            progress.measured_rate = smoothed(progress.measured_rate, lasted_s)

    def _stand_still(self, run: Run) -> None:
        """Draw one frame if the explorer wants it, and show the picture."""
        if self._explorer.takes_step():
            run.skip_time(1 / run.loop.program.sketch.progress.wanted_rate)
            if run.step(self._manner.inputs):
                self._take_picture(run.loop)
        self._show_picture()
        run.pacer.begin_anew(self._screen.now())

    def _must_begin_anew(self, loop: Loop) -> bool:
        """Tell whether a file was saved and can be read; if it cannot, the old version goes on."""
        if not self._manner.reloads:
            return False
        shaders = loaded_files()
        self._watch.add([*loop.program.files, *shaders, *files_read()])
        saved = self._watch.changed()
        changed = {path for path in saved if not self._explorer.takes_written(path)}
        if not changed:
            return False
        try:
            with reporting(self._path):
                files = (path for path in changed if path.suffix in (".py", PYTHON_MODE))
                compile_all(files, self._python)
                reload_shaders(changed, self._screen.backend)
            is_exchanged = self._manner.keeps_state and exchange(loop, changed - shaders)
        except StoppedError as stopped:
            self._show_mistake(stopped.report)
            return False
        if self._mistake is not None:
            self._screen.set_title(self._path.stem)
            self._clear_mistake()
        return bool(changed - shaders) and not is_exchanged

    def _wait_for_change(self) -> Ending:
        """Keep the window, with the mistake in it, until it is closed or a file is saved."""
        while not self._screen.is_closed:
            if self._manner.reloads and self._watch.changed():
                return Ending.CHANGED
            for event in self._screen.wait(IDLE_S):
                if isinstance(event, KeyEvent) and event.key == ESC:
                    return Ending.CLOSED
            if self._screen.is_damaged:
                self._show_picture()
        return Ending.CLOSED

    def _take_picture(self, loop: Loop) -> None:
        """Show a picture that is complete; the first one of a text clears the mistake before."""
        is_first = not self._last.is_of_run
        self._last.take(loop.program.sketch.canvas.target)
        if is_first:
            self._clear_mistake()
        self._show_picture()

    def _show_mistake(self, report: Report) -> None:
        """Tell a mistake, and show it over the last picture, in a window that is large enough."""
        self._say(report)
        self._mistake = report
        self._screen.set_title(f"{self._path.stem}: a mistake in {report.place}")
        if self._last.target is None:
            self._last.take(Target(*FIRST_PICTURE))
        picture = self._last.target
        assert picture is not None
        if (size := shown_size(picture.across, picture.down)) != self._size:
            self._screen.set_size(*size)
        self._show_picture()

    def _clear_mistake(self) -> None:
        """Show the sketch alone again, in a window of its size."""
        if self._mistake is None:
            return
        self._mistake = None
        if picture := self._last.target:
            self._screen.set_size(picture.across, picture.down)

    def _show_picture(self) -> None:
        picture = self._last.target
        if picture is None:
            return
        shown = self._explorer.picture(picture)
        size = shown.across, shown.down
        if self._explorer.has_overlay:
            shown = self._overlay.over(shown, size, self._explorer.draw_over)
        if report := self._mistake:
            shown = self._panel.over(
                shown, shown_size(*size), lambda canvas: draw_mistake(canvas, report)
            )
        self._screen.show(shown)
