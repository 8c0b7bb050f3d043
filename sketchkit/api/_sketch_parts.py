"""What a sketch is made of: the only attributes that the groups of its methods may use."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from sketchkit.api.events import KeyEvent, MouseEvent
from sketchkit.api.host import Host
from sketchkit.core.clock import Clock
from sketchkit.core.constants import JAVA2D
from sketchkit.core.turns import Turns
from sketchkit.draw.renderer import Reader
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8

if TYPE_CHECKING:
    from sketchkit.api.data.streams import OutputStream, PrintWriter
    from sketchkit.vector.page import Page

SMOOTH_SAMPLES = 4  # for each pixel; Processing's driver gives 4 for every level of smooth()


class Canvas(Protocol):
    """What a sketch asks of the surface it draws on."""

    @property
    def width(self) -> int:
        """Columns of pixels."""
        ...

    @property
    def height(self) -> int:
        """Rows of pixels."""
        ...

    @property
    def target(self) -> Target:
        """What it draws on."""
        ...

    @property
    def has_shapes(self) -> bool:
        """Whether something but a background was drawn since the last flush."""
        ...

    @property
    def repeats_keys(self) -> bool:
        """Whether keys that repeat because they are held reach the sketch in P2D and P3D."""
        ...

    def resize(
        self, width: int, height: int, renderer_name: str, samples: int, density: int = 1
    ) -> None:
        """Give the canvas another size; what was drawn is lost."""
        ...

    def offscreen(self, width: int, height: int, renderer_name: str, samples: int) -> Canvas:
        """Return another canvas, drawn on out of sight."""
        ...

    def begin_frame(self, *, is_looping: bool = True) -> None:
        """Put back matrix and lights."""
        ...

    def translate(self, x: float, y: float, z: float = 0.0) -> None:
        """Move the origin."""
        ...

    def scale(self, x: float, /) -> None:
        """Make all that follows larger."""
        ...

    def end_frame(self) -> None:
        """Draw everything recorded so far."""
        ...

    def image_data(self) -> U8:
        """Return the picture, (h, w, 4) RGBA, top row first."""
        ...

    def when_drawn(self, call: Callable[[], None]) -> None:
        """Have `call` called at each `endDraw()`."""
        ...

    def look(self, target: Target) -> U8:
        """Return what is on a canvas without what was recorded last, (h, w, 4)."""
        ...

    def begin_reading(self, reader: Reader) -> None:
        """Have a reader follow what is drawn from now on."""
        ...

    def end_reading(self, reader: Reader) -> None:
        """Have it follow no longer."""
        ...


class Phase(IntEnum):
    """How far a sketch has come: some functions make sense only up to a point."""

    LOADING = 0  # the file's own lines are run
    SETTINGS = 1
    SETUP = 2
    DRAW = 3


@dataclass
class Progress:
    """Where a sketch is in its life.

    Attributes
    ----------
    phase : Phase
        What is being run.
    frame_count : int
        0 in `setup()`, 1 in the first `draw()`.
    is_looping, is_redraw_due, is_finished : bool
        Whether `draw()` is called again and again; once more; or never again.
    wanted_rate, measured_rate : float
        Frames a second, as asked for and as reached.
    """

    phase: Phase = Phase.LOADING
    frame_count: int = 0
    is_looping: bool = True
    is_redraw_due: bool = True
    is_finished: bool = False
    wanted_rate: float = 60.0
    measured_rate: float = 60.0
    failures: list[BaseException] = field(default_factory=list)  # of threads; raised in the loop
    due_calls: list[Callable[[], object]] = field(
        default_factory=list
    )  # of dialogs that are closed


@dataclass
class Format:
    """The size and kind of canvas that the sketch has asked for."""

    width: int = 100
    height: int = 100
    renderer: str = JAVA2D
    density: int = 1
    smoothing: int = 2  # 0: one sample for each pixel; else SMOOTH_SAMPLES
    ratio: tuple[int, int] | None = None  # the area of windowRatio()


@dataclass
class Pointer:
    """The mouse: where it is, where it was at the last `draw()` and at the last event."""

    x: int = 0
    y: int = 0
    previous_x: int = 0
    previous_y: int = 0
    drawn_x: int = 0
    drawn_y: int = 0
    event_x: int = 0
    event_y: int = 0
    button: int = 0
    is_pressed: bool = False
    is_new: bool = True  # until it has been over the window
    event: MouseEvent | None = None


@dataclass
class Keyboard:
    """The keys: the last one, and those that are held."""

    key: str = "\0"
    code: int = 0
    held: set[int] = field(default_factory=set)
    event: KeyEvent | None = None


class PageReader(Reader, Protocol):
    """Makes a page of what is drawn."""

    def finish(self) -> Page:
        """Return the page."""
        ...


@dataclass(frozen=True)
class Recording:
    """A file that is being drawn into, and what writes it in the end."""

    filename: str
    write: Callable[[Page], bytes]
    reader: PageReader


class SketchParts:
    """All the attributes there are. Groups add methods, never attributes.

    `namespace` is what the student's file has defined, `handlers` those of its functions whose
    names are values too; `registered` is what libraries want to have called, by its method's name;
    `_publish` is called when live values change in the middle of a function.
    """

    canvas: Canvas
    progress: Progress
    pointer: Pointer
    keyboard: Keyboard
    folder: Path
    args: list[str]
    namespace: Mapping[str, object]
    handlers: dict[str, Callable[..., object]]
    registered: dict[str, list[object]]
    _recordings: dict[str, Recording]
    _begun_files: list[PrintWriter | OutputStream]
    _format: Format
    _host: Host
    _clock: Clock
    _turns: Turns
    _publish: Callable[[], None]

    def _reformat(self) -> None:
        wanted = self._format
        samples = SMOOTH_SAMPLES if wanted.smoothing else 1
        size = wanted.width, wanted.height
        self.canvas.resize(*size, wanted.renderer, samples, wanted.density)
        self._publish()
