"""`sketchkit render --out movie.mp4`: frames become a film instead of pictures."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import click

from sketchkit.assets.movies.movie import Movie
from sketchkit.cli import say
from sketchkit.cli.render_record import Record
from sketchkit.runtime.headless import Frame, Launch, render


def film(launch: Launch, path: Path, numbers: Sequence[int], record: Record) -> None:
    """Render frames of a sketch into a film.

    It ends where the sketch ends. If the frames lie apart, as `1-60:5` does, so much time is
    between them in the film as well.
    """
    frames = render(launch, numbers, record.backend)
    movie: Movie | None = None
    last: int | None = None  # frame, if the sketch ended before the last one asked for
    try:
        for frame in progress(frames, len(numbers)):
            if frame.repeats is not None and movie:
                last = frame.repeats
                continue
            movie = movie or Movie(path, frame.rate / _step(numbers))
            movie.add(frame.pixels)
            record.add_frame(launch.path, frame, path)
        _finish(movie)
        if last is not None:
            say.note(f"The sketch draws no more after frame {last}: there the film ends.")
    finally:
        if movie:
            movie.give_up()


def progress(frames: Iterable[Frame], count: int) -> Iterator[Frame]:
    """Yield frames, with a bar on the terminal that shows how many there have been."""
    from rich.console import Console  # 60 ms to import
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeRemainingColumn

    console = Console(stderr=True)
    if not console.is_terminal:
        yield from frames
        return
    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        yield from bar.track(frames, total=count)


def _step(numbers: Sequence[int]) -> int:
    """Return how far apart the frames are; 1 if they are not evenly spaced."""
    gaps = {later - earlier for earlier, later in pairwise(sorted(set(numbers)))}
    return gaps.pop() if len(gaps) == 1 else 1


def _finish(movie: Movie | None) -> None:
    if movie is None:
        return
    remark = movie.finish()
    width, height = movie.size
    length = _length(movie.path)
    count = f"{movie.frame_count} frame{'s' * (movie.frame_count != 1)}"
    click.echo(
        f"{movie.path.name}: {count} of {width} x {height}, {movie.fps:g} a second, {length}",
        err=True,
    )
    if remark:
        say.note(remark)


def _length(path: Path) -> str:
    """Return the length of a file, as people say it."""
    length = path.stat().st_size
    return f"{length / 1e6:.1f} MB" if length > 1e5 else f"{length / 1e3:.1f} kB"
