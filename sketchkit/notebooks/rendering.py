"""`sketchkit.render()`: the pictures of a sketch as arrays, for notebooks and other programs."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import cache
from pathlib import Path
from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, TypeAlias

from sketchkit.api.sketch import Sketch
from sketchkit.core.clock import Clock
from sketchkit.core.errors import SketchError, shown
from sketchkit.draw.backend import Backend
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.vertex import U8
from sketchkit.notebooks.functions import CELL, FunctionsProgram
from sketchkit.runtime import headless
from sketchkit.runtime.backends import open_backend
from sketchkit.runtime.frame_numbers import parse_frames
from sketchkit.runtime.headless import Frame, Launch
from sketchkit.runtime.loader import Program, Tell
from sketchkit.runtime.loop import Loop
from sketchkit.runtime.source import Source

if TYPE_CHECKING:
    from PIL.Image import Image

MAGIC_CELL = "cell.py"  # what the text of a cell is called in mistakes

Function: TypeAlias = Callable[..., object]
Functions: TypeAlias = Mapping[str, object] | ModuleType | Iterable[Function]


def render(
    sketch: str | Path | Functions = (),
    *,
    frames: int | str | Iterable[int] = 1,
    renderer: str | None = None,
    seed: int = 0,
    as_images: bool = False,
    **functions: Function,
) -> list[U8] | list[Image]:
    """Return the pictures of some frames of a sketch, as `sketchkit render` makes them.

    Parameters
    ----------
    sketch : path, or functions
        The sketch's file. Or its functions, which see Processing's names while they run: a
        dictionary (in a notebook `globals()`), a module, or a list of them.
    frames : int, text or iterable of int
        Values of frameCount: 30, "1-60:5", range(1, 61). 0 is the picture after `setup()`.
    renderer : "gl" or "cpu", optional
        What draws. Without it OpenGL, and the renderer in NumPy where there is no OpenGL.
    seed : int
        Where `random()` and `noise()` begin.
    as_images : bool
        Whether pictures are Pillow's instead of arrays: a notebook shows them.
    **functions : callable
        `setup=...`, `draw=...`: single functions, in place of those of `sketch`.

    Returns
    -------
    list of (h, w, 3) uint8, or of PIL images
        In rising order of their frames, top row first.

    Raises
    ------
    StoppedError
        If the sketch has a mistake; its message is what the command line shows.

    Examples
    --------
    >>> def draw():
    ...     background(0, 0, 255)
    >>> sketchkit.render(draw=draw)[0][50, 50]
    array([  0,   0, 255], dtype=uint8)
    """
    numbers = _numbers(frames)
    opener: headless.Opener | None = None
    if isinstance(sketch, str | Path):
        if functions:
            raise SketchError("render() takes a file or functions, not both.", got=shown(sketch))
        launch = Launch(Path(sketch), _tell, seed)
    else:
        known = {**_by_name(sketch), **functions}
        launch, opener = Launch(Path.cwd() / CELL, _tell, seed), _opener_of(known)
    pictures = [
        frame.pixels.copy()
        for frame in headless.render(launch, numbers, backend_of(renderer), opener)
    ]
    return as_pillow(pictures) if as_images else pictures


def render_text(text: str, numbers: Sequence[int], renderer: str | None, seed: int) -> list[Frame]:
    """Return the pictures of a sketch that is a text and lies in no file."""
    source = Source(Path.cwd() / MAGIC_CELL, text.encode())

    def opener(launch: Launch, renderer: Renderer, clock: Clock) -> AbstractContextManager[Loop]:
        return headless.started(lambda *rest: Program(source, *rest), launch, renderer, clock)

    launch = Launch(source.path, _tell, seed)
    return list(headless.render(launch, numbers, backend_of(renderer), opener))


@cache
def backend_of(renderer: str | None) -> Backend:
    """Return what draws. It stays, so that canvases and shapes can be shown when a run is over."""
    choice = open_backend(renderer)
    if choice.remark:
        print(choice.remark, file=sys.stderr)
    return choice.backend


def as_pillow(pictures: Iterable[U8]) -> list[Image]:
    """Return pictures as Pillow's images."""
    from PIL.Image import fromarray  # 40 ms to import

    return [fromarray(pixels) for pixels in pictures]


def _opener_of(functions: Mapping[str, object]) -> headless.Opener:
    def opener(launch: Launch, renderer: Renderer, clock: Clock) -> AbstractContextManager[Loop]:
        def make(sketch: Sketch, tell: Tell) -> Program:
            return FunctionsProgram(functions, sketch, tell)

        return headless.started(make, launch, renderer, clock)

    return opener


def _by_name(functions: Functions) -> Mapping[str, object]:
    if isinstance(functions, ModuleType):
        return vars(functions)
    if isinstance(functions, Mapping):
        return functions
    listed = list(functions)
    if all(isinstance(each, FunctionType) for each in listed):
        return {getattr(each, "__name__", ""): each for each in listed}
    raise SketchError(
        "render() takes a sketch's file, or functions: a dictionary, a module or a list of them.",
        got=shown(functions),
    )


def _numbers(frames: int | str | Iterable[int]) -> Sequence[int]:
    match frames:
        case int():
            return [frames]
        case str():
            return parse_frames(frames)
    return list(frames)


def _tell(path: Path, line: int, text: str) -> None:
    name = path.name if path.is_file() or path.name == MAGIC_CELL else CELL
    print(f"{name}, line {line}: {text}", file=sys.stderr)
