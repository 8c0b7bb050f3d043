"""`%%sketch`: a notebook's cell is run as a sketch, and its picture or film is shown below it."""

from __future__ import annotations

import shlex
from argparse import ArgumentParser
from collections.abc import Callable
from io import BytesIO
from typing import NoReturn, Protocol

from sketchkit.assets.movies.apng import ApngEncoder
from sketchkit.core.errors import SketchError
from sketchkit.notebooks.rendering import render_text
from sketchkit.runtime.backends import RENDERERS
from sketchkit.runtime.frame_numbers import parse_frames


class Shell(Protocol):
    """IPython, as far as it is needed."""

    def register_magic_function(
        self, func: Callable[[str, str], object], magic_kind: str, magic_name: str
    ) -> None:
        """Make a function a magic one."""
        ...


class Picture:
    """What a cell shows: a PNG, which moves if it has several frames."""

    def __init__(self, png: bytes) -> None:
        self._png = png

    def _repr_png_(self) -> bytes:
        """Return it, as Jupyter asks for it."""
        return self._png


class _Options(ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise SketchError(f"%%sketch: {message}.", hint="Write %%sketch --frames 1-60, say.")


def load_ipython_extension(shell: Shell) -> None:
    """Take `%load_ext sketchkit`: from then on there is `%%sketch`."""
    shell.register_magic_function(sketch, "cell", "sketch")


def sketch(line: str, cell: str) -> Picture:
    """Run a cell as a sketch and return its picture; of several frames, an animation.

    Parameters
    ----------
    line : str
        Options: `--frames 1-60`, `--fps 30`, `--renderer cpu`, `--seed 5`.
    cell : str
        The sketch. Its files lie in the notebook's folder.

    Examples
    --------
    >>> sketch("--frames 1-30", "def draw(): circle(50, 50, frameCount)")  # doctest: +SKIP
    """
    options = _Options(prog="%%sketch", add_help=False)
    options.add_argument("--frames", type=parse_frames, default=(1,))
    options.add_argument("--fps", type=float)
    options.add_argument("--renderer", choices=RENDERERS)
    options.add_argument("--seed", type=int, default=0)
    chosen = options.parse_args(shlex.split(line))
    frames = render_text(cell, chosen.frames, chosen.renderer, chosen.seed)
    file = BytesIO()
    height, width = frames[0].pixels.shape[:2]
    film = ApngEncoder(file, (width, height), chosen.fps or frames[0].rate)
    for frame in frames:
        film.add(frame.pixels)
    film.finish()
    return Picture(file.getvalue())
