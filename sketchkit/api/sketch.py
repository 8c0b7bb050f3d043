"""Sketch: a sketch alive. It owns the canvas, the clock, the random numbers, mouse and keys."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sketchkit.api._sketch_parts import Canvas, Format, Keyboard, Pointer, Progress
from sketchkit.api.byte_files import ByteFiles
from sketchkit.api.chance import use_random
from sketchkit.api.data_files import DataFiles
from sketchkit.api.dates import Dates
from sketchkit.api.environment import Environment
from sketchkit.api.files import Files
from sketchkit.api.folders import Folders
from sketchkit.api.host import Host, NoWindow
from sketchkit.api.input import Input
from sketchkit.api.looping import Looping
from sketchkit.api.offscreen import Offscreen
from sketchkit.api.outside import Outside
from sketchkit.api.randomness import Randomness
from sketchkit.api.recording import Records
from sketchkit.api.registering import Registering
from sketchkit.api.requests import Requests
from sketchkit.api.window_ratio import WindowRatio
from sketchkit.api.windows import Windows
from sketchkit.assets.network import allow_network
from sketchkit.assets.output import picture_bytes
from sketchkit.assets.paths import set_sketch_folder
from sketchkit.core.clock import Clock, VirtualClock
from sketchkit.core.constants import FX2D, JAVA2D
from sketchkit.core.noise import PerlinNoise
from sketchkit.core.rng import JavaRandom
from sketchkit.core.turns import Turns


class Sketch(
    Environment,
    Offscreen,
    Looping,
    Input,
    Windows,
    WindowRatio,
    Files,
    Folders,
    Outside,
    ByteFiles,
    DataFiles,
    Requests,
    Records,
    Registering,
    Randomness,
    Dates,
):
    """What is the same in all of a sketch's functions; the sketch itself knows it as `this`.

    Parameters
    ----------
    canvas : PGraphics
        What it draws on.
    clock : Clock
        What time it is.
    host : Host
        Where it is shown.
    folder : Path
        Where its file lies.
    args : list of str
        What was written behind its name on the command line.
    seed : int
        Where its random numbers and its noise begin.
    """

    def __init__(
        self,
        canvas: Canvas,
        *,
        clock: Clock | None = None,
        host: Host | None = None,
        folder: Path | None = None,
        args: Sequence[str] = (),
        seed: int = 0,
    ) -> None:
        self.canvas = canvas
        self.progress = Progress()
        self.pointer = Pointer()
        self.keyboard = Keyboard()
        self.folder = folder or Path.cwd()
        self.args = list(args)
        self.namespace = {}
        self.handlers = {}
        self.registered = {}
        self._recordings = {}
        self._begun_files = []
        self._host = host or NoWindow()
        self._format = Format(density=self._host.density)
        self._clock = clock or VirtualClock()
        self._turns = Turns(self._clock.millis)
        self._random = JavaRandom(seed)
        self._noise = PerlinNoise(seed)
        self._first_seed = seed
        self._has_own_seeds = {"random": False, "noise": False}
        self._publish = _nothing
        self._reformat()

    def start_without_smoothing(self) -> None:
        """Begin as if `noSmooth()` had been called."""
        self._format.smoothing = 0
        self._reformat()

    @property
    def is_java2d(self) -> bool:
        """Whether it has asked for no renderer, so that its window is as JAVA2D's."""
        return self._format.renderer in (JAVA2D, FX2D)

    def set_key(self, key: object) -> None:
        """Take what one of its functions has set `key` to: a character, or a number such as 0."""
        self.keyboard.key = chr(key) if isinstance(key, int) else str(key)

    def attach(self, namespace: Mapping[str, object], publish: Callable[[], None]) -> None:
        """Belong to a program: to what its file has defined, and to what publishes live values."""
        self.namespace = namespace
        self._publish = publish

    def take_over(self) -> None:
        """Be the one whose files are found and whose `randomSeed()` rules `PVector.random2D()`.

        Images, vectors and lists belong to no sketch, but there is one at a time. Where time is
        virtual every run must give the same, and nothing is read from the internet.
        """
        allow_network(not isinstance(self._clock, VirtualClock))
        use_random(self._random)
        set_sketch_folder(self.folder)

    def _repr_png_(self) -> bytes:
        """Return the picture, as Jupyter asks for it."""
        return picture_bytes(self.canvas.image_data()[..., :3], ".png")

    if not TYPE_CHECKING:  # a checker must still find misspelt attributes

        def __getattr__(self, name: str) -> object:
            """Give `this.rect` as `rect`."""
            if name.startswith("_") or not hasattr(self.canvas, name):
                raise AttributeError(name, name=name, obj=self)
            return getattr(self.canvas, name)

    def __dir__(self) -> list[str]:
        """Return its attributes, and the canvas's."""
        return sorted({*super().__dir__(), *dir(self.canvas)})


def _nothing() -> None:
    """Stand in for the runtime, which publishes live values."""
