"""A sketch in a window: frames in time, mistakes shown, and a fresh start on each save."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from enum import Enum
from pathlib import Path
from typing import Protocol

from sketchkit.api.events import KeyEvent
from sketchkit.api.host import Host
from sketchkit.api.pshader import loaded_files, reload_shaders
from sketchkit.core.clock import RealClock
from sketchkit.core.constants import ESC
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.runtime.events import AnyEvent
from sketchkit.runtime.headless import Launch, opened
from sketchkit.runtime.loader import Tell
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.reload import Watch, compile_all
from sketchkit.runtime.report import Report, StoppedError, reporting
from sketchkit.runtime.source import PYTHON_MODE

IDLE_S = 0.1  # how long to wait for events when nothing is to be drawn
RATE_WEIGHT = 0.05  # of the newest frame in frameRate, as in Processing


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

    def wait(self, timeout_s: float) -> Sequence[AnyEvent]:
        """Return what has happened, at the latest after a while."""
        ...

    def pace(self, frames_per_second: float) -> None:
        """Prepare to show so many frames a second."""
        ...

    def show(self, target: Target) -> None:
        """Show a picture."""
        ...


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
    args : sequence of str
        What the sketch sees as `args`.
    python : 2 or 3, optional
        Which Python it is written in. Without it, the end of its name tells.
    tell : callable
        Called with file, line and text of each remark.
    say : callable
        Called with each mistake.
    now : callable
        Returns the time, in seconds from whenever.
    """

    def __init__(  # noqa: PLR0913 # one place calls it
        self,
        path: Path,
        screen: Screen,
        *,
        args: Sequence[str] = (),
        python: int | None = None,
        tell: Tell,
        say: Callable[[Report], None],
        now: Callable[[], float] = time.perf_counter,
    ) -> None:
        self._path = path.absolute()  # a sketch is run in its own folder
        self._screen = screen
        self._args = args
        self._python = python or (2 if path.suffix == PYTHON_MODE else 3)
        self._tell = tell
        self._say = say
        self._now = now
        self._picture: Target | None = None
        self._watch = Watch([self._path])

    def play(self) -> bool:
        """Play until the window is closed; tell whether all went well at the end."""
        while True:
            self._screen.set_title(self._path.stem)
            try:
                ending, is_well = self._run(), True
            except StoppedError as stopped:
                self._show(stopped.report)
                ending, is_well = self._wait_for_change(), False
            if ending is Ending.CLOSED:
                return is_well

    def _run(self) -> Ending:
        renderer = Renderer(self._screen.backend)
        seed = time.time_ns() & 0xFFFFFFFF
        launch = Launch(self._path, self._tell, seed, self._args, python=self._python)
        with opened(launch, renderer, RealClock(), self._screen) as loop:
            try:
                loop.begin()
            finally:
                self._watch.add(loop.program.files)
            self._picture = loop.program.sketch.canvas.target
            self._screen.show(self._picture)
            ending = self._go_on(loop)
            loop.end()
        return ending

    def _go_on(self, loop: Loop) -> Ending:
        progress = loop.program.sketch.progress
        due_s = last_s = self._now()
        while not (self._screen.is_closed or loop.is_finished):
            wait_s = due_s - self._now() if loop.is_drawing else IDLE_S
            for event in self._screen.wait(max(wait_s, 0.0)):
                loop.post(event)
            if self._has_new_version(loop):
                return Ending.CHANGED
            now_s = self._now()
            if loop.is_drawing and now_s < due_s:
                continue
            is_new = loop.step()
            self._show_picture()
            if not is_new:
                continue
            self._screen.pace(progress.wanted_rate)
            due_s = max(due_s + 1 / progress.wanted_rate, now_s)
            progress.measured_rate = _smoothed(progress.measured_rate, now_s - last_s)
            last_s = now_s
        return Ending.CLOSED

    def _has_new_version(self, loop: Loop) -> bool:
        """Tell whether a file was saved and can be read; if it cannot, the old version goes on."""
        shaders = loaded_files()
        self._watch.add([*loop.program.files, *shaders])
        changed = set(self._watch.changed())
        if not changed:
            return False
        try:
            with reporting(self._path):
                files = (path for path in changed if path.suffix in (".py", PYTHON_MODE))
                compile_all(files, self._python)
                reload_shaders(changed, self._screen.backend)
        except StoppedError as stopped:
            self._show(stopped.report)
            return False
        return bool(changed - shaders)

    def _wait_for_change(self) -> Ending:
        """Keep the window, with the last picture in it, until it is closed or a file is saved."""
        while not self._screen.is_closed:
            if self._watch.changed():
                return Ending.CHANGED
            for event in self._screen.wait(IDLE_S):
                if isinstance(event, KeyEvent) and event.key == ESC:
                    return Ending.CLOSED
            self._show_picture()
        return Ending.CLOSED

    def _show(self, report: Report) -> None:
        self._say(report)
        self._screen.set_title(f"{self._path.stem}: a mistake in {report.place}")

    def _show_picture(self) -> None:
        if self._picture is not None:
            self._screen.show(self._picture)


def _smoothed(rate: float, elapsed_s: float) -> float:
    """Return frames a second, so that one slow frame does not make the number jump."""
    average_s = (1 - RATE_WEIGHT) / rate + RATE_WEIGHT * elapsed_s
    return 1 / average_s
