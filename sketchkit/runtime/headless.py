"""A sketch without a window: the pictures of the frames that are asked for, always the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import perf_counter
from typing import TypeAlias

from sketchkit.api.graphics import PGraphics
from sketchkit.api.host import Host, NoWindow
from sketchkit.api.sketch import Sketch
from sketchkit.core.clock import FRAMES_PER_SECOND, Clock, VirtualClock, milliseconds_of
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8
from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.explore.lookout import Lookout
from sketchkit.runtime.loader import Program, Tell, seed_everything
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.replay import Replay
from sketchkit.runtime.report import reporting
from sketchkit.runtime.source import Source

FIRST_SIZE = 100  # px, each way: what a sketch without size() has


@dataclass(frozen=True)
class Frame:
    """A picture of a sketch.

    Attributes
    ----------
    number : int
        frameCount, as it was asked for.
    pixels : (h, w, 3) uint8
        Top row first.
    draw_calls, vertices : int
        What the renderer was given for it.
    elapsed_ms : float
        How long it took to draw and to read back.
    rate : float
        Frames in a second of the sketch's clock.
    repeats : int or None
        The number of the frame whose picture this is, if the sketch drew no more by then.
    """

    number: int
    pixels: U8
    draw_calls: int
    vertices: int
    elapsed_ms: float
    rate: float = FRAMES_PER_SECOND
    repeats: int | None = None


@dataclass(frozen=True)
class Launch:
    """How a sketch is started.

    Attributes
    ----------
    path : Path
        Its file.
    tell : callable
        Called with file, line and text of each remark that does not stop it.
    seed : int
        Where its random numbers begin.
    args : sequence of str
        What it sees as `args`.
    replay : Replay
        What happens with mouse and keys.
    python : 2 or 3, optional
        Which Python it is written in. Without it, the end of its name tells.
    density : int
        Without a window: 1 or 2 pixels for each unit of the sketch, each way.
    rate : float or None
        Frames in a second of its clock; None: as many as it asks for by `frameRate()`.
    """

    path: Path
    tell: Tell
    seed: int = 0
    args: Sequence[str] = ()
    replay: Replay = field(default_factory=Replay)
    python: int | None = None
    density: int = 1
    rate: float | None = FRAMES_PER_SECOND


Opener: TypeAlias = Callable[[Launch, Renderer, Clock], AbstractContextManager[Loop]]


def render(
    launch: Launch,
    numbers: Sequence[int],
    backend: Backend,
    opener: Opener | None = None,
    *,
    looks: bool = True,
) -> Iterator[Frame]:
    """Yield the pictures of some frames of a sketch, in rising order.

    Parameters
    ----------
    launch : Launch
        The sketch.
    numbers : sequence of int
        Values of frameCount; 0 is the picture after `setup()`.
    backend : Backend
        What draws.
    opener : callable, optional
        Makes the sketch ready to begin, if it is no file: see `started`.
    looks : bool
        Whether the sketch is told when nothing of what it draws shows. Not if nothing is drawn.

    Raises
    ------
    StoppedError
        If the sketch stops by a mistake; the frames before that have been yielded.
    """
    renderer = Renderer(backend)
    clock = VirtualClock()
    with (opener or opened)(launch, renderer, clock) as loop:
        seed_everything(launch.seed)
        steps = Steps(loop, clock, launch.replay, launch.rate)
        lookout = Lookout(loop.program, renderer)
        if not looks:
            lookout.stop()
        for frame in _frames(steps, renderer, lookout, sorted(set(numbers))):
            if remark := lookout.look(frame.pixels, steps.frame):
                launch.tell(remark.path, remark.line, remark.text)
            yield frame


@contextmanager
def opened(
    launch: Launch, renderer: Renderer, clock: Clock, host: Host | None = None
) -> Iterator[Loop]:
    """Read a sketch and make it ready to begin; at the end of the block it is gone.

    Raises
    ------
    StoppedError
        If it cannot be read, or stops by a mistake in the block.
    """
    with reporting(launch.path):
        source = Source.read(launch.path, launch.python)

    def make(sketch: Sketch, tell: Tell) -> Program:
        return Program(source, sketch, tell)

    with started(make, launch, renderer, clock, host) as loop:
        yield loop


@contextmanager
def started(
    make: Callable[[Sketch, Tell], Program],
    launch: Launch,
    renderer: Renderer,
    clock: Clock,
    host: Host | None = None,
) -> Iterator[Loop]:
    """Make a program ready to begin; at the end of the block it is gone.

    Parameters
    ----------
    make : callable
        Makes the program, for a sketch that is new.

    Raises
    ------
    StoppedError
        If it stops by a mistake in the block.
    """
    sketch = Sketch(
        PGraphics(renderer, Target(FIRST_SIZE, FIRST_SIZE)),
        clock=clock,
        host=host or NoWindow(launch.density),
        folder=launch.path.absolute().parent,
        args=launch.args,
        seed=launch.seed,
    )
    program = make(sketch, launch.tell)
    with program, reporting(launch.path, program):  # as long as its names are there
        yield Loop(program, restarts_chance=isinstance(clock, VirtualClock))


class Steps:
    """Takes a sketch from frame to frame by a virtual clock, and the hand with it.

    Attributes
    ----------
    loop : Loop
    rate : float
        Frames in a second of the clock; 0 before `begin()`, if the sketch is to say it.
    frame : int
        The one that was drawn last. After `noLoop()` it goes on as long as events are to come.
    """

    def __init__(
        self,
        loop: Loop,
        clock: VirtualClock,
        replay: Replay,
        rate: float | None = FRAMES_PER_SECOND,
    ) -> None:
        self.loop = loop
        self.rate = rate or 0.0
        self.frame = 0
        self._clock = clock
        self._replay = replay

    def begin(self) -> None:
        """Make the picture of frame 0; only then is known how fast the sketch wants to be."""
        self.loop.begin()
        self.rate = self.rate or self.loop.program.sketch.progress.wanted_rate
        self._clock.frames_per_second = self.rate

    @property
    def can_go_on(self) -> bool:
        """Whether there is another frame that may differ from this one."""
        if self.loop.is_finished:
            return False
        return self.loop.is_drawing or self._replay.goes_on_after(self.frame)

    def step(self) -> None:
        """Take the next frame."""
        self.frame += 1
        self._clock.frame = self.frame
        for event in self._replay.at(self.frame):
            self.loop.post(self._at_this_time(event))
        self.loop.step()

    def _at_this_time(self, event: AnyEvent) -> AnyEvent:
        """Return an event that agrees with the sketch's clock.

        Events are tied to frames: the same hand does the same in a film of another rate. So a
        double click stays one, however far apart its frames are on that film's clock; but what
        an event says of its time is what `millis()` says in the same frame.
        """
        if isinstance(event, WindowEvent) or self.rate == FRAMES_PER_SECOND:
            return event
        return replace(event, millis=milliseconds_of(self.frame, self.rate))


def _frames(
    steps: Steps, renderer: Renderer, lookout: Lookout, numbers: Sequence[int]
) -> Iterator[Frame]:
    loop = steps.loop
    canvas = loop.program.sketch.canvas
    with lookout.watching(0):
        elapsed_s = _timed(steps.begin, renderer)
    for number in numbers:
        while steps.frame < number and steps.can_go_on:
            is_wanted = steps.frame + 1 in (1, 2, number)
            with lookout.watching(steps.frame + 1) if is_wanted else nullcontext():
                elapsed_s = _timed(steps.step, renderer)
        reading = perf_counter()
        pixels = canvas.image_data()[:, :, :3]
        yield Frame(
            number,
            pixels,
            renderer.stats.draw_calls,
            renderer.stats.vertices,
            round((elapsed_s + perf_counter() - reading) * 1000, 3),
            steps.rate,
            steps.frame if steps.frame < number else None,
        )
    loop.end()


def _timed(draw: Callable[[], object], renderer: Renderer) -> float:
    """Draw, counting from zero, and return how many seconds it took."""
    renderer.reset_stats()
    start = perf_counter()
    draw()
    return perf_counter() - start
