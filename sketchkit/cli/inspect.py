"""`sketchkit inspect`: which line of a sketch has drawn a pixel."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path

import click

from sketchkit.cli import say
from sketchkit.cli.python_mode import python_mode
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.runtime.backends import RENDERERS, RendererError, open_backend
from sketchkit.runtime.explore.inspection import OutsideError, as_value, inspect, report
from sketchkit.runtime.headless import Launch
from sketchkit.runtime.replay import EventsError, Replay, read_replay
from sketchkit.runtime.report import StoppedError

WRONG_CALL = 2  # exit status


def pixel(text: str) -> tuple[int, int]:
    """Return x and y of `120,80`.

    Raises
    ------
    click.BadParameter
        If that is no pixel.
    """
    try:
        x, y = (int(part) for part in text.split(","))
    except ValueError:
        raise click.BadParameter(
            f"{text} is no pixel. Write x and y with a comma between: 120,80"
        ) from None
    return x, y


@click.command(name="inspect")
@click.argument("sketch", type=sketch_file)
@click.option("--frame", default=1, show_default=True, type=click.IntRange(0), help="Which.")
@click.option(
    "--pixel",
    "pixels",
    required=True,
    multiple=True,
    type=pixel,
    metavar="X,Y",
    help="Counted from the top left of the picture. May be given more than once.",
)
@click.option("--seed", default=0, show_default=True, help="Where random() and noise() begin.")
@click.option(
    "--input",
    "events",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Replay mouse and keys from an events file.",
)
@click.option("--renderer", type=click.Choice(RENDERERS), help="What draws.")
@python_mode
@click.option("--json", "as_json", is_flag=True, help="Print JSON instead of text.")
@click.option("--traceback", is_flag=True, help="Show all that Python says about a mistake.")
def command(  # noqa: PLR0913 # click hands over each option
    sketch: Path,
    frame: int,
    pixels: Sequence[tuple[int, int]],
    seed: int,
    events: Path | None,
    renderer: str | None,
    python: int | None,
    as_json: bool,
    traceback: bool,
) -> None:
    """Say which line of SKETCH has drawn a pixel: with which matrix, colours, lights and shader.

    Everything else that was drawn there is listed too, and why it does not show. Frame 0 is the
    picture after setup().
    """
    try:
        replay = read_replay(events) if events else Replay()
        backend = open_backend(renderer).backend
        launch = Launch(sketch, say.remark, seed, replay=replay, python=python)
        found = inspect(launch, frame, pixels, backend)
    except (EventsError, OutsideError) as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)
    except RendererError as reason:
        say.note(f"The {renderer} renderer does not work here: {reason}.")
        sys.exit(WRONG_CALL)
    except StoppedError as stopped:
        say.mistake(stopped.report, with_traceback=traceback)
        sys.exit(1)
    if as_json:
        values = [as_value(own) for own in found]
        click.echo(json.dumps(values if len(values) > 1 else values[0], indent=2))
        return
    click.echo("\n\n".join("\n".join(report(own, sketch.name)) for own in found))
