"""`sketchkit run`: a sketch in a window."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from sketchkit.assets.output import write_file
from sketchkit.cli import say
from sketchkit.cli.python_mode import python_mode
from sketchkit.cli.sketch_file import sketch_file
from sketchkit.runtime.explore.explorer import SketchExplorer
from sketchkit.runtime.explorer import NoExplorer
from sketchkit.runtime.inputs import Inputs, Live, Recorded, Replayed
from sketchkit.runtime.player import Manner, Player
from sketchkit.runtime.replay import EventsError, read_replay
from sketchkit.runtime.window import Window, WindowError

NO_WINDOW = WRONG_CALL = 2  # exit status


@click.command(name="run", context_settings={"ignore_unknown_options": True})
@click.argument("sketch", type=sketch_file)
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
@click.option("--no-reload", is_flag=True, help="Let saved files be until the next run.")
@click.option(
    "--keep-state",
    is_flag=True,
    help="When the sketch is saved, let it go on: its variables keep their values, functions are "
    "the new ones, setup() is run again only if its own text has changed.",
)
@click.option(
    "--record-input",
    "record",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Write down mouse and keys, for --input. Time and random numbers are render's meanwhile.",
)
@click.option(
    "--input",
    "events",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Play back mouse and keys from an events file, as render does.",
)
@python_mode
@click.option(
    "--no-explore",
    is_flag=True,
    help="Give the sketch F1 to F12 too, and say nothing of pictures in which nothing shows.",
)
@click.option("--traceback", is_flag=True, help="Show all that Python says about a mistake.")
def command(  # noqa: PLR0913 # click hands over each option
    sketch: Path,
    args: tuple[str, ...],
    no_reload: bool,
    keep_state: bool,
    record: Path | None,
    events: Path | None,
    python: int | None,
    no_explore: bool,
    traceback: bool,
) -> None:
    """Show SKETCH, a Python file (.py or .pyde) or its folder, in a window.

    F1 shows the keys that explore it: pause, another camera, which line drew what, numbers.
    Esc or closing the window ends it. Save the sketch, one of its modules or a file that it has
    loaded, and it starts again in the same window. What follows SKETCH is the list that the sketch
    sees as args.
    """
    inputs = _inputs(record, events)
    try:
        window = Window(sketch.stem)
    except WindowError as reason:
        say.note(
            f"No window can be opened here ({reason}); "
            f"sketchkit render {sketch} draws the sketch without one."
        )
        sys.exit(NO_WINDOW)
    record = record and record.absolute()  # a sketch is run in its own folder
    with window:
        player = Player(
            sketch,
            window,
            Manner(args, inputs, not no_reload, keep_state, python),
            tell=say.remark,
            say=lambda report: say.mistake(report, with_traceback=traceback),
            note=say.note,
            explorer=NoExplorer() if no_explore else SketchExplorer(say.remark),
        )
        is_well = player.play()
    if record and isinstance(inputs, Recorded):
        write_file(record, inputs.text().encode())
    sys.exit(0 if is_well else 1)


def _inputs(record: Path | None, events: Path | None) -> Inputs:
    """Return where the events come from."""
    if record and events:
        raise click.UsageError("--input plays a file back: there is nothing new to record.")
    try:
        return Replayed(read_replay(events)) if events else Recorded() if record else Live()
    except EventsError as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)
