"""Filming what a window shows: a key begins it, and the same key ends it.

The film keeps time: a frame that was shown for long is in it more than once, and one that was
gone too soon is not in it.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from pathlib import Path

from sketchkit.assets.movies.encoder import MovieError
from sketchkit.assets.movies.movie import Movie
from sketchkit.draw.vertex import U8


class Filming:
    """Makes `movie-0001.mp4` and so on, beside the sketch; GIFs where there is no PyAV.

    Parameters
    ----------
    folder : Path
        The sketch's.
    say : callable
        Told what has begun, and what has become of it.
    """

    def __init__(self, folder: Path, say: Callable[[str], None]) -> None:
        self._folder = folder
        self._say = say
        self._movie: Movie | None = None
        self._start_s = 0.0
        self._last: U8 | None = None  # frame, shown until the next: it is not in the film yet

    @property
    def is_on(self) -> bool:
        """Whether a film is being made."""
        return self._movie is not None

    def toggle(self, fps: float) -> None:
        """Begin a film of so many frames a second, or end the one that is being made."""
        if self.is_on:
            self.stop()
        else:
            self._begin(fps)

    def add(self, pixels: U8, now_s: float) -> None:
        """Add a frame, (h, w, 3 or 4), that is shown from now on; nothing if it is not filming."""
        movie = self._movie
        if movie is None:
            return
        if self._last is None:
            self._start_s, self._last = now_s, pixels
        place = round((now_s - self._start_s) * movie.fps)
        try:
            while movie.frame_count < place:
                movie.add(self._last)
            self._last = pixels
        except (MovieError, OSError) as problem:
            self._give_up(movie, problem)

    def stop(self) -> None:
        """End the film that is being made, if there is one."""
        movie, self._movie = self._movie, None
        if movie is None:
            return
        last, self._last = self._last, None
        try:
            if last is not None:
                movie.add(last)
            remark = movie.finish()
        except (MovieError, OSError) as problem:
            self._give_up(movie, problem)
            return
        seconds = movie.frame_count / movie.fps
        self._say(f"{movie.path.name}: {seconds:.1f} seconds.{f' {remark}' if remark else ''}")

    def _begin(self, fps: float) -> None:
        path = _free_name(self._folder, ".mp4" if importlib.util.find_spec("av") else ".gif")
        try:
            self._movie = Movie(path, fps)
        except OSError as problem:
            self._say(f"{path.name} cannot be written: {problem.strerror}.")
            return
        self._say(f"Filming {path.name}. The same key ends it.")

    def _give_up(self, movie: Movie, problem: Exception) -> None:
        self._movie = self._last = None
        movie.give_up()
        reason = problem.strerror if isinstance(problem, OSError) else str(problem)
        self._say(f"{movie.path.name} cannot be written: {reason}.")


def _free_name(folder: Path, ending: str) -> Path:
    """Return the name with the first number that no film has yet."""
    taken = {path.stem for path in folder.glob("movie-*")}
    number = 1
    while f"movie-{number:04}" in taken:
        number += 1
    return folder / f"movie-{number:04}{ending}"
