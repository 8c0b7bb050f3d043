"""A film: it is given frames, and lies there whole when it is finished, or not at all."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, Self

import numpy as np

from sketchkit.assets.movies.apng import ApngEncoder
from sketchkit.assets.movies.encoder import U8, Encoder, MovieError
from sketchkit.assets.movies.gif import GifEncoder
from sketchkit.assets.movies.mp4 import Mp4Encoder
from sketchkit.assets.movies.webp import WebpEncoder
from sketchkit.assets.output import copy_to_file
from sketchkit.core.errors import either

# By the ending of the file's name.
ENCODERS: dict[str, Callable[[BinaryIO, tuple[int, int], float], Encoder]] = {
    ".mp4": Mp4Encoder,
    ".gif": GifEncoder,
    ".webp": WebpEncoder,
    ".png": ApngEncoder,
    ".apng": ApngEncoder,
}


def is_movie(path: Path) -> bool:
    """Return whether a name is that of a film."""
    return path.suffix.lower() in ENCODERS and not path.is_dir()


class Movie:
    """A film that is being made. As a block it is finished at the end, and given up by an error.

    It grows in a file without a name, which vanishes with the process: only a film that is
    finished gets a name.

    Parameters
    ----------
    path : Path
        Where it is to lie; the ending says the kind.
    fps : float
        Frames a second.

    Raises
    ------
    MovieError
        If it is of no known kind, or what writes it is not installed.

    Examples
    --------
    >>> with Movie(Path("spin.gif"), 30) as movie:  # doctest: +SKIP
    ...     for pixels in frames:
    ...         movie.add(pixels)
    """

    def __init__(self, path: Path, fps: float) -> None:
        if path.suffix.lower() not in ENCODERS:
            raise MovieError(f"A film's name ends in {either(ENCODERS)}.", got=repr(path.name))
        self.path = path
        self.fps = fps
        self.frame_count = 0
        self.size = (0, 0)  # of the first frame, and so of all
        self._encoder: Encoder | None = None
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = tempfile.TemporaryFile(dir=path.parent)  # noqa: SIM115 # closed by the block

    def add(self, pixels: U8) -> None:
        """Add a frame, (h, w, 3 or 4) uint8, top row first.

        If its size differs from the first one's, what is too much is cut off on the right and at
        the bottom, and what is missing is black.
        """
        pixels = pixels[..., :3]
        if self._encoder is None:
            self.size = (pixels.shape[1], pixels.shape[0])
            make = ENCODERS[self.path.suffix.lower()]
            self._encoder = make(self._file, self.size, self.fps)
        self._encoder.add(_fitted(pixels, self.size))
        self.frame_count += 1

    def finish(self) -> str | None:
        """Put the film where it belongs; return what the user should know, if there is anything."""
        if self._encoder is None:
            self.give_up()
            return None
        remark = self._encoder.finish()
        copy_to_file(self.path, self._file)
        self.give_up()
        return remark

    def give_up(self) -> None:
        """Forget it, unless it is finished."""
        if self._encoder:
            self._encoder.close()
        self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if error is None:
            self.finish()
        else:
            self.give_up()


def _fitted(pixels: U8, size: tuple[int, int]) -> U8:
    """Return a frame of the film's size, as an array of its own."""
    width, height = size
    fitted = np.zeros((height, width, 3), np.uint8)
    part = pixels[:height, :width]
    fitted[: part.shape[0], : part.shape[1]] = part
    return fitted
