"""`sketchkit render`: the pictures of some frames, without a window, the same at every run."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import click

from sketchkit.assets.movies.encoder import MovieError
from sketchkit.assets.movies.movie import ENCODERS, is_movie
from sketchkit.assets.output import picture_bytes, write_file
from sketchkit.cli import say
from sketchkit.cli.film import film
from sketchkit.cli.frames import frames as frames_option
from sketchkit.cli.python_mode import python_mode
from sketchkit.cli.render_record import Record
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.core.clock import FRAMES_PER_SECOND
from sketchkit.core.errors import either
from sketchkit.runtime.backends import RENDERERS, RendererError, open_backend
from sketchkit.runtime.headless import Launch, render
from sketchkit.runtime.loader import Tell
from sketchkit.runtime.replay import EventsError, Replay, read_replay
from sketchkit.runtime.report import StoppedError

WRONG_CALL = 2  # exit status


@click.command(name="render")
@click.argument("sketches", metavar="SKETCH...", nargs=-1, required=True, type=sketch_file)
@click.option(
    "--frames",
    "numbers",
    type=frames_option,
    default="1",
    show_default=True,
    metavar="LIST",
    help="Values of frameCount: 3, 1,30, 1-60 or 1-60:5. 0 is the picture after setup().",
)
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    default=Path("out"),
    show_default=True,
    help="Where frame-0001.png and so on go; of several sketches, each to a folder of its own. "
    "Or a film: a name that ends in .mp4, .gif, .webp or .png.",
)
@click.option(
    "--renderer",
    type=click.Choice(RENDERERS),
    help="What draws. Without it OpenGL, and the CPU renderer where there is no OpenGL.",
)
@click.option(
    "--density",
    type=click.IntRange(1, 2),
    default=1,
    show_default=True,
    help="Pixels for each unit of the sketch, each way: 2 as on a screen of high density.",
)
@click.option(
    "--fps",
    type=click.FloatRange(min=0, min_open=True, max=1000),
    help="Frames a second of a film. Without it as many as the sketch asks for, or 60.",
)
@click.option("--seed", default=0, show_default=True, help="Where random() and noise() begin.")
@click.option(
    "--input",
    "events",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Replay mouse and keys from an events file; the README shows how one is written.",
)
@click.option(
    "--json",
    "record_path",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write a report: versions, renderer, and for each frame draw calls, vertices, time.",
)
@python_mode
@click.option("--traceback", is_flag=True, help="Show all that Python says about a mistake.")
def command(  # noqa: PLR0913 # click hands over each option
    sketches: Sequence[Path],
    numbers: tuple[int, ...],
    out: Path,
    renderer: str | None,
    density: int,
    fps: float | None,
    seed: int,
    events: Path | None,
    record_path: Path | None,
    python: int | None,
    traceback: bool,
) -> None:
    """Write the pictures of some frames of each SKETCH, a Python file or its folder, or a film.

    No window and no display are needed. Time, date, mouse and random numbers are fixed, so that
    two renders are equal to the last bit.
    """
    folders = _folders(sketches, out, fps)
    try:
        choice = open_backend(renderer)
    except RendererError as reason:
        say.note(f"The {renderer} renderer does not work here: {reason}.")
        sys.exit(WRONG_CALL)
    if choice.remark:
        say.note(choice.remark)
    record = Record(choice.backend, seed)
    replay = _replay(events)
    for sketch, folder in folders.items():
        try:
            rate = fps if is_movie(folder) else FRAMES_PER_SECOND
            launch = Launch(
                sketch,
                _teller(record),
                seed,
                replay=replay,
                python=python,
                density=density,
                rate=rate,
            )
            make = film if is_movie(folder) else _render_one
            make(launch, folder, numbers, record)
        except StoppedError as stopped:
            say.mistake(stopped.report, with_traceback=traceback)
            record.add_mistake(sketch, stopped.report)
        except MovieError as problem:
            say.note(str(problem))
            sys.exit(WRONG_CALL)
    if record_path:
        record.write(record_path)
    sys.exit(1 if record.mistakes else 0)


def _replay(events: Path | None) -> Replay:
    try:
        return read_replay(events) if events else Replay()
    except EventsError as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)


def _render_one(launch: Launch, folder: Path, numbers: Sequence[int], record: Record) -> None:
    for frame in render(launch, numbers, record.backend):
        file = folder / f"frame-{frame.number:04}.png"
        write_file(file, picture_bytes(frame.pixels, file.suffix))
        record.add_frame(launch.path, frame, file)


def _teller(record: Record) -> Tell:
    def tell(path: Path, line: int, text: str) -> None:
        say.remark(path, line, text)
        record.add_remark(path, line, text)

    return tell


def _folders(sketches: Sequence[Path], out: Path, fps: float | None) -> dict[Path, Path]:
    """Return where the pictures of each sketch go: a folder, or a film."""
    out = out.absolute()  # a sketch is run in its own folder
    if out.is_file() and not is_movie(out):
        raise click.UsageError(f"--out {out.name} is a file; a film ends in {either(ENCODERS)}.")
    if fps and not is_movie(out):
        raise click.UsageError("--fps is for a film: --out movie.mp4, say.")
    if len(sketches) > 1 and is_movie(out):
        raise click.UsageError("A film shows one sketch. Render them one after the other.")
    if len(sketches) == 1:
        return {sketches[0]: out}
    names = Counter(sketch.stem for sketch in sketches)
    twins = [name for name, count in names.items() if count > 1]
    if twins:
        raise click.UsageError(
            f"Two sketches are called {twins[0]}: their pictures would go to the same folder. "
            "Render them one after the other, with another --out."
        )
    return {sketch: out / sketch.stem for sketch in sketches}
